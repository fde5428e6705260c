//! Normal contact of bodies of any shape, on the half-space: pressures that are not negative and keep the bodies apart,
//! on any number of patches in one system.
//!
//! With `E* = G/(1 - sigma)` and the undeformed distance `h`:
//!
//! ```math
//! \frac{1}{\pi E^*} \int \frac{p(x', y')}{R} dx' dy' + h \ge \delta, \qquad p \ge 0, \qquad
//! \text{equal where } p > 0.
//! ```
mod chord;
mod complementarity;
mod contact;
mod elements;
mod error;
mod lattice;
mod level;
mod load;
mod love;
mod outline;
mod overlap;
mod patch;
mod patch_strip;
mod product;
mod refinement;
mod solution;
mod solve;
pub(crate) mod strip_system;
mod strips;
mod turn;

pub(crate) use chord::ChordPoint;
pub(crate) use contact::SLIP_UNIT;
pub use contact::{Estimate, Method, NormalContact, Resolution, Status};
pub use error::{NormalError, Side};
pub use patch::Patch;
pub use patch_strip::{Band, Moments};
