//! Pose, load and velocity of a wheelset, as far as they are given.

use creepage_rail::{RailMotion, Side};

use crate::error::{WheelsetError, checked};

const WHEELSET: &str = "wheelset";
const MOTION: &str = "motion";
/// What a speed must be, and what to do where it is not.
const MOVING: &str = "finite, and not zero unless the wheels spin at given pitch rates: at rest nothing rolls, and \
    what a contact carries depends on its history (`creepage roll` solves that of one contact; a small speed \
    with creepages kept gives steady rolling)";

/// How the rigid slip of a contact follows from the wheelset's motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "schema",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "lowercase")
)]
pub enum RigidSlip {
    /// Creepage and spin at the reference point, all over the contact: what programs of contact
    /// mechanics mostly do.
    #[default]
    Flat,
    /// The rolling radius and the direction of the surface at every place of the contact: across
    /// a curved contact spin varies.
    Curved,
}

/// Whether areas of contact in planes of their own feel each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "schema",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "lowercase")
)]
pub enum Patches {
    /// Each sinks under the load of the others, as elastic bodies do.
    #[default]
    Together,
    /// Each is pressed as if it were alone, as most programs have it. At a given height loads differ by
    /// tens of per cent from those of areas together.
    Apart,
}

/// Pose of a wheelset, as far as it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelsetPose {
    /// One wheel alone; both where `None`.
    pub side: Option<Side>,
    /// Its centre to the right of the track centre (m).
    pub y: f64,
    /// Turn about `z` (rad), positive turns the axle's right end back.
    pub yaw: f64,
    /// Turn about `x` (rad), positive lowers the right wheel; free where `None`.
    pub roll: Option<f64>,
    /// What holds it down.
    pub load: Option<Load>,
}

impl WheelsetPose {
    /// Whether nothing but the height is left to be given.
    pub(crate) fn is_fixed(&self) -> bool {
        self.side.is_some() || self.roll.is_some()
    }
}

impl WheelsetPose {
    /// Its mirror image fore and aft.
    pub(crate) fn fore_and_aft(&self) -> Self {
        Self { yaw: -self.yaw, ..*self }
    }
}

/// Vertical constraint of a wheelset: load or height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// Vertical force of the wheelset on the track (N); where it rolls freely, half of it on each rail.
    Axle(f64),
    /// The same where it rolls freely under a given moment.
    Loaded {
        /// Vertical force of the wheelset on the track (N).
        load: f64,
        /// Moment about `x` with which it presses on the track, about its centre (N m), positive where it
        /// presses the right wheel down.
        moment: f64,
    },
    /// Vertical force of a wheel on its rail (N), the same on both.
    Wheel(f64),
    /// Vertical forces of the left and the right wheel on their rails (N).
    Wheels([f64; 2]),
    /// Its height (m, down); at 0 the nominal circle touches the track plane.
    Height(f64),
}

impl Load {
    /// Vertical forces of the left and the right wheel (N) that carry this load where each unit of force
    /// has these levers about `x` (m): by a given moment, which no other load has.
    pub(crate) fn by_levers(self, [left, right]: [f64; 2]) -> Self {
        match self {
            Self::Loaded { load, moment } => {
                let on_right = (moment - load * left) / (right - left);
                Self::Wheels([load - on_right, on_right])
            }
            other => other,
        }
    }

    /// What a wheel is to carry by itself (N), where that is given.
    #[must_use]
    pub fn of_wheel(self, side: Side) -> Option<f64> {
        match self {
            Self::Wheel(load) => Some(load),
            Self::Wheels(loads) => Some(loads[usize::from(side == Side::Right)]),
            Self::Axle(_) | Self::Loaded { .. } | Self::Height(_) => None,
        }
    }
}

/// Condition that gives a pitch rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// A torque about the axle (N m), positive where it drives forward: friction balances it. None
    /// where the wheelset rolls freely.
    Torque(f64),
    /// The sum of the forces along `x` on the rails (N), as it is reported: negative where the wheelset drives.
    Force(f64),
}

impl Default for Drive {
    fn default() -> Self {
        Self::Torque(0.0)
    }
}

/// Pitch rate of the wheels, or the condition that gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PitchRate {
    /// Together, at a given angular velocity about the axle (rad/s), or one that is found.
    Rigid(Option<f64>),
    /// Each by itself on the axle, the left and the right one, at a given angular velocity (rad/s) or one
    /// that is found.
    Independent([Option<f64>; 2]),
}

impl Default for PitchRate {
    fn default() -> Self {
        Self::Rigid(None)
    }
}

/// Velocity of a wheelset, as far as it is given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WheelsetVelocity {
    /// Speed along the track (m/s); negative where it runs backwards.
    pub speed: f64,
    /// Angular velocity about the axle.
    pub pitch: PitchRate,
    /// What it is found from where it is not given; of independent wheels each.
    pub drive: Drive,
    /// Velocity to the right (m/s).
    pub lateral_velocity: f64,
    /// Velocity downwards (m/s).
    pub vertical_velocity: f64,
    /// Angular velocity about `x` (rad/s), positive where the right wheel goes down.
    pub roll_rate: f64,
    /// Angular velocity about `z`, against the track (rad/s).
    pub yaw_rate: f64,
    /// Curvature of the track (1/m), positive in a right-hand curve.
    pub curvature: f64,
    /// How the left and the right rail move.
    pub rails: [RailMotion; 2],
}

impl WheelsetVelocity {
    /// Whether a pitch rate is to be found.
    #[must_use]
    pub fn is_free(&self) -> bool {
        match self.pitch {
            PitchRate::Rigid(rate) => rate.is_none(),
            PitchRate::Independent(rates) => rates.contains(&None),
        }
    }

    /// Whether it runs backwards; at rest, whether it turns so.
    pub(crate) fn is_backward(&self) -> bool {
        let turns = match self.pitch {
            PitchRate::Rigid(rate) => rate.unwrap_or(0.0),
            PitchRate::Independent(rates) => rates.iter().flatten().sum(),
        };
        if self.speed == 0.0 { turns < 0.0 } else { self.speed < 0.0 }
    }

    /// Its mirror image fore and aft: a curve to the right is one still.
    pub(crate) fn fore_and_aft(&self) -> Self {
        let turned = |rate: Option<f64>| rate.map(|rate| -rate);
        Self {
            speed: -self.speed,
            yaw_rate: -self.yaw_rate,
            pitch: match self.pitch {
                PitchRate::Rigid(rate) => PitchRate::Rigid(turned(rate)),
                PitchRate::Independent(rates) => PitchRate::Independent(rates.map(turned)),
            },
            drive: match self.drive {
                Drive::Torque(torque) => Drive::Torque(-torque),
                Drive::Force(force) => Drive::Force(-force),
            },
            ..*self
        }
    }
}

fn finite(section: &'static str, key: &'static str, value: f64) -> Result<f64, WheelsetError> {
    checked(section, key, value, value.is_finite(), "finite")
}

impl WheelsetPose {
    /// Checks numbers that come from elsewhere than a file.
    ///
    /// # Errors
    /// [`WheelsetError`] unless all are finite and the load positive.
    pub fn checked(&self) -> Result<(), WheelsetError> {
        finite(WHEELSET, "y", self.y)?;
        finite(WHEELSET, "yaw", self.yaw)?;
        finite(WHEELSET, "roll", self.roll.unwrap_or(0.0))?;
        self.load.map_or(Ok(()), Load::checked)
    }
}

impl Load {
    /// The key of `[wheelset]` that gives it.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Axle(_) | Self::Loaded { .. } => "axle_load",
            Self::Wheel(_) => "wheel_load",
            Self::Wheels(_) => "wheel_load_left",
            Self::Height(_) => "z",
        }
    }

    /// Whether each of its numbers makes sense.
    ///
    /// # Errors
    /// [`WheelsetError::Invalid`] unless loads are positive and all is finite.
    pub fn checked(self) -> Result<(), WheelsetError> {
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
    /// [`WheelsetError`] unless all are finite and the wheelset moves.
    pub fn checked(&self) -> Result<(), WheelsetError> {
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
