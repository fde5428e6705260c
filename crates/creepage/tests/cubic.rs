//! The laws in closed form against a second implementation, the thesis, and each other.
// A theory that cannot be prepared fails the test.
#![allow(clippy::unwrap_used)]

mod common;

use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, PI};

use common::{contact, creepage, try_contact};
use creepage::approximate::linear::{CreepageCoefficients, Linear};
use creepage::approximate::polach::Polach;
use creepage::approximate::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::approximate::vermeulen_johnson::VermeulenJohnson;
use creepage::{Creepage, FieldPoint, Force, Region, Status, Theory};
use serde_json::Value;

const REFERENCE: &str = include_str!("data/cubic_laws.json");

fn array(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

/// The reference is rounded to six decimals.
#[test]
fn second_implementation() {
    let cases: Vec<Value> = serde_json::from_str(REFERENCE).unwrap();
    assert_eq!(cases.len(), 40);
    for case in &cases {
        let number = |name: &str| case[name].as_f64().unwrap();
        let (a_over_b, poisson) = (number("a_over_b"), number("poisson"));
        let at = creepage(number("xi"), number("eta"), number("chi"));
        let linear = Linear::new(&contact(a_over_b, poisson)).unwrap();
        let shen = ShenHedrickElkins::new(&contact(a_over_b, poisson)).unwrap();
        let johnson = VermeulenJohnson::new(&contact(a_over_b, poisson)).unwrap();
        let polach = Polach::new(&contact(a_over_b, poisson)).unwrap();
        // The reference clips linear theory at mu N, the moment by the same factor.
        let unclipped = linear.solve(at).force;
        let clipped = array(unclipped).map(|f| f / unclipped.magnitude().max(1.0));
        for (name, actual) in [
            ("linear_clipped", clipped),
            ("shen_hedrick_elkins", array(shen.solve(at).force)),
            ("vermeulen_johnson", array(johnson.solve(at).force)),
            ("polach", array(polach.solve(at).force)),
        ] {
            for (actual, expected) in actual.iter().zip(case[name].as_array().unwrap()) {
                // Null where the law has no moment: given as zero.
                let error = actual - expected.as_f64().unwrap_or(0.0);
                assert!(error.abs() < 1e-6, "{name}: {actual} {expected} in {case}");
            }
        }
    }
}

/// (4.91), `sigma = 1/4`: linear theory's growth from the circle to `a/b = .2` and `b/a = .2`
/// against that of `psi_1` and `phi`. With Table 3's degree 5: 1.074, 1.056, .940, .928 (printed
/// 1.07, 1.05, .94, .93); converged: 1.072, 1.054, .933, .925.
#[test]
fn four_ratios_of_the_thesis() {
    let circle = VermeulenJohnson::new(&contact(1.0, 0.25)).unwrap();
    let ratios = |coefficients: &dyn Fn(f64) -> CreepageCoefficients| {
        let round = coefficients(1.0);
        [0.2, 5.0].map(|a_over_b| {
            let (shape, c) =
                (VermeulenJohnson::new(&contact(a_over_b, 0.25)).unwrap(), coefficients(a_over_b));
            [
                round.c22 * circle.psi() / shape.psi() / c.c22,
                round.c11 * circle.phi() / shape.phi() / c.c11,
            ]
        })
    };
    let of_degree_5 = ratios(&|r| CreepageCoefficients::of_degree(&contact(r, 0.25), 5).unwrap());
    let converged = ratios(&|r| CreepageCoefficients::new(&contact(r, 0.25)).unwrap());
    for (actual, expected) in [
        (of_degree_5, [[1.074, 1.056], [0.940, 0.928]]),
        (converged, [[1.072, 1.054], [0.933, 0.925]]),
    ] {
        for (actual, expected) in actual.as_flattened().iter().zip(expected.as_flattened()) {
            assert!((actual - expected).abs() < 5.5e-4, "{actual} {expected}");
        }
    }
}

/// Johnson (1958): `C11 = 4/(1 - 3 sigma/4)`, `C22 = 4/(1 - sigma/4)`.
#[test]
fn johnson_is_the_case_of_the_circle() {
    for poisson in [0.0, 0.25, 0.5] {
        for a_over_b in [1.0, 1.0 + 1e-9, 1.0 - 1e-9] {
            let theory = VermeulenJohnson::new(&contact(a_over_b, poisson)).unwrap();
            assert!((PI / theory.phi() - 4.0 / (1.0 - 0.75 * poisson)).abs() < 1e-7);
            assert!((PI / theory.psi() - 4.0 / (1.0 - 0.25 * poisson)).abs() < 1e-7);
        }
    }
}

/// Steeper than linear theory, most so for slender shapes (`4/pi` as `a/b -> 0`).
#[test]
fn slope_of_vermeulen_johnson_against_linear_theory() {
    for (a_over_b, c11, c22) in
        [(0.05, 1.273, 1.270), (0.2, 1.264, 1.246), (1.0, 1.200, 1.161), (5.0, 1.108, 1.084)]
    {
        let slope = VermeulenJohnson::new(&contact(a_over_b, 0.28))
            .unwrap()
            .jacobian(Creepage::default())
            .unwrap();
        let linear =
            Linear::new(&contact(a_over_b, 0.28)).unwrap().jacobian(Creepage::default()).unwrap();
        assert!((slope[0][0] / linear[0][0] - c11).abs() < 6e-4, "{a_over_b}");
        assert!((slope[1][1] / linear[1][1] - c22).abs() < 6e-4, "{a_over_b}");
    }
}

#[test]
fn vermeulen_johnson_says_that_it_ignores_spin() {
    let theory = VermeulenJohnson::new(&contact(2.0, 0.28)).unwrap();
    let (without, with) = (creepage(0.1, 0.2, 0.0), creepage(0.1, 0.2, 1e-3));
    assert_eq!(theory.solve(without).status, Status::Solved);
    assert_eq!(theory.solve(with).status, Status::SpinTooLarge);
    assert_eq!(theory.solve(with).force, theory.solve(without).force);
}

/// Field of `theory` on strips of the ellipse, with weights: Gauss nodes across, the midpoint rule
/// along in the angle whose cosine is `x` over the strip's half-length.
fn strips(theory: &dyn Theory, a_over_b: f64, at: Creepage) -> Vec<(f64, FieldPoint)> {
    const ALONG: i32 = 600;
    let (a, b) = (f64::sqrt(a_over_b), f64::sqrt(1.0 / a_over_b));
    let across = gauss_quad::GaussLegendre::new(400.try_into().unwrap());
    let strip = |&(node, weight): &(f64, f64)| {
        // y = b sin(pi/2 node): smooth at the ends.
        let (sin, cos) = (0.5 * PI * node).sin_cos();
        let heights = (0..ALONG).map(|i| ((f64::from(i) + 0.5) * PI / f64::from(ALONG)).sin_cos());
        let positions: Vec<_> = heights.clone().map(|(_, x)| [a * cos * x, b * sin]).collect();
        let unit = weight * 0.5 * PI * cos * cos * PI / f64::from(ALONG);
        let points = theory.field(at, &positions);
        heights.map(|(height, _)| unit * height).zip(points).collect::<Vec<_>>()
    };
    across.iter().flat_map(strip).collect()
}

/// The tractions have kinks where adhesion ends: this quadrature is good to 1e-5.
#[test]
fn tractions_add_up_to_the_force() {
    for (a_over_b, [xi, eta, chi]) in
        [(0.4, [0.5, 0.2, 0.0]), (1.0, [0.2, -0.6, 0.0]), (3.0, [-0.1, 0.1, 0.15])]
    {
        let at = creepage(xi, eta, chi);
        let theories: [Box<dyn Theory>; 4] = [
            Box::new(VermeulenJohnson::new(&contact(a_over_b, 0.28)).unwrap()),
            Box::new(ShenHedrickElkins::new(&contact(a_over_b, 0.28)).unwrap()),
            Box::new(Polach::new(&contact(a_over_b, 0.28)).unwrap()),
            Box::new(
                Polach::new(&contact(a_over_b, 0.28)).unwrap().with_reduction(0.5, 0.2).unwrap(),
            ),
        ];
        for theory in &theories {
            let mut total = [0.0; 2];
            for (weight, point) in strips(&**theory, a_over_b, at) {
                let size = point.traction[0].hypot(point.traction[1]);
                let (x, y) =
                    (point.position[0] / a_over_b.sqrt(), point.position[1] * a_over_b.sqrt());
                let bound = 1.0 - x * x - y * y;
                match point.region {
                    Region::Outside => panic!("{point:?} is inside"),
                    Region::Slip => assert!((size * size - bound).abs() < 1e-14),
                    Region::Adhesion => assert!(size * size <= bound + 1e-14),
                }
                total[0] += weight * point.traction[0] * 1.5 / PI;
                total[1] += weight * point.traction[1] * 1.5 / PI;
            }
            let force = theory.solve(at).force;
            assert!((total[0] - force.fx).abs() < 1e-5, "{a_over_b}: {total:?} {force:?}");
            assert!((total[1] - force.fy).abs() < 1e-5, "{a_over_b}: {total:?} {force:?}");
        }
    }
}

/// The slip that Vermeulen and Johnson's tractions cause vanishes on the edge of the adhesion
/// ellipse, where quadrature (outside) and closed form (inside) meet; and in the slip area it has
/// the sense of the traction for longitudinal creepage.
#[test]
fn slip_of_vermeulen_johnson() {
    for a_over_b in [0.02, 0.3, 1.0, 4.0, 50.0] {
        let theory = VermeulenJohnson::new(&contact(a_over_b, 0.3)).unwrap();
        let scale = 1.0 / theory.jacobian(Creepage::default()).unwrap()[0][0];
        for (cos, sin) in [(1.0, 0.0), (0.0, 1.0), (0.6, 0.8)] {
            let at = creepage(scale * cos, scale * sin, 0.0);
            let size = theory.adhesion(at);
            let (a, b) = (f64::sqrt(a_over_b), f64::sqrt(1.0 / a_over_b));
            let on = |angle: f64, distance: f64| {
                let (sin, cos) = angle.sin_cos();
                let x = 1.0 - size + size * distance * cos;
                theory.field(at, &[[a * x, b * size * distance * sin]])[0]
            };
            for i in 1..12 {
                let angle = f64::from(i) * PI / 6.0;
                let near = on(angle, 1.0 + 1e-10);
                assert_eq!(near.region, Region::Slip);
                let slip = near.slip[0].hypot(near.slip[1]);
                // It grows as the root of the distance.
                assert!(slip < 1e-3 * scale, "{a_over_b} {angle}: {slip}");
                assert_eq!(on(angle, 1.0 - 1e-10).region, Region::Adhesion);
            }
        }
        let at = creepage(scale, 0.0, 0.0);
        let trailing = theory.field(at, &[[-0.95 * a_over_b.sqrt(), 0.0]])[0];
        assert!(trailing.slip[0] > 0.0 && trailing.slip[1].abs() < 1e-12 * scale);
        let full = creepage(4.0 * scale, 0.0, 0.0);
        assert!(theory.adhesion(full).abs() < 1e-15);
        let leading = theory.field(full, &[[0.9 * a_over_b.sqrt(), 0.0]])[0];
        assert!(leading.slip[0] > 0.0);
    }
}

/// Without spin and reduction, Polach's force is `(2/pi)(eps/(1 + eps^2) + atan eps)` in the
/// direction of the creepage, `eps = (pi/4) C11 s` for `eta = 0`.
#[test]
fn polach_without_spin() {
    for a_over_b in [0.1, 1.0, 8.0] {
        let polach = Polach::new(&contact(a_over_b, 0.28)).unwrap();
        let linear = Linear::new(&contact(a_over_b, 0.28)).unwrap();
        for size in [1e-3, 0.3, 2.0, 50.0] {
            let eps = FRAC_PI_4 * linear.solve(creepage(size, 0.0, 0.0)).force.fx;
            let expected = FRAC_2_PI * (eps / (1.0 + eps * eps) + eps.atan());
            let force = polach.solve(creepage(size, 0.0, 0.0)).force;
            assert!((force.fx - expected).abs() < 1e-14 && force.fy == 0.0 && force.mz == 0.0);
            let oblique = polach.solve(creepage(0.6 * size, 0.8 * size, 0.0)).force;
            assert!((oblique.fx * 0.8 - oblique.fy * 0.6).abs() < 1e-14);
        }
    }
}

/// The reduction factors reduce the slope to their mean, and leave spin alone.
#[test]
fn polach_reduced() {
    let plain = Polach::new(&contact(1.0, 0.28)).unwrap();
    let reduced = plain.clone().with_reduction(0.4, 0.1).unwrap();
    let (plain, reduced) = (
        plain.jacobian(Creepage::default()).unwrap(),
        reduced.jacobian(Creepage::default()).unwrap(),
    );
    assert!((reduced[0][0] / plain[0][0] - 0.25).abs() < 1e-14);
    assert!((reduced[1][1] / plain[1][1] - 0.25).abs() < 1e-14);
    assert!((reduced[1][2] - plain[1][2]).abs() < 1e-14);
}

/// A known defect, which is stated: with `xi = chi`, however small, the lateral force of spin is
/// too small by the factor `|s_yC|/s_C = a/sqrt(1 + a^2)`.
#[test]
fn polach_underrates_spin_beside_longitudinal_creepage() {
    for (a_over_b, factor) in [(0.2, 0.41), (1.0, 0.71), (5.0, 0.91)] {
        let at = creepage(1e-6, 0.0, 1e-6);
        let force = Polach::new(&contact(a_over_b, 0.28)).unwrap().solve(at).force;
        let linear = Linear::new(&contact(a_over_b, 0.28)).unwrap().solve(at).force;
        let exact = f64::sqrt(a_over_b / (1.0 + a_over_b));
        assert!((exact - factor).abs() < 0.005);
        assert!((force.fy / linear.fy - exact).abs() < 1e-5, "{a_over_b}");
        assert!((force.fx / linear.fx - 1.0).abs() < 1e-5, "{a_over_b}");
    }
}

/// Peaks of the force of pure spin, `sigma = .28`: the second implementation's, which are read
/// off a grid, and `(3/8) w` times the largest `e/(1 + e^2)^2`, `9/(16 sqrt 3)`.
#[test]
fn polach_in_pure_spin() {
    for (a_over_b, peak, at) in [(0.2, 0.261, 1.8), (1.0, 0.607, 2.7), (5.0, 0.883, 0.6)] {
        let polach = Polach::new(&contact(a_over_b, 0.28)).unwrap();
        let force = |chi: f64| polach.solve(creepage(0.0, 0.0, chi)).force.fy;
        let (mut best, mut best_chi) = (0.0, 0.0);
        for i in 1..1000 {
            let chi = 0.01 * f64::from(i);
            if force(chi) > best {
                (best, best_chi) = (force(chi), chi);
            }
        }
        assert!((best - peak).abs() < 1e-3, "{a_over_b}: {best}");
        let weight = 1.0 + 6.3 * (1.0 - f64::exp(-a_over_b));
        let exact = 0.375 * weight * 9.0 / (16.0 * 3.0_f64.sqrt());
        assert!((best - exact).abs() < 1e-4 && best <= exact, "{a_over_b}: {best} {exact}");
        assert!((best_chi - at).abs() < 0.06, "{a_over_b}: {best_chi}");
        assert!(force(1e6).abs() < 1e-9);
    }
}

#[test]
fn nonsense_is_an_error() {
    for (a_over_b, poisson) in [(0.0, 0.3), (f64::NAN, 0.3), (1e4, 0.3), (1.0, -0.1)] {
        assert!(try_contact(a_over_b, poisson).and_then(|c| VermeulenJohnson::new(&c)).is_err());
        assert!(try_contact(a_over_b, poisson).and_then(|c| ShenHedrickElkins::new(&c)).is_err());
        assert!(try_contact(a_over_b, poisson).and_then(|c| Polach::new(&c)).is_err());
    }
    let polach = Polach::new(&contact(1.0, 0.3)).unwrap();
    for (adhesion, slip) in [(0.0, 0.0), (1.1, 0.5), (0.5, 0.6), (0.5, 0.0), (f64::NAN, 0.1)] {
        assert!(polach.clone().with_reduction(adhesion, slip).is_err());
    }
}
