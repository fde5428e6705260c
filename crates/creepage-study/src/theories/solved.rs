//! A case solved, whichever way it was asked.

use std::sync::Arc;

use crate::{Case, InverseCase};
use creepage::rolling::exact::Known;

use crate::theories::examination::Examination;
use crate::theories::find::{FindError, find_creepage};
use crate::theories::left_out::LeftOut;
use crate::theories::prepared::PreparedTheory;
use crate::theories::registry::Entry;
use crate::theories::unlike::kappa_over_mu;

/// A case, and all that a theory tells about it.
#[derive(Debug)]
pub struct SolvedCase {
    /// The case; its creepage is given or found.
    pub case: Case,
    /// What was given, where the creepage was found to wanted forces.
    pub known: Option<Known>,
    /// Force, field and details.
    pub found: Examination,
}

impl SolvedCase {
    /// Solves a case for its forces, by a theory that was prepared for its contact.
    #[must_use]
    pub fn forces(case: Case, theory: Arc<PreparedTheory>) -> Self {
        let found = Examination::new(theory, case.contact.ellipse(), case.creepage);
        Self { case, known: None, found }
    }

    /// Finds the creepage at which the known quantities of the case hold, and solves it there by
    /// the theory of that name, prepared for its contact.
    ///
    /// # Errors
    /// [`FindError`] unless the theory is the full one and the forces are within reach.
    pub fn creepage(
        case: InverseCase,
        name: &'static str,
        theory: Arc<PreparedTheory>,
    ) -> Result<Self, FindError> {
        let found = find_creepage(&case, name, theory)?;
        let known = Some(case.known);
        Ok(Self { case: case.found(found.creepage()), known, found })
    }

    /// What a theory leaves out of the case, if that matters.
    #[must_use]
    pub fn left_out(&self, theory: &Entry) -> Option<LeftOut> {
        theory.leaves_out(kappa_over_mu(&self.case.contact, self.case.friction))
    }
}
