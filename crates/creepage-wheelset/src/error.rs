//! Errors of the wheelset solver.

use creepage::InvalidValue;
use creepage::gap::GapError;
use creepage::normal::NormalError;
use creepage_rail::{GeometryError, Side};

/// Error of the wheelset solver in a position and a motion.
///
/// Messages name quantities by their keys of a case file and the section that has them.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WheelsetError {
    /// A number out of its range.
    #[error("[{section}] {invalid}")]
    Invalid {
        /// What the number belongs to.
        section: &'static str,
        /// Which number, and what is valid.
        invalid: InvalidValue,
    },
    /// Two quantities that exclude each other.
    #[error("[{section}] give {one} or {other}, not both")]
    Conflict {
        /// What they belong to.
        section: &'static str,
        /// The one.
        one: &'static str,
        /// The other.
        other: &'static str,
    },
    /// Wheels and rails that do not go together.
    #[error("[{section}] {source}")]
    Geometry {
        /// What they belong to.
        section: &'static str,
        /// Why.
        source: GeometryError,
    },
    /// Nothing holds the wheelset down.
    #[error("[wheelset] needs one of axle_load, wheel_load and z")]
    NoLoad,
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
    #[error("{} wheel: {}", side_word(*side), shape_word(source))]
    Shape {
        /// The side.
        side: Side,
        /// Why.
        source: GapError,
    },
    /// A contact without a pressure that can be computed.
    #[error("{} wheel: {}", side_word(*side), pressure_word(source))]
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
    #[error(
        "[wheelset] no derivatives: the equilibrium is singular, what it finds does not follow from what is given"
    )]
    NotDifferentiable,
    /// Surfaces that vary along rolling, asked for what is not known of them.
    #[error(
        "[wheel] slices, flat, waviness and [rail] slices, corrugation, roller_radius: {what} is not known where \
         surfaces vary along rolling"
    )]
    Varies {
        /// What was asked for.
        what: &'static str,
    },
    /// Wheels that cannot roll in steps.
    #[error("wheels that roll in steps {what}")]
    Steps {
        /// What they need.
        what: &'static str,
    },
    /// Load and friction did not come to rest.
    #[error(
        "[wheelset] no position was settled on that carries the load: it can jump by some tenths of a per cent \
         where two areas of contact join, and on a flange that climbs friction may carry what the load does not: \
         try a position beside this one, less friction, or give z"
    )]
    NotSettled,
}

/// What a gap refuses, in words of profiles.
fn shape_word(source: &GapError) -> String {
    match source {
        GapError::Invalid(InvalidValue { quantity: "radius_rolling", .. }) => {
            "wheel and rail do not part along rolling there, as far on the flange at large yaw: give another position"
                .into()
        }
        other => other.to_string(),
    }
}

/// What pressing refuses, in words of profiles: nobody gave a gap.
fn pressure_word(source: &NormalError) -> String {
    match source {
        NormalError::ReachesEdge { beyond, .. } if beyond.is_finite() => format!(
            "the contact area is {:.2} mm larger than the part of both profiles that lies opposite each other there: \
             give profiles that go on, less load, or another position",
            1e3 * beyond
        ),
        NormalError::ReachesEdge { .. } => {
            "the contact area has no end on one side, for the surfaces do not part \
             there: give profiles that go on, less load, or another position"
                .into()
        }
        other => other.to_string(),
    }
}

/// The word for a side of the track.
#[must_use]
pub fn side_word(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}

impl WheelsetError {
    /// Of a number that belongs to `section`.
    pub(crate) fn invalid(section: &'static str) -> impl Fn(InvalidValue) -> Self {
        move |invalid| Self::Invalid { section, invalid }
    }

    /// Places what geometry refuses.
    pub(crate) fn geometry(section: &'static str) -> impl Fn(GeometryError) -> Self {
        move |error| match error {
            GeometryError::Value { name, value, range } => Self::Invalid {
                section,
                invalid: InvalidValue { quantity: name, value, valid: range },
            },
            source => Self::Geometry { section, source },
        }
    }
}

/// A number, checked.
pub(crate) fn checked(
    section: &'static str,
    quantity: &'static str,
    value: f64,
    is_valid: bool,
    valid: &'static str,
) -> Result<f64, WheelsetError> {
    let invalid = InvalidValue { quantity, value, valid };
    is_valid.then_some(value).ok_or(WheelsetError::Invalid { section, invalid })
}
