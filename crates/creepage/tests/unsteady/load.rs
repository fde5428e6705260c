//! Loads that change.

use creepage::Status;
use creepage::unsteady::{Motion, Rolling};

use super::support::{circle, coarse, creeping};

/// Eight times the load makes a contact twice as large: the same in its own units.
#[test]
fn another_load_is_another_unit() {
    let (mut one, mut other) = (circle(coarse()), pressed(8.0));
    let motion = |scale: f64| creeping(0.5 * scale, 0.1 * scale, 0.3);
    for _ in 0..3 {
        let small = one.advance(0.1, &motion(1.0)).unwrap();
        let large = other.advance(0.2, &motion(2.0)).unwrap();
        let (small, large) = (small.solution.force, large.solution.force);
        assert!((8.0 * small.fx - large.fx).abs() < 1e-6, "{small:?} {large:?}");
        assert!((16.0 * small.mz - large.mz).abs() < 1e-6, "{small:?} {large:?}");
    }
}

/// Pressed anew with another load.
fn pressed(load: f64) -> Rolling {
    let mut rolling = circle(coarse());
    rolling.press(0.0).unwrap();
    rolling.advance(1.0, &Motion::default()).unwrap();
    rolling.press(load).unwrap();
    rolling
}

/// A load that changes slowly leaves rolling steady at every moment.
#[test]
fn a_slow_change_is_steady_at_every_moment() {
    let motion = creeping(0.6, 0.0, 0.2);
    for (from, to) in [(1.0, 2.0), (2.0, 1.0)] {
        let mut rolling = pressed(from);
        rolling.step(20.0, &motion).unwrap();
        let steps = 60;
        for k in 1..=steps {
            rolling.press(from + (to - from) * f64::from(k) / f64::from(steps)).unwrap();
            rolling.step(1.0, &motion).unwrap();
        }
        let changing = rolling.step(1.0, &motion).unwrap().solution.force;
        let steady = pressed(to).step(30.0, &motion).unwrap().solution.force;
        // It lags by some two contact lengths, in which the load changes by 7 %, and has rested for one.
        assert!((changing.fx / steady.fx - 1.0).abs() < 0.01, "{changing:?} {steady:?}");
        assert!((changing.mz - steady.mz).abs() < 0.01 * steady.fx, "{changing:?} {steady:?}");
    }
}

#[test]
fn it_bounces() {
    let mut rolling = circle(coarse());
    let motion = creeping(0.4, -0.2, 0.3);
    let first = rolling.step(0.5, &motion).unwrap().solution.force;
    rolling.press(0.0).unwrap();
    let apart = rolling.step(0.5, &motion).unwrap();
    assert_eq!((apart.solution.force.fx, apart.adhesion_share), (0.0, 0.0));
    rolling.press(1.0).unwrap();
    let again = rolling.step(0.5, &motion).unwrap();
    assert_eq!(again.solution.status, Status::Solved);
    assert!((again.solution.force.fx - first.fx).abs() < 2e-3, "{again:?} {first:?}");
}

/// Whatever the jump: forces stay within those of friction.
#[test]
fn jumps_of_the_load_stay_within_friction() {
    let motion = creeping(1.5, 0.0, 0.5);
    for load in [0.01, 0.3, 0.9, 1.2, 3.0, 50.0] {
        let mut rolling = circle(coarse());
        rolling.step(2.0, &motion).unwrap();
        rolling.press(load).unwrap();
        for length in [0.01, 0.1, 1.0] {
            let rolled = rolling.step(length, &motion).unwrap();
            assert_eq!(rolled.solution.status, Status::Solved, "{load}");
            assert!(rolled.solution.force.magnitude() <= 1.01 * load, "{load} {rolled:?}");
        }
    }
}
