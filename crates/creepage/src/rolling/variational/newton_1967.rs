//! Newton's method as the programme of 1967 ran it (5.12): undamped, with the exact Hessian,
//! stopped by the change of the monomials' coefficients.

use nalgebra::DVector;

use super::functional::Expansion;
use super::{Start, Variational};
use crate::rolling::{Creepage, Force};

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

/// The course of the iteration, and where it ended.
#[derive(Debug, Clone, PartialEq)]
pub struct NewtonRun {
    /// The steps in order.
    pub steps: Vec<NewtonStep>,
    /// The unknowns, as [`VariationalSolution::tau`](super::VariationalSolution::tau): start
    /// of the next case of a chain.
    pub tau: Vec<f64>,
    /// Coefficients `tau_k` of (5.1): of `X'`, then of `Y'`, in `1, x, y, x^2, xy, y^2, ...`,
    /// with the major semi-axis as unit of length.
    pub monomials: Vec<f64>,
    /// Force and moment.
    pub force: Force,
    /// CONVER: the last change was below its tolerance. Otherwise the printed page says CYCLE.
    pub converged: bool,
}

impl Variational {
    /// Runs the iteration of 1967 from `start` until the largest change of a coefficient is
    /// below `delta` times the largest coefficient (5.12c), or `max_iterations` are done.
    ///
    /// It fails in one to four cases of a hundred from a cold start, which is why
    /// [`Variational::solve_from`] damps; in a chain of neighbouring cases it seldom does.
    #[must_use]
    pub fn newton_1967(
        &self,
        creepage: Creepage,
        start: &Start,
        delta: f64,
        max_iterations: usize,
    ) -> NewtonRun {
        let functional = self.functional(creepage);
        let mut tau = start.tau(&self.mesh, &self.weights, creepage);
        let mut expansion = Expansion::zeros(functional.unknowns());
        let mut steps: Vec<NewtonStep> = Vec::new();
        let mut converged = false;
        while !converged && steps.len() < max_iterations {
            functional.expand(&tau, &mut expansion);
            let Some(change) = expansion.hessian.clone().lu().solve(&-&expansion.gradient) else {
                break;
            };
            tau += &change;
            let step = NewtonStep {
                tolerance: delta * largest(&self.monomials(&tau)),
                change: largest(&self.monomials(&change)),
                mean_integrand: expansion.value,
            };
            converged = step.change < step.tolerance;
            steps.push(step);
        }
        NewtonRun {
            steps,
            monomials: self.monomials(&tau),
            force: self.response.force(tau.as_slice()),
            tau: tau.as_slice().to_vec(),
            converged,
        }
    }

    fn monomials(&self, tau: &DVector<f64>) -> Vec<f64> {
        self.traction_polynomials(tau.as_slice())
            .map(|polynomials| polynomials.iter().flat_map(|p| p.coefficients().to_vec()).collect())
            .unwrap_or_default()
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}
