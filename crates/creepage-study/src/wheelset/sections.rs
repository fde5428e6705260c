//! Sections of a wheelset file, as they are written.

use std::f64::consts::PI;

use creepage::{InvalidValue, Solid};
use creepage_rail::Smoothing;
use creepage_rail::file::{CornerSearch, ReadOptions};
use creepage_wheelset::{Patches, RigidSlip, StepsStart};
use schemars::JsonSchema;
use serde::Deserialize;

use super::error::WheelsetFileError;
use super::free::{GivenOrFree, PitchValue};
use super::friction::RailFrictionValue;
use super::guard::GuardSection;
use super::varying::{CorrugationSection, FlatValue, WavinessSection};
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
    /// In place of `smooth`: the weight (m3) of the curvature's square beside points that count alike, however far
    /// apart they are.
    smooth_weight: Option<f64>,
    /// What is a corner, at which curves break, and what is roughness.
    #[schemars(with = "CornersSection")]
    #[serde(default)]
    corners: Option<CornersSection>,
}

/// A corner turns by more than `turn` while its neighbours within `reach` turn by less than `rest`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CornersSection {
    /// The least turn of a corner (rad); 30 degrees by default.
    turn: Option<f64>,
    /// By how much its neighbours turn at most (rad); 6 degrees by default.
    rest: Option<f64>,
    /// How far to both sides they are looked at (m); 0.002 by default, and with 0 every such turn is a corner.
    reach: Option<f64>,
}

impl CornersSection {
    fn search(self) -> CornerSearch {
        let usual = CornerSearch::default();
        CornerSearch {
            turn: self.turn.unwrap_or(usual.turn),
            rest: self.rest.unwrap_or(usual.rest),
            reach: self.reach.unwrap_or(usual.reach),
        }
    }

    fn check(self, section: &'static str) -> Result<(), CaseError> {
        let CornerSearch { turn, rest, reach } = self.search();
        for (quantity, value, is_valid) in [
            ("reading.corners.turn", turn, turn > 0.0 && turn <= PI),
            ("reading.corners.rest", rest, rest > 0.0 && rest <= PI),
            ("reading.corners.reach", reach, (0.0..=0.1).contains(&reach)),
        ] {
            let valid =
                "turn and rest are angles above zero, at most pi (rad); reach is at most 0.1 (m)";
            if !is_valid {
                return Err(CaseError::invalid(section)(InvalidValue { quantity, value, valid }));
            }
        }
        Ok(())
    }
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
    /// One way to smooth at most.
    pub(super) fn check(&self, section: &'static str) -> Result<(), CaseError> {
        if self.smooth.is_some() && self.smooth_weight.is_some() {
            let [first, second] =
                ["reading.smooth", "reading.smooth_weight"].map(|key| (section, key));
            return Err(CaseError::Conflict { first, second });
        }
        self.corners.map_or(Ok(()), |corners| corners.check(section))
    }

    /// The smoothing of points, which have no file: they are in metres, y to the field side, z down.
    pub(super) fn smoothing_of_points(
        &self,
        section: &'static str,
    ) -> Result<Option<Smoothing>, WheelsetFileError> {
        let of_files = [
            ("unit", self.unit.is_some()),
            ("y", self.y.is_some()),
            ("z", self.z.is_some()),
            ("corners", self.corners.is_some()),
        ];
        match of_files.into_iter().find_map(|(key, is_given)| is_given.then_some(key)) {
            Some(key) => Err(WheelsetFileError::ReadingOfPoints { section, key }),
            None => Ok(self.wanted().smoothing),
        }
    }

    pub(super) fn wanted(&self) -> ReadOptions {
        ReadOptions {
            unit: self.unit,
            field_side: self.y.map(|sense| sense == LateralSense::FieldSide),
            down: self.z.map(|sense| sense == UprightSense::Down),
            smoothing: self
                .smooth
                .map(Smoothing::Wavelength)
                .or(self.smooth_weight.map(Smoothing::Weight)),
            corners: self.corners.map(CornersSection::search),
            ..ReadOptions::default()
        }
    }
}

/// A wheel.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WheelSection {
    /// Name of a standard profile, such as "S1002", else a file beside the case file.
    pub(super) profile: Option<String>,
    /// The profile's points [y, z] (m) in place of a name, y to the field side, z down, along the profile
    /// in either sense.
    pub(super) points: Option<Vec<[f64; 2]>>,
    /// Profiles around the wheel in place of one: a file of slices { u, profile, features } with u the angle
    /// from straight down towards +x at pitch 0 (rad), or the program CONTACT's list (.slcw).
    pub(super) slices: Option<String>,
    /// What the profile's file does not show, or is to be read as, and how it is smoothed.
    #[schemars(with = "ReadingSection")]
    #[serde(default)]
    pub(super) reading: Option<ReadingSection>,
    /// A flat { length, depth, angle, shape = "chord" or "haversine" }, or several in brackets.
    #[schemars(with = "FlatValue")]
    #[serde(default)]
    pub(super) flat: Option<FlatValue>,
    /// Harmonics [{ order, amplitude, phase }] of a wheel out of round: dr = amplitude sin(order th + phase).
    pub(super) waviness: Option<Vec<WavinessSection>>,
    /// Nominal radius, at the profile's y = z = 0 (m).
    pub(super) radius: Option<f64>,
    /// The flange back's y in profile coordinates (m); -0.070 by default.
    pub(super) flange_back: Option<f64>,
}

impl WheelSection {
    fn has_profile(&self) -> bool {
        self.profile.is_some() || self.points.is_some() || self.slices.is_some()
    }

    /// What this section leaves out as in another; the reading goes with the file.
    pub(super) fn or(&self, other: &Self) -> Self {
        let file = if self.has_profile() { self } else { other };
        Self {
            profile: file.profile.clone(),
            points: file.points.clone(),
            slices: file.slices.clone(),
            reading: self.reading.or(file.reading),
            flat: self.flat.clone().or_else(|| other.flat.clone()),
            waviness: self.waviness.clone().or_else(|| other.waviness.clone()),
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
    /// The profile's points [y, z] (m) in place of a name, y to the field side, z down, along the profile
    /// in either sense.
    pub(super) points: Option<Vec<[f64; 2]>>,
    /// Profiles along the rail in place of one: a file of slices { u, profile, features } with u the place along
    /// the track (m), or the program CONTACT's list (.slcs).
    pub(super) slices: Option<String>,
    /// Waves [{ wavelength, amplitude, phase }] along the rail: dz = amplitude sin(2 pi u/wavelength + phase).
    pub(super) corrugation: Option<Vec<CorrugationSection>>,
    /// What the profile's file does not show, or is to be read as, and how it is smoothed.
    #[schemars(with = "ReadingSection")]
    #[serde(default)]
    pub(super) reading: Option<ReadingSection>,
    /// Turn of the profile as given (rad), positive inclines the head to the track centre;
    /// 0 by default.
    pub(super) cant: Option<f64>,
    /// Shift to the right from where the rail was laid (m); 0 by default.
    pub(super) dy: Option<f64>,
    /// Shift downwards (m); 0 by default.
    pub(super) dz: Option<f64>,
    /// Turn about x through the profile's origin (rad), by the right-hand rule; 0 by default.
    pub(super) droll: Option<f64>,
    /// Velocity to the right (m/s); 0 by default.
    pub(super) dy_rate: Option<f64>,
    /// Velocity downwards (m/s); 0 by default.
    pub(super) dz_rate: Option<f64>,
    /// Angular velocity about x (rad/s); 0 by default.
    pub(super) droll_rate: Option<f64>,
    /// Stiffness of the springs on which a rail without mass lies, across (N/m), beside `stiffness_z`.
    pub(super) stiffness_y: Option<f64>,
    /// The same, down (N/m).
    pub(super) stiffness_z: Option<f64>,
    /// Force on the sprung rail beside the wheel's, to the right (N); 0 by default.
    pub(super) force_y: Option<f64>,
    /// The same, down (N).
    pub(super) force_z: Option<f64>,
    /// Radius of a roller in place of the rail (m), where its rim touches the track plane; its axle lies along y.
    /// Below zero it is a ring around the wheel. `speed` is that of the rim there.
    pub(super) roller_radius: Option<f64>,
    /// A guard or check rail { profile, flangeway, height, cant, friction } beside it, on which the back of the flange
    /// runs; { grooved = true } where the rail's own profile has it.
    #[schemars(with = "GuardSection")]
    #[serde(default)]
    pub(super) guard: Option<GuardSection>,
    /// Friction on this rail, where it differs from that of [contact].
    #[schemars(with = "RailFrictionValue")]
    #[serde(default)]
    pub(super) friction: Option<RailFrictionValue>,
}

impl RailSection {
    fn has_profile(&self) -> bool {
        self.profile.is_some() || self.points.is_some() || self.slices.is_some()
    }

    /// What this section leaves out as in another; the reading goes with the file.
    pub(super) fn or(&self, other: &Self) -> Self {
        let file = if self.has_profile() { self } else { other };
        Self {
            profile: file.profile.clone(),
            points: file.points.clone(),
            slices: file.slices.clone(),
            corrugation: self.corrugation.clone().or_else(|| other.corrugation.clone()),
            reading: self.reading.or(file.reading),
            cant: self.cant.or(other.cant),
            dy: self.dy.or(other.dy),
            dz: self.dz.or(other.dz),
            droll: self.droll.or(other.droll),
            dy_rate: self.dy_rate.or(other.dy_rate),
            dz_rate: self.dz_rate.or(other.dz_rate),
            droll_rate: self.droll_rate.or(other.droll_rate),
            stiffness_y: self.stiffness_y.or(other.stiffness_y),
            stiffness_z: self.stiffness_z.or(other.stiffness_z),
            force_y: self.force_y.or(other.force_y),
            force_z: self.force_z.or(other.force_z),
            roller_radius: self.roller_radius.or(other.roller_radius),
            guard: self.guard.clone().or_else(|| other.guard.clone()),
            friction: self.friction.clone().or_else(|| other.friction.clone()),
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
    /// Height of each rail profile's origin, downwards from the track plane (m), beside `rail_position`;
    /// by default the rails' highest points lie in the track plane.
    pub(super) rail_height: Option<f64>,
    /// Radius of the curve (m), positive where it bends to the right. Give this or `curvature`.
    pub(super) curve_radius: Option<f64>,
    /// Curvature (1/m), positive where the track bends to the right; 0 by default.
    pub(super) curvature: Option<f64>,
    /// Height of the outer rail over the inner one (m); with `mass` and `centre_height` of the
    /// wheelset the loads of both wheels follow.
    pub(super) superelevation: Option<f64>,
}

/// The wheelset and where it stands.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WheelsetSection {
    /// Distance between the flange backs (m).
    pub(super) back_to_back: f64,
    /// Its place along the track (m), where rails vary; 0 by default.
    pub(super) s: Option<f64>,
    /// How far its wheels have rolled on (rad), where they vary, positive forward as `pitch_rate`; 0 by default.
    pub(super) pitch: Option<f64>,
    /// Its centre to the right of the track centre (m); 0 by default.
    pub(super) y: Option<f64>,
    /// Turn about z (rad): positive turns the axle's right end back; 0 by default.
    pub(super) yaw: Option<f64>,
    /// Turn about x (rad): positive lowers the right wheel; a number, or "free" (the default).
    #[schemars(with = "GivenOrFree")]
    #[serde(default)]
    pub(super) roll: Option<GivenOrFree>,
    /// Vertical force of the wheelset on the track (N). Give this, `wheel_load` or `z`.
    pub(super) axle_load: Option<f64>,
    /// Moment about x with which the wheelset presses on the track under its `axle_load`, about its centre
    /// (N m), positive where it presses the right wheel down; with roll = "free". Without it each rail
    /// carries half of the load.
    pub(super) roll_moment: Option<f64>,
    /// Vertical force of a wheel on its rail (N), the same on both.
    pub(super) wheel_load: Option<f64>,
    /// Vertical force of the left wheel (N), beside `wheel_load_right`; 0 where it is lifted.
    pub(super) wheel_load_left: Option<f64>,
    /// Vertical force of the right wheel (N).
    pub(super) wheel_load_right: Option<f64>,
    /// Mass that the wheelset carries, its own included (kg): with `centre_height` the loads of both
    /// wheels in a curve follow.
    pub(super) mass: Option<f64>,
    /// Height of that mass's centre over the rails (m).
    pub(super) centre_height: Option<f64>,
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

/// How wheels sit on their axle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum WheelsOnAxle {
    /// They turn together.
    Rigid,
    /// Each turns by itself.
    Independent,
}

/// How the wheelset moves.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MotionSection {
    /// Speed along the track (m/s), in a curve along its centre line; negative where the wheelset runs
    /// backwards.
    pub(super) speed: f64,
    /// Angular velocity about the axle (rad/s), positive when it rolls forward; or "free"
    /// (the default): friction has the moment about the axle that `torque` asks for, to 1e-5 of what it could
    /// have. Two of these in brackets are those of the left and the right wheel, which then turn
    /// independently.
    #[schemars(with = "PitchValue")]
    #[serde(default)]
    pub(super) pitch_rate: Option<PitchValue>,
    /// Angular velocity of the left wheel (rad/s) or "free", beside `pitch_rate_right`.
    #[schemars(with = "GivenOrFree")]
    #[serde(default)]
    pub(super) pitch_rate_left: Option<GivenOrFree>,
    /// Angular velocity of the right wheel (rad/s) or "free".
    #[schemars(with = "GivenOrFree")]
    #[serde(default)]
    pub(super) pitch_rate_right: Option<GivenOrFree>,
    /// "rigid" (the default): both wheels turn with the axle; "independent": each by itself.
    #[schemars(with = "WheelsOnAxle")]
    #[serde(default)]
    pub(super) wheels: Option<WheelsOnAxle>,
    /// Torque about the axle (N m), positive where it drives forward, of independent wheels on each; 0
    /// by default. The pitch rate is found.
    pub(super) torque: Option<f64>,
    /// Sum of the forces along x on the rails (N), as it is reported: negative where the wheelset drives.
    /// In place of `torque`.
    pub(super) longitudinal_force: Option<f64>,
    /// Velocity to the right (m/s); 0 by default.
    pub(super) lateral_velocity: Option<f64>,
    /// Velocity downwards (m/s); 0 by default.
    pub(super) vertical_velocity: Option<f64>,
    /// Angular velocity about x (rad/s), positive where the right wheel goes down; 0 by default.
    pub(super) roll_rate: Option<f64>,
    /// Angular velocity about z (rad/s); 0 by default.
    pub(super) yaw_rate: Option<f64>,
}

/// How wheels begin that `creepage roll` rolls in steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StepsStartSection {
    /// "none" (the default): just pressed together; "steady": as if they had rolled for ever as in the first row.
    #[serde(default)]
    pub(super) traction: StepsStartTraction,
}

/// The traction with which wheels begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum StepsStartTraction {
    /// None.
    #[default]
    None,
    /// That of steady rolling with the motion of the first row.
    Steady,
}

impl StepsStartSection {
    pub(super) fn start(self) -> StepsStart {
        match self.traction {
            StepsStartTraction::None => StepsStart::Pressed,
            StepsStartTraction::Steady => StepsStart::Steady,
        }
    }
}

/// What the contacts have in common.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FrictionSection {
    /// Coefficient of friction on both rails; or how it varies.
    #[schemars(with = "RailFrictionValue")]
    #[serde(default)]
    pub(super) friction: Option<RailFrictionValue>,
    /// "together" (the default): areas in planes of their own sink under each other's load; "apart":
    /// each is pressed as if it were alone.
    #[schemars(with = "Patches")]
    #[serde(default)]
    pub(super) patches: Option<Patches>,
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
