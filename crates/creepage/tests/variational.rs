//! The numerical theory of chapter 5: reference cases, symmetries, and one minimum from every
//! start.
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss
)]

mod common;

use common::contact;
use creepage::variational::{Settings, Start, TractionBound, Variational, Weight};
use creepage::{Creepage, Force, Region, Status, Theory};
use proptest::prelude::*;
use serde_json::Value;

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} is no number"))
}

fn count(value: &Value, key: &str) -> usize {
    number(value, key) as usize
}

/// 36 cases computed by two independent discretizations (see data/README.md).
#[test]
fn forces_of_the_reference_cases() {
    let data: Value = serde_json::from_str(include_str!("data/variational.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 36);
    for case in cases {
        let weight = if case["weight"] == "W1" { Weight::Elliptic } else { Weight::Uniform };
        let mesh = [count(case, "nx"), count(case, "ny")];
        let settings = Settings {
            degree: count(case, "M"),
            mesh,
            weight,
            bound: TractionBound::Unchecked,
            adhesion_weight: None,
        };
        let theory =
            Variational::new(&contact(number(case, "a_over_b"), number(case, "sigma")), settings)
                .unwrap();
        assert_eq!(theory.mesh().len(), count(case, "points"));
        let creepage =
            Creepage::new(number(case, "xi"), number(case, "eta"), number(case, "chi")).unwrap();
        let found = theory.solve_from(creepage, &Start::FullSliding);
        let force = found.solution.force;
        for (value, key) in [(force.fx, "fx"), (force.fy, "fy"), (force.mz, "mz")] {
            // Both are converged to about 1e-10.
            let expected = number(case, key);
            assert!((value - expected).abs() < 1e-9, "{key}: {value}, not {expected}: {case}");
        }
        assert!((found.mean_integrand - number(case, "I_mean")).abs() < 1e-12);
        assert_eq!(found.aberrations, count(case, "aberrations"));
        assert_eq!(found.solution.status, Status::Solved);
    }
}

fn close(a: Force, b: Force, tolerance: f64) -> bool {
    (a.fx - b.fx).abs().max((a.fy - b.fy).abs()).max((a.mz - b.mz).abs()) < tolerance
}

/// 1260 cases, of which each start must find the same minimum.
#[test]
fn every_case_converges_to_one_minimum_from_three_starts() {
    let mut cases = 0;
    for a_over_b in [0.2, 0.5, 1.0, 2.0] {
        let theory = Variational::new(&contact(a_over_b, 0.28), Settings::default()).unwrap();
        for chi in [0.0, 0.5, 1.0, 2.0, 5.0] {
            for size in [0.1, 0.2, 0.35, 0.6, 1.0, 1.7, 2.5, 3.5, 5.0] {
                for angle in [-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0_f64] {
                    let (sin, cos) = angle.to_radians().sin_cos();
                    let creepage = Creepage::new(size * cos, size * sin, chi).unwrap();
                    let [first, second, third] = [Start::FullSliding, Start::Adhesion, Start::Zero]
                        .map(|start| theory.solve_from(creepage, &start));
                    for other in [&first, &second, &third] {
                        let place = format!("a/b {a_over_b}, {creepage:?}");
                        assert_ne!(other.solution.status, Status::NotConverged, "{place}");
                        // Convergence is to 1e-9 in the unknowns.
                        let (here, there) = (first.solution.force, other.solution.force);
                        assert!(close(here, there, 1e-8), "{place}: {here:?}, {there:?}");
                    }
                    cases += 1;
                }
            }
        }
    }
    assert_eq!(cases, 1260);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// (4.28): mirror and exchange of directions. Each of the four cases is solved on its own.
    #[test]
    fn symmetries(
        a_over_b in 0.2..2.5_f64, poisson in 0.0..0.5_f64,
        size in 0.05..4.0_f64, angle in -3.2..3.2_f64, chi in -5.0..5.0_f64,
    ) {
        let theory = Variational::new(&contact(a_over_b, poisson), Settings::default()).unwrap();
        let (sin, cos) = angle.sin_cos();
        let (xi, eta) = (size * cos, size * sin);
        let force = |xi, eta, chi| theory.solve(Creepage::new(xi, eta, chi).unwrap()).force;
        let Force { fx, fy, mz } = force(xi, eta, chi);
        // Twice the convergence tolerance.
        let reversed = Force { fx: -fx, fy: -fy, mz: -mz };
        let mirrored = Force { fx, fy: -fy, mz: -mz };
        let backward = Force { fx: -fx, fy, mz };
        // (4.28) to 1e-9: each solution is converged to 1e-9 and better.
        prop_assert!(close(force(-xi, -eta, -chi), reversed, 1e-9));
        prop_assert!(close(force(xi, -eta, -chi), mirrored, 1e-9));
        prop_assert!(close(force(-xi, eta, chi), backward, 1e-9));
    }

    /// Resultants of the polynomials against quadrature of the traction over the ellipse.
    #[test]
    fn forces_are_the_resultants_of_the_traction(
        a_over_b in 0.1..8.0_f64, xi in -2.0..2.0_f64, eta in -2.0..2.0_f64, chi in -3.0..3.0_f64,
    ) {
        let theory = Variational::new(&contact(a_over_b, 0.3), Settings::default()).unwrap();
        let creepage = Creepage::new(xi, eta, chi).unwrap();
        let solution = theory.solve(creepage);
        let resultant = resultant(&theory, a_over_b, creepage);
        // The quadrature is exact but for rounding.
        prop_assert!(close(solution.force, resultant, 1e-12));
    }
}

/// Gauss-like quadrature on the hemisphere: `x = a sin t cos f`, `y = b sin t sin f`, exact for
/// the traction's polynomial times the square root.
fn resultant(theory: &Variational, a_over_b: f64, creepage: Creepage) -> Force {
    const N: usize = 40;
    let (a, b) = (a_over_b.sqrt(), a_over_b.sqrt().recip());
    let mut nodes = Vec::new();
    let mut weights = Vec::new();
    // With z = cos t the traction's square root is z, and dx dy = z dz df: polynomials in z.
    for (z, weight) in gauss_legendre() {
        let r = (1.0 - z * z).sqrt();
        for k in 0..N {
            let (sin, cos) = (std::f64::consts::TAU * k as f64 / N as f64).sin_cos();
            nodes.push([a * r * cos, b * r * sin]);
            weights.push(weight * z * std::f64::consts::TAU / N as f64);
        }
    }
    let field = theory.field(creepage, &nodes);
    // N = 2/3 pi ab times the peak pressure.
    let unit = 1.5 / std::f64::consts::PI;
    let mut force = Force::default();
    for (point, weight) in field.iter().zip(weights) {
        let [x, y] = point.position;
        let [tx, ty] = point.traction;
        force.fx += unit * weight * tx;
        force.fy += unit * weight * ty;
        force.mz += unit * weight * (x * ty - y * tx);
    }
    force
}

/// Nodes and weights on `[0, 1]`.
fn gauss_legendre() -> Vec<(f64, f64)> {
    let rule = gauss_quad::GaussLegendre::new(12.try_into().unwrap());
    rule.into_iter().map(|(x, w)| (0.5 * (x + 1.0), 0.5 * w)).collect()
}

#[test]
fn no_creepage_is_no_force() {
    let theory = Variational::new(&contact(1.0, 0.28), Settings::default()).unwrap();
    let found = theory.solve(Creepage::default());
    assert_eq!(found.status, Status::Solved);
    assert!(found.force.magnitude() < f64::MIN_POSITIVE);
}

#[test]
fn small_creepage_is_reported_and_more_degree_helps() {
    let creepage = Creepage::new(0.1, 0.0, 0.0).unwrap();
    let coarse =
        Variational::new(&contact(1.0, 0.28), Settings::default()).unwrap().solve(creepage);
    assert_eq!(coarse.status, Status::CreepageTooSmall);
    let fine =
        Variational::new(&contact(1.0, 0.28), Settings::of_degree(8)).unwrap().solve(creepage);
    assert_eq!(fine.status, Status::Solved);
    assert!(fine.force.fx > 2.0 * coarse.force.fx);
}

#[test]
fn large_creepage_is_full_sliding() {
    let theory = Variational::new(&contact(0.7, 0.3), Settings::default()).unwrap();
    let creepage = Creepage::new(60.0, -80.0, 0.0).unwrap();
    let found = theory.solve(creepage);
    // The slip of elastic bodies turns the traction by about 1/|creepage|.
    assert!(close(found.force, Force { fx: 0.6, fy: -0.8, mz: 0.0 }, 0.02));
    let field = theory.field(creepage, &[[0.1, 0.2], [5.0, 0.0]]);
    assert_eq!(field[0].region, Region::Slip);
    assert!(field[1].traction[0].hypot(field[1].traction[1]) < f64::MIN_POSITIVE);
}

#[test]
fn nonsense_is_an_error_that_names_the_field() {
    let message =
        |settings| Variational::new(&contact(1.0, 0.3), settings).unwrap_err().to_string();
    assert!(message(Settings::of_degree(99)).contains("degree = 99"));
    let mesh = Settings { mesh: [2, 10], ..Settings::default() };
    assert!(message(mesh).contains("mesh = 2 x 10"));
}

/// The same case from a cold start: the exact minimum, which the print approaches to 5e-8.
#[test]
fn figure_12_at_the_exact_minimum() {
    let data: Value = serde_json::from_str(include_str!("data/figure12.json")).unwrap();
    let theory = Variational::new(&contact(0.5, 0.28), Settings::default()).unwrap();
    let (sin, cos) = (-30.0_f64).to_radians().sin_cos();
    let creepage = Creepage::new(1.7 * cos, 1.7 * sin, 2.0).unwrap();
    let found = theory.solve_from(creepage, &Start::FullSliding);
    let monomials: Vec<f64> = theory
        .traction_polynomials(&found.tau)
        .unwrap()
        .iter()
        .flat_map(|polynomial| polynomial.coefficients().to_vec())
        .collect();
    let columns = [(&data["printed"]["TAU"], 1e-7), (&data["exact_minimum_tau"], 1e-9)];
    for (column, tolerance) in columns {
        for (value, expected) in monomials.iter().zip(column.as_array().unwrap()) {
            assert!((value - expected.as_f64().unwrap()).abs() < tolerance);
        }
    }
    // The list of the printed page: T, S and the one aberration.
    assert_eq!(found.aberrations, 1);
    let points = data["points"].as_array().unwrap();
    assert_eq!(points.len(), found.points.len());
    for (point, expected) in found.points.iter().zip(points) {
        assert!((point.t - number(expected, "T")).abs() < 1e-6);
        assert!((point.s - number(expected, "S")).abs() < 1e-6);
    }
}
