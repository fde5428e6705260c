//! The way to the least loss of power: through integrands with rounder slips.

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
    if creepage == Creepage::default() {
        return Minimum { tau: 0.0 * tau, iterations: 0, converged: true };
    }
    let mean_slip = theory
        .functional_of(creepage, Form::Power { smoothing: 0.0, stiffness: 0.0 })
        .mean_if_rigid();
    let stiffness = mean_slip / margin(theory.response.degree());
    let mut minimum = Minimum { tau, iterations: 0, converged: false };
    let [rounder @ .., last] = SMOOTHINGS;
    let stages = rounder.iter().filter(|_| !is_near).map(|smoothing| (*smoothing, ROUGHLY));
    for (smoothing, delta) in stages.chain([(last, limits.delta)]) {
        let form = Form::Power { smoothing: smoothing * mean_slip, stiffness };
        let functional = theory.functional_of(creepage, form);
        let max_iterations = limits.max_iterations - minimum.iterations;
        let limits = Limits { delta, max_iterations };
        let before = minimum.iterations;
        minimum = newton::minimize(&functional, minimum.tau, limits, &mut observe);
        minimum.iterations += before;
    }
    minimum
}
