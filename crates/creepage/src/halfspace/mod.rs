//! The elastic half-space: tractions on an ellipse in, displacement differences out.
//!
//! The load-displacement equations of chapters 2 and 3 are block diagonal in
//! [hemispherical harmonics](harmonics), and well conditioned there at any degree.

pub mod harmonics;
pub mod vanishing;

mod load_displacement;
mod polynomial;
mod products;

pub use load_displacement::LoadDisplacement;
pub use polynomial::{Polynomial, PolynomialError};
