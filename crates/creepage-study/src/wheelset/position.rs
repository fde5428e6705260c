//! `[wheelset]` and `[motion]`: where the wheelset stands, and how it moves.

use creepage_rail::{RailMotion, Side};
use creepage_wheelset::{Drive, Load, PitchRate, WheelsetPose, WheelsetVelocity};

use super::error::{WheelsetFileError, checked};
use super::free::{GivenOrFree, PitchValue};
use super::sections::{MotionSection, SideName, TrackSection, WheelsOnAxle, WheelsetSection};
use super::vehicle::VehicleInCurve;
use crate::case::CaseError;

const WHEELSET: &str = "wheelset";
const MOTION: &str = "motion";
/// Larger angles of roll and yaw are refused (rad).
const TURN: f64 = 0.5;

fn finite(section: &'static str, key: &'static str, value: f64) -> Result<f64, CaseError> {
    checked(section, key, value, value.is_finite(), "finite")
}

impl WheelsetSection {
    /// Where it stands; what holds it down may be left out.
    pub(super) fn stance(&self) -> Result<WheelsetPose, WheelsetFileError> {
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
    fn load(&self) -> Result<Option<Load>, WheelsetFileError> {
        let wheels = match (self.wheel_load_left, self.wheel_load_right) {
            (Some(left), Some(right)) => Some(Load::Wheels([left, right])),
            (None, None) => None,
            (left, _) => {
                let key = if left.is_some() { "wheel_load_right" } else { "wheel_load_left" };
                return Err(CaseError::Missing { section: WHEELSET.into(), key: key.into() }.into());
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
                    Err(CaseError::Missing { section: WHEELSET.into(), key: "axle_load".into() }
                        .into())
                }
                None => Ok(None),
            };
        };
        if let Some((other, _)) = given.next() {
            return Err(
                CaseError::Conflict { first: (WHEELSET, key), second: (WHEELSET, other) }.into()
            );
        }
        let is_free = !matches!(self.roll, Some(GivenOrFree::Given(_))) && self.side.is_none();
        if self.roll_moment.is_some() && !(is_free && matches!(load, Load::Loaded { .. })) {
            let other = if is_free { key } else { "roll" };
            let [first, second] = ["roll_moment", other].map(|key| (WHEELSET, key));
            return Err(CaseError::Conflict { first, second }.into());
        }
        load.checked()?;
        Ok(Some(load))
    }

    /// The vehicle whose loads follow from the statics of a curve, where they are not given.
    pub(super) fn vehicle(
        &self,
        track: &TrackSection,
        tapes: f64,
    ) -> Result<Option<VehicleInCurve>, WheelsetFileError> {
        let missing = |key: &str| CaseError::Missing { section: WHEELSET.into(), key: key.into() };
        let (mass, height) = match (self.mass, self.centre_height) {
            (Some(mass), Some(height)) => (mass, height),
            (None, None) if track.superelevation.is_none() => return Ok(None),
            (None, None) => {
                let Some(load) = self.load()? else { return Err(missing("mass").into()) };
                return Err(WheelsetFileError::SuperelevationOfLoad { key: load.key() });
            }
            (None, _) => return Err(missing("mass").into()),
            (_, None) => return Err(missing("centre_height").into()),
        };
        if let Some(load) = self.load()? {
            let [first, second] = ["mass", load.key()].map(|key| (WHEELSET, key));
            return Err(CaseError::Conflict { first, second }.into());
        }
        let raised = track.superelevation.unwrap_or(0.0);
        VehicleInCurve::new([mass, height, raised], tapes).map(Some)
    }

    /// One wheel alone takes its own load, and nothing lets it roll.
    fn alone(&self, name: SideName) -> Result<Side, WheelsetFileError> {
        let (side, word) = match name {
            SideName::Left => (Side::Left, "left"),
            SideName::Right => (Side::Right, "right"),
        };
        let wrong = |key, instead| {
            Err(WheelsetFileError::OneWheel { section: WHEELSET, key, side: word, instead })
        };
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

impl MotionSection {
    /// How it moves on a track of a curvature (1/m) whose rails move.
    pub(super) fn travel(
        &self,
        curvature: f64,
        rails: [RailMotion; 2],
    ) -> Result<WheelsetVelocity, WheelsetFileError> {
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
            return Err(CaseError::Conflict { first, second }.into());
        }
        // Two wheels that turn apart share no force.
        if self.longitudinal_force.is_some() && matches!(travel.pitch, PitchRate::Independent(_)) {
            let [first, second] = ["longitudinal_force", "wheels"].map(|key| (MOTION, key));
            return Err(CaseError::Conflict { first, second }.into());
        }
        Ok(travel)
    }

    fn pitch(&self) -> Result<PitchRate, WheelsetFileError> {
        let independent = self.wheels == Some(WheelsOnAxle::Independent);
        let conflict = |one, other| {
            let [first, second] = [one, other].map(|key| (MOTION, key));
            Err(CaseError::Conflict { first, second }.into())
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

    fn drive(&self) -> Result<Drive, WheelsetFileError> {
        match (self.torque, self.longitudinal_force) {
            (Some(_), Some(_)) => {
                let [first, second] = ["torque", "longitudinal_force"].map(|key| (MOTION, key));
                Err(CaseError::Conflict { first, second }.into())
            }
            (_, Some(force)) => Ok(Drive::Force(force)),
            (torque, None) => Ok(Drive::Torque(torque.unwrap_or(0.0))),
        }
    }
}
