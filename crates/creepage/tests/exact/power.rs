//! Creepage times force is the power turned to heat in the slip area.

use creepage::coulomb::Resolution;

use crate::support::{exact, solve};

/// Creepage times force is the power turned to heat in the slip area. Both are extrapolated from
/// two grids; what is left of their difference is heat in slip areas narrower than an element.
#[test]
fn both_powers_agree() {
    let cases =
        [[0.0, -0.6, 0.0], [0.5, 0.3, 1.0], [1.0, -1.0, 2.0], [0.0, 0.0, 2.0], [2.0, 0.5, 0.3]];
    let mut worst = [0.0_f64; 2];
    for ratio in [0.3, 1.0, 4.0] {
        for (worst, resolution) in worst.iter_mut().zip([Resolution::FAST, Resolution::FINE]) {
            let theory = exact(ratio, 0.28, resolution);
            for case in cases {
                let found = solve(&theory, case);
                *worst = worst.max((found.power - found.dissipation).abs() / found.power);
            }
        }
    }
    assert!(worst[1] < 0.02 && worst[1] < 0.5 * worst[0], "{worst:?}");
}

/// Beyond small creepage (half of friction is used) the powers agree within 1 % at the standard
/// resolution in nine of ten cases, and within 5 % in all of these; 6 % has been seen in others.
#[test]
fn powers_agree_where_friction_is_used() {
    let mut apart = Vec::new();
    for (ratio, poisson) in [(0.2, 0.1), (0.6, 0.45), (1.0, 0.28), (1.7, 0.0), (4.0, 0.3)] {
        let theory = exact(ratio, poisson, Resolution::STANDARD);
        for k in 0..24 {
            let t = f64::from(k) + ratio;
            let found = solve(
                &theory,
                [3.0 * (1.7 * t).sin(), 3.0 * (2.9 * t).cos(), 8.0 * (0.9 * t).sin()],
            );
            if found.force.magnitude() > 0.5 || found.force.mz.abs() > 0.3 {
                apart.push((found.power - found.dissipation).abs() / found.power);
            }
        }
    }
    apart.sort_by(f64::total_cmp);
    assert!(apart.len() > 60);
    assert!(apart[apart.len() * 9 / 10] < 0.01 && apart[apart.len() - 1] < 0.05, "{apart:?}");
}
