//! Newton's method as the programme of 1967 ran it (5.12): undamped, with the exact Hessian,
//! stopped by the change of the monomials' coefficients.

use nalgebra::DVector;

use super::functional::{Expansion, Functional};
use super::newton::{Minimum, Step};
use super::{Limits, Variational};

/// One line `TOEG GEV GEMAFW` of the printed page (Fig. 12).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonStep {
    /// TOEG, the change that would be small enough: `delta` times the largest coefficient.
    pub tolerance: f64,
    /// GEV, the largest change of a coefficient in this step.
    pub change: f64,
    /// GEMAFW, the mean of `W T S` before this step.
    pub mean_integrand: f64,
}

impl NewtonStep {
    /// The step in the coefficients of the monomials.
    pub(super) fn new(theory: &Variational, delta: f64, step: &Step) -> Self {
        Self {
            tolerance: delta * largest(&theory.monomials(step.tau.as_slice())),
            change: largest(&theory.monomials(step.change.as_slice())),
            mean_integrand: step.value,
        }
    }
}

/// Runs the iteration of 1967 from `tau` until the largest change of a coefficient is below
/// `delta` times the largest coefficient (5.12c), or the iterations are used up.
///
/// It fails in one to four cases of a hundred from a cold start, which is why the default
/// damps; in a chain of neighbouring cases it seldom does.
pub(super) fn iterate(
    theory: &Variational,
    functional: &Functional,
    mut tau: DVector<f64>,
    limits: Limits,
    mut observe: impl FnMut(NewtonStep),
) -> Minimum {
    let mut expansion = Expansion::zeros(functional.unknowns());
    for iterations in 1..=limits.max_iterations {
        functional.expand(&tau, &mut expansion);
        let Some(change) = expansion.hessian.clone().lu().solve(&-&expansion.gradient) else {
            return Minimum { tau, iterations, converged: false };
        };
        let next = &tau + &change;
        if !next.iter().all(|unknown| unknown.is_finite()) {
            return Minimum { tau, iterations, converged: false };
        }
        let step = Step { value: expansion.value, change: &change, tau: &next };
        let step = NewtonStep::new(theory, limits.delta, &step);
        observe(step);
        tau = next;
        if step.change < step.tolerance {
            return Minimum { tau, iterations, converged: true };
        }
    }
    Minimum { tau, iterations: limits.max_iterations, converged: false }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}
