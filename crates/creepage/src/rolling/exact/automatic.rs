//! As fine as a wanted accuracy needs.

use std::sync::OnceLock;

use super::{Creepage, Exact, ExactSolution, FieldPoint, Resolution, Solution, Theory};
use crate::check::{self, InvalidValue};

/// The full theory at the first of the three named resolutions whose error bar of the force is
/// small enough; each is prepared when a case first needs it.
///
/// ```
/// use creepage::rolling::exact::Automatic;
/// use creepage::rolling::Creepage;
/// let theory = Automatic::new(1.0, 0.28, 0.005)?;
/// let solution = theory.solve_to_accuracy(Creepage::new(3.0, 0.0, 0.0)?);
/// assert!(solution.error.fx < 0.005);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug)]
pub struct Automatic {
    poisson: f64,
    accuracy: f64,
    fast: Exact,
    finer: [OnceLock<Exact>; 2],
}

impl Automatic {
    /// Prepares for `a/b`, Poisson's ratio and the wanted accuracy of `fx` and `fy`.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Exact::new`], and unless `accuracy` is finite and positive.
    pub fn new(a_over_b: f64, poisson: f64, accuracy: f64) -> Result<Self, InvalidValue> {
        check::positive("accuracy", accuracy)?;
        let fast = Exact::new(a_over_b, poisson, Resolution::FAST)?;
        Ok(Self { poisson, accuracy, fast, finer: [OnceLock::new(), OnceLock::new()] })
    }

    /// Solves, refining until the error bars of `fx` and `fy` are below the wanted accuracy or
    /// the finest resolution is reached; the error bars tell which.
    #[must_use]
    pub fn solve_to_accuracy(&self, creepage: Creepage) -> ExactSolution {
        self.level_for(creepage).1
    }

    fn level_for(&self, creepage: Creepage) -> (&Exact, ExactSolution) {
        let solve = |theory: &Exact| theory.solve_with(creepage, &mut theory.workspace());
        let mut level = &self.fast;
        let mut solution = solve(level);
        for (cell, resolution) in self.finer.iter().zip([Resolution::STANDARD, Resolution::FINE]) {
            if solution.error.fx.max(solution.error.fy) <= self.accuracy {
                break;
            }
            level =
                cell.get_or_init(|| Exact::prepare(self.fast.ellipse, self.poisson, resolution));
            solution = solve(level);
        }
        (level, solution)
    }
}

impl Theory for Automatic {
    fn solve(&self, creepage: Creepage) -> Solution {
        let solution = self.solve_to_accuracy(creepage);
        Solution { force: solution.force, status: solution.status }
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.level_for(creepage).0.field(creepage, positions)
    }
}
