//! Errors of wheel-rail geometry.

use crate::{Role, Side};

/// Error of wheel-rail geometry that makes no sense, or of contact that profiles do not hold.
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
    /// A wheel's tread far from where its radius is.
    #[error(
        "the wheel's tread lies at z = {z:.4} m of its profile, and its radius is that at z = 0: shift \
         the profile's points by {:.4} m", -z
    )]
    TreadOff {
        /// Where the tread lies (m).
        z: f64,
    },
    /// A wheel's flange far from its back.
    #[error(
        "the wheel's flange stands at y = {tip:.4} m of its profile, and flange_back is {flange_back} m: a \
         flange of that place has flange_back = {fitting:.3}, or shift the profile's points"
    )]
    FlangeOff {
        /// `y` of the flange's tip (m).
        tip: f64,
        /// `y` of the flange's back, as given (m).
        flange_back: f64,
        /// The flange's back by the profile (m).
        fitting: f64,
    },
    /// A rail whose profile has its origin in the track centre, put there again.
    #[error(
        "the rail's head lies at y = {head:.4} m of its profile, and the position {position} m is that of \
         y = 0: it is 0 for this profile, or place the rail by the gauge"
    )]
    RailOff {
        /// `y` of the head's highest point (m).
        head: f64,
        /// The position given (m).
        position: f64,
    },
    /// A grooved rail whose profile has no groove.
    #[error(
        "the rail's profile has no groove 5 mm deep between two heads: no part of it is a guard rail"
    )]
    NoGroove,
    /// A grooved rail that is to take another profile.
    #[error("a grooved rail cannot change its profile in place: its groove would change too")]
    GroovedWears,
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
