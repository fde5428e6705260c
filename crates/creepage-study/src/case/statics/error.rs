//! Errors of statics files.

use creepage::InvalidValue;
use creepage::halfspace::ResponseError;
use creepage::statics::{DieError, PartialSlipError, ShearError};

use crate::case::error::CaseError;

/// Error of a statics file; every message names the section and the key.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StaticsError {
    /// As in any case file.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A load that belongs to another problem.
    #[error("[statics] {key} is no load of problem \"{problem}\": it takes {}", listed(keys))]
    ForeignKey {
        /// The key.
        key: &'static str,
        /// The problem's name.
        problem: &'static str,
        /// The keys that the problem takes.
        keys: &'static [&'static str],
    },
    /// What belongs to a rectangle alone.
    #[error("{what} has no place in problem \"{problem}\": \"sheared-rectangle\" takes it")]
    OfRectangle {
        /// A section or a key.
        what: &'static str,
        /// The problem's name.
        problem: &'static str,
    },
    /// A step of a rectangle's path whose force is not reached.
    #[error(
        "[statics] steps: the force of step {number}, {force} N, is more than the {most} N that friction and the \
         layer bear"
    )]
    PathBeyond {
        /// Its number, from 1.
        number: usize,
        /// What was asked (N).
        force: f64,
        /// The most (N).
        most: f64,
    },
    /// Bodies that touch in no circle.
    #[error(
        "[upper], [lower]: problem \"compression\" takes bodies of revolution, whose contact is a circle; here \
         a/b = {ratio}"
    )]
    NotRound {
        /// Semi-axis along `x` over that along `y`.
        ratio: f64,
    },
    /// The areas of adhesion and slip of a compression do not settle.
    #[error("[statics] problem \"compression\": the areas of adhesion and slip do not converge")]
    NotSettled,
    /// An upper body where the problem has none.
    #[error("section [upper] has no place in problem \"die\": the die is rigid")]
    DieWithUpper,
    /// Friction where the problem has none.
    #[error("[contact] friction has no place in problem \"die\": the die is taken as smooth")]
    DieWithFriction,
    /// The load lies so far out that the die lifts off on the opposite side (3.27b).
    #[error(
        "[statics] offset_x = {:?}, offset_y = {:?}: the die lifts off, for the load lies {:?} \
         times too far out; all of the base has contact up to offset_x = {:?}, offset_y = {:?}",
        offset[0], offset[1], five_digits(*excess), limit[0], limit[1]
    )]
    LiftOff {
        /// Offset of the load (m).
        offset: [f64; 2],
        /// Offset over the largest in that direction.
        excess: f64,
        /// The largest offset in that direction, a hair inside (m).
        limit: [f64; 2],
    },
    /// The tangential force reaches the limit of friction.
    #[error(
        "[statics] force_x, force_y: the bodies slide, for the tangential force of {force} N \
         reaches the limit of friction, mu N = {limit} N"
    )]
    Sliding {
        /// Magnitude of the tangential force (N).
        force: f64,
        /// Coefficient of friction times normal force (N).
        limit: f64,
    },
    /// A path without a step.
    #[error("[statics] steps: a path has one step at least")]
    NoSteps,
    /// A load of a step where loads stay.
    #[error(
        "[statics] steps: step {number} has a normal_force of its own, which goes with problem \"shift-path\" alone"
    )]
    LoadOfStep {
        /// Its number, from 1.
        number: usize,
    },
    /// A number of a step.
    #[error("[statics] steps: step {number}: {source}")]
    Step {
        /// Its number, from 1.
        number: usize,
        /// What is wrong.
        source: InvalidValue,
    },
    /// A step of a path reaches the limit of friction.
    #[error(
        "[statics] steps: the bodies slide in step {number}, whose {key} of {value} reaches {limit}, and what a path does \
         beyond is not known"
    )]
    PathSlides {
        /// Its number, from 1.
        number: usize,
        /// "force" (N) or "shift" (m).
        key: &'static str,
        /// What was asked.
        value: f64,
        /// Where the bodies slide.
        limit: f64,
    },
    /// The die has no solution.
    #[error(transparent)]
    Die(#[from] DieError),
    /// The shift with slip has no solution.
    #[error(transparent)]
    PartialSlip(#[from] PartialSlipError),
    /// A rectangle's path has no solution.
    #[error(transparent)]
    Shear(#[from] ShearError),
    /// The half-space gives no answer.
    #[error(transparent)]
    Response(#[from] ResponseError),
}

impl StaticsError {
    pub(crate) fn die(offset: [f64; 2], source: DieError) -> Self {
        match source {
            DieError::LiftOff { excess, .. } => {
                // Written to five digits, the limit must still lie within the limit.
                let limit = offset.map(|part| five_digits((1.0 - 1e-4) * part / excess));
                Self::LiftOff { offset, excess, limit }
            }
            DieError::Invalid(invalid) if invalid.quantity == "normal_force" => {
                CaseError::invalid("contact")(invalid).into()
            }
            DieError::Invalid(invalid) => CaseError::invalid("statics")(invalid).into(),
            other => other.into(),
        }
    }

    pub(crate) fn partial_slip(source: PartialSlipError) -> Self {
        match source {
            PartialSlipError::Sliding { force, limit } => Self::Sliding { force, limit },
            PartialSlipError::Invalid(invalid) => CaseError::invalid("contact")(invalid).into(),
            other => other.into(),
        }
    }
}

/// The keys of a load in words; "none" for a problem without.
fn listed(keys: &[&str]) -> String {
    if keys.is_empty() { "none but the normal force".into() } else { keys.join(", ") }
}

fn five_digits(value: f64) -> f64 {
    format!("{value:.4e}").parse().unwrap_or(value)
}
