//! Errors of a contact map's build.

use creepage_map::MapError;
use creepage_wheelset::WheelsetError;

use crate::case::CaseError;
use crate::wheelset::error::WheelsetFileError;

/// Error of a map's build.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MapBuildError {
    /// A number of the plan.
    #[error("{quantity} must be {valid}, got {value}")]
    Plan {
        /// The quantity.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// What it must be.
        valid: &'static str,
    },
    /// The wheelset cannot be pressed or solved.
    #[error(transparent)]
    Wheelset(#[from] WheelsetFileError),
    /// The wheelset cannot be pressed or solved in a position.
    #[error(transparent)]
    Position(#[from] WheelsetError),
    /// The map does not take what was found.
    #[error(transparent)]
    Map(#[from] MapError),
    /// Rigid slip by place is not in a map.
    #[error("[contact] slip = \"curved\" is not in a contact map: leave it out, or solve directly")]
    Curved,
    /// Something that a map does not know.
    #[error("{what}: not in a contact map; solve the wheelset directly, or leave it out")]
    NotInMap {
        /// The keys.
        what: &'static str,
    },
    /// No load from which a plan can take its own.
    #[error("[wheelset] needs axle_load or wheel_load for a contact map, whose loads are about it")]
    NoLoad,
    /// One wheel alone.
    #[error("[wheelset] side: a contact map has both wheels, leave it out")]
    OneWheel,
    /// The table of ellipses is one of another theory.
    #[error("the table of ellipses is of {theory}; a contact map needs one of exact")]
    EllipsesOf {
        /// That theory.
        theory: String,
    },
    /// The table of ellipses is too narrow.
    #[error(
        "the table of ellipses has {quantity} from {} to {}; this contact map needs {} to {}",
        given[0], given[1], needed[0], needed[1]
    )]
    EllipsesRange {
        /// `a_over_b` or `poisson`.
        quantity: &'static str,
        /// From where to where it has them.
        given: [f64; 2],
        /// From where to where they are needed.
        needed: [f64; 2],
    },
    /// Nothing was pressed at a place.
    #[error("at y = {y} m no height was found at which the wheel carries {load} N")]
    NotPressed {
        /// The place (m).
        y: f64,
        /// The load (N).
        load: f64,
    },
    /// Wheel and rail do not meet over enough of the range.
    #[error("wheel and rail meet over too little of the range: {places} places")]
    Short {
        /// How many places were left.
        places: usize,
    },
    /// The journal.
    #[error("cannot keep what is built in {}: {source}", path.display())]
    Journal {
        /// Its file.
        path: std::path::PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Another run builds the same.
    #[error("{} is being written by another run", path.display())]
    Busy {
        /// The journal's file.
        path: std::path::PathBuf,
    },
    /// It was told to stop.
    #[error("stopped before it was built")]
    Stopped,
}

impl MapBuildError {
    /// Wheels under loads of their own.
    pub(super) const UNEVEN: Self =
        Self::NotInMap { what: "[wheelset] roll_moment, wheel_load_left, mass" };

    pub(super) fn from_case(error: CaseError) -> Self {
        Self::Wheelset(error.into())
    }
}
