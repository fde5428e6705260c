//! The limits: linear theory, full sliding, strips.

use creepage::approximate::linear::Linear;
use creepage::approximate::saturated::Saturated;
use creepage::coulomb::Resolution;
use creepage::{Creepage, Status, Theory};

use crate::common::contact;
use crate::support::{components, exact, solve};

#[test]
fn no_creepage_no_force() {
    let theory = exact(2.0, 0.3, Resolution::FAST);
    let found = solve(&theory, [0.0; 3]);
    assert_eq!(found.status, Status::Solved);
    assert!(components(found.force).iter().all(|f| *f == 0.0));
}

/// Small creepage: all of Kalker's coefficients to 0.1 %, `C33` to 0.15 %; and within the error bars.
#[test]
fn small_creepage_is_linear() {
    let short = [(0.1, 0.0), (0.1, 0.28), (0.1, 0.5), (0.15, 0.5), (0.3, 0.5)];
    let long = [(1.0, 0.0), (1.0, 0.5), (3.0, 0.28), (10.0, 0.0), (10.0, 0.28), (10.0, 0.5)];
    for (ratio, poisson) in short.into_iter().chain(long) {
        let theory = exact(ratio, poisson, Resolution::FINE);
        let gains =
            Linear::new(&contact(ratio, poisson)).unwrap().jacobian(Creepage::default()).unwrap();
        // No element slides yet.
        let small = 1e-7;
        for column in 0..3 {
            let mut at = [0.0; 3];
            at[column] = small;
            let found = solve(&theory, at);
            let (force, bars) = (components(found.force), components(found.error));
            for row in 0..3 {
                let expected = small * gains[row][column];
                let error = (force[row] - expected).abs();
                let case = format!("{ratio} {poisson} [{row}][{column}] {force:?} {expected}");
                // Symmetry makes the others vanish, but for the tolerance of the iteration.
                let part = if (row, column) == (2, 2) { 0.0015 } else { 0.001 };
                assert!(error <= part * expected.abs() + 1e-6 * small, "{case}");
                assert!(error <= bars[row] + 1e-6 * small, "{case} {bars:?}");
            }
        }
    }
}

/// Large creepage: full sliding, with the pole of the spin anywhere, to 0.02 %.
#[test]
fn large_creepage_saturates() {
    let theory = exact(1.0, 0.28, Resolution::FINE);
    let found = solve(&theory, [6e3, 8e3, 0.0]).force;
    // Elastic slip is 1e-4 of the rigid slip.
    assert!((found.fx - 0.6).abs() < 1e-4 && (found.fy - 0.8).abs() < 1e-4);
    for ratio in [0.1_f64, 0.4, 1.0, 3.0, 10.0] {
        let theory = exact(ratio, 0.28, Resolution::FINE);
        let saturated = Saturated::new(&contact(ratio, 0.28)).unwrap();
        for k in 0..24 {
            // The pole goes outwards in a spiral from the middle, to twice the semi-axes.
            let (sin, cos) = (1.3 * f64::from(k)).sin_cos();
            let distance = f64::from(k) / 12.0;
            let (x, y) = (distance * cos * ratio.sqrt(), distance * sin / ratio.sqrt());
            let creepage = Creepage::new(1e5 * y, -1e5 * x, 1e5).unwrap();
            let found = components(theory.solve(creepage).force);
            let expected = components(saturated.solve(creepage).force);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 2e-4, "{ratio} {k}: {found} {expected}");
            }
        }
    }
}

/// Slender across the rolling direction every strip is Carter's: an adhesion area shorter by
/// the same length `lambda` in all, `lambda / a = xi sqrt(b/a) / 4`.
#[test]
fn slender_strips_are_carters() {
    let ratio = 1.0 / 50.0_f64;
    let theory = exact(ratio, 0.28, Resolution::STANDARD);
    for xi in [0.1, 0.3, 0.5] {
        let shorter = 0.25 * xi / ratio.sqrt();
        let steps = 20_000;
        let carter: f64 = (0..steps)
            .map(|k| {
                let y = (f64::from(k) + 0.5) / f64::from(steps);
                let length = (1.0 - y * y).sqrt();
                1.5 / f64::from(steps)
                    * length.powi(2)
                    * (1.0 - (1.0 - shorter / length).max(0.0).powi(2))
            })
            .sum();
        let found = solve(&theory, [xi, 0.0, 0.0]).force.fx;
        // C11 at this ratio is 0.2 % above its limit for strips.
        assert!((found - carter).abs() < 0.005, "xi {xi}: {found} {carter}");
    }
}
