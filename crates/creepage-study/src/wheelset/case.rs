//! What the file of a wheelset describes, every number of it checked.

use std::path::PathBuf;

use creepage::{SolidPair, TheorySpec};
use creepage_rail::file::Action;
use creepage_rail::{RailMotion, Running, Side};
use schemars::JsonSchema;
use serde::Deserialize;

use super::friction::RailFriction;
use super::springs::RailSprings;
use crate::{DamageWanted, HeatWanted, Sources};

/// A wheelset in its track.
#[derive(Debug, Clone)]
pub struct WheelsetCase {
    /// Wheels and rails.
    pub running: Running,
    /// Where the wheelset stands.
    pub stance: Stance,
    /// How it moves, where that is given.
    pub travel: Option<Travel>,
    /// Wheel and rail, where their materials are given.
    pub solids: Option<SolidPair>,
    /// Friction on the left and the right rail, where it is given.
    pub friction: Option<[RailFriction; 2]>,
    /// Springs of the left and the right rail, where they lie on any.
    pub springs: [Option<RailSprings>; 2],
    /// What the surfaces slide by before they deform.
    pub slip: RigidSlip,
    /// Whether areas in planes of their own feel each other.
    pub patches: Patches,
    /// The laws of wear and fatigue, where their numbers are wanted.
    pub damage: Option<DamageWanted>,
    /// What is wanted of temperatures; wheels are the upper bodies.
    pub heat: Option<HeatWanted>,
    /// The theory and its options.
    pub theory: TheorySpec,
    /// Profile files, and what had to be found in them.
    pub notes: Vec<ProfileNote>,
}

impl WheelsetCase {
    /// The profile files it was read from.
    #[must_use]
    pub fn sources(&self) -> Sources {
        Sources::new(self.notes.iter().map(|note| &note.path))
    }
}

/// A profile's file, and what was found in it that nobody had said.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileNote {
    /// The file.
    pub path: PathBuf,
    /// What was found, assumed and done.
    pub actions: Vec<Action>,
}

/// How the rigid slip of a contact follows from the wheelset's motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Patches {
    /// Each sinks under the load of the others, as elastic bodies do.
    #[default]
    Together,
    /// Each is pressed as if it were alone, as most programs have it. At a given height loads differ by
    /// tens of per cent from those of areas together.
    Apart,
}

/// Where a wheelset stands, as far as it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stance {
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

impl Stance {
    /// Whether nothing but the height is left to be given.
    pub(super) fn is_fixed(&self) -> bool {
        self.side.is_some() || self.roll.is_some()
    }
}

impl Stance {
    /// Its mirror image fore and aft.
    pub(super) fn fore_and_aft(&self) -> Self {
        Self { yaw: -self.yaw, ..*self }
    }
}

/// What holds a wheelset down.
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
    pub(super) fn by_levers(self, [left, right]: [f64; 2]) -> Self {
        match self {
            Self::Loaded { load, moment } => {
                let on_right = (moment - load * left) / (right - left);
                Self::Wheels([load - on_right, on_right])
            }
            other => other,
        }
    }

    /// What a wheel is to carry by itself (N), where that is given.
    pub(super) fn of_wheel(self, side: Side) -> Option<f64> {
        match self {
            Self::Wheel(load) => Some(load),
            Self::Wheels(loads) => Some(loads[usize::from(side == Side::Right)]),
            Self::Axle(_) | Self::Loaded { .. } | Self::Height(_) => None,
        }
    }
}

/// What a pitch rate is found from.
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

/// How the wheels turn.
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

/// How a wheelset moves, as far as it is given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Travel {
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

impl Travel {
    /// Whether a pitch rate is to be found.
    #[must_use]
    pub fn is_free(&self) -> bool {
        match self.pitch {
            PitchRate::Rigid(rate) => rate.is_none(),
            PitchRate::Independent(rates) => rates.contains(&None),
        }
    }

    /// Whether it runs backwards; at rest, whether it turns so.
    pub(super) fn is_backward(&self) -> bool {
        let turns = match self.pitch {
            PitchRate::Rigid(rate) => rate.unwrap_or(0.0),
            PitchRate::Independent(rates) => rates.iter().flatten().sum(),
        };
        if self.speed == 0.0 { turns < 0.0 } else { self.speed < 0.0 }
    }

    /// Its mirror image fore and aft: a curve to the right is one still.
    pub(super) fn fore_and_aft(&self) -> Self {
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
