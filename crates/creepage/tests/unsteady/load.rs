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

/// Pressed with another load from the beginning.
fn pressed(load: f64) -> Rolling {
    let mut rolling = circle(coarse());
    rolling.start_with_load(load).unwrap();
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
    // They meet within a thousandth of the semi-axis.
    rolling.press(1.0).unwrap();
    rolling.step(0.001, &motion).unwrap();
    let again = rolling.step(0.5, &motion).unwrap();
    assert_eq!(again.solution.status, Status::Solved);
    // The elements that the growing contact passes one after the other are those of the error bar.
    let bar = again.solution.error.unwrap().fx;
    assert!((again.solution.force.fx - first.fx).abs() < bar, "{again:?} {first:?}");
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

/// A row in which the load grows or shrinks by much, at once or row by row on the same straight line.
#[test]
fn a_row_may_be_cut_into_many() {
    let motion = creeping(0.5, 0.2, 0.3);
    let end = |[from, to]: [f64; 2], rows: u32| {
        let mut rolling = circle(coarse());
        rolling.start_with_load(from).unwrap();
        rolling.step(2.0, &motion).unwrap();
        for row in 1..rows {
            rolling.press(from + (to - from) * f64::from(row) / f64::from(rows)).unwrap();
            rolling.step(1.0 / f64::from(rows), &motion).unwrap();
        }
        rolling.press(to).unwrap();
        rolling.step(1.0 / f64::from(rows), &motion).unwrap().solution
    };
    for loads in [[1.0, 2.0], [4.0, 1.0], [1.0, 50.0], [0.0, 1.0]] {
        let (once, often) = (end(loads, 1), end(loads, 50));
        assert_eq!(once.status, Status::Solved);
        // Step control allows 3e-3 of the friction force a step, of either sign.
        let (fx, fy) = (once.force.fx - often.force.fx, once.force.fy - often.force.fy);
        assert!(fx.hypot(fy) < 3e-3 * loads[1], "{loads:?} {once:?} {often:?}");
    }
}

/// A force that friction gives at the end of a row only grows with the load.
#[test]
fn a_force_grows_with_the_load_where_friction_asks_for_it() {
    let mut rolling = circle(coarse());
    rolling.step(1.0, &Motion::forces(0.5, 0.0)).unwrap();
    for (load, force) in [(4.0, 3.0), (0.0, 0.0), (2.0, -1.5)] {
        rolling.press(load).unwrap();
        let rolled = rolling.step(0.7, &Motion::forces(force, 0.0)).unwrap();
        assert_eq!(rolled.solution.status, Status::Solved, "{load}: {rolled:?}");
        // The two grids meet the force to 1e-7 each.
        assert!(
            (rolled.solution.force.fx - force).abs() < 1e-6 * load.max(1.0),
            "{load}: {rolled:?}"
        );
    }
}

/// Pressed eight times as hard at once, the bodies adhere as they are: the force does not change.
#[test]
fn a_press_at_rest_keeps_the_force() {
    let motion = creeping(0.5, 0.2, 0.3);
    let mut rolling = circle(coarse());
    let before = rolling.step(2.0, &motion).unwrap().solution.force;
    rolling.press(8.0).unwrap();
    let pressed = rolling.step(1e-3, &motion).unwrap().solution;
    // The contact before covers a quarter of the elements; they give the error bar.
    let error = pressed.error.unwrap();
    assert!((pressed.force.fx - before.fx).abs() < error.fx, "{pressed:?} {before:?}");
    assert!((pressed.force.fy - before.fy).abs() < error.fy, "{pressed:?} {before:?}");
}
