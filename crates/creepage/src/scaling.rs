//! Scaling between the dimensionless quantities of the theories and SI units: (4.20), one place.

use crate::check::{self, InvalidValue};
use crate::creepage::{Creepage, Force};
use crate::hertz::Hertz;

/// Creepage and spin as a vehicle dynamicist has them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SiCreepage {
    /// Longitudinal creepage `upsilon_x`: relative velocity over rolling velocity.
    pub longitudinal: f64,
    /// Lateral creepage `upsilon_y`: relative velocity over rolling velocity.
    pub lateral: f64,
    /// Spin `phi`: relative angular velocity about the normal over rolling velocity (rad/m).
    pub spin: f64,
}

/// Tangential force and moment in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SiForce {
    /// Longitudinal force `F_x` (N).
    pub longitudinal: f64,
    /// Lateral force `F_y` (N).
    pub lateral: f64,
    /// Spin moment `M_z` (N m).
    pub moment: f64,
}

impl std::ops::Neg for SiForce {
    type Output = Self;

    /// The reaction: what the lower body exerts on the upper.
    fn neg(self) -> Self {
        Self { longitudinal: -self.longitudinal, lateral: -self.lateral, moment: -self.moment }
    }
}

/// The units in which one contact's quantities are of order one.
///
/// ```
/// use creepage::{Scaling, SiCreepage};
/// use creepage::{Ellipse, Hertz, Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let ellipse = Ellipse::new(6e-3, 4e-3)?;
/// let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3)?;
/// let scaling = Scaling::new(&contact, 0.3)?;
/// let creepage = scaling.creepage(SiCreepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 })?;
/// assert!((scaling.si_creepage(creepage).longitudinal - 1e-3).abs() < 1e-18);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    /// Unit of length, `c = sqrt(a b)` (m).
    pub length: f64,
    /// Unit of slip and creepage, `mu c / rho`.
    pub slip: f64,
    /// Unit of force, `mu N` (N).
    pub force: f64,
    /// Unit of traction, `mu` times the peak pressure (Pa).
    pub traction: f64,
}

impl Scaling {
    /// The units of a contact without dimensions: one each.
    pub const DIMENSIONLESS: Self = Self { length: 1.0, slip: 1.0, force: 1.0, traction: 1.0 };

    /// The units of `contact` with coefficient of friction `friction`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive, and so are the units.
    pub fn new(contact: &Hertz, friction: f64) -> Result<Self, InvalidValue> {
        check::positive("friction", friction)?;
        let length = contact.ellipse().c();
        Ok(Self {
            length: check::positive("unit of length c", length)?,
            slip: check::positive("unit of slip mu c / rho", friction * length / contact.rho())?,
            force: check::positive("unit of force mu N", friction * contact.normal_force())?,
            traction: check::positive("unit of traction", friction * contact.peak_pressure())?,
        })
    }

    /// `xi`, `eta`, `chi` of a creepage in SI units.
    ///
    /// # Errors
    /// [`InvalidValue`] when a component is not finite.
    pub fn creepage(&self, si: SiCreepage) -> Result<Creepage, InvalidValue> {
        check::finite("longitudinal", si.longitudinal)?;
        check::finite("lateral", si.lateral)?;
        check::finite("spin", si.spin)?;
        Creepage::new(
            si.longitudinal / self.slip,
            si.lateral / self.slip,
            si.spin * self.length / self.slip,
        )
    }

    /// Creepage in SI units.
    #[must_use]
    pub fn si_creepage(&self, creepage: Creepage) -> SiCreepage {
        SiCreepage {
            longitudinal: creepage.xi * self.slip,
            lateral: creepage.eta * self.slip,
            spin: creepage.chi * self.slip / self.length,
        }
    }

    /// Force in SI units.
    #[must_use]
    pub fn si_force(&self, force: Force) -> SiForce {
        SiForce {
            longitudinal: force.fx * self.force,
            lateral: force.fy * self.force,
            moment: force.mz * self.force * self.length,
        }
    }

    /// Frictional power over rolling velocity: the energy turned to heat per metre rolled,
    /// `F_x upsilon_x + F_y upsilon_y + M_z phi` (J/m).
    #[must_use]
    pub fn power_per_metre(&self, force: Force, creepage: Creepage) -> f64 {
        self.force
            * self.slip
            * (force.fx * creepage.xi + force.fy * creepage.eta + force.mz * creepage.chi)
    }
}
