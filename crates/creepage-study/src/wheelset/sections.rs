//! The sections of the file, as they are written.

use creepage::Solid;
use creepage_rail::file::Wanted;
use schemars::JsonSchema;
use serde::Deserialize;

use super::case::RigidSlip;
use super::free::Freely;
use crate::case::CaseError;
use crate::case::body::Body;

/// What a profile's file does not show, or is to be read as, and how it is smoothed.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ReadingSection {
    /// Length of the file's unit (m), such as 0.001 or 0.0254.
    unit: Option<f64>,
    /// Where y grows to in the file.
    #[schemars(with = "LateralSense")]
    #[serde(default)]
    y: Option<LateralSense>,
    /// Where z grows to in the file.
    #[schemars(with = "UprightSense")]
    #[serde(default)]
    z: Option<UprightSense>,
    /// Waves of this length (m) keep half of their amplitude.
    smooth: Option<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum LateralSense {
    FieldSide,
    TrackSide,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum UprightSense {
    Down,
    Up,
}

impl ReadingSection {
    pub(super) fn wanted(&self) -> Wanted {
        Wanted {
            unit: self.unit,
            field_side: self.y.map(|sense| sense == LateralSense::FieldSide),
            down: self.z.map(|sense| sense == UprightSense::Down),
            smoothing: self.smooth,
            ..Wanted::default()
        }
    }
}

/// A wheel.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WheelSection {
    /// Name of a standard profile, such as "S1002", else a file beside the case file.
    pub(super) profile: Option<String>,
    /// What the profile's file does not show, or is to be read as, and how it is smoothed.
    #[schemars(with = "ReadingSection")]
    #[serde(default)]
    pub(super) reading: Option<ReadingSection>,
    /// Nominal radius, at the profile's y = z = 0 (m).
    pub(super) radius: Option<f64>,
    /// The flange back's y in profile coordinates (m); -0.070 by default.
    pub(super) flange_back: Option<f64>,
}

impl WheelSection {
    /// What this section leaves out as in another; the reading goes with the file.
    pub(super) fn or(&self, other: &Self) -> Self {
        let file = if self.profile.is_some() { self } else { other };
        Self {
            profile: file.profile.clone(),
            reading: self.reading.or(file.reading),
            radius: self.radius.or(other.radius),
            flange_back: self.flange_back.or(other.flange_back),
        }
    }
}

/// A rail.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RailSection {
    /// Name of a standard profile, such as "UIC60", else a file beside the case file.
    pub(super) profile: Option<String>,
    /// What the profile's file does not show, or is to be read as, and how it is smoothed.
    #[schemars(with = "ReadingSection")]
    #[serde(default)]
    pub(super) reading: Option<ReadingSection>,
    /// Turn of the profile as given (rad), positive inclines the head to the track centre;
    /// 0 by default.
    pub(super) cant: Option<f64>,
}

impl RailSection {
    /// What this section leaves out as in another; the reading goes with the file.
    pub(super) fn or(&self, other: &Self) -> Self {
        let file = if self.profile.is_some() { self } else { other };
        Self {
            profile: file.profile.clone(),
            reading: self.reading.or(file.reading),
            cant: self.cant.or(other.cant),
        }
    }
}

/// Where the rails stand: `gauge` and `gauge_height`, or `rail_position`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct TrackSection {
    /// Distance between the rails' nearest points (m).
    pub(super) gauge: Option<f64>,
    /// Depth below the highest point down to which they are looked for (m).
    pub(super) gauge_height: Option<f64>,
    /// Distance of each rail profile's origin from the track centre (m).
    pub(super) rail_position: Option<f64>,
}

/// The wheelset and where it stands.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WheelsetSection {
    /// Distance between the flange backs (m).
    pub(super) back_to_back: f64,
    /// Its centre to the right of the track centre (m); 0 by default.
    pub(super) y: Option<f64>,
    /// Turn about z (rad): positive turns the axle's right end back; 0 by default.
    pub(super) yaw: Option<f64>,
    /// Turn about x (rad): positive lowers the right wheel; a number, or "free" (the default).
    #[schemars(with = "Freely")]
    #[serde(default)]
    pub(super) roll: Option<Freely>,
    /// Vertical force of the wheelset on the track (N). Give this, `wheel_load` or `z`.
    pub(super) axle_load: Option<f64>,
    /// Vertical force of a wheel on its rail (N).
    pub(super) wheel_load: Option<f64>,
    /// Height, downwards (m); at 0 the nominal circle touches the track plane.
    pub(super) z: Option<f64>,
    /// One wheel alone.
    #[schemars(with = "SideName")]
    #[serde(default)]
    pub(super) side: Option<SideName>,
}

/// A side of the track by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum SideName {
    /// The left wheel.
    Left,
    /// The right wheel.
    Right,
}

/// How the wheelset moves.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MotionSection {
    /// Speed along the track (m/s).
    pub(super) speed: f64,
    /// Angular velocity about the axle (rad/s), positive when it rolls forward; or "free"
    /// (the default): no net moment about the axle, to 1e-5 of what friction could have.
    #[schemars(with = "Freely")]
    #[serde(default)]
    pub(super) pitch_rate: Option<Freely>,
    /// Velocity to the right (m/s); 0 by default.
    pub(super) lateral_velocity: Option<f64>,
    /// Velocity downwards (m/s); 0 by default.
    pub(super) vertical_velocity: Option<f64>,
    /// Angular velocity about x (rad/s), positive where the right wheel goes down; 0 by default.
    pub(super) roll_rate: Option<f64>,
    /// Angular velocity about z (rad/s); 0 by default.
    pub(super) yaw_rate: Option<f64>,
}

/// What the contacts have in common.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FrictionSection {
    /// Coefficient of friction.
    pub(super) friction: f64,
    /// "flat" (the default): creepage and spin at each contact's reference point hold all over it;
    /// "curved": the rolling radius and the direction of the surface at every place.
    pub(super) slip: Option<RigidSlip>,
}

/// An elastic material.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialSection {
    /// Shear modulus G (Pa). Give this or `young_modulus`.
    pub(super) shear_modulus: Option<f64>,
    /// Young's modulus E (Pa). Give this or `shear_modulus`.
    pub(super) young_modulus: Option<f64>,
    /// Poisson's ratio, 0 to 0.5.
    pub(super) poisson: f64,
}

impl MaterialSection {
    pub(super) fn solid(&self, section: &'static str) -> Result<Solid, CaseError> {
        let &Self { shear_modulus, young_modulus, poisson } = self;
        let (radius_rolling, radius_lateral) = (None, None);
        Body { shear_modulus, young_modulus, poisson, radius_rolling, radius_lateral }
            .solid(section)
    }
}
