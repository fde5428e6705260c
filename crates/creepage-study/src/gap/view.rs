//! A solved case on areas of any shape, as its reports see it.

use creepage::coulomb::ElementField;
use creepage::normal::NormalContact;
use creepage::{Creepage, Scaling, Solution};

use super::creepage::SiGiven;
use super::field::AreaField;
use crate::{AnyCase, SolvedCase};

/// A solved case whose contact is areas of any shape, with what its reports ask for again and again.
pub(crate) struct OnAreas<'a> {
    pub(super) solved: &'a SolvedCase,
    pub(super) contact: &'a NormalContact,
    pub(super) elements: &'a [ElementField],
    pub(super) given: SiGiven,
    pub(super) scaling: Scaling,
    pub(super) solution: Solution,
    pub(super) creepage: Creepage,
}

impl<'a> OnAreas<'a> {
    /// `None` for Hertz's ellipse.
    pub(crate) fn of(solved: &'a SolvedCase) -> Option<Self> {
        let (contact, AnyCase::Gap(case)) = (solved.areas()?, &solved.case) else { return None };
        Some(Self {
            solved,
            contact,
            elements: solved.elements(),
            given: case.given,
            scaling: solved.scaling(),
            solution: solved.solution(),
            creepage: solved.creepage(),
        })
    }

    /// Names of the three quantities that were given, where the creepage was to be found.
    pub(crate) fn known(&self) -> Option<Vec<&'static str>> {
        self.given.known()
    }

    /// Its elements.
    pub(crate) fn field(&self) -> AreaField<'a> {
        AreaField {
            elements: self.elements,
            scaling: self.scaling,
            friction: self.solved.case.friction(),
            theory: self.solved.theory.name,
        }
    }
}
