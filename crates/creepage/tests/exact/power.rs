//! Creepage times force is the power turned to heat in the slip area.

use creepage::coulomb::{ElementField, Resolution};
use creepage::theory::Solved;

use crate::common::at;
use crate::support::{exact, solve};

/// The heat of slip areas narrower than an element is what the forces' power has beyond traction
/// times slip; nowhere does traction times slip turn more to heat than that, beyond the error of
/// extrapolation. The documentation says 0.2 %, at any creepage.
#[test]
fn both_powers_agree() {
    for (ratio, poisson) in [(0.2, 0.1), (0.6, 0.45), (1.0, 0.28), (1.7, 0.0), (4.0, 0.3)] {
        let theory = exact(ratio, poisson, Resolution::STANDARD);
        for k in 0..24 {
            let t = f64::from(k) + ratio;
            let size = (0.25 * (f64::from(k) - 20.0)).exp();
            let directions = [3.0 * (1.7 * t).sin(), 3.0 * (2.9 * t).cos(), 8.0 * (0.9 * t).sin()];
            let found = solve(&theory, directions.map(|direction| size * direction));
            let apart = (found.power - found.dissipation).abs() / found.power;
            assert!(apart < 0.002, "{ratio} {k} {found:?}");
        }
    }
}

/// What traction times slip gives in the elements approaches the whole with the elements' size:
/// what is added along the trailing edge for narrower slip areas vanishes.
#[test]
fn heat_of_the_trailing_edge_vanishes_with_the_elements() {
    let resolved = |resolution| {
        let theory = exact(1.0, 0.28, resolution);
        let solved = theory.solve_contact(at([0.5, 0.3, 1.0]));
        let elements = solved.elements();
        let from_slip = |e: &ElementField| {
            let ([p, q], [u, v]) = (e.point.traction, e.point.slip);
            e.share / e.bound * (p * u + q * v)
        };
        elements.iter().map(from_slip).sum::<f64>() / solved.power()
    };
    let [fast, fine] = [Resolution::FAST, Resolution::FINE].map(resolved);
    assert!(
        (1.0 - fine).abs() < 0.03 && (1.0 - fine).abs() < 0.6 * (1.0 - fast).abs(),
        "{fast} {fine}"
    );
}
