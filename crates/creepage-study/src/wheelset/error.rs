//! What can be wrong with the file of a wheelset.

use std::io;
use std::path::PathBuf;

use creepage::InvalidValue;
use creepage_rail::file::FileError;
use creepage_rail::{GeometryError, Role};

use crate::case::CaseError;

/// Why a file is not that of a wheelset in its track.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WheelsetError {
    /// Its form, or a number out of its range.
    #[error(transparent)]
    Case(#[from] CaseError),
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
    /// A profile file that makes no sense.
    #[error("[{section}] profile: {}: {source}", path.display())]
    Profile {
        /// The section's name.
        section: &'static str,
        /// The profile's file.
        path: PathBuf,
        /// What is wrong with it.
        source: FileError,
    },
    /// A rail's profile on a wheel, or the other way round.
    #[error("[{section}] profile = \"{profile}\" is that of a {}", word(*found))]
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
    #[error("[wheelset] {key} makes no sense with side = \"{side}\": {instead}")]
    OneWheel {
        /// The key.
        key: &'static str,
        /// `left` or `right`.
        side: &'static str,
        /// What to give.
        instead: &'static str,
    },
    /// No amplitude, or no place, at which the wheelset runs.
    #[error("wheels and rails do not meet with the wheelset in the middle of the track: {0}")]
    Apart(GeometryError),
}

fn word(role: Role) -> &'static str {
    match role {
        Role::Wheel => "wheel",
        Role::Rail => "rail",
    }
}

impl WheelsetError {
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
