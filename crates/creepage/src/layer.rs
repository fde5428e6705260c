//! Thin layer between the bodies: oxide, sand, clay, lubricant.

use crate::check::{self, InvalidValue};
use crate::scaling::Scaling;

/// A thin layer that shears under the tangential traction at the same place, `u = p h/G`, and may
/// yield. Source: K. Hou, J. Kalousek, E. Magel, Wear 211 (1997) 134-140, as in E.A.H. Vollebregt,
/// *User guide for CONTACT*, section 4.1.6.
///
/// ```
/// use creepage::{Ellipse, Hertz, Layer, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let ellipse = Ellipse::new(6e-3, 4e-3)?;
/// let hertz = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3)?;
/// let magnetite = Layer::elastic(20e-6, 176.6e6)?;
/// let contact = hertz.with_friction(0.3)?.with_layer(magnetite);
/// assert_eq!(contact.layer(), Some(magnetite));
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    thickness: f64,
    shear_modulus: f64,
    plasticity: Option<Plasticity>,
}

/// The shear stress beyond which a layer deforms plastically: `yield_stress + slope u_pl`, `u_pl` the
/// plastic displacement gathered since the leading edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plasticity {
    /// Yield stress in shear (Pa).
    pub yield_stress: f64,
    /// Its rise with the plastic displacement (Pa/m): positive where the layer hardens.
    pub slope: f64,
}

impl Layer {
    /// A layer of this thickness (m) and shear modulus (Pa).
    ///
    /// # Errors
    /// [`InvalidValue`] unless `thickness` is finite and not negative, `shear_modulus` finite and
    /// positive.
    pub fn elastic(thickness: f64, shear_modulus: f64) -> Result<Self, InvalidValue> {
        let is_valid = thickness.is_finite() && thickness >= 0.0;
        check::require(is_valid, "thickness", thickness, "finite and not negative")?;
        check::positive("shear_modulus", shear_modulus)?;
        Ok(Self { thickness, shear_modulus, plasticity: None })
    }

    /// The same, which yields.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `yield_stress` is finite and positive, and `slope` finite and above
    /// `-G/h`, the slope of a layer that softens faster than it springs back.
    pub fn with_plasticity(self, plasticity: Plasticity) -> Result<Self, InvalidValue> {
        check::positive("yield_stress", plasticity.yield_stress)?;
        let slope = plasticity.slope;
        let is_valid = slope.is_finite() && slope * self.flexibility() > -1.0;
        check::require(is_valid, "slope", slope, "finite and above -shear_modulus/thickness")?;
        Ok(Self { plasticity: Some(plasticity), ..self })
    }

    /// Thickness (m).
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Shear modulus (Pa).
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Where it yields, if it does.
    #[must_use]
    pub fn plasticity(&self) -> Option<Plasticity> {
        self.plasticity
    }

    /// Displacement over traction, `h/G` (m/Pa).
    #[must_use]
    pub fn flexibility(&self) -> f64 {
        self.thickness / self.shear_modulus
    }

    /// Displacement over traction in the units of a contact: slip times length over traction.
    pub(crate) fn dimensionless_flexibility(&self, scaling: Scaling) -> f64 {
        self.flexibility() * scaling.traction / (scaling.slip * scaling.length)
    }
}

impl Plasticity {
    /// In the units of a contact.
    pub(crate) fn dimensionless(self, scaling: Scaling) -> Self {
        let Scaling { slip, length, traction, .. } = scaling;
        Self {
            yield_stress: self.yield_stress / traction,
            slope: self.slope * slip * length / traction,
        }
    }
}
