//! Wheel and rail: profiles, their files, the geometry of contact and the creepage of a wheelset.
//!
//! No contact theory here. A [`Wheelset`] on a [`Track`] in a [`Position`] hands out, for every
//! place of contact, the undeformed distance in the plane of contact and the rigid slip in it:
//! what a theory of contact takes.
//!
//! Axes of the track are right-handed: `x` forward, `y` to the right, `z` down; roll is about
//! `x`, yaw about `z`. A profile has its own coordinates: `y` to the **field side** on both sides
//! of the track, `z` down. Everything is in SI units: m, rad, s.
//!
//! ```
//! use creepage_rail::{Place, Position, Side, Standard, Track, Wheelset};
//!
//! let rail = Standard::Uic60.profile();
//! let wheel = Standard::S1002.profile();
//! let track = Track::new(&rail, 0.025f64.atan(), Place::gauge(1.435, 0.014))?;
//! let running = Wheelset::like(&wheel, 0.46, 1.360)?.on(track);
//!
//! let touching = running.resting(0.003, 0.0, None)?;
//! let pressed = Position { z: touching.z + 20e-6, ..touching };
//! let contacts = running.contacts(&pressed)?;
//! assert_eq!(contacts.len(), 2);
//! assert!(contacts.iter().any(|contact| contact.side == Side::Right && contact.angle < -0.09));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod conicity;
mod contact;
pub mod curve;
pub mod file;
mod frame;
mod geometry_error;
mod measures;
mod meeting;
mod motion;
mod pair_surfaces;
mod profile;
mod roller;
mod rolling;
mod running;
mod search;
mod slices;
mod standard;
mod surfaces;
mod track;
mod variation;
mod varying_contact;
mod varying_search;
mod waves;
mod wheel;

pub use conicity::{ConicityError, RadiusDifference};
pub use contact::{Across, Contact};
pub use curve::{Curve, CurvePoint, Piece, Smoothing, SplineError};
pub use frame::Side;
pub use geometry_error::GeometryError;
pub use measures::WheelMeasures;
pub use motion::{Motion, RailMotion};
pub use pair_surfaces::contact_axes;
pub use profile::{Profile, ProfileError, Role};
pub use roller::Roller;
pub use rolling::{Revolving, RollingCreepage, SurfaceMotion};
pub use running::{Touch, WheelsetOnTrack};
pub use slices::{Slice, SliceError, SliceSurface};
pub use standard::{RailHead, Standard};
pub use track::{Deviation, Place, Rail, Track};
pub use variation::{Corrugation, Flat, FlatShape, RailVariation, Waviness, WheelVariation};
pub use waves::Waves;
pub use wheel::{Position, Wheel, Wheelset};
