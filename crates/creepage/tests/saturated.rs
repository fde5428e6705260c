//! The theory of large creepage and spin against the reference, its symmetries and a plain
//! integral over the contact.

use std::f64::consts::PI;

use creepage::rolling::saturated::Saturated;
use creepage::rolling::{Creepage, Force, Region, Status, Theory};
use serde_json::Value;

const REFERENCE: &str = include_str!("data/saturated.json");

fn creepage(xi: f64, eta: f64, chi: f64) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap()
}

fn array(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

fn force(a_over_b: f64, creepage: Creepage) -> [f64; 3] {
    array(Saturated::new(a_over_b).unwrap().solve(creepage).force)
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
