//! The derivative of the full theory, and the inverse problem that rests on it.

use creepage::Creepage;
use creepage::coulomb::{Exact, InverseError, Known, Resolution, Workspace};

use crate::support::components;

fn creepage([xi, eta, chi]: [f64; 3]) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap()
}

/// Small, for a difference must not reach over a kink.
const STEP: f64 = 1e-4;

/// Central differences of the fourth order and the derivative, the largest difference over the
/// largest entry.
fn disagreement(theory: &Exact, case: [f64; 3], workspace: &mut Workspace) -> f64 {
    theory.solve_with(creepage(case), workspace);
    let derivative = theory.derivative(workspace);
    let mut worst = 0.0_f64;
    for column in 0..3 {
        let mut at = |steps: f64| {
            let mut moved = case;
            moved[column] += STEP * steps;
            components(theory.solve_with(creepage(moved), workspace).force)
        };
        let [near, back, far, far_back] = [at(1.0), at(-1.0), at(2.0), at(-2.0)];
        for row in 0..3 {
            let central = 8.0 * (near[row] - back[row]) - (far[row] - far_back[row]);
            worst = worst.max((central / (12.0 * STEP) - derivative[row][column]).abs());
        }
    }
    worst / derivative.iter().flatten().fold(0.0, |m: f64, d| m.max(d.abs()))
}

/// 40 cases, none with a kink (an element that changes between adhesion and slip) in its step.
#[test]
fn the_derivative_is_that_of_the_solver() {
    for (ratio, poisson) in [(0.3, 0.3), (1.0, 0.0), (1.0, 0.28), (4.0, 0.45)] {
        let theory = Exact::new(ratio, poisson, Resolution::FAST).unwrap();
        let mut workspace = theory.workspace();
        for k in 0..10 {
            let t = f64::from(k);
            let case = [(1.7 * t).sin(), 0.9 * (2.3 * t + 1.0).cos(), 2.5 * (0.9 * t).sin()];
            let found = disagreement(&theory, case, &mut workspace);
            // Tractions solved to 1e-8 leave some 1e-11 in forces, 1e-7 in their differences.
            assert!(found < 1e-6, "{case:?}: {found}");
        }
    }
}

#[test]
fn the_inverse_finds_the_creepage_back() {
    let theory = Exact::new(1.5, 0.28, Resolution::FAST).unwrap();
    let mut workspace = theory.workspace();
    for case in [[0.3, 0.2, 0.1], [0.6, -0.3, 0.4], [-0.4, 0.5, -0.6], [0.05, 0.0, 0.8]] {
        let force = theory.solve_with(creepage(case), &mut workspace).force;
        let known = Known {
            fx: Some(force.fx),
            fy: Some(force.fy),
            mz: Some(force.mz),
            ..Known::default()
        };
        let found = theory.find(known, &mut workspace).unwrap().creepage;
        // Forces to 1e-7 over derivatives of some tenths.
        for (found, expected) in [found.xi(), found.eta(), found.chi()].into_iter().zip(case) {
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
        }
    }
}

#[test]
fn any_mix_of_three_will_do() {
    let theory = Exact::new(0.7, 0.28, Resolution::FAST).unwrap();
    let mut workspace = theory.workspace();
    let known = Known { xi: Some(0.4), fy: Some(0.3), mz: Some(0.1), ..Known::default() };
    let found = theory.find(known, &mut workspace).unwrap();
    assert!((found.creepage.xi() - 0.4).abs() < 1e-15);
    assert!((found.solution.force.fy - 0.3).abs() < 1e-6);
    assert!((found.solution.force.mz - 0.1).abs() < 1e-6);
}

/// A ball with spin rolls sideways so that no lateral force arises: near zero the creepage is
/// `-C23/C22 chi`.
#[test]
fn a_free_ball_creeps_against_its_spin() {
    let theory = Exact::new(1.0, 0.0, Resolution::STANDARD).unwrap();
    let known = Known { xi: Some(0.0), chi: Some(1e-3), fy: Some(0.0), ..Known::default() };
    let found = theory.find(known, &mut theory.workspace()).unwrap();
    let expected = -4.0 / 3.0 / (32.0 / (3.0 * std::f64::consts::PI)) * 1e-3;
    // The tolerance of the force is 1e-4 of what one part in a thousand of spin gives.
    assert!((found.creepage.eta() / expected - 1.0).abs() < 0.01, "{}", found.creepage.eta());
}

#[test]
fn what_cannot_be_is_refused() {
    let theory = Exact::new(1.0, 0.28, Resolution::FAST).unwrap();
    let mut workspace = theory.workspace();
    let mut find = |known| theory.find(known, &mut workspace).unwrap_err();
    let two = Known { xi: Some(0.1), fy: Some(0.0), ..Known::default() };
    assert_eq!(find(two), InverseError::NotThree { given: 2 });
    let infinite = Known { xi: Some(f64::NAN), fy: Some(0.0), chi: Some(0.0), ..Known::default() };
    assert!(matches!(find(infinite), InverseError::InvalidValue(_)));
    for known in [
        Known { fx: Some(1.2), eta: Some(0.0), chi: Some(0.0), ..Known::default() },
        Known { fx: Some(0.9), fy: Some(0.9), chi: Some(0.0), ..Known::default() },
        Known { fy: Some(0.95), xi: Some(0.0), eta: Some(0.0), ..Known::default() },
    ] {
        let InverseError::NotReachable { nearest, .. } = find(known) else {
            unreachable!("{known:?} was found");
        };
        assert!(nearest.magnitude() <= 1.01);
    }
}
