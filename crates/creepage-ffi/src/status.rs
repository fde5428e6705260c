//! How far a force may be trusted, as a number.

use creepage::theory::TheoryFacts;
use creepage::{Contact, Solution, Status, TheorySpec};

use crate::failure::Failure;

/// The theory's equations are solved.
pub const CREEPAGE_SOLVED: i32 = 0;
/// The iteration ended before its tolerance was met.
pub const CREEPAGE_NOT_CONVERGED: i32 = 1;
/// Solved, but creepage is too small for the theory's resolution.
pub const CREEPAGE_CREEPAGE_TOO_SMALL: i32 = 2;
/// Solved, but spin is beyond the bound up to which the theory holds.
pub const CREEPAGE_SPIN_TOO_LARGE: i32 = 3;
/// A status that this version of the interface does not know.
pub const CREEPAGE_DOUBTFUL: i32 = 4;
/// Solved, but as if the bodies were alike: their difference matters, and only "exact" counts it.
pub const CREEPAGE_UNLIKE_BODIES: i32 = 5;
/// Solved, but the error bars of the force are larger than the accuracy that was asked for.
pub const CREEPAGE_ACCURACY_NOT_REACHED: i32 = 6;

/// `|kappa/mu|` from which the force of like bodies is off by about a hundredth of `mu N`.
const MATTERS: f64 = 0.01;

/// What the force of like bodies is worth to bodies of this contact.
pub(crate) fn of_like_bodies(contact: &Contact) -> i32 {
    let matters = contact.kappa_over_mu().abs() >= MATTERS;
    if matters { CREEPAGE_UNLIKE_BODIES } else { CREEPAGE_SOLVED }
}

/// What a theory can answer, and what its answers are worth.
pub(crate) struct Judge {
    facts: &'static TheoryFacts,
    /// Of a solution to which nothing else is to be said.
    solved: i32,
    /// Largest error bar that was asked for.
    accuracy: f64,
}

impl Judge {
    pub(crate) fn new(spec: &TheorySpec, contact: &Contact) -> Self {
        let facts = spec.facts();
        let solved =
            if facts.dissimilar_bodies { CREEPAGE_SOLVED } else { of_like_bodies(contact) };
        Self { facts, solved, accuracy: spec.prescribed_accuracy().unwrap_or(f64::INFINITY) }
    }

    pub(crate) fn theory(&self) -> &'static str {
        self.facts.name
    }

    /// Whether the theory has what is asked for.
    pub(crate) fn can_answer(&self, errors: bool, derivatives: bool) -> Result<(), Failure> {
        if errors && !self.facts.error_bars {
            return Err(Failure::NoErrorBars(self.facts.name));
        }
        if derivatives && !self.facts.derivative {
            return Err(Failure::NoDerivative(self.facts.name));
        }
        Ok(())
    }

    pub(crate) fn status(&self, solution: &Solution) -> i32 {
        let bar = solution.error.map_or(0.0, |error| error.fx.max(error.fy));
        match solution.status {
            Status::Solved if bar > self.accuracy => CREEPAGE_ACCURACY_NOT_REACHED,
            Status::Solved => self.solved,
            Status::NotConverged => CREEPAGE_NOT_CONVERGED,
            Status::CreepageTooSmall => CREEPAGE_CREEPAGE_TOO_SMALL,
            Status::SpinTooLarge => CREEPAGE_SPIN_TOO_LARGE,
            _ => CREEPAGE_DOUBTFUL,
        }
    }
}
