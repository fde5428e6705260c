//! What can be wrong with the file of a wheelset.

use std::io;
use std::path::PathBuf;

use creepage::InvalidValue;
use creepage::gap::GapError;
use creepage::normal::NormalError;
use creepage_rail::file::FileError;
use creepage_rail::{GeometryError, ProfileError, Role, Side};

use crate::case::CaseError;
use crate::gap::GapCaseError;

/// Why a file is not that of a wheelset in its track.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WheelsetError {
    /// Its form, or a number out of its range.
    #[error(transparent)]
    Case(#[from] CaseError),
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
    #[error("[wheelset] {key} makes no sense with side = \"{side}\": {instead}")]
    OneWheel {
        /// The key.
        key: &'static str,
        /// `left` or `right`.
        side: &'static str,
        /// What to give.
        instead: &'static str,
    },
    /// Nothing holds the wheelset down.
    #[error("[wheelset] needs one of axle_load, wheel_load and z")]
    NoLoad,
    /// A theory or an option that areas of any shape do not have.
    #[error(transparent)]
    Theory(Box<GapCaseError>),
    /// A position in which wheel and rail do not meet as they should.
    #[error("[wheelset] {source}")]
    Position {
        /// The side.
        side: Side,
        /// Why.
        source: GeometryError,
    },
    /// A position in which the wheelset does not come to rest on both rails.
    #[error("[wheelset] roll = \"free\": {0}")]
    Resting(GeometryError),
    /// Surfaces that make no undeformed distance.
    #[error("{} wheel: {source}", side_word(*side))]
    Shape {
        /// The side.
        side: Side,
        /// Why.
        source: GapError,
    },
    /// A contact without a pressure that can be computed.
    #[error("{} wheel: {source}", side_word(*side))]
    Pressure {
        /// The side.
        side: Side,
        /// Why.
        source: NormalError,
    },
    /// No height carries the load.
    #[error("[wheelset] no height was found at which the rails carry {load} N")]
    LoadNotFound {
        /// The load (N).
        load: f64,
    },
    /// No roll gives both rails the same load.
    #[error(
        "[wheelset] roll = \"free\": none was found at which both rails carry the same with z = {z} m"
    )]
    RollNotFound {
        /// The height (m).
        z: f64,
    },
    /// The wheel slides through faster than it rolls.
    #[error(
        "[motion] speed and pitch_rate: the {} wheel and its rail do not roll forward at a \
         contact", side_word(*side)
    )]
    NotForward {
        /// The side.
        side: Side,
    },
    /// No pitch rate without a moment about the axle.
    #[error("[motion] pitch_rate = \"free\": none was found without a moment about the axle")]
    PitchNotFound,
    /// A wheel that its load would lift.
    #[error(
        "[wheelset] roll_moment lifts the {} wheel: it would carry {load:.6} N; give roll, or loads of \
         both wheels", side_word(*side)
    )]
    Lifts {
        /// The side.
        side: Side,
        /// What it would carry (N).
        load: f64,
    },
    /// A wheel that is to carry nothing and lies in its rail.
    #[error(
        "[wheelset] the {} wheel is to carry nothing, but at this roll it would sink into its rail while the \
         other carries its load", side_word(*side)
    )]
    Sinks {
        /// The side.
        side: Side,
    },
    /// A lifted wheel whose height nothing tells.
    #[error(
        "[wheelset] the {} wheel carries nothing and roll is free: nothing says how high it hangs; \
         give roll", side_word(*side)
    )]
    Hangs {
        /// The side.
        side: Side,
    },
    /// Rails on springs without a place at which these carry the wheels.
    #[error(
        "[rail] stiffness_y, stiffness_z: no place of the rails was found at which the springs carry the wheels"
    )]
    RailNotFound,
    /// Rails on springs where they must be rigid.
    #[error("[rail] stiffness_y, stiffness_z: {what} takes rigid rails; solve the file itself")]
    RigidRails {
        /// What was asked for.
        what: &'static str,
    },
    /// More traction than friction can carry.
    #[error(
        "[motion] no pitch rate was found at which friction balances {wanted} (torque in N m or \
         longitudinal_force in N): it can carry {most:.6} at most"
    )]
    TractionNotFound {
        /// What was wanted (N m or N).
        wanted: f64,
        /// What friction can carry (N m or N).
        most: f64,
    },
    /// Height, roll or pitch rate do not follow from the rest.
    #[error("[wheelset] no derivatives: what is found here does not follow what is given")]
    NotDifferentiable,
    /// Load and friction did not come to rest.
    #[error(
        "[wheelset] no position was settled on that carries the load, which can jump by some tenths \
         of a per cent where two areas of contact join: try a position beside this one, or give z"
    )]
    NotSettled,
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

pub(super) fn side_word(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}

/// A whole section that must be there.
pub(super) fn section(section: &str, needs: &str) -> CaseError {
    CaseError::MissingSection { section: section.into(), needs: needs.into() }
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
