//! Minimization of `I` by Newton's method with Marquardt's damping, which never fails.

use nalgebra::{Cholesky, DVector};

use super::Limits;
use super::functional::{Expansion, Functional};

/// State of the damped iteration when it ends.
pub(super) struct Minimum {
    pub(super) tau: DVector<f64>,
    pub(super) iterations: usize,
    pub(super) converged: bool,
}

/// An accepted step: `I` before it, the change, and the unknowns after it.
pub(super) struct Step<'a> {
    pub(super) value: f64,
    pub(super) change: &'a DVector<f64>,
    pub(super) tau: &'a DVector<f64>,
}

const FIRST_DAMPING: f64 = 1e-3;
const LARGEST_DAMPING: f64 = 1e12;

/// Newton's method with Marquardt's damping, from `tau`.
///
/// The pure Newton step is tried first; while it does not lower `I`, the Hessian's diagonal
/// is raised. `observe` sees every accepted step.
pub(super) fn minimize(
    functional: &Functional,
    mut tau: DVector<f64>,
    limits: Limits,
    mut observe: impl FnMut(Step),
) -> Minimum {
    let unknowns = functional.unknowns();
    let (mut here, mut there) = (Expansion::zeros(unknowns), Expansion::zeros(unknowns));
    functional.expand(&tau, &mut here);
    let mut damping = 0.0_f64;
    for iterations in 1..=limits.max_iterations {
        if functional.is_negligible(here.value) {
            return Minimum { tau, iterations: iterations - 1, converged: true };
        }
        if let Some(step) = damped_step(&here, damping) {
            let next = &tau + &step;
            if damping == 0.0 && step.amax() <= limits.delta * next.amax() {
                observe(Step { value: here.value, change: &step, tau: &next });
                return Minimum { tau: next, iterations, converged: true };
            }
            functional.expand(&next, &mut there);
            // Near the minimum rounding alone decides which value is lower.
            if there.value <= here.value + functional.rounding(here.value) {
                observe(Step { value: here.value, change: &step, tau: &next });
                tau = next;
                std::mem::swap(&mut here, &mut there);
                damping = if damping <= FIRST_DAMPING { 0.0 } else { damping / 10.0 };
                continue;
            }
        }
        damping = (10.0 * damping).max(FIRST_DAMPING);
        if damping > LARGEST_DAMPING {
            return Minimum { tau, iterations, converged: false };
        }
    }
    Minimum { tau, iterations: limits.max_iterations, converged: false }
}

/// Newton's step with the diagonal raised by the share `damping`, unless the matrix is not
/// positive definite.
fn damped_step(expansion: &Expansion, damping: f64) -> Option<DVector<f64>> {
    let mut matrix = expansion.hessian.clone();
    if damping > 0.0 {
        let size = matrix.diagonal().amax();
        for i in 0..matrix.nrows() {
            matrix[(i, i)] += damping * matrix[(i, i)].abs().max(1e-6 * size);
        }
    }
    Some(Cholesky::new(matrix)?.solve(&(-&expansion.gradient)))
}
