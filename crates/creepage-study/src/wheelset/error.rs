//! Errors of wheelset files.

use std::io;
use std::path::PathBuf;

use creepage::InvalidValue;
use creepage_rail::file::{FileError, SliceListError};
use creepage_rail::{GeometryError, ProfileError, Role, SliceError};
use creepage_wheelset::WheelsetError;

use crate::case::CaseError;
use crate::gap::GapCaseError;

/// Error of a wheelset file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WheelsetFileError {
    /// Its form, or a number out of its range.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// What it describes cannot be solved.
    #[error(transparent)]
    Solve(WheelsetError),
    /// More positions than a table may have.
    #[error(
        "{asked} positions are too many for a table: {most} at most, which are hours or days of work"
    )]
    Positions {
        /// How many there would be.
        asked: f64,
        /// How many there may be.
        most: f64,
    },
    /// A profile that is neither a known name nor a file that can be read.
    #[error(
        "[{section}] profile = \"{profile}\": neither a name ({}) nor a file that can be read \
         ({}: {source})", names.join(", "), path.display()
    )]
    NoProfile {
        /// The section's name.
        section: &'static str,
        /// What the file says.
        profile: String,
        /// Names of profiles that belong there.
        names: Vec<&'static str>,
        /// The file that was looked for.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A profile file that makes no sense, or does not show what its section may say.
    #[error("[{section}] profile: {}: {source}{}", path.display(), hint(source))]
    Profile {
        /// The section's name.
        section: &'static str,
        /// The profile's file.
        path: PathBuf,
        /// What is wrong with it.
        source: FileError,
    },
    /// A file of slices that is not there.
    #[error("[{section}] slices: {}: {source}", path.display())]
    NoSlices {
        /// The section's name.
        section: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Invalid file of slices.
    #[error("[{section}] slices: {}: {source}", path.display())]
    SlicesToml {
        /// The section's name.
        section: &'static str,
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: Box<toml::de::Error>,
    },
    /// A list of slices that cannot be read.
    #[error("[{section}] slices: {}: {source}", path.display())]
    SliceList {
        /// The section's name.
        section: &'static str,
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: SliceListError,
    },
    /// Slices that make no surface.
    #[error("[{section}] slices: {}: {source}", path.display())]
    Slices {
        /// The section's name.
        section: &'static str,
        /// The file.
        path: PathBuf,
        /// Why.
        source: SliceError,
    },
    /// A chord of another depth than it has.
    #[error(
        "[{section}] flat.depth = {value}: a chord of that length on this wheel is {needs:.7} m deep; leave depth \
         out, or take shape = \"haversine\""
    )]
    ChordDepth {
        /// The section's name.
        section: &'static str,
        /// What the file says (m).
        value: f64,
        /// The depth of the chord (m).
        needs: f64,
    },
    /// What asks for wheels of revolution on prismatic rails.
    #[error(
        "[wheel] slices, flat, waviness and [rail] slices, corrugation, roller_radius: {what} takes round wheels on \
         straight rails that do not vary; solve the file itself, or rows of `creepage batch` over s and pitch"
    )]
    Varies {
        /// What was asked for.
        what: &'static str,
    },
    /// What knows of no guard rail.
    #[error(
        "[rail] guard: {what} knows of running rails alone; leave guard out, or solve the file itself"
    )]
    Guarded {
        /// What was asked for.
        what: &'static str,
    },
    /// Points that make no profile.
    #[error("[{section}] points: {source}")]
    Points {
        /// The section's name.
        section: &'static str,
        /// Why.
        source: ProfileError,
    },
    /// A standard profile has no file to be read.
    #[error(
        "[{section}] reading makes no sense with the standard profile \"{profile}\": leave it out"
    )]
    NoFile {
        /// The section's name.
        section: &'static str,
        /// The profile's name.
        profile: String,
    },
    /// A superelevation where the loads do not follow from it.
    #[error(
        "[track] superelevation shares a vehicle's weight between its wheels, by [wheelset] mass and centre_height: {key} \
         gives the load already; leave out one of them"
    )]
    SuperelevationOfLoad {
        /// The key of the load.
        key: &'static str,
    },
    /// What is read of a file, for points.
    #[error(
        "[{section}] reading.{key} is for profiles of files: points are in metres, y to the field side, z down, and \
         take smooth alone"
    )]
    ReadingOfPoints {
        /// The section's name.
        section: &'static str,
        /// The key.
        key: &'static str,
    },
    /// A rail's profile on a wheel, or the other way round.
    #[error("[{section}] profile = \"{profile}\" is that of a {found}")]
    Role {
        /// The section's name.
        section: &'static str,
        /// What the file says.
        profile: String,
        /// What the profile belongs to.
        found: Role,
    },
    /// Wheels and rails that do not go together.
    #[error("[{section}] {source}")]
    Geometry {
        /// The section's name.
        section: &'static str,
        /// Why.
        source: GeometryError,
    },
    /// A value that one wheel alone cannot have.
    #[error("[{section}] {key} makes no sense with side = \"{side}\": {instead}")]
    OneWheel {
        /// The section's name.
        section: &'static str,
        /// The key.
        key: &'static str,
        /// `left` or `right`.
        side: &'static str,
        /// What to give.
        instead: &'static str,
    },
    /// A theory or an option that areas of any shape do not have.
    #[error(transparent)]
    Theory(Box<GapCaseError>),
    /// Rails on springs where they must be rigid.
    #[error("[rail] stiffness_y, stiffness_z: {what} takes rigid rails; solve the file itself")]
    RigidRails {
        /// What was asked for.
        what: &'static str,
    },
    /// No amplitude, or no place, at which the wheelset runs.
    #[error("wheels and rails do not meet with the wheelset in the middle of the track: {0}")]
    Apart(GeometryError),
}

/// Where the section says what its file does not show.
fn hint(error: &FileError) -> &'static str {
    match error {
        FileError::Ask { .. }
        | FileError::Length { .. }
        | FileError::UpsideDown { .. }
        | FileError::FlangeOutside { .. } => {
            " (reading = { unit = 0.001, y = \"field-side\", z = \"down\" })"
        }
        _ => "",
    }
}

impl From<WheelsetError> for WheelsetFileError {
    /// A number that is out of range is one of the file.
    fn from(error: WheelsetError) -> Self {
        match error {
            WheelsetError::Invalid { section, invalid } => {
                CaseError::Invalid { section, invalid }.into()
            }
            WheelsetError::Conflict { section, one, other } => {
                CaseError::Conflict { first: (section, one), second: (section, other) }.into()
            }
            other => Self::Solve(other),
        }
    }
}

/// A whole section that must be there.
pub(super) fn section(section: &str, needs: &str) -> CaseError {
    CaseError::MissingSection { section: section.into(), needs: needs.into() }
}

impl WheelsetFileError {
    /// Places what geometry refuses in its section of the file.
    pub(super) fn geometry(section: &'static str) -> impl Fn(GeometryError) -> Self {
        move |error| match error {
            GeometryError::Value { name, value, range } => {
                let invalid = InvalidValue { quantity: name, value, valid: range };
                CaseError::Invalid { section, invalid }.into()
            }
            source => Self::Geometry { section, source },
        }
    }
}

/// A number of the file, checked.
pub(super) fn checked(
    section: &'static str,
    quantity: &'static str,
    value: f64,
    is_valid: bool,
    valid: &'static str,
) -> Result<f64, CaseError> {
    let invalid = InvalidValue { quantity, value, valid };
    is_valid.then_some(value).ok_or(CaseError::Invalid { section, invalid })
}

/// A key that must be there.
pub(super) fn needed<T>(section: &str, key: &str, value: Option<T>) -> Result<T, CaseError> {
    value.ok_or_else(|| CaseError::Missing { section: section.into(), key: key.into() })
}
