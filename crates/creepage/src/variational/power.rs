//! Minimization of the power loss by continuation: through integrands with rounder slips.

use nalgebra::DVector;

use super::Variational;
use super::functional::Form;
use super::newton::{self, Minimum, Step};
use super::settings::Limits;
use crate::Creepage;

/// Where the rigid slip has its mean the penalty begins this far below the bound: more room for
/// polynomials of low degree, which cannot jump; none in the limit, which is Coulomb's law.
fn margin(degree: usize) -> f64 {
    0.4 / (degree + 1) as f64
}

/// `|s|` is rounded off to `sqrt(s^2 + e^2)`, `e` over the mean rigid slip falling so.
const SMOOTHINGS: [f64; 4] = [0.3, 0.1, 0.03, 0.01];
/// How near the minima before the last are approached.
const ROUGHLY: f64 = 0.1;

/// Goes from `tau` to the minimum: through rounder slips, unless `tau` is that of a neighbour.
pub(super) fn minimize(
    theory: &Variational,
    creepage: Creepage,
    tau: DVector<f64>,
    is_near: bool,
    limits: Limits,
    mut observe: impl FnMut(Step),
) -> Minimum {
    let Some(mean_slip) = theory.mean_slip(creepage, &tau) else {
        return Minimum { tau: 0.0 * tau, iterations: 0, converged: true };
    };
    let elastic = theory.elastic.as_ref();
    let stiffness = mean_slip / margin(theory.response.degree());
    let mut minimum = Minimum { tau, iterations: 0, converged: false };
    let [rounder @ .., last] = SMOOTHINGS;
    let stages = rounder.iter().filter(|_| !is_near).map(|smoothing| (*smoothing, ROUGHLY));
    for (smoothing, delta) in stages.chain([(last, limits.delta)]) {
        let smoothing = smoothing * mean_slip;
        let form = Form::Power { smoothing, stiffness, elastic };
        let functional = theory.functional_of(creepage, form);
        let max_iterations = limits.max_iterations - minimum.iterations;
        let limits = Limits { delta, max_iterations };
        let before = minimum.iterations;
        minimum = newton::minimize(&functional, minimum.tau, limits, &mut observe);
        minimum.iterations += before;
    }
    minimum
}

impl Variational {
    /// Mean over the mesh by `Z` of the slip that the motion would bring without traction, or with the
    /// tractions as they are where that is more; none where nothing moves.
    fn mean_slip(&self, creepage: Creepage, tau: &DVector<f64>) -> Option<f64> {
        let mean = |slip: &dyn Fn(usize) -> [f64; 2]| {
            let weights = self.power_weights.iter().enumerate();
            let sum: f64 = weights
                .map(|(point, weight)| {
                    let [p, q] = slip(point);
                    weight * p.hypot(q)
                })
                .sum();
            sum / self.power_weights.iter().sum::<f64>()
        };
        let moving = mean(&|point| self.mesh.rigid_slip(creepage, point));
        let changing = self.elastic.as_ref().map(|_| {
            mean(&|point| {
                let [.., p, q] = self.mesh.state(creepage, tau.as_slice(), point);
                [p, q]
            })
        });
        Some(moving.max(changing.unwrap_or(0.0))).filter(|slip| *slip > 0.0)
    }
}
