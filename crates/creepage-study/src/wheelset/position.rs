//! `[wheelset]` and `[motion]`: where the wheelset stands, and how it moves.

use creepage_rail::{RailMotion, Side};

use super::case::{Drive, Load, PitchRate, WheelsetPose, WheelsetVelocity};
use super::error::{WheelsetError, checked};
use super::free::{GivenOrFree, PitchValue};
use super::sections::{MotionSection, SideName, TrackSection, WheelsOnAxle, WheelsetSection};
use crate::case::CaseError;

const WHEELSET: &str = "wheelset";
const MOTION: &str = "motion";
/// Larger angles of roll and yaw are refused (rad).
const TURN: f64 = 0.5;

impl WheelsetSection {
    /// Where it stands; what holds it down may be left out.
    pub(super) fn stance(&self) -> Result<WheelsetPose, WheelsetError> {
        let length = |key, value: Option<f64>| finite(WHEELSET, key, value.unwrap_or(0.0));
        let angle =
            |key, value: f64| checked(WHEELSET, key, value, value.abs() <= TURN, "-0.5 to 0.5 rad");
        let load = self.load()?;
        let side = self.side.map(|name| self.alone(name)).transpose()?;
        Ok(WheelsetPose {
            side,
            y: length("y", self.y)?,
            yaw: angle("yaw", self.yaw.unwrap_or(0.0))?,
            roll: match self.roll.and_then(GivenOrFree::number) {
                Some(roll) => Some(angle("roll", roll)?),
                None => None,
            },
            load,
        })
    }

    /// At most one of those that hold it down.
    fn load(&self) -> Result<Option<Load>, CaseError> {
        let wheels = match (self.wheel_load_left, self.wheel_load_right) {
            (Some(left), Some(right)) => Some(Load::Wheels([left, right])),
            (None, None) => None,
            (left, _) => {
                let key = if left.is_some() { "wheel_load_right" } else { "wheel_load_left" };
                return Err(CaseError::Missing { section: WHEELSET.into(), key: key.into() });
            }
        };
        let axle = self.axle_load.map(|load| match self.roll_moment {
            Some(moment) => Load::Loaded { load, moment },
            None => Load::Axle(load),
        });
        let given = [
            ("axle_load", axle),
            ("wheel_load", self.wheel_load.map(Load::Wheel)),
            ("wheel_load_left", wheels),
            ("z", self.z.map(Load::Height)),
        ];
        let mut given = given.into_iter().filter_map(|(key, load)| Some((key, load?)));
        let Some((key, load)) = given.next() else {
            return match self.roll_moment {
                Some(_) => {
                    Err(CaseError::Missing { section: WHEELSET.into(), key: "axle_load".into() })
                }
                None => Ok(None),
            };
        };
        if let Some((other, _)) = given.next() {
            return Err(CaseError::Conflict { first: (WHEELSET, key), second: (WHEELSET, other) });
        }
        let is_free = !matches!(self.roll, Some(GivenOrFree::Given(_))) && self.side.is_none();
        if self.roll_moment.is_some() && !(is_free && matches!(load, Load::Loaded { .. })) {
            let other = if is_free { key } else { "roll" };
            let [first, second] = ["roll_moment", other].map(|key| (WHEELSET, key));
            return Err(CaseError::Conflict { first, second });
        }
        load.checked()?;
        Ok(Some(load))
    }

    /// The loads of both wheels in a curve: of a rigid vehicle that leans outwards by the acceleration in the
    /// plane of its track.
    pub(super) fn load_in_curve(
        &self,
        track: &TrackSection,
        (speed, curvature): (f64, f64),
        tapes: f64,
    ) -> Result<Option<Load>, CaseError> {
        const GRAVITY: f64 = 9.806_65;
        let missing = |key: &str| CaseError::Missing { section: WHEELSET.into(), key: key.into() };
        let (mass, height) = match (self.mass, self.centre_height) {
            (Some(mass), Some(height)) => (mass, height),
            (None, None) if track.superelevation.is_none() => return Ok(None),
            (None, None) if self.load()?.is_some() => return Ok(None),
            (None, _) => return Err(missing("mass")),
            (_, None) => return Err(missing("centre_height")),
        };
        if let Some(load) = self.load()? {
            let [first, second] = ["mass", load.key()].map(|key| (WHEELSET, key));
            return Err(CaseError::Conflict { first, second });
        }
        let positive = |key, value: f64| {
            checked(WHEELSET, key, value, value > 0.0 && value.is_finite(), "positive and finite")
        };
        let (mass, height) = (positive("mass", mass)?, positive("centre_height", height)?);
        let raised = track.superelevation.unwrap_or(0.0);
        let is_valid = raised.abs() < 0.5 * tapes;
        let valid = "less than half of the distance between the wheels' running circles";
        let raised = checked("track", "superelevation", raised, is_valid, valid)?;
        let tilt = (raised / tapes).asin();
        let outward = speed * speed * curvature.abs();
        let aside = outward * tilt.cos() - GRAVITY * tilt.sin();
        let down = GRAVITY * tilt.cos() + outward * tilt.sin();
        let (half, more) = (0.5 * mass * down, mass * aside * height / tapes);
        let [outer, inner] = [half + more, half - more];
        let least = outer.min(inner);
        let valid = "positive: the vehicle overturns at this speed, radius and superelevation";
        checked(WHEELSET, "load of the lighter wheel in the curve", least, least > 0.0, valid)?;
        Ok(Some(if curvature < 0.0 {
            Load::Wheels([inner, outer])
        } else {
            Load::Wheels([outer, inner])
        }))
    }

    /// One wheel alone takes its own load, and nothing lets it roll.
    fn alone(&self, name: SideName) -> Result<Side, WheelsetError> {
        let (side, word) = match name {
            SideName::Left => (Side::Left, "left"),
            SideName::Right => (Side::Right, "right"),
        };
        let wrong = |key, instead| Err(WheelsetError::OneWheel { key, side: word, instead });
        let both = [("axle_load", self.axle_load), ("wheel_load_left", self.wheel_load_left)];
        let mut both = both.into_iter().chain([("mass", self.mass)]);
        if let Some((key, _)) = both.find(|(_, value)| value.is_some()) {
            return wrong(key, "give wheel_load or z");
        }
        match self.roll {
            Some(GivenOrFree::Given(_)) => Ok(side),
            Some(GivenOrFree::Free) => wrong("roll = \"free\"", "give a number"),
            None => Err(CaseError::Missing { section: WHEELSET.into(), key: "roll".into() }.into()),
        }
    }
}

/// What a speed must be, and what to do where it is not.
const MOVING: &str = "finite, and not zero unless the wheels spin at given pitch rates: at rest nothing rolls, and \
    what a contact carries depends on its history (`creepage roll` solves that of one contact; a small speed \
    with creepages kept gives steady rolling)";

impl MotionSection {
    /// How it moves on a track of a curvature (1/m) whose rails move.
    pub(super) fn travel(
        &self,
        curvature: f64,
        rails: [RailMotion; 2],
    ) -> Result<WheelsetVelocity, CaseError> {
        let rate = |value: Option<f64>| value.unwrap_or(0.0);
        let travel = WheelsetVelocity {
            speed: self.speed,
            pitch: self.pitch()?,
            drive: self.drive()?,
            lateral_velocity: rate(self.lateral_velocity),
            vertical_velocity: rate(self.vertical_velocity),
            roll_rate: rate(self.roll_rate),
            yaw_rate: rate(self.yaw_rate),
            curvature,
            rails,
        };
        travel.checked()?;
        if (self.torque.is_some() || self.longitudinal_force.is_some()) && !travel.is_free() {
            let given = if self.torque.is_some() { "torque" } else { "longitudinal_force" };
            let [first, second] = [given, "pitch_rate"].map(|key| (MOTION, key));
            return Err(CaseError::Conflict { first, second });
        }
        // Two wheels that turn apart share no force.
        if self.longitudinal_force.is_some() && matches!(travel.pitch, PitchRate::Independent(_)) {
            let [first, second] = ["longitudinal_force", "wheels"].map(|key| (MOTION, key));
            return Err(CaseError::Conflict { first, second });
        }
        Ok(travel)
    }

    fn pitch(&self) -> Result<PitchRate, CaseError> {
        let independent = self.wheels == Some(WheelsOnAxle::Independent);
        let conflict = |one, other| {
            let [first, second] = [one, other].map(|key| (MOTION, key));
            Err(CaseError::Conflict { first, second })
        };
        let apart = [self.pitch_rate_left, self.pitch_rate_right];
        if apart.iter().any(Option::is_some) {
            return match (self.pitch_rate, self.wheels) {
                (Some(_), _) => conflict("pitch_rate_left", "pitch_rate"),
                (_, Some(WheelsOnAxle::Rigid)) => conflict("pitch_rate_left", "wheels"),
                _ => Ok(PitchRate::Independent(apart.map(|rate| rate?.number()))),
            };
        }
        match self.pitch_rate {
            Some(PitchValue::Wheels(_)) if self.wheels == Some(WheelsOnAxle::Rigid) => {
                conflict("pitch_rate", "wheels")
            }
            Some(PitchValue::Wheels(rates)) => {
                Ok(PitchRate::Independent(rates.map(GivenOrFree::number)))
            }
            Some(PitchValue::Axle(rate)) if independent => {
                Ok(PitchRate::Independent([rate.number(); 2]))
            }
            Some(PitchValue::Axle(rate)) => Ok(PitchRate::Rigid(rate.number())),
            None if independent => Ok(PitchRate::Independent([None; 2])),
            None => Ok(PitchRate::Rigid(None)),
        }
    }

    fn drive(&self) -> Result<Drive, CaseError> {
        match (self.torque, self.longitudinal_force) {
            (Some(_), Some(_)) => {
                let [first, second] = ["torque", "longitudinal_force"].map(|key| (MOTION, key));
                Err(CaseError::Conflict { first, second })
            }
            (_, Some(force)) => Ok(Drive::Force(force)),
            (torque, None) => Ok(Drive::Torque(torque.unwrap_or(0.0))),
        }
    }
}

fn finite(section: &'static str, key: &'static str, value: f64) -> Result<f64, CaseError> {
    checked(section, key, value, value.is_finite(), "finite")
}

impl WheelsetPose {
    /// Checks numbers that come from elsewhere than a file.
    ///
    /// # Errors
    /// [`CaseError`] unless all are finite and the load positive.
    pub fn checked(&self) -> Result<(), CaseError> {
        finite(WHEELSET, "y", self.y)?;
        finite(WHEELSET, "yaw", self.yaw)?;
        finite(WHEELSET, "roll", self.roll.unwrap_or(0.0))?;
        self.load.map_or(Ok(()), Load::checked)
    }
}

impl Load {
    /// The key of `[wheelset]` that gives it.
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Axle(_) | Self::Loaded { .. } => "axle_load",
            Self::Wheel(_) => "wheel_load",
            Self::Wheels(_) => "wheel_load_left",
            Self::Height(_) => "z",
        }
    }

    /// Whether each of its numbers makes sense.
    fn checked(self) -> Result<(), CaseError> {
        let positive = |value: f64| {
            let is_valid = value > 0.0 && value.is_finite();
            checked(WHEELSET, self.key(), value, is_valid, "positive and finite")
        };
        match self {
            Self::Axle(load) | Self::Wheel(load) => positive(load)?,
            Self::Loaded { load, moment } => {
                finite(WHEELSET, "roll_moment", moment)?;
                positive(load)?
            }
            Self::Wheels(loads) => {
                for (key, load) in ["wheel_load_left", "wheel_load_right"].into_iter().zip(loads) {
                    let is_valid = load >= 0.0 && load.is_finite();
                    checked(WHEELSET, key, load, is_valid, "finite and not negative")?;
                }
                let valid = "positive: one wheel at least carries";
                let sum = loads[0] + loads[1];
                checked(WHEELSET, "sum of both wheel loads", sum, sum > 0.0, valid)?
            }
            Self::Height(z) => finite(WHEELSET, "z", z)?,
        };
        Ok(())
    }
}

impl WheelsetVelocity {
    /// Checks numbers that come from elsewhere than a file.
    ///
    /// # Errors
    /// [`CaseError`] unless all are finite and the wheelset moves.
    pub fn checked(&self) -> Result<(), CaseError> {
        let rates = match self.pitch {
            PitchRate::Rigid(rate) => [rate; 2],
            PitchRate::Independent(rates) => rates,
        };
        let spins = rates.iter().all(|rate| rate.is_some_and(|rate| rate != 0.0));
        let moves = (self.speed != 0.0 || spins) && self.speed.is_finite();
        checked(MOTION, "speed", self.speed, moves, MOVING)?;
        let drive = match self.drive {
            Drive::Torque(torque) => ("torque", torque),
            Drive::Force(force) => ("longitudinal_force", force),
        };
        for (key, value) in [
            ("pitch_rate", rates[0].unwrap_or(0.0)),
            ("pitch_rate", rates[1].unwrap_or(0.0)),
            drive,
            ("lateral_velocity", self.lateral_velocity),
            ("vertical_velocity", self.vertical_velocity),
            ("roll_rate", self.roll_rate),
            ("yaw_rate", self.yaw_rate),
        ] {
            finite(MOTION, key, value)?;
        }
        finite("track", "curvature", self.curvature)?;
        for rail in self.rails {
            finite("rail", "dy_rate", rail.lateral_velocity)?;
            finite("rail", "dz_rate", rail.vertical_velocity)?;
            finite("rail", "droll_rate", rail.roll_rate)?;
        }
        Ok(())
    }
}
