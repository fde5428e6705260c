//! Errors of a contact map: states out of range, and damaged files.

use creepage::InvalidValue;
use creepage::table::FileError;

use crate::Side;

/// A quantity whose range a map has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// The lateral place of a wheel on its rail (m): with `y`, roll and yaw.
    Place,
    /// The wheelset's height (m).
    Height,
    /// The vertical load of a wheel (N).
    Load,
    /// Yaw (rad).
    Yaw,
    /// Roll beyond that of a wheelset that rolls freely there (rad).
    Roll,
    /// Coefficient of friction.
    Friction,
    /// Speed along the track (m/s).
    Speed,
    /// Another number of position or motion, which must be finite.
    Finite,
}

impl std::fmt::Display for Quantity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Place => "lateral place of wheel on rail (m)",
            Self::Height => "height z (m)",
            Self::Load => "vertical load of a wheel (N)",
            Self::Yaw => "yaw (rad)",
            Self::Roll => "roll beyond the free one (rad)",
            Self::Friction => "friction",
            Self::Speed => "speed (m/s)",
            Self::Finite => "a number of position or motion",
        })
    }
}

/// Error of a map: a state out of its range, or a damaged file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// What was asked lies outside the map, which does not extrapolate.
    #[error("outside the map: {quantity} is {value}, the map has {low} to {high}")]
    Outside {
        /// The quantity.
        quantity: Quantity,
        /// What was asked.
        value: f64,
        /// The least of the map.
        low: f64,
        /// The most of the map.
        high: f64,
    },
    /// Something of one wheel.
    #[error("{} wheel: {error}", if *side == Side::Left { "left" } else { "right" })]
    Wheel {
        /// Its side.
        side: Side,
        /// What.
        error: Box<MapError>,
    },
    /// Neither height nor load is given.
    #[error("one of z and axle_load is needed")]
    NoLoad,
    /// The position under a load, or the free pitch rate, was not found.
    #[error("no position or pitch rate was found: {left:.1e} of the load is left")]
    NotFound {
        /// What the last step left, in parts of the load.
        left: f64,
    },
    /// No derivatives: what is found does not follow what is given.
    #[error("the equilibrium is singular: what it finds has no derivatives by what is given")]
    NotDifferentiable,
    /// A number out of the range of the table of ellipses.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// Numbers that no map has.
    #[error("it is no contact map: its {0} make no sense")]
    Senseless(&'static str),
    /// Bytes that are not those of a map.
    #[error("it is no contact map, or it is damaged: its checksum does not fit")]
    Damaged,
    /// NetCDF that is not laid out as a map.
    #[error("it is no contact map: `{0}` is missing or of another kind")]
    Missing(&'static str),
    /// A map of another format.
    #[error("its format is number {found}, and this program reads number {known}: build it again")]
    Format {
        /// That of the file.
        found: i32,
        /// That of this program.
        known: i32,
    },
    /// The NetCDF library does not take the map.
    #[error("it cannot be laid out as NetCDF")]
    Unfit,
    /// The table of ellipses in the map cannot be read.
    #[error("its table of ellipses: {0}")]
    Ellipses(FileError),
}
