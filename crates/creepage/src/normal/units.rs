//! Units of rolling on a contact of any shape, in which its quantities are of order one.

use super::contact::NormalContact;
use crate::Scaling;
use crate::check::{self, InvalidValue};

/// Unit of slip over the largest traction bound in units of `G`: the elastic slip is of order one.
pub(crate) const SLIP_UNIT: f64 = 0.5;

impl NormalContact {
    /// Units of creepage, force and position for a coefficient of friction: those of every theory
    /// of rolling on this contact. The unit of length is a root of the area, that of slip half the
    /// largest traction bound over the shear modulus.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn scaling(&self, friction: f64) -> Result<Scaling, InvalidValue> {
        check::positive("friction", friction)?;
        let traction = friction * self.peak_pressure().value;
        Ok(Scaling {
            length: (self.area().value / 3.0).sqrt(),
            slip: SLIP_UNIT * traction / self.pair().shear_modulus(),
            force: friction * self.load().value,
            traction,
        })
    }
}
