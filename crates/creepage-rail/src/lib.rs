//! Wheel and rail: profiles, their files, the geometry of contact and the creepage of a wheelset.
//!
//! No contact theory here. A [`Wheelset`] on a [`Track`] in a [`Position`] hands out, for every
//! place of contact, the undeformed distance in the plane of contact and the rigid slip in it:
//! what a theory of contact takes.
//!
//! Axes of the track are right-handed: `x` forward, `y` to the right, `z` down; roll is about
//! `x`, yaw about `z`. A profile has its own coordinates: `y` to the **field side** on both sides
//! of the track, `z` down. Everything is in SI units: m, rad, s.

pub mod curve;
mod profile;
mod standard;

pub use curve::{Curve, CurvePoint, Piece, SplineError};
pub use profile::{Profile, ProfileError, Role};
pub use standard::{RailHead, Standard};
