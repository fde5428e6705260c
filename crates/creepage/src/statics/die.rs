//! Rigid, flat die of elliptical base, pressed into a half-space (3.211).

use std::f64::consts::PI;

use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;
use crate::halfspace::{DisplacementField, Edge, Polynomial, ResponseError, Traction};
use crate::solid::Solid;

/// Error of a die without a solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DieError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The half-space gives no answer.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// The load lies so far out that the die lifts off on the opposite side (3.27b).
    #[error(
        "the die lifts off: the load at x = {x} m, y = {y} m lies {excess} times as far out as \
         the ellipse of a third of the die's semi-axes, within which all of the base has contact"
    )]
    LiftOff {
        /// Offset of the load along the semi-axis `a` (m).
        x: f64,
        /// Offset of the load along the semi-axis `b` (m).
        y: f64,
        /// `sqrt((3 x/a)^2 + (3 y/b)^2)`, above one.
        excess: f64,
    },
}

/// A rigid, flat, elliptical die on a half-space, without friction, pressed by a force whose
/// line of action may lie off the centre.
///
/// ```
/// use creepage::statics::Die;
/// use creepage::{Ellipse, Solid};
/// let steel = Solid::new(82e9, 0.28)?;
/// let die = Die::new(steel, Ellipse::new(5e-3, 10e-3)?, 20e3, [1e-3, 0.0])?;
/// assert!((die.indentation() * 1e6 - 6.02).abs() < 0.01); // micrometres
/// assert!(die.tilt()[0] > 0.0); // deeper on the side of the load
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Die {
    shear_modulus: f64,
    indentation: f64,
    tilt: [f64; 2],
    margin: f64,
    traction: Traction,
    field: DisplacementField,
}

impl Die {
    /// A die with base `base` (m) on the half-space `solid`, pressed by `normal_force` (N) at
    /// `offset` `[x, y]` (m) from the centre.
    ///
    /// # Errors
    /// [`DieError::LiftOff`] when the offset lies outside the ellipse of a third of the
    /// semi-axes; [`DieError::Invalid`] unless the force is positive and all is finite.
    pub fn new(
        solid: Solid,
        base: Ellipse,
        normal_force: f64,
        offset: [f64; 2],
    ) -> Result<Self, DieError> {
        let force = check::positive("normal_force", normal_force)?;
        let x = check::finite("offset_x", offset[0])?;
        let y = check::finite("offset_y", offset[1])?;
        let arm = [3.0 * x / base.a(), 3.0 * y / base.b()];
        let margin = 1.0 - arm[0].hypot(arm[1]);
        // The limit itself is a solution; a rounding must not make an error of it.
        if margin < -4.0 * f64::EPSILON {
            return Err(DieError::LiftOff { x, y, excess: 1.0 - margin });
        }
        // The die is rigid, so that 1/G halves (2.10).
        let (shear_modulus, poisson) = (2.0 * solid.shear_modulus(), solid.poisson());
        let traction = pressure(base, force / shear_modulus, arm)?;
        let field = DisplacementField::new(&traction, poisson, 0.5 - poisson)?;
        let [indentation, tilt_x, tilt_y] =
            compliances(base).map(|share| (1.0 - poisson) * force / (PI * shear_modulus) * share);
        let tilt = [tilt_x * x, tilt_y * y];
        Ok(Self { shear_modulus, indentation, tilt, margin: margin.max(0.0), traction, field })
    }

    /// Depth of the base's centre below the undeformed surface, `c00` (m) (3.28).
    #[must_use]
    pub fn indentation(&self) -> f64 {
        self.indentation
    }

    /// Slopes `[c10, c01]` of the base (rad): its depth is `c00 + c10 x + c01 y` (3.24).
    #[must_use]
    pub fn tilt(&self) -> [f64; 2] {
        self.tilt
    }

    /// How far the load is from lifting the die: one for a central load, zero at the limit
    /// (3.27b). It is the least pressure at the edge, over that of the central load.
    #[must_use]
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// Pressure on the half-space at `[x, y]` (Pa) (3.25); it grows without bound towards the
    /// edge. Zero on the edge and beyond.
    #[must_use]
    pub fn pressure(&self, point: [f64; 2]) -> f64 {
        // At the limit of lift-off rounding may make it negative.
        (self.shear_modulus * self.traction.at(point)[2]).max(0.0)
    }

    /// Displacement `[u, v, w]` of the half-space's surface at `[x, y]` (m), under the die and
    /// beside it.
    #[must_use]
    pub fn displacement(&self, point: [f64; 2]) -> [f64; 3] {
        self.field.at(point)
    }
}

/// The pressure of a force, over `G`, whose offset is `arm/3` in semi-axes (3.26).
fn pressure(base: Ellipse, force: f64, arm: [f64; 2]) -> Result<Traction, ResponseError> {
    let f00 = force / (2.0 * base.area());
    let pressure = Polynomial::new(vec![f00, f00 * arm[0] / base.a(), f00 * arm[1] / base.b()])?;
    let none = Polynomial::zero(0);
    Ok(Traction::new(base, Edge::Singular, [&none, &none, &pressure])?)
}

/// `[c00, c10/x0, c01/y0]` in units of `(1 - sigma) N / (pi G)`: (3.28).
fn compliances(base: Ellipse) -> [f64; 3] {
    let (integrals, major, minor) = (base.integrals(), base.major(), base.minor());
    let about_major = 3.0 * integrals.b / (minor * minor * major);
    let about_minor = 3.0 * integrals.d / major.powi(3);
    let centre = integrals.k / major;
    if base.a() <= base.b() {
        [centre, about_major, about_minor]
    } else {
        [centre, about_minor, about_major]
    }
}
