//! Strip theory.

use std::f64::consts::PI;

use creepage::approximate::carter::Carter;
use creepage::approximate::strip::StripTheory;
use creepage::{Creepage, Region, Status, Theory};

use super::cases::{self, CREEPAGES, array, contact, creepage, kappa, largest_difference};
use super::plane::principal_value;

/// `G / (2 mu p0)` times the unit of creepage.
fn slope(a_over_b: f64, poisson: f64) -> f64 {
    kappa(a_over_b, poisson) * PI / 3.0
}

/// Slip at `position` by the plane half-space's kernels, from the theory's own tractions.
fn plane_slip(
    theory: &StripTheory,
    (a_over_b, poisson): (f64, f64),
    at: Creepage,
    position: [f64; 2],
    breaks: &[f64],
) -> [f64; 2] {
    let kernel = |i: usize| {
        let traction = |x| theory.field(at, &[[x, position[1]]])[0].traction[i];
        principal_value(traction, breaks, position[0]) / (PI * slope(a_over_b, poisson))
    };
    let rigid = at.rigid_slip(position);
    [rigid[0] - (1.0 - poisson) * kernel(0), rigid[1] - kernel(1)]
}

/// Where the strip at `y` changes from adhesion to slip, by bisection.
fn border(theory: &StripTheory, at: Creepage, y: f64, half_length: f64) -> f64 {
    let (mut slip, mut adhesion) = (-half_length, half_length * (1.0 - 1e-12));
    for _ in 0..200 {
        let middle = f64::midpoint(slip, adhesion);
        match theory.field(at, &[[middle, y]])[0].region {
            Region::Adhesion => adhesion = middle,
            Region::Slip | Region::Outside => slip = middle,
        }
    }
    adhesion
}

#[test]
fn slip_vanishes_in_the_adhesion_area_by_an_independent_plane_integral() {
    let mut adhering = 0;
    for (a_over_b, poisson) in [(0.2, 0.28), (0.5, 0.0), (1.0, 0.45), (2.0, 0.3)] {
        let theory = StripTheory::new(&contact(a_over_b, poisson));
        let (a, b) = (a_over_b.sqrt(), a_over_b.sqrt().recip());
        for (xi, eta, psi) in
            [(0.4, 0.0, 0.0), (0.3, -0.4, 0.2), (-0.2, 0.3, -0.5), (0.0, 0.1, 0.7)]
        {
            let at = creepage(xi, eta, psi * theory.spin_bound());
            for t in [-0.6, 0.1, 0.5] {
                let half_length = a * f64::sqrt(1.0 - t * t);
                let y = b * t;
                let border = border(&theory, at, y, half_length);
                if border > half_length * 0.99 {
                    continue;
                }
                adhering += 1;
                let breaks = [-half_length, border, half_length];
                for share in [0.1, 0.5, 0.9] {
                    let x = border + share * (half_length - border);
                    let slip = plane_slip(&theory, (a_over_b, poisson), at, [x, y], &breaks);
                    // The oracle's quadrature is good to 1e-10.
                    assert!(slip[0].hypot(slip[1]) < 1e-9, "{a_over_b} {at:?} {x} {y}: {slip:?}");
                    let x = border - share * (border + half_length);
                    let slip = plane_slip(&theory, (a_over_b, poisson), at, [x, y], &breaks);
                    let stated = theory.field(at, &[[x, y]])[0].slip;
                    // The border is known to rounding, the slip like its square root.
                    assert!(
                        (slip[0] - stated[0]).hypot(slip[1] - stated[1]) < 1e-6,
                        "{at:?} {x} {y}: {slip:?} {stated:?}"
                    );
                }
            }
        }
    }
    assert!(adhering > 30, "{adhering}");
}

/// Below the bound everywhere, at it in the slip area.
#[test]
fn traction_keeps_to_its_bound() {
    let theory = StripTheory::new(&contact(0.4, 0.28));
    let (a, b) = (0.4_f64.sqrt(), 0.4_f64.sqrt().recip());
    for [xi, eta, chi] in CREEPAGES {
        let at = creepage(xi, eta, chi);
        for i in 0..40 {
            for j in 0..40 {
                let (u, t) = (f64::from(i) / 20.0 - 0.99, f64::from(j) / 20.0 - 0.99);
                let bound = (1.0 - u * u - t * t).max(0.0).sqrt();
                let point = theory.field(at, &[[a * u, b * t]])[0];
                let size = point.traction[0].hypot(point.traction[1]);
                assert!(size <= bound + 1e-12, "{at:?} {point:?}");
                if point.region == Region::Slip {
                    assert!((size - bound).abs() < 1e-12, "{at:?} {point:?}");
                } else {
                    assert!(point.slip[0].hypot(point.slip[1]) < 1e-9);
                }
            }
        }
    }
}

/// Forces are the integrals of the field.
#[test]
fn forces_are_the_sums_of_the_tractions() {
    let theory = StripTheory::new(&contact(0.5, 0.28));
    let (a, b) = (0.5_f64.sqrt(), 0.5_f64.sqrt().recip());
    let n = 600;
    let angle = |i: usize| PI * (i as f64 + 0.5) / n as f64;
    for [xi, eta, chi] in CREEPAGES {
        let at = creepage(xi, eta, chi);
        let mut sum = [0.0; 3];
        for j in 0..n {
            let (s, t) = angle(j).sin_cos();
            for i in 0..n {
                let (sin, cos) = angle(i).sin_cos();
                let position = [a * s * cos, b * t];
                let [tx, ty] = theory.field(at, &[position])[0].traction;
                let weight = 1.5 / PI * (a * s * sin) * (b * s) * (PI / n as f64).powi(2);
                sum[0] += weight * tx;
                sum[1] += weight * ty;
                sum[2] += weight * (position[0] * ty - position[1] * tx);
            }
        }
        // The midpoint rule across borders of the adhesion area: of order 1/n at worst.
        let difference = largest_difference(sum, array(theory.solve(at).force));
        assert!(difference < 3e-4, "{at:?}: {difference}");
    }
}

/// Haines and Ollerton's total, in the closed form for any direction: the adhering strips' part
/// `(3/2) acos(D) (X1, E)`, and the rest along the rigid slip.
#[test]
fn closed_form_without_spin() {
    for (a_over_b, poisson) in [(0.1, 0.28), (0.7, 0.0), (1.0, 0.5), (3.0, 0.25)] {
        let theory = StripTheory::new(&contact(a_over_b, poisson));
        let (a, slope) = (a_over_b.sqrt(), slope(a_over_b, poisson));
        for (xi, eta) in [(0.3, 0.0), (-0.9, 0.0), (0.0, 0.6), (0.4, 0.5), (2.0, -1.0), (9.0, 9.0)]
        {
            let (x1, e) = (slope * xi / (1.0 - poisson), slope * eta);
            let depth = x1.hypot(e);
            let rigid = [xi / xi.hypot(eta), eta / xi.hypot(eta)];
            let expected = if depth < 1.0 {
                let s = (1.0 - depth * depth).sqrt();
                let sticking = 1.5 * depth.acos();
                let sliding = 1.0 - 1.5 * s + 0.5 * s.powi(3);
                let total = sliding + sticking * depth;
                // Where both parts have one direction this is f (X1, E)/D of that total f.
                [
                    sticking * x1 + sliding * rigid[0],
                    sticking * e + sliding * rigid[1],
                    -e * a * (1.0 - total),
                ]
            } else {
                [rigid[0], rigid[1], 0.0]
            };
            let force = array(theory.solve(creepage(xi, eta, 0.0)).force);
            let difference = largest_difference(force, expected);
            assert!(difference < 1e-12, "{a_over_b} {xi} {eta}: {force:?} {expected:?}");
        }
    }
}

/// With longitudinal creepage the middle strip is Carter's problem, `D` being a quarter of his
/// creepage.
#[test]
fn middle_strip_is_carters() {
    let (a_over_b, poisson) = (0.3, 0.28);
    let theory = StripTheory::new(&contact(a_over_b, poisson));
    let a = f64::sqrt(a_over_b);
    for depth in [0.1, -0.4, 0.8] {
        let xi = depth * (1.0 - poisson) / slope(a_over_b, poisson);
        let carter = Carter::new(4.0 * depth).unwrap();
        for k in 0..40 {
            let x = f64::from(k) / 20.0 - 0.99;
            let point = theory.field(creepage(xi, 0.0, 0.0), &[[a * x, 0.0]])[0];
            let expected = carter.at(x);
            assert_eq!(point.region, expected.region);
            assert!((point.traction[0] - expected.traction[0]).abs() < 1e-14);
            // Both slips over the creepage: the units of length differ.
            let slips = [point.slip[0] / xi, expected.slip[0] / (4.0 * depth)];
            assert!((slips[0] - slips[1]).abs() < 1e-13);
        }
    }
}

/// The coefficients of the plane-strain limit; corrections are of the order of the creepage.
#[test]
fn small_creepage() {
    for (a_over_b, poisson) in [(0.05, 0.28), (0.2, 0.0), (1.0, 0.28)] {
        let theory = StripTheory::new(&contact(a_over_b, poisson));
        let kappa = kappa(a_over_b, poisson);
        let expected = cases::strip_coefficients(a_over_b, poisson);
        let small = 1e-6;
        let ratio = |at: [f64; 3]| {
            let force = theory.solve(creepage(at[0], at[1], at[2])).force;
            array(force).map(|f| f / (kappa * small))
        };
        let (along, across, spin) =
            (ratio([small, 0.0, 0.0]), ratio([0.0, small, 0.0]), ratio([0.0, 0.0, small]));
        assert!((along[0] / expected.c11 - 1.0).abs() < 1e-5);
        assert!((across[1] / expected.c22 - 1.0).abs() < 1e-5);
        assert!((across[2] / expected.c32 - 1.0).abs() < 1e-5);
        assert!((spin[1] / expected.c23 - 1.0).abs() < 1e-5);
        assert!((spin[2] / expected.c33 - 1.0).abs() < 1e-5);
    }
}

#[test]
fn spin_beyond_the_bound_is_said() {
    for (ratio, bound) in [(0.2, 5.29), (1.0, 3.54), (5.0, 1.06)] {
        let theory = StripTheory::new(&contact(ratio, 0.28));
        assert!((theory.spin_bound() - bound).abs() < 0.005);
        let status = |chi| theory.solve(creepage(0.3, 0.1, chi)).status;
        assert_eq!(status(0.999 * theory.spin_bound()), Status::Solved);
        assert_eq!(status(-1.001 * theory.spin_bound()), Status::SpinTooLarge);
    }
}

/// Beyond the bound in spin all slides along the rigid slip. Reference: the closed form (4.106)
/// of that, good to 1e-12. With the spin pole inside, its strips' quadrature is good to 1e-5.
#[test]
fn full_sliding() {
    for (a_over_b, across, expected) in [
        (0.2, 0.0, [0.0, 0.880_872_896_269_554]),
        (0.5, 0.0, [0.0, 0.642_259_447_117_875_1]),
        (1.0, 0.0, [0.0, 0.589_048_622_548_086_2]),
        (1.0, 0.25, [0.289_922_368_910_386_2, 0.553_095_947_832_016_5]),
        (1.0, 1.0, [0.883_572_933_822_146_6, 0.220_893_233_455_536_74]),
        (1.0, 4.0, [0.993_707_402_083_820_1, 0.050_226_787_094_788_256]),
        (1.0, 10.0, [0.998_998_925_583_370_7, 0.020_014_321_564_494_74]),
    ] {
        let theory = StripTheory::new(&contact(a_over_b, 0.28));
        let solution = theory.solve(creepage(0.0, 20.0 * across, 20.0));
        assert_eq!(solution.status, Status::SpinTooLarge);
        let expected = [0.0, expected[0], expected[1]];
        let difference = largest_difference(array(solution.force), expected);
        let tolerance = if across > 1.0 { 1e-10 } else { 1e-5 };
        assert!(difference < tolerance, "{a_over_b} {across}: {difference}");
    }
}

/// An independent implementation with 2000 strips; its quadrature, and the six digits of the
/// table, are good to 1e-5 or so but where the direction jumps between strips.
#[test]
fn reference_values() {
    let (error, case) = cases::largest_error(
        "strip_pure_rigid",
        |_| true,
        |case| {
            let theory = StripTheory::new(&contact(case.a_over_b, case.poisson));
            array(theory.solve(case.creepage).force)
        },
    );
    assert!(error < 5e-4, "{error} {case}");
}
