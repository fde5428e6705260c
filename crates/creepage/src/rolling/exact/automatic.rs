//! As fine as a wanted accuracy needs.

use std::sync::OnceLock;

use super::{
    Creepage, Exact, ExactSolution, FieldPoint, Force, Found, InverseError, Known, Resolution,
    Solution, Theory,
};
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
#[derive(Debug, Clone)]
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
        let finer = [OnceLock::new(), OnceLock::new()];
        Ok(Self { poisson, accuracy, fast, finer })
    }

    /// The same between unlike bodies, as [`Exact::with_unlikeness`].
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Exact::with_unlikeness`].
    pub fn with_unlikeness(self, kappa_over_mu: f64) -> Result<Self, InvalidValue> {
        let fast = self.fast.with_unlikeness(kappa_over_mu)?;
        let finer = [OnceLock::new(), OnceLock::new()];
        Ok(Self { fast, finer, ..self })
    }

    /// Solves, refining until the error bars of `fx` and `fy` are below the wanted accuracy or
    /// the finest resolution is reached; the error bars tell which.
    #[must_use]
    pub fn solve_to_accuracy(&self, creepage: Creepage) -> ExactSolution {
        self.level(creepage).1
    }

    /// As [`Automatic::solve_to_accuracy`]; also gives the theory at the resolution that sufficed.
    #[must_use]
    pub fn level(&self, creepage: Creepage) -> (&Exact, ExactSolution) {
        self.refine(|theory| {
            let solution = theory.solve_with(creepage, &mut theory.workspace());
            (solution.error, solution)
        })
    }

    /// As [`Exact::find`], refining until the error bars of `fx` and `fy` at the creepage found
    /// are below the wanted accuracy or the finest resolution is reached.
    ///
    /// ```
    /// use creepage::rolling::exact::{Automatic, Known};
    /// let theory = Automatic::new(1.0, 0.28, 0.004)?;
    /// let known = Known { eta: Some(0.0), chi: Some(0.2), fx: Some(0.5), ..Known::default() };
    /// let (_, found) = theory.find(known)?;
    /// assert!((found.solution.force.fx - 0.5).abs() < 1e-6 && found.solution.error.fx < 0.004);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InverseError`] as [`Exact::find`], at the finest resolution.
    pub fn find(&self, known: Known) -> Result<(&Exact, Found), InverseError> {
        const UNKNOWN: Force = Force { fx: f64::INFINITY, fy: f64::INFINITY, mz: f64::INFINITY };
        let (theory, found) = self.refine(|theory| {
            let found = theory.find(known, &mut theory.workspace());
            (found.as_ref().map_or(UNKNOWN, |found| found.solution.error), found)
        });
        Ok((theory, found?))
    }

    fn prepare(&self, resolution: Resolution) -> Exact {
        let mut theory = Exact::prepare(self.fast.ellipse, self.poisson, resolution);
        theory.set_unlikeness(self.fast.kappa_over_mu);
        theory
    }

    /// The first resolution whose answer has an error bar that is small enough, and the answer.
    fn refine<T>(&self, answer: impl Fn(&Exact) -> (Force, T)) -> (&Exact, T) {
        let mut theory = &self.fast;
        let (mut error, mut found) = answer(theory);
        for (cell, resolution) in self.finer.iter().zip([Resolution::STANDARD, Resolution::FINE]) {
            if error.fx.max(error.fy) <= self.accuracy {
                break;
            }
            theory = cell.get_or_init(|| self.prepare(resolution));
            (error, found) = answer(theory);
        }
        (theory, found)
    }
}

impl Theory for Automatic {
    fn solve(&self, creepage: Creepage) -> Solution {
        let solution = self.solve_to_accuracy(creepage);
        Solution { force: solution.force, status: solution.status }
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.level(creepage).0.field(creepage, positions)
    }
}
