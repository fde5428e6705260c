//! `[wheelset]` and `[motion]`: where the wheelset stands, and how it moves.

use creepage_rail::Side;

use super::case::{Load, Stance, Travel};
use super::error::{WheelsetError, checked};
use super::free::Freely;
use super::sections::{MotionSection, SideName, WheelsetSection};
use crate::case::CaseError;

const WHEELSET: &str = "wheelset";
const MOTION: &str = "motion";
/// Larger angles of roll and yaw are refused (rad).
const TURN: f64 = 0.5;

impl WheelsetSection {
    /// Where it stands; what holds it down may be left out.
    pub(super) fn stance(&self) -> Result<Stance, WheelsetError> {
        let length = |key, value: Option<f64>| finite(WHEELSET, key, value.unwrap_or(0.0));
        let angle =
            |key, value: f64| checked(WHEELSET, key, value, value.abs() <= TURN, "-0.5 to 0.5 rad");
        let load = self.load()?;
        let side = self.side.map(|name| self.alone(name)).transpose()?;
        Ok(Stance {
            side,
            y: length("y", self.y)?,
            yaw: angle("yaw", self.yaw.unwrap_or(0.0))?,
            roll: match self.roll.and_then(Freely::number) {
                Some(roll) => Some(angle("roll", roll)?),
                None => None,
            },
            load,
        })
    }

    /// At most one of the three that hold it down.
    fn load(&self) -> Result<Option<Load>, CaseError> {
        let given = [
            ("axle_load", self.axle_load.map(Load::Axle)),
            ("wheel_load", self.wheel_load.map(Load::Wheel)),
            ("z", self.z.map(Load::Height)),
        ];
        let mut given = given.into_iter().filter_map(|(key, load)| Some((key, load?)));
        let Some((key, load)) = given.next() else { return Ok(None) };
        if let Some((other, _)) = given.next() {
            return Err(CaseError::Conflict { first: (WHEELSET, key), second: (WHEELSET, other) });
        }
        match load {
            Load::Axle(value) | Load::Wheel(value) => {
                let is_valid = value > 0.0 && value.is_finite();
                checked(WHEELSET, key, value, is_valid, "positive and finite")?
            }
            Load::Height(value) => finite(WHEELSET, key, value)?,
        };
        Ok(Some(load))
    }

    /// One wheel alone takes its own load, and nothing lets it roll.
    fn alone(&self, name: SideName) -> Result<Side, WheelsetError> {
        let (side, word) = match name {
            SideName::Left => (Side::Left, "left"),
            SideName::Right => (Side::Right, "right"),
        };
        let wrong = |key, instead| Err(WheelsetError::OneWheel { key, side: word, instead });
        if self.axle_load.is_some() {
            return wrong("axle_load", "give wheel_load or z");
        }
        match self.roll {
            Some(Freely::Given(_)) => Ok(side),
            Some(Freely::Free) => wrong("roll = \"free\"", "give a number"),
            None => Err(CaseError::Missing { section: WHEELSET.into(), key: "roll".into() }.into()),
        }
    }
}

/// What a speed must be, and what to do where it is not.
const FORWARD: &str = "positive and finite: at rest nothing rolls, and where a wheelset runs backwards give \
    the speed without its sign, yaw, yaw_rate and pitch_rate with the other one; then forces along x and \
    moments about y and z have the other sign too";

impl MotionSection {
    pub(super) fn travel(&self) -> Result<Travel, CaseError> {
        let rate = |key, value: Option<f64>| finite(MOTION, key, value.unwrap_or(0.0));
        let forward = self.speed > 0.0 && self.speed.is_finite();
        let pitch_rate = self.pitch_rate.and_then(Freely::number);
        Ok(Travel {
            speed: checked(MOTION, "speed", self.speed, forward, FORWARD)?,
            pitch_rate: pitch_rate.map(|rate| finite(MOTION, "pitch_rate", rate)).transpose()?,
            lateral_velocity: rate("lateral_velocity", self.lateral_velocity)?,
            vertical_velocity: rate("vertical_velocity", self.vertical_velocity)?,
            roll_rate: rate("roll_rate", self.roll_rate)?,
            yaw_rate: rate("yaw_rate", self.yaw_rate)?,
        })
    }
}

fn finite(section: &'static str, key: &'static str, value: f64) -> Result<f64, CaseError> {
    checked(section, key, value, value.is_finite(), "finite")
}

impl Stance {
    /// Checks numbers that come from elsewhere than a file.
    ///
    /// # Errors
    /// [`CaseError`] unless all are finite and the load positive.
    pub fn checked(&self) -> Result<(), CaseError> {
        finite(WHEELSET, "y", self.y)?;
        finite(WHEELSET, "yaw", self.yaw)?;
        finite(WHEELSET, "roll", self.roll.unwrap_or(0.0))?;
        match self.load {
            Some(Load::Axle(value)) => {
                let is_valid = value > 0.0 && value.is_finite();
                checked(WHEELSET, "axle_load", value, is_valid, "positive and finite")?
            }
            Some(Load::Wheel(value)) => {
                let is_valid = value > 0.0 && value.is_finite();
                checked(WHEELSET, "wheel_load", value, is_valid, "positive and finite")?
            }
            Some(Load::Height(value)) => finite(WHEELSET, "z", value)?,
            None => 0.0,
        };
        Ok(())
    }
}

impl Travel {
    /// Checks numbers that come from elsewhere than a file.
    ///
    /// # Errors
    /// [`CaseError`] unless all are finite and the wheelset runs forwards.
    pub fn checked(&self) -> Result<(), CaseError> {
        let forward = self.speed > 0.0 && self.speed.is_finite();
        checked(MOTION, "speed", self.speed, forward, FORWARD)?;
        for (key, value) in [
            ("pitch_rate", self.pitch_rate.unwrap_or(0.0)),
            ("lateral_velocity", self.lateral_velocity),
            ("vertical_velocity", self.vertical_velocity),
            ("roll_rate", self.roll_rate),
            ("yaw_rate", self.yaw_rate),
        ] {
            finite(MOTION, key, value)?;
        }
        Ok(())
    }
}
