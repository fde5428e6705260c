//! Carter 1926: two cylinders with parallel axes, creepage in the rolling direction only.
//!
//! F. W. Carter, On the action of a locomotive driving wheel, Proc. R. Soc. London A 112
//! (1926) 151-157; here in the thesis's form, chapter 1, (1.1)-(1.3), Figs 2 and 3. The two
//! formulas given by the thesis are verified by the plane half-space integral in the tests.
//!
//! It is the one exact closed solution of rolling with friction, in two dimensions (plane
//! strain): a traction `mu p0 sqrt(1 - x^2)` over the whole contact, less a similar one over the
//! adhesion area, which borders on the leading edge. There is no ellipse and no Poisson's ratio
//! in it, so it stands beside the three-dimensional theories and is asked by its own parameter.
//!
//! With `xi = upsilon_x rho/(mu a)`, lengths in units of `a`, and the adhesion area from `x0` to
//! the leading edge at 1 (1.2), (1.3):
//!
//! ```math
//! \frac{X}{\mu p_0} = \operatorname{sgn} \xi
//! \left[ \sqrt{1 - x^2} - \sqrt{(1 - x)(x - x_0)} \right],
//! \quad x_0 = \frac{|\xi|}{2} - 1; \qquad
//! \frac{F_x}{\mu N} = \frac{\xi (8 - |\xi|)}{16}
//! ```

use std::f64::consts::PI;

use crate::check::{self, InvalidValue};
use crate::solid::SolidPair;
use crate::{FieldPoint, Region};

/// Carter's solution at one creepage.
///
/// Lengths are in units of the contact's half-width `a`, with the leading edge at `x = 1`;
/// tractions in units of `mu` times the peak pressure, slip in units of `mu a / rho`.
///
/// ```
/// use creepage::approximate::carter::Carter;
/// let half = Carter::new(2.0)?; // half of the creepage at which gross sliding sets in
/// assert_eq!(half.force(), 0.75);
/// assert_eq!(half.trailing_edge(), 0.0); // the adhesion area covers half of the contact
/// assert_eq!(half.at(-0.6).traction[0], 0.8); // slip area: the traction bound
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carter {
    creepage: f64,
}

impl Carter {
    /// Size of the dimensionless creepage at which gross sliding sets in.
    pub const GROSS_SLIDING: f64 = 4.0;

    /// The solution at the dimensionless creepage `upsilon_x rho / (mu a)`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `creepage` is finite.
    pub fn new(creepage: f64) -> Result<Self, InvalidValue> {
        Ok(Self { creepage: check::finite("creepage", creepage)? })
    }

    /// Half the width of the adhesion area: 1 in free rolling, 0 in gross sliding.
    #[must_use]
    pub fn adhesion_half_width(&self) -> f64 {
        (1.0 - self.creepage.abs() / Self::GROSS_SLIDING).max(0.0)
    }

    /// Trailing edge of the adhesion area, `b/a` of (1.2): -1 in free rolling, 1 when gross
    /// sliding sets in and beyond.
    #[must_use]
    pub fn trailing_edge(&self) -> f64 {
        1.0 - 2.0 * self.adhesion_half_width()
    }

    /// Force per length of the cylinders, in units of `mu N` (1.3).
    #[must_use]
    pub fn force(&self) -> f64 {
        if self.creepage.abs() >= Self::GROSS_SLIDING {
            return 1.0_f64.copysign(self.creepage);
        }
        self.creepage * (8.0 - self.creepage.abs()) / 16.0
    }

    /// Derivative of [`Carter::force`] by the dimensionless creepage.
    #[must_use]
    pub fn derivative(&self) -> f64 {
        0.5 * self.adhesion_half_width()
    }

    /// Traction and slip at `x` in units of `a`; outside the contact both are zero. The second
    /// components, across the rolling direction, are zero everywhere.
    #[must_use]
    pub fn at(&self, x: f64) -> FieldPoint {
        let sense = 1.0_f64.copysign(self.creepage);
        let semicircle = ((1.0 - x) * (1.0 + x)).max(0.0).sqrt();
        // Positive inside the adhesion area, negative outside.
        let inside = (1.0 - x) * (x - self.trailing_edge());
        let (traction, slip, region) = if x.abs() > 1.0 {
            (0.0, 0.0, Region::Outside)
        } else if self.adhesion_half_width() == 0.0 {
            (sense * semicircle, self.creepage - sense * Self::GROSS_SLIDING * x, Region::Slip)
        } else if inside > 0.0 {
            (sense * (semicircle - inside.sqrt()), 0.0, Region::Adhesion)
        } else {
            let slip = sense * Self::GROSS_SLIDING * (-inside).sqrt();
            (sense * semicircle, slip, Region::Slip)
        };
        FieldPoint { position: [x, 0.0], traction: [traction, 0.0], slip: [slip, 0.0], region }
    }
}

/// Two cylinders with parallel axes pressed together along a line, in SI units: Hertz's line
/// contact, which gives Carter's solution its scale.
///
/// ```
/// use creepage::approximate::carter::LineContact;
/// use creepage::{Solid, SolidPair};
/// let steel = Solid::new(82e9, 0.28)?;
/// let contact = LineContact::new(SolidPair::new(steel, steel), [0.5, 0.5], 1e6)?;
/// let carter = contact.carter(1e-3, 0.3)?;
/// let force_per_metre = carter.force() * 0.3 * 1e6; // N/m
/// assert!(force_per_metre > 0.0 && force_per_metre < 0.3 * 1e6);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    half_width: f64,
    peak_pressure: f64,
    rho: f64,
}

impl LineContact {
    /// Presses two cylinders of `radii` (m) together with `load` (N per m of their length).
    ///
    /// A radius is positive where the body is convex, negative where it is hollow, infinite
    /// where it is flat.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `load` is finite and positive, no radius is zero, and the
    /// cylinders can touch along a single line (`1/R+ + 1/R- > 0`).
    pub fn new(pair: SolidPair, radii: [f64; 2], load: f64) -> Result<Self, InvalidValue> {
        check::positive("load", load)?;
        for radius in radii {
            let valid = "a number other than zero, or infinity for a flat body";
            check::require(radius.recip().is_finite(), "radius", radius, valid)?;
        }
        // (1.2): 1/rho = (1/R+ + 1/R-)/4.
        let rho = check::positive("rho", 4.0 / (radii[0].recip() + radii[1].recip()))?;
        let half_width = (load * rho * (1.0 - pair.poisson()) / (PI * pair.shear_modulus())).sqrt();
        check::positive("half_width", half_width)?;
        Ok(Self { half_width, peak_pressure: 2.0 * load / (PI * half_width), rho })
    }

    /// Half-width `a` of the contact (m).
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// Largest pressure, `2 N / (pi a)` with `N` per length (Pa).
    #[must_use]
    pub fn peak_pressure(&self) -> f64 {
        self.peak_pressure
    }

    /// Characteristic length `rho` of (1.2) (m): the diameter, for equal cylinders.
    #[must_use]
    pub fn rho(&self) -> f64 {
        self.rho
    }

    /// Carter's solution at the longitudinal `creepage` `upsilon_x` with coefficient of
    /// friction `friction`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `creepage` is finite and `friction` finite and positive.
    pub fn carter(&self, creepage: f64, friction: f64) -> Result<Carter, InvalidValue> {
        check::finite("creepage", creepage)?;
        check::positive("friction", friction)?;
        Carter::new(creepage * self.rho / (friction * self.half_width))
    }
}
