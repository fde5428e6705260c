//! What the file of a wheelset describes, every number of it checked.

use std::path::PathBuf;

use creepage::{SolidPair, TheorySpec};
use creepage_rail::file::Action;
use creepage_rail::{Running, Side};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{DamageWanted, Sources};

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
    /// Coefficient of friction, where it is given.
    pub friction: Option<f64>,
    /// What the surfaces slide by before they deform.
    pub slip: RigidSlip,
    /// The laws of wear and fatigue, where their numbers are wanted.
    pub damage: Option<DamageWanted>,
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

/// What holds a wheelset down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// Vertical force of the wheelset on the track (N).
    Axle(f64),
    /// Vertical force of a wheel on its rail (N).
    Wheel(f64),
    /// Its height (m, down); at 0 the nominal circle touches the track plane.
    Height(f64),
}

/// How a wheelset moves, as far as it is given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Travel {
    /// Speed along the track (m/s).
    pub speed: f64,
    /// Angular velocity about the axle (rad/s); free where `None`.
    pub pitch_rate: Option<f64>,
    /// Velocity to the right (m/s).
    pub lateral_velocity: f64,
    /// Velocity downwards (m/s).
    pub vertical_velocity: f64,
    /// Angular velocity about `x` (rad/s), positive where the right wheel goes down.
    pub roll_rate: f64,
    /// Angular velocity about `z` (rad/s).
    pub yaw_rate: f64,
}
