//! Friction that depends on the slip: the limits of the elements are held while the tractions are
//! solved, and follow the slip from one solution to the next.

use super::{Equations, Outcome, State};
use crate::coulomb::grid::Grid;
use crate::coulomb::mixing::Mixing;
use crate::coulomb::resistance::LEAST;

/// Largest change of a limit, over that at rest, in a solution.
const TOLERANCE: f64 = 1e-7;
const ROUNDS: usize = 120;
/// Largest residual of tractions between one set of limits and the next, which amplify it.
const FINE: f64 = 1e-8;
/// Below this change of the limits steps are mixed; before, each is taken as it is: from friction at
/// rest the limits fall step by step towards the first solution, which mixed steps might pass.
const NEAR: f64 = 0.02;
/// Steps after which they are mixed in any case.
const PLAIN: usize = 40;

impl State {
    /// Improves the tractions until they obey friction at the slip that [`State::forcing`] causes;
    /// where friction depends on the slip, from the limits as they are.
    pub(crate) fn solve(&mut self, grid: &Grid, equations: &mut Equations) -> Outcome {
        let mut sum = self.solve_to(super::TOLERANCE, grid, equations);
        let Some(resistance) = &grid.resistance else { return sum };
        let (mut limits, mut mixing) = (self.limits.clone(), Mixing::default());
        for round in 0..ROUNDS {
            let slip = |element: usize| {
                let [x, y] = self.visible(grid, element).1.unwrap_or_default();
                x.hypot(y)
            };
            resistance.limits(&grid.mesh, &grid.pressure.bounds, slip, &mut limits);
            let changes = limits.iter().zip(&self.limits).map(|(new, old)| (new - old).abs());
            let change = changes.fold(0.0, f64::max);
            if change <= TOLERANCE {
                return sum;
            }
            if change < NEAR || round >= PLAIN || resistance.yields() {
                mixing.improve(&mut self.limits, &limits);
                self.limits.iter_mut().for_each(|limit| *limit = limit.clamp(LEAST, 1.0));
            } else {
                self.limits.copy_from_slice(&limits);
            }
            let again = self.solve_to(FINE, grid, equations);
            sum.converged = again.converged;
            sum.sweeps += again.sweeps;
            sum.factorizations += again.factorizations;
        }
        Outcome { converged: false, ..sum }
    }

    /// Starts from no traction and the same limit, over that at rest, in every element.
    pub(crate) fn reset_to(&mut self, limit: f64) {
        self.reset();
        self.limits.fill(limit);
    }
}
