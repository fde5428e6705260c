//! Dimensionless creepage and force (4.20): the input and the output of every theory.

use crate::check::{self, InvalidValue};

/// Dimensionless creepage and spin (4.20): three finite numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Creepage {
    pub(crate) xi: f64,
    pub(crate) eta: f64,
    pub(crate) chi: f64,
}

impl Creepage {
    /// Largest size of a component: far beyond full sliding, and safe to square.
    pub const MAX: f64 = 1e100;

    /// Dimensionless creepage and spin.
    ///
    /// # Errors
    /// [`InvalidValue`] that names the component which is not finite, or larger than
    /// [`Creepage::MAX`].
    pub fn new(xi: f64, eta: f64, chi: f64) -> Result<Self, InvalidValue> {
        let checked = |name, value: f64| {
            check::require(value.abs() <= Self::MAX, name, value, "between -1e100 and 1e100")
        };
        Ok(Self { xi: checked("xi", xi)?, eta: checked("eta", eta)?, chi: checked("chi", chi)? })
    }

    /// Longitudinal, `xi = upsilon_x rho / (mu c)`.
    #[must_use]
    pub const fn xi(&self) -> f64 {
        self.xi
    }

    /// Lateral, `eta = upsilon_y rho / (mu c)`.
    #[must_use]
    pub const fn eta(&self) -> f64 {
        self.eta
    }

    /// Spin, `chi = phi rho / mu`.
    #[must_use]
    pub const fn chi(&self) -> f64 {
        self.chi
    }

    /// `[xi, eta, chi]`.
    #[must_use]
    pub const fn components(&self) -> [f64; 3] {
        [self.xi, self.eta, self.chi]
    }

    /// Slip of the bodies as if rigid, in the unit `mu c / rho`, at `position` in units of `c`:
    /// `(xi - chi y, eta + chi x)`.
    #[must_use]
    pub fn rigid_slip(&self, position: [f64; 2]) -> [f64; 2] {
        [self.xi - self.chi * position[1], self.eta + self.chi * position[0]]
    }
}

/// Dimensionless tangential force and moment on the lower body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Force {
    /// Longitudinal, `f_x = F_x / (mu N)`.
    pub fx: f64,
    /// Lateral, `f_y = F_y / (mu N)`.
    pub fy: f64,
    /// Moment about the normal, `m_z = M_z / (mu N c)`.
    pub mz: f64,
}

impl Force {
    /// `[fx, fy, mz]`.
    #[must_use]
    pub const fn components(&self) -> [f64; 3] {
        [self.fx, self.fy, self.mz]
    }

    /// `sqrt(f_x^2 + f_y^2)`: the used part of the friction force `mu N`.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.fx.hypot(self.fy)
    }
}
