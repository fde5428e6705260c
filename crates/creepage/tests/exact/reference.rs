//! The reference cases, and the convergence to the truth.

use creepage::coulomb::Resolution;
use creepage::{Status, Theory};

use crate::common::{ReferenceCase, steady_rolling};
use crate::support::{exact, solve};

/// Errors of the force and of the moment beyond the reference's uncertainty, sorted.
fn reference_errors(resolution: Resolution) -> [Vec<f64>; 2] {
    let cases = steady_rolling();
    let mut errors = [Vec::new(), Vec::new()];
    for alike in cases.chunk_by(|one, two| one.contact() == two.contact()) {
        let theory = exact(alike[0].a_over_b, alike[0].poisson, resolution);
        for case in alike {
            let found = theory.solve(case.creepage());
            assert_eq!(found.status, Status::Solved);
            let [fx, fy, mz] = beyond_uncertainty(case, found.force.components());
            errors[0].push(fx.hypot(fy));
            errors[1].push(mz);
        }
    }
    for list in &mut errors {
        list.sort_by(f64::total_cmp);
    }
    errors
}

fn beyond_uncertainty(case: &ReferenceCase, force: [f64; 3]) -> [f64; 3] {
    let expected = [case.fx, case.fy, case.mz];
    let uncertainty = [case.u_fx, case.u_fy, case.u_mz];
    [0, 1, 2].map(|k| ((force[k] - expected[k]).abs() - uncertainty[k]).max(0.0))
}

/// Median, root mean square and worst of a sorted list.
fn statistics(sorted: &[f64]) -> [f64; 3] {
    let square = sorted.iter().map(|e| e * e).sum::<f64>() / sorted.len() as f64;
    [sorted[sorted.len() / 2], square.sqrt(), sorted[sorted.len() - 1]]
}

/// 132 cases: median, root mean square and worst as the table in the documentation of `Exact`
/// prints them; half a unit of the last printed digit is added.
#[test]
fn reference_cases() {
    for (resolution, printed, half_a_unit) in [
        (Resolution::FAST, [0.01, 0.08, 0.28], [0.005, 0.005, 0.005]),
        (Resolution::STANDARD, [0.00, 0.02, 0.13], [0.005, 0.005, 0.005]),
        (Resolution::FINE, [0.00, 0.01, 0.04], [0.005, 0.005, 0.005]),
    ] {
        let [force, moment] = reference_errors(resolution);
        assert_eq!(force.len(), 132);
        let (force, moment) = (statistics(&force), statistics(&moment));
        for k in 0..3 {
            let limit = 0.01 * (printed[k] + half_a_unit[k]);
            assert!(force[k] <= limit, "{resolution:?}: force {force:?}");
            assert!(moment[k] <= limit, "{resolution:?}: moment {moment:?}");
        }
    }
}

/// The second order shows over two refinements; from one to the next the error depends on where
/// the border of the adhesion area falls between elements.
#[test]
fn convergence_is_of_high_order() {
    let reference = exact(0.8, 0.28, Resolution::new(48, 40).unwrap());
    let grids = [(8, 8), (16, 16), (32, 32)]
        .map(|(along, across)| exact(0.8, 0.28, Resolution::new(along, across).unwrap()));
    let cases =
        [[0.9, 0.2, 0.3], [0.5, 1.0, 0.5], [0.3, -0.8, 0.4], [1.5, 0.4, 1.0], [0.0, 0.6, 0.0]];
    let mut errors = [0.0; 3];
    for case in cases {
        let truth = solve(&reference, case).force;
        for (error, theory) in errors.iter_mut().zip(&grids) {
            let force = solve(theory, case).force;
            *error += (force.fx - truth.fx).hypot(force.fy - truth.fy);
        }
    }
    let order = 0.5 * (errors[0] / errors[2]).log2();
    assert!(order > 1.5, "order {order}, errors {errors:?}");
}
