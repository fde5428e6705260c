//! The derivative of the full theory, and the inverse problem that rests on it.

use creepage::Theory;
use creepage::coulomb::{Constraints, Exact, InverseError, Resolution};

use crate::common::at;
use crate::support::{components, exact};

/// Large enough for forces from tractions that are iterated to 1e-6, which leaves some 1e-8.
const STEP: f64 = 5e-4;

/// Central differences of the fourth order and the derivative, the largest difference over the
/// largest entry.
fn disagreement(theory: &Exact, case: [f64; 3]) -> f64 {
    let derivative = theory.jacobian(at(case)).unwrap();
    let mut worst = 0.0_f64;
    for column in 0..3 {
        let force = |steps: f64| {
            let mut moved = case;
            moved[column] += STEP * steps;
            components(theory.solve(at(moved)).force)
        };
        let [near, back, far, far_back] = [force(1.0), force(-1.0), force(2.0), force(-2.0)];
        for row in 0..3 {
            let central = 8.0 * (near[row] - back[row]) - (far[row] - far_back[row]);
            worst = worst.max((central / (12.0 * STEP) - derivative[row][column]).abs());
        }
    }
    worst / derivative.iter().flatten().fold(0.0, |m: f64, d| m.max(d.abs()))
}

/// 40 cases, through signs, mirror images and extrapolation. The solver's own derivative is held to
/// 1e-6 beside it, where it may iterate further.
#[test]
fn the_derivative_is_that_of_the_solver() {
    for (ratio, poisson) in [(0.3, 0.3), (1.0, 0.0), (1.0, 0.28), (4.0, 0.45)] {
        let theory = exact(ratio, poisson, Resolution::FAST);
        for k in 0..10 {
            let t = f64::from(k);
            let case = [(1.7 * t).sin(), 0.9 * (2.3 * t + 1.0).cos(), 2.5 * (0.9 * t).sin()];
            let found = disagreement(&theory, case);
            // 5e-8 over the step, and the ends of rounded corners within it.
            assert!(found < 5e-4, "{case:?}: {found}");
        }
    }
}

#[test]
fn the_inverse_finds_the_creepage_back() {
    let theory = exact(1.5, 0.28, Resolution::FAST);
    for case in [[0.3, 0.2, 0.1], [0.6, -0.3, 0.4], [-0.4, 0.5, -0.6], [0.05, 0.0, 0.8]] {
        let force = theory.solve(at(case)).force;
        let constraints = Constraints {
            fx: Some(force.fx),
            fy: Some(force.fy),
            mz: Some(force.mz),
            ..Constraints::default()
        };
        let found = theory.find(constraints).unwrap().creepage();
        // Forces to 1e-7 over derivatives of some tenths.
        for (found, expected) in found.components().into_iter().zip(case) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
}

#[test]
fn any_mix_of_three_will_do() {
    let theory = exact(0.7, 0.28, Resolution::FAST);
    let constraints =
        Constraints { xi: Some(0.4), fy: Some(0.3), mz: Some(0.1), ..Constraints::default() };
    let found = theory.find(constraints).unwrap();
    assert!((found.creepage().xi() - 0.4).abs() < 1e-15);
    assert!((found.solution().force.fy - 0.3).abs() < 1e-6);
    assert!((found.solution().force.mz - 0.1).abs() < 1e-6);
}

/// A ball with spin rolls sideways so that no lateral force arises: near zero the creepage is
/// `-C23/C22 chi`.
#[test]
fn a_free_ball_creeps_against_its_spin() {
    let theory = exact(1.0, 0.0, Resolution::STANDARD);
    let constraints =
        Constraints { xi: Some(0.0), chi: Some(1e-3), fy: Some(0.0), ..Constraints::default() };
    let found = theory.find(constraints).unwrap();
    let expected = -4.0 / 3.0 / (32.0 / (3.0 * std::f64::consts::PI)) * 1e-3;
    // The tolerance of the force is 1e-4 of what one part in a thousand of spin gives.
    assert!((found.creepage().eta() / expected - 1.0).abs() < 0.01, "{}", found.creepage().eta());
}

#[test]
fn what_cannot_be_is_refused() {
    let theory = exact(1.0, 0.28, Resolution::FAST);
    let find = |constraints| theory.find(constraints).unwrap_err();
    let two = Constraints { xi: Some(0.1), fy: Some(0.0), ..Constraints::default() };
    assert_eq!(find(two), InverseError::NotThree { given: 2 });
    let infinite =
        Constraints { xi: Some(f64::NAN), fy: Some(0.0), chi: Some(0.0), ..Constraints::default() };
    assert!(matches!(find(infinite), InverseError::InvalidValue(_)));
    for constraints in [
        Constraints { fx: Some(1.2), eta: Some(0.0), chi: Some(0.0), ..Constraints::default() },
        Constraints { fx: Some(0.9), fy: Some(0.9), chi: Some(0.0), ..Constraints::default() },
        Constraints { fy: Some(0.95), xi: Some(0.0), eta: Some(0.0), ..Constraints::default() },
    ] {
        let InverseError::NotReachable { nearest, .. } = find(constraints) else {
            unreachable!("{constraints:?} was found");
        };
        assert!(nearest.magnitude() <= 1.01);
    }
}
