//! FaStrip.

use std::f64::consts::PI;

use creepage::rolling::fastrip::{Fastrip, Variant};
use creepage::rolling::strip::StripTheory;
use creepage::rolling::{Region, Theory};

use super::cases::{
    self, CREEPAGES, Case, array, coefficients, creepage, kappa, largest_difference,
    strip_coefficients,
};

fn fastrip(a_over_b: f64, poisson: f64, variant: Variant, grid: [usize; 2]) -> Fastrip {
    Fastrip::new(a_over_b, poisson, &coefficients(a_over_b, poisson), variant, grid).unwrap()
}

fn force(case: &Case, variant: Variant, n: usize) -> [f64; 3] {
    array(fastrip(case.a_over_b, case.poisson, variant, [n, n]).solve(case.creepage).force)
}

#[test]
fn modified_reference_values() {
    let (error, case) = cases::largest_error(
        "fastrip_modif_conv",
        |_| true,
        |case| force(case, Variant::Modified, 300),
    );
    // The bound.
    assert!(error < 0.004, "{error} {case}");
}

/// Against CONTACT's own, within what its coarser square grid and its three-digit coefficients
/// leave.
#[test]
fn original_reference_values() {
    let (error, case) = cases::largest_error(
        "fastrip_orig_conv",
        |_| true,
        |case| force(case, Variant::Original, 300),
    );
    assert!(error < 0.004, "{error} {case}");
}

#[test]
fn error_against_the_full_theory() {
    let [rms, worst, moment] =
        cases::error_against_full_theory(|case| force(case, Variant::Modified, 100));
    assert!(
        (rms - 0.0269).abs() < 0.001 && worst < 0.09 && moment < 0.021,
        "{rms} {worst} {moment}"
    );
}
