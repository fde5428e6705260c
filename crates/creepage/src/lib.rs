//! Rolling contact of two elastic bodies with dry friction.

pub mod halfspace;
pub mod rolling;
pub mod special;
pub mod statics;

mod check;
mod ellipse;
mod hertz;
mod solid;

pub use check::InvalidValue;
pub use ellipse::Ellipse;
pub use hertz::{Hertz, HertzError, Radii};
pub use solid::{Solid, SolidPair};
