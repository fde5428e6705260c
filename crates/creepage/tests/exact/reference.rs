//! The reference cases, and the convergence to the truth.

use creepage::Status;
use creepage::coulomb::{Exact, Resolution};
use creepage_validation::ReferenceCase;

use crate::support::{components, solve};

/// Errors of the force and of the moment beyond the reference's uncertainty, sorted.
fn reference_errors(resolution: Resolution) -> [Vec<f64>; 2] {
    let cases = creepage_validation::steady_rolling().unwrap();
    let mut errors = [Vec::new(), Vec::new()];
    let contact = |case: &ReferenceCase| (case.a_over_b, case.poisson);
    for alike in cases.chunk_by(|one, two| contact(one) == contact(two)) {
        let (a_over_b, poisson) = contact(&alike[0]);
        let theory = Exact::new(a_over_b, poisson, resolution).unwrap();
        for case in alike {
            let found = theory.solve_with(case.creepage, &mut theory.workspace());
            assert_eq!(found.status, Status::Solved);
            let values = [found.force, case.force, case.uncertainty.unwrap()].map(components);
            let beyond = |k: usize| {
                let [value, expected, uncertainty] = [0, 1, 2].map(|i: usize| values[i][k]);
                ((value - expected).abs() - uncertainty).max(0.0)
            };
            errors[0].push(beyond(0).hypot(beyond(1)));
            errors[1].push(beyond(2));
        }
    }
    for list in &mut errors {
        list.sort_by(f64::total_cmp);
    }
    errors
}

/// Median, root mean square and worst of a sorted list.
fn statistics(sorted: &[f64]) -> [f64; 3] {
    let square = sorted.iter().map(|e| e * e).sum::<f64>() / sorted.len() as f64;
    [sorted[sorted.len() / 2], square.sqrt(), sorted[sorted.len() - 1]]
}

/// 132 cases, with the accuracies that the documentation promises.
#[test]
fn reference_cases() {
    for (resolution, limits) in [
        (Resolution::FAST, [0.006, 0.006, 0.015]),
        (Resolution::STANDARD, [0.002, 0.004, 0.005]),
        (Resolution::FINE, [0.0005, 0.001, 0.002]),
    ] {
        let [force, moment] = reference_errors(resolution);
        assert_eq!(force.len(), 132);
        for (found, limit) in statistics(&force).into_iter().zip(limits) {
            assert!(found <= limit, "{resolution:?}: force {:?}", statistics(&force));
        }
        for (found, limit) in statistics(&moment).into_iter().zip(limits) {
            assert!(found <= 2.0 * limit, "{resolution:?}: moment {:?}", statistics(&moment));
        }
    }
}

/// The second order shows over two refinements; from one to the next the error depends on where
/// the border of the adhesion area falls between elements.
#[test]
fn convergence_is_of_high_order() {
    let reference = Exact::new(0.8, 0.28, Resolution::new(48, 40).unwrap()).unwrap();
    let grids = [(8, 8), (16, 16), (32, 32)].map(|(along, across)| {
        Exact::new(0.8, 0.28, Resolution::new(along, across).unwrap()).unwrap()
    });
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
