//! One creepage after another: warm starts, and no jumps.

use creepage::coulomb::Resolution;
use creepage::{Creepage, Status, Theory};

use crate::support::{components, exact};

#[test]
fn warm_starts_find_the_same_solutions() {
    let theory = exact(1.0, 0.28, Resolution::STANDARD);
    let curve: Vec<_> =
        (0..40).map(|k| Creepage::new(0.4, -0.2, 0.1 * f64::from(k)).unwrap()).collect();
    for (warm, creepage) in theory.curve(&curve).into_iter().zip(&curve) {
        let cold = theory.solve(*creepage).force;
        for (warm, cold) in components(warm.force).into_iter().zip(components(cold)) {
            // Both are iterated to tractions of 1e-6, forces to 5e-8.
            assert!((warm - cold).abs() < 1e-6, "{creepage:?}");
        }
    }
}

/// However much smaller the next creepage is, and be it none: the last tractions do no harm.
#[test]
fn a_curve_may_come_down_to_nothing() {
    for ratio in [0.05, 1.0, 40.0] {
        let theory = exact(ratio, 0.28, Resolution::FAST);
        for size in [0.0, 1e-300, 1e-20, 1e-9, 1e-3] {
            let [from, to] = [2.0, size].map(|s| Creepage::new(s, -0.3 * s, 0.2 * s).unwrap());
            let warm = theory.curve(&[from, to])[1];
            assert_eq!(warm.status, Status::Solved, "{ratio} {size:e}");
            let cold = theory.solve(to).force;
            for (warm, cold) in components(warm.force).into_iter().zip(components(cold)) {
                // Both are iterated to 1e-6 of tractions that are of the size of the creepage.
                assert!(
                    (warm - cold).abs() <= 1e-6 * size && cold.abs() <= 100.0 * size,
                    "{ratio} {size:e} {warm} {cold}"
                );
            }
        }
    }
}

/// The force has no jumps where elements begin to slide: along a curve through all states its
/// steps shrink with those of the creepage.
#[test]
fn the_force_is_continuous() {
    let theory = exact(1.3, 0.28, Resolution::FAST);
    let largest_step = |count: u32| {
        let curve: Vec<_> = (0..=count)
            .map(|k| {
                let t = f64::from(k) / f64::from(count);
                Creepage::new(1.5 * t, 0.8 - t, 4.0 * t * t).unwrap()
            })
            .collect();
        let forces: Vec<_> =
            theory.curve(&curve).iter().map(|found| components(found.force)).collect();
        let steps = forces
            .windows(2)
            .map(|f| (0..3).map(|k| (f[1][k] - f[0][k]).abs()).fold(0.0, f64::max));
        steps.fold(0.0, f64::max)
    };
    let [coarse, fine] = [100, 1600].map(largest_step);
    // A smooth curve gives 1/16; a jump would stay as it is.
    assert!(fine < coarse / 12.0, "{coarse} {fine}");
}
