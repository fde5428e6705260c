//! Steady rolling with friction: creepage and spin in, tangential force and moment out.
//!
//! Every theory works in the thesis's dimensionless quantities (4.20); [`Scaling`] is the one
//! place where they meet SI units.
//!
//! # Sign convention
//! `x` is the rolling direction, `z` points into the lower body; material flows through the
//! contact towards `-x`, so the leading edge is at `x > 0`. Creepage and spin are the velocity
//! of the **upper** body relative to the **lower**, over the rolling velocity. Tractions,
//! forces and the moment are exerted **by the upper body on the lower**, and have the sense of
//! the slip.

pub mod carter;
pub mod fastrip;
pub mod fastsim;
pub mod linear;
pub mod polach;
pub mod saturated;
pub mod shen_hedrick_elkins;
pub mod strip;
pub mod variational;
pub mod vermeulen_johnson;

mod chords;
mod creepage;
mod cubic;
mod dual;
mod field;
mod scaling;
mod theory;

pub use creepage::{Creepage, Force};
pub use field::{FieldPoint, Region};
pub use scaling::{Scaling, SiCreepage, SiForce};
pub use theory::{Solution, Status, Theory};
