//! As fine as a wanted accuracy needs.

use std::sync::OnceLock;

use super::{
    Creepage, Exact, ExactSolution, FieldPoint, Force, Found, InverseError, Known, Resolution,
    Solution, Theory,
};
use crate::Contact;
use crate::check::{self, InvalidValue};
use crate::theory::{Jacobian, Solved};

/// The full theory at the first of the three named resolutions whose error bar of the force is
/// small enough; each is prepared when a case first needs it.
///
/// ```
/// use creepage::coulomb::Automatic;
/// use creepage::{Contact, Creepage, Ellipse};
/// let theory = Automatic::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?, 0.005)?;
/// let solution = theory.solve_to_accuracy(Creepage::new(3.0, 0.0, 0.0)?);
/// assert!(solution.error.fx < 0.005);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Automatic {
    accuracy: f64,
    fast: Exact,
    finer: [OnceLock<Exact>; 2],
}

impl Automatic {
    /// The accuracy of `fx` and `fy` where none is asked for, in parts of `mu N`.
    pub const DEFAULT_ACCURACY: f64 = 1e-3;

    /// Prepares for a contact and the prescribed accuracy of `fx` and `fy`.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`Exact::new`], and unless `accuracy` is finite and positive.
    pub fn new(contact: &Contact, accuracy: f64) -> Result<Self, InvalidValue> {
        check::positive("accuracy", accuracy)?;
        let fast = Exact::new(contact, Resolution::FAST)?;
        let finer = [OnceLock::new(), OnceLock::new()];
        Ok(Self { accuracy, fast, finer })
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
    /// use creepage::coulomb::{Automatic, Known};
    /// use creepage::{Contact, Ellipse};
    /// let theory = Automatic::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?, 0.004)?;
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
        Exact::prepare(&self.fast.contact, resolution)
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
    fn contact(&self) -> &Contact {
        self.fast.contact()
    }

    fn solve(&self, creepage: Creepage) -> Solution {
        self.solve_to_accuracy(creepage).into()
    }

    fn jacobian(&self, creepage: Creepage) -> Option<Jacobian> {
        self.level(creepage).0.jacobian(creepage)
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.level(creepage).0.field(creepage, positions)
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        self.level(creepage).0.solved(creepage)
    }

    fn solved_for(&self, known: Known) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        Some(self.find(known).map(|(level, found)| level.solved(found.creepage)))
    }
}
