//! What geometry refuses.

use crate::{Role, Side};

/// Geometry that makes no sense, or contact that profiles do not hold.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometryError {
    /// A value out of its range.
    #[error("{name} = {value}: must be {range}")]
    Value {
        /// Which value.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What may be.
        range: &'static str,
    },
    /// A profile of the other role was wanted.
    #[error("a {role:?} profile is wanted here")]
    NotA {
        /// The role wanted.
        role: Role,
    },
    /// The rail's profile ends above the depth at which the gauge is measured.
    #[error(
        "the head ends {depth} m below its highest point on the track side: the gauge is measured down to {height} m"
    )]
    HeadTooLow {
        /// Where the profile ends (m).
        depth: f64,
        /// Depth of the gauge's measurement (m).
        height: f64,
    },
    /// No part of the rail's profile looks upwards.
    #[error("no part of the rail's head looks upwards")]
    Hidden,
    /// Wheel and rail do not meet within their profiles.
    #[error("{side:?} wheel: the profiles do not meet with the wheelset at y = {y} m")]
    Apart {
        /// Side of the track.
        side: Side,
        /// The wheelset's lateral position (m).
        y: f64,
    },
    /// The bodies overlap up to the end of a profile.
    #[error("{side:?} wheel: contact reaches the end of a profile at y = {y} m of the track")]
    End {
        /// Side of the track.
        side: Side,
        /// Where, in the track (m).
        y: f64,
    },
}
