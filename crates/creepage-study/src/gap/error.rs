//! Errors of cases with `[gap]`.

use std::io;

use creepage::coulomb::InverseError;
use creepage::gap::GapError;
use creepage::normal::NormalError;
use creepage::theory::TheoryError;

use crate::{CaseError, SolveError, UnattainableForce};

/// Error of a case with `[gap]`; every message names the section and the key.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GapCaseError {
    /// What any case file may have wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A key that other case files have.
    #[error("[{section}] {key} has no meaning beside [gap]: {instead}")]
    Foreign {
        /// The section's name.
        section: &'static str,
        /// The key.
        key: &'static str,
        /// What to give in its place.
        instead: &'static str,
    },
    /// Not one shape.
    #[error(
        "[gap] needs exactly one of polynomial, section, grid, groove and roller: {}",
        if given.is_empty() { "none is given".into() } else { format!("given are {}", given.join(" and ")) }
    )]
    NotOneShape {
        /// Those that are given.
        given: Vec<&'static str>,
    },
    /// A radius where the shape has its own opening along x.
    #[error("[gap] radius_rolling goes with section alone: {shape} opens along x by itself")]
    RadiusBeside {
        /// `polynomial`, `grid` or `roller`.
        shape: &'static str,
    },
    /// A section without a radius along x.
    #[error(
        "[gap] {shape} needs a rolling radius: [gap] radius_rolling, or a column radius_rolling beside y \
         and gap"
    )]
    NoRadius {
        /// The key, and the file if there is one.
        shape: String,
    },
    /// Two radii along x.
    #[error("[gap] radius_rolling and the column radius_rolling of {shape} exclude each other")]
    TwoRadii {
        /// The key, and the file if there is one.
        shape: String,
    },
    /// Points that cannot be read.
    #[error("[gap] {shape}: {source}")]
    Points {
        /// The key, and the file if there is one.
        shape: String,
        /// What is wrong with it.
        source: GapFileError,
    },
    /// Numbers that are no undeformed distance.
    #[error("[gap] {shape}: {source}")]
    Gap {
        /// The key, and the file if there is one.
        shape: String,
        /// What is wrong with them.
        source: GapError,
    },
    /// The bodies have no contact area that can be computed.
    #[error("[gap] {shape}, [contact] {pressed}: {source}")]
    Normal {
        /// The key, and the file if there is one.
        shape: String,
        /// The load or the approach.
        pressed: String,
        /// Why.
        source: NormalError,
    },
    /// A theory or an option that areas of any shape do not take, or a number out of its range.
    #[error("[solve] {0}")]
    Theory(#[from] TheoryError),
    /// A theory that does not roll along a curve.
    #[error("[contact] surface = \"curved\" is rolled by exact alone: {name} knows planes")]
    CurvedTheory {
        /// Its name.
        name: &'static str,
    },
    /// A law of friction, a layer or a slip from place to place on a curve.
    #[error(
        "[contact] surface = \"curved\" takes constant friction, without a layer and without [contact] slip: its own \
         slip differs from place to place"
    )]
    CurvedFriction,
    /// Forces other than the longitudinal one on a curve.
    #[error(
        "[contact] surface = \"curved\" finds the longitudinal creepage to a longitudinal_force alone, at a given lateral \
         creepage and spin"
    )]
    CurvedWanted,
    /// A history on a curve.
    #[error(
        "[contact] surface = \"curved\" is for steady rolling: histories and the pressure alone are in a plane"
    )]
    CurvedSteady,
    /// What knows contacts in a plane alone.
    #[error(
        "[contact] surface = \"curved\" has a slip of its own: {what} take contacts in a plane; give \"plane\", or solve \
         case by case"
    )]
    CurvedOf {
        /// What was asked for, in the plural.
        what: &'static str,
    },
    /// A refinement until an accuracy is met, on a curve.
    #[error(
        "[contact] surface = \"curved\" takes one resolution, \"fast\", \"standard\", \"fine\" or two numbers of \
         elements: \"auto\" is for a plane"
    )]
    CurvedAuto,
    /// A curve that is not given.
    #[error("[contact] surface = \"curved\" needs [gap] groove: other shapes are given in a plane")]
    NoCurve,
    /// A curved contact that was not solved.
    #[error("[contact] surface = \"curved\": {source}")]
    Curved {
        /// Why.
        source: creepage::curved::CurvedError,
    },
    /// No creepage gives the wanted forces.
    #[error(transparent)]
    UnattainableForce(#[from] UnattainableForce),
    /// The theory does not find creepages.
    #[error("[wanted] needs the theory exact: {name} does not find creepages")]
    FindsNothing {
        /// Its name.
        name: &'static str,
    },
    /// The wanted forces make no sense.
    #[error("[wanted] {0}")]
    Inverse(#[from] InverseError),
}

impl From<SolveError> for GapCaseError {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::Theory(error) => Self::Theory(error),
            SolveError::UnattainableForce(error) => Self::UnattainableForce(error),
            SolveError::Inverse(error) => Self::Inverse(error),
            SolveError::FindsNothing { name } => Self::FindsNothing { name },
        }
    }
}

/// Error of points, of a file or of the case itself, that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GapFileError {
    /// The system cannot read it.
    #[error("cannot read it: {0}")]
    Read(io::Error),
    /// Not CSV: rows of different lengths.
    #[error("{0}")]
    Csv(#[from] csv::Error),
    /// A column is missing.
    #[error("column {name} is missing")]
    NoColumn {
        /// The column.
        name: &'static str,
    },
    /// A column that means nothing here.
    #[error("unknown column `{name}`: known are {}", known.join(", "))]
    UnknownColumn {
        /// The column.
        name: String,
        /// Those that there may be.
        known: Vec<&'static str>,
    },
    /// A column twice.
    #[error("column {name} stands there twice")]
    ColumnTwice {
        /// The column.
        name: String,
    },
    /// Columns of different lengths.
    #[error("column {name} has {found} numbers, but column {other} has {expected}")]
    Lengths {
        /// A column.
        name: String,
        /// Its numbers.
        found: usize,
        /// Another column.
        other: String,
        /// The numbers of that.
        expected: usize,
    },
    /// A cell that is not a finite number.
    #[error("line {line}: {column} = {cell:?} is not valid: it must be a finite number")]
    NotANumber {
        /// Line of the file, from 1.
        line: u64,
        /// The column.
        column: String,
        /// What stands there.
        cell: String,
    },
}
