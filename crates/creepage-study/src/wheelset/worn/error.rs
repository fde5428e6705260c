//! Errors of wear over a distance.

use std::io;
use std::path::PathBuf;

use creepage_rail::{GeometryError, ProfileError};

use crate::case::CaseError;
use crate::error::ReportError;
use crate::wheelset::WheelsetFileError;

/// Error of wear over a distance.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WearError {
    /// The wheelset's file.
    #[error(transparent)]
    Wheelset(#[from] WheelsetFileError),
    /// The section `[wear]`.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The table of situations cannot be read.
    #[error("[wear] table: cannot read {}: {source}", path.display())]
    Table {
        /// Its file.
        path: PathBuf,
        /// Why.
        source: csv::Error,
    },
    /// A column that no situation has.
    #[error(
        "[wear] table: {}: unknown column {column:?}: it may have {}", path.display(), known.join(", ")
    )]
    Column {
        /// Its file.
        path: PathBuf,
        /// The column.
        column: String,
        /// Those that there are.
        known: Vec<&'static str>,
    },
    /// A column twice.
    #[error("[wear] table: {}: column {column} is there twice", path.display())]
    Twice {
        /// Its file.
        path: PathBuf,
        /// The column.
        column: &'static str,
    },
    /// A cell that is no number.
    #[error("[wear] table: {}: row {row}, {column}: {text:?} is no number", path.display())]
    Cell {
        /// Its file.
        path: PathBuf,
        /// Its row, from 1 below the header.
        row: usize,
        /// Its column.
        column: &'static str,
        /// What it holds.
        text: String,
    },
    /// Situations without any share of the distance.
    #[error("[wear] situations: share must be zero or positive and finite, and not zero for all")]
    Shares,
    /// What was asked of one wheel alone, or of unlike sides.
    #[error("[wear] sides = \"mean\" needs both wheels, of one profile, and rails of one profile")]
    Mean,
    /// A situation that cannot be solved.
    #[error("[wear] situation {number} after {distance:.0} m and {passages:.0} passages: {source}")]
    Situation {
        /// Its number, from 1.
        number: usize,
        /// Distance run (m).
        distance: f64,
        /// Passages.
        passages: f64,
        /// Why.
        source: Box<WheelsetFileError>,
    },
    /// A theory that does not tell where surfaces slide.
    #[error("[solve] theory = {theory:?} has no slip to wear by: [wear] takes {}", known.join(", "))]
    Theory {
        /// Its name.
        theory: &'static str,
        /// Those that have.
        known: &'static [&'static str],
    },
    /// A situation without a number for the wear of a contact.
    #[error(
        "[wear] situation {number}: its wear is not a number: Archard's law needs a speed other than zero"
    )]
    NoWear {
        /// Its number, from 1.
        number: usize,
    },
    /// A contact beside the profile.
    #[error("{body}: a contact at y = {y} m lies beside the profile's points")]
    OffProfile {
        /// Which.
        body: &'static str,
        /// Where (m).
        y: f64,
    },
    /// A limit of what the profiles do not have.
    #[error(
        "[wear.limits] {measure}: no profile that wears has it: flange measures need a wheel with a flange"
    )]
    NoMeasure {
        /// What is measured.
        measure: &'static str,
    },
    /// A limit that new profiles are past.
    #[error("[wear.limits] {measure}: {limit} is passed by {body} when new: {value:.6}")]
    LimitPassed {
        /// What is measured.
        measure: &'static str,
        /// Whose it is.
        body: &'static str,
        /// When new (m; the conicity is a number).
        value: f64,
        /// The limit.
        limit: f64,
    },
    /// A worn profile whose points cross.
    #[error(
        "{body}: worn so deep that the profile crosses itself: take smaller steps, or a shorter distance"
    )]
    Crosses {
        /// Which.
        body: &'static str,
    },
    /// A worn profile that makes no curve.
    #[error("{body}: {source}")]
    Profile {
        /// Which.
        body: &'static str,
        /// Why.
        source: ProfileError,
    },
    /// Worn profiles that do not go together.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// The work so far.
    #[error("cannot keep the work so far in {}: {source}", path.display())]
    State {
        /// Its file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The work of another run.
    #[error(
        "{} keeps {steps} steps of a run of another case, or by another version: remove it, or let this run \
         have another place",
        path.display()
    )]
    OtherRun {
        /// Its file.
        path: PathBuf,
        /// Its steps.
        steps: usize,
    },
    /// Results cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// It was told to stop.
    #[error("stopped before the whole distance was run")]
    Stopped,
}

impl WearError {
    /// Whether the input is at fault; otherwise something failed on the way, and what was run so far stays.
    #[must_use]
    pub fn is_wrong_input(&self) -> bool {
        match self {
            Self::State { source, .. } => source.kind() == io::ErrorKind::AlreadyExists,
            Self::Situation { distance, passages, .. } => *distance + *passages == 0.0,
            Self::Report(ReportError::OverSource { .. }) => true,
            Self::Report(_) | Self::Crosses { .. } | Self::Profile { .. } | Self::Stopped => false,
            _ => true,
        }
    }
}
