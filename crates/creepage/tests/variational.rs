//! The numerical theory of chapter 5 against its reference cases.

use creepage::rolling::variational::{Settings, Start, Variational, Weight};
use creepage::rolling::{Creepage, Status};
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
        let settings = Settings { degree: count(case, "M"), mesh, weight };
        let theory =
            Variational::new(number(case, "a_over_b"), number(case, "sigma"), settings).unwrap();
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
