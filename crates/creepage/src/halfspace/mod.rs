//! The elastic half-space: tractions on an ellipse in, displacement differences out.
//!
//! The load-displacement equations of chapters 2 and 3 are block diagonal in
//! [hemispherical harmonics](harmonics), and well conditioned there at any degree.
//! [`Polynomial`]s in `x`, `y` are the public face: a [`Traction`] is made of three, and
//! [`LoadDisplacement`] turns it into the displacement differences `u = u+ - u-` inside the
//! ellipse, [`DisplacementLoad`] these into the traction. [`DisplacementField`] evaluates the
//! displacement differences anywhere on the surface, for bodies that differ too.
//!
//! Tractions are over the combined shear modulus `G`, exerted on the lower body; lengths are
//! in the unit of the ellipse, displacements too.
//!
//! For like bodies they are Boussinesq's and Cerruti's integrals over the ellipse (2.11c), (2.15),
//! `R` the distance between `(x, y)` and `(x', y')`:
//!
//! ```math
//! \begin{aligned}
//! u &= \frac{1}{\pi G} \iint \left[
//!   \left( \frac{1 - \sigma}{R} + \frac{\sigma (x - x')^2}{R^3} \right) X
//!   + \frac{\sigma (x - x')(y - y')}{R^3} Y \right] dx' dy' \\
//! v &= \frac{1}{\pi G} \iint \left[ \frac{\sigma (x - x')(y - y')}{R^3} X
//!   + \left( \frac{1 - \sigma}{R} + \frac{\sigma (y - y')^2}{R^3} \right) Y \right] dx' dy' \\
//! w &= \frac{1 - \sigma}{\pi G} \iint \frac{Z}{R} \, dx' dy'
//! \end{aligned}
//! ```
//!
//! ```
//! use creepage::Ellipse;
//! use creepage::halfspace::{Edge, LoadDisplacement, Polynomial, Traction};
//! // Hertz: the pressure G f00 (1 - r^2)^(1/2) makes a paraboloid.
//! let ellipse = Ellipse::new(1.0, 1.0)?;
//! let (none, f00) = (Polynomial::zero(0), Polynomial::new(vec![0.1])?);
//! let hertz = Traction::new(ellipse, Edge::Vanishing, [&none, &none, &f00])?;
//! let [_, _, w] = LoadDisplacement::new(ellipse, 0.28, 2)?.displacement(&hertz)?;
//! let approach = 0.72 * 0.1 * std::f64::consts::FRAC_PI_2;
//! assert!((w.coefficient(0, 0) - approach).abs() < 1e-15);
//! assert!((w.coefficient(2, 0) + approach / 2.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod closed_forms;
pub mod coefficients;
pub mod harmonics;
pub(crate) mod vanishing;

mod coupling;
mod displacement_field;
mod displacement_load;
mod elliptic;
mod lines;
mod load_displacement;
mod polynomial;
mod products;
mod traction;

use crate::check::InvalidValue;
use crate::ellipse::Ellipse;

pub use displacement_field::DisplacementField;
pub use displacement_load::DisplacementLoad;
pub use load_displacement::LoadDisplacement;
pub use polynomial::{Polynomial, PolynomialError};
pub use traction::{Edge, Resultants, Traction};

/// Error of the half-space's response.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResponseError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// A result is no polynomial of finite coefficients.
    #[error(transparent)]
    Polynomial(#[from] PolynomialError),
    /// The equations were prepared for another ellipse.
    #[error("the equations were prepared for the ellipse {prepared:?}, not for {given:?}")]
    OtherEllipse {
        /// The ellipse that was given.
        given: Ellipse,
        /// The ellipse that the equations belong to.
        prepared: Ellipse,
    },
    /// The equations were prepared for a lower degree.
    #[error("degree {needed} is needed, but the equations were prepared up to {prepared}")]
    Degree {
        /// Degree of the displacements.
        needed: usize,
        /// Degree that was prepared.
        prepared: usize,
    },
    /// No traction that vanishes at the edge causes the displacement.
    #[error(
        "no traction that vanishes at the edge causes this displacement: the nearest one misses \
         it by a part {residual:e} of its size"
    )]
    Unreachable {
        /// Largest difference of a harmonic's coefficient over the largest coefficient.
        residual: f64,
    },
    /// Rounding has made a block of the equations singular.
    #[error("the equations of degree {degree} are singular to working precision")]
    Singular {
        /// Degree of the block.
        degree: usize,
    },
}
