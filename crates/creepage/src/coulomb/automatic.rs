//! Adaptive resolution: the coarsest grid whose error bar meets a prescribed accuracy.

use std::sync::OnceLock;

use super::{
    Constraints, Exact, ExactSolved, InverseError, InverseSolution, NonHertzian, Resolution,
};
use crate::check::{self, InvalidValue};
use crate::theory::Solved;
use crate::{Contact, Creepage, Force, Theory};

/// The full theory at the first of the three named resolutions whose error bar of the force is
/// small enough; each is prepared when a case first needs it.
///
/// ```
/// use creepage::coulomb::Automatic;
/// use creepage::{Contact, Creepage, Ellipse, Theory};
/// let theory = Automatic::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?, 0.005)?;
/// let solution = theory.solve(Creepage::new(3.0, 0.0, 0.0)?);
/// assert!(solution.error.is_some_and(|error| error.fx < 0.005));
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct Automatic {
    contact: Contact,
    resolutions: Resolutions<Exact>,
}

/// What is prepared for one resolution, and for finer ones when a case first needs them.
#[derive(Debug, Clone)]
pub(super) struct Resolutions<P> {
    /// Error bar of the forces from which a finer resolution is taken.
    accuracy: f64,
    first: P,
    finer: [OnceLock<P>; 2],
}

impl<P> Resolutions<P> {
    /// Finer than the first, [`Resolution::FAST`], where error bars of `fx` and `fy` are above
    /// `accuracy`.
    pub(super) fn new(accuracy: f64, first: P) -> Self {
        Self { accuracy, first, finer: [OnceLock::new(), OnceLock::new()] }
    }

    /// The first of them.
    pub(super) fn first(&self) -> &P {
        &self.first
    }

    /// That one only.
    pub(super) fn only(first: P) -> Self {
        Self::new(f64::INFINITY, first)
    }

    /// The answer of the first resolution at which its error bars are small enough.
    pub(super) fn answer<'p, A>(
        &'p self,
        prepare: impl Fn(Resolution) -> P,
        answer: impl Fn(&'p P) -> A,
        error: impl Fn(&A) -> Force,
    ) -> A {
        let mut found = answer(&self.first);
        for (cell, resolution) in self.finer.iter().zip([Resolution::STANDARD, Resolution::FINE]) {
            let Force { fx, fy, .. } = error(&found);
            if fx.max(fy) <= self.accuracy {
                break;
            }
            found = answer(cell.get_or_init(|| prepare(resolution)));
        }
        found
    }
}

/// Error bars of what was found; infinite where nothing was.
pub(super) fn error_bars<'a, S: 'a>(
    found: &'a Result<S, InverseError>,
    solved: impl Fn(&'a S) -> &'a dyn Solved,
) -> Force {
    const UNKNOWN: Force = Force { fx: f64::INFINITY, fy: f64::INFINITY, mz: f64::INFINITY };
    found.as_ref().map_or(UNKNOWN, |found| solved(found).solution().error.unwrap_or_default())
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
        Ok(Self { contact: contact.clone(), resolutions: Resolutions::new(accuracy, fast) })
    }

    /// Solves, refining until the error bars of `fx` and `fy` are below the prescribed accuracy or
    /// the finest resolution is reached; the error bars show which.
    #[must_use]
    pub fn solve_contact(&self, creepage: Creepage) -> ExactSolved<'_> {
        self.resolutions.answer(
            |resolution| Exact::prepare(&self.contact, resolution),
            |theory| theory.solve_contact(creepage),
            |solved| solved.solution().error.unwrap_or_default(),
        )
    }

    /// As [`Exact::find`], refining until the error bars of `fx` and `fy` at the creepage found
    /// are below the prescribed accuracy or the finest resolution is reached.
    ///
    /// ```
    /// use creepage::coulomb::{Automatic, Constraints};
    /// use creepage::{Contact, Ellipse};
    /// let theory = Automatic::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?, 0.004)?;
    /// let constraints =
    ///     Constraints { eta: Some(0.0), chi: Some(0.2), fx: Some(0.5), ..Constraints::default() };
    /// let solution = theory.find(constraints)?.solution();
    /// assert!((solution.force.fx - 0.5).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InverseError`] as [`Exact::find`], at the finest resolution.
    pub fn find(&self, constraints: Constraints) -> Result<InverseSolution<'_>, InverseError> {
        self.resolutions.answer(
            |resolution| Exact::prepare(&self.contact, resolution),
            |theory| theory.find(constraints),
            |found| error_bars(found, |found| &found.solved),
        )
    }
}

impl Theory for Automatic {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        Box::new(self.solve_contact(creepage))
    }

    fn solved_for(
        &self,
        constraints: Constraints,
    ) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        Some(self.find(constraints).map(|found| -> Box<dyn Solved> { Box::new(found.solved) }))
    }
}

/// The full theory on areas of any shape at the first of the three named resolutions whose error bars of
/// `fx` and `fy` are within an accuracy; each is prepared when a case first needs it.
#[derive(Debug, Clone)]
pub struct NonHertzianAutomatic {
    contact: Contact,
    resolutions: Resolutions<NonHertzian>,
}

impl NonHertzianAutomatic {
    /// Prepares for areas of any shape and the accuracy of `fx` and `fy`, in parts of `mu N`.
    ///
    /// # Errors
    /// [`InvalidValue`] as [`NonHertzian::on`], and unless `accuracy` is finite and positive.
    pub fn on(contact: &Contact, accuracy: f64) -> Result<Self, InvalidValue> {
        check::positive("accuracy", accuracy)?;
        let fast = NonHertzian::on(contact, Resolution::FAST)?;
        Ok(Self { contact: contact.clone(), resolutions: Resolutions::new(accuracy, fast) })
    }

    fn finer(&self, first: &NonHertzian, resolution: Resolution) -> NonHertzian {
        // It was prepared for the same contact before.
        NonHertzian::on(&self.contact, resolution).unwrap_or_else(|_| first.clone())
    }
}

impl Theory for NonHertzianAutomatic {
    fn contact(&self) -> &Contact {
        &self.contact
    }

    fn solved(&self, creepage: Creepage) -> Box<dyn Solved + '_> {
        let first = self.resolutions.first();
        let prepare = |resolution| self.finer(first, resolution);
        Box::new(self.resolutions.answer(
            prepare,
            |theory| theory.solve(creepage),
            |solved| solved.solution().error.unwrap_or_default(),
        ))
    }

    fn solved_for(
        &self,
        constraints: Constraints,
    ) -> Option<Result<Box<dyn Solved + '_>, InverseError>> {
        let first = self.resolutions.first();
        let found = self.resolutions.answer(
            |resolution| self.finer(first, resolution),
            |theory| theory.find(constraints),
            |found| error_bars(found, |found| found),
        );
        Some(found.map(|found| -> Box<dyn Solved> { Box::new(found) }))
    }
}
