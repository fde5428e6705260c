//! The theory of large creepage and spin against the reference, its symmetries and a plain
//! integral over the contact.

// A theory that cannot be prepared fails the test.
#![allow(clippy::unwrap_used)]

mod common;

use std::f64::consts::PI;

use common::{contact, creepage, try_contact};
use creepage::approximate::saturated::Saturated;
use creepage::{Creepage, Force, Region, Status, Theory};
use serde_json::Value;

const REFERENCE: &str = include_str!("data/saturated.json");

fn array(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

fn force(a_over_b: f64, creepage: Creepage) -> [f64; 3] {
    array(Saturated::new(&contact(a_over_b, 0.28)).unwrap().solve(creepage).force)
}

fn assert_close(actual: [f64; 3], expected: [f64; 3], tolerance: f64, case: &str) {
    for (actual, expected) in actual.iter().zip(expected) {
        assert!((actual - expected).abs() <= tolerance, "{case}: {actual} is not {expected}");
    }
}

/// `a <= b` as printed; and `a > b` by the symmetry (4.101), the third with its sign corrected.
#[test]
fn reference_values() {
    let cases: Vec<Value> = serde_json::from_str(REFERENCE).unwrap();
    assert_eq!(cases.len(), 60);
    for case in &cases {
        let number = |name: &str| case[name].as_f64().unwrap();
        let (g, upsilon) = (number("g"), number("upsilon"));
        let (sin, cos) = number("alpha_deg").to_radians().sin_cos();
        let (xi, eta) = (upsilon * cos, upsilon * sin);
        let [fx, fy, mz] = [number("fx"), number("fy"), number("mz")];
        for chi in [1.0, 0.01, 300.0] {
            let ahead = creepage(chi * xi, chi * eta, chi);
            assert_close(force(g, ahead), [fx, fy, mz], 1e-10, &case.to_string());
            let back = creepage(-chi * xi, -chi * eta, -chi);
            assert_close(force(g, back), [-fx, -fy, -mz], 1e-10, &case.to_string());
            let turned = creepage(chi * eta, -chi * xi, chi);
            assert_close(force(1.0 / g, turned), [fy, -fx, mz], 1e-10, &case.to_string());
        }
    }
}

/// (4.101): mirror images about both axes, and exchange of the axes (third relation with its sign
/// corrected), for poles inside and outside.
#[test]
fn symmetries() {
    for a_over_b in [1e-3, 0.2, 0.9, 3.0] {
        for (xi, eta) in [(0.3, 0.1), (0.9, -1.4), (-5.0, 2.0)] {
            let [fx, fy, mz] = force(a_over_b, creepage(xi, eta, 1.0));
            let case = format!("{a_over_b} {xi} {eta}");
            let tolerance = 1e-12;
            assert_close(force(a_over_b, creepage(-xi, eta, 1.0)), [-fx, fy, mz], tolerance, &case);
            assert_close(force(a_over_b, creepage(xi, -eta, 1.0)), [fx, -fy, mz], tolerance, &case);
            let exchanged = force(1.0 / a_over_b, creepage(eta, xi, 1.0));
            assert_close(exchanged, [fy, fx, mz], tolerance, &case);
        }
    }
}

/// The circle: force `9 pi/32`, moment `9 pi/128`, whatever the direction.
#[test]
fn pole_on_the_edge_of_the_circle() {
    for i in 0..40 {
        let (sin, cos) = (0.17 * f64::from(i)).sin_cos();
        for distance in [1.0 - 1e-13, 1.0, 1.0 + 1e-13] {
            let f = 9.0 * PI / 32.0;
            let expected = [f * cos, f * sin, 9.0 * PI / 128.0];
            let actual = force(1.0, creepage(distance * cos, distance * sin, 1.0));
            assert_close(actual, expected, 1e-12, &format!("{cos} {sin} {distance}"));
        }
    }
}

/// The closed form and the quadrature meet on the edge of any ellipse.
#[test]
fn continuous_where_the_pole_leaves_the_contact() {
    for a_over_b in [1e-3, 0.03, 0.5, 2.0, 1e3] {
        for i in 0..40 {
            let (sin, cos) = (0.17 * f64::from(i)).sin_cos();
            let (xi, eta) = (sin / f64::sqrt(a_over_b), cos * f64::sqrt(a_over_b));
            let at = |distance: f64| force(a_over_b, creepage(distance * xi, distance * eta, 1.0));
            // The forces change by 1e-12 in between.
            assert_close(at(1.0 - 1e-12), at(1.0 + 1e-12), 1e-10, &format!("{a_over_b} {i}"));
        }
    }
}

/// The traction's integral over the hemisphere above the contact, with the pole outside, where it
/// is smooth.
#[test]
fn tractions_add_up_to_the_force() {
    let rule = gauss_quad::GaussLegendre::new(60.try_into().unwrap());
    for (a_over_b, xi, eta) in [(0.5, 2.5, 1.0), (1.0, -1.0, 1.5), (3.0, 1.5, 2.0)] {
        let theory = Saturated::new(&contact(a_over_b, 0.28)).unwrap();
        let (a, b) = (f64::sqrt(a_over_b), f64::sqrt(1.0 / a_over_b));
        let case = creepage(xi, eta, -1.0);
        let mut total = [0.0; 3];
        for (node, weight) in &rule {
            let z = 0.5 * (1.0 + node);
            for i in 0..120 {
                let (sin, cos) = (f64::from(i) * PI / 60.0).sin_cos();
                let r = (1.0 - z * z).sqrt();
                let point = theory.field(case, &[[a * r * cos, b * r * sin]])[0];
                assert_eq!(point.region, Region::Slip);
                let ([x, y], [p, q]) = (point.position, point.traction);
                for (total, part) in total.iter_mut().zip([p, q, x * q - y * p]) {
                    *total += part * 3.0 / (2.0 * PI) * z * 0.5 * weight * PI / 60.0;
                }
            }
        }
        assert_close(total, force(a_over_b, case), 1e-12, &format!("{a_over_b}"));
    }
}

/// Force and moment are the gradient of a convex function of degree one: the derivative is
/// symmetric, and vanishes along the creepage itself.
#[test]
fn derivative_is_a_hessian() {
    let theory = Saturated::new(&contact(0.6, 0.28)).unwrap();
    for at in [[0.2, 0.3, 1.0], [2.0, -1.0, 0.5], [1.0, 0.4, 0.0], [0.0, 0.0, -2.0]] {
        let matrix = theory.jacobian(creepage(at[0], at[1], at[2])).unwrap();
        for (i, row) in matrix.iter().enumerate() {
            let along: f64 = row.iter().zip(at).map(|(entry, x)| entry * x).sum();
            assert!(along.abs() < 1e-13, "{at:?}");
            assert!(row[i] >= -1e-13, "{at:?}");
            for (j, entry) in row.iter().enumerate() {
                assert!((entry - matrix[j][i]).abs() < 1e-13, "{at:?}");
            }
        }
    }
}

#[test]
fn no_creepage_has_no_direction() {
    let solution = Saturated::new(&contact(2.0, 0.28)).unwrap().solve(Creepage::default());
    assert_eq!(solution.status, Status::CreepageTooSmall);
    assert_close(array(solution.force), [0.0; 3], 0.0, "rest");
}

/// Without spin `F = mu N` and `m_z = 0`; a faint spin brings a moment in proportion.
#[test]
fn pole_at_infinity() {
    for a_over_b in [0.01, 1.0, 7.0] {
        assert_close(force(a_over_b, creepage(3.0, -4.0, 0.0)), [0.6, -0.8, 0.0], 1e-14, "no spin");
        let [_, _, large] = force(a_over_b, creepage(3.0, -4.0, 1e-5));
        let [_, _, small] = force(a_over_b, creepage(3.0, -4.0, 1e-7));
        // Rounding of 1e-15 in a moment of 1e-7; the next term is of relative order 1e-10.
        assert!((large / small / 100.0 - 1.0).abs() < 1e-7, "{a_over_b} {large} {small}");
    }
}

#[test]
fn nonsense_is_an_error() {
    for a_over_b in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-4, 1e4] {
        let found = try_contact(a_over_b, 0.28).and_then(|c| Saturated::new(&c));
        assert_eq!(found.unwrap_err().quantity, "a_over_b");
    }
}
