//! Kalker's reduction factor: springs of surfaces that are not clean and dry.

use std::f64::consts::FRAC_PI_4;

use crate::approximate::dual::Real;
use crate::check::{self, InvalidValue};
use crate::contact::Contact;
use crate::friction_law::{FrictionLaw, RollingFriction};

/// A factor of the slope of the traction that falls as creepage grows,
/// `k = k0 (alpha + (1 - alpha)/(1 + beta eps))` with Polach's gradient `eps`, which is as the area of slip to
/// that of adhesion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reduction {
    at_rest: f64,
    /// That at infinite creepage over that at rest.
    left: f64,
    fall: f64,
    /// Friction by the speed of slip, and that speed at a slip of one (m/s).
    friction: Option<(FrictionLaw, f64)>,
}

impl Reduction {
    /// `None` where the springs are those of clean and dry surfaces.
    pub(crate) fn new(
        [at_rest, left, fall]: [f64; 3],
        contact: &Contact,
    ) -> Result<Option<Self>, InvalidValue> {
        let valid =
            "three factors [k0, alpha, beta] with 0 < k0 <= 1, 0 < alpha <= 1 and beta >= 0";
        for factor in [at_rest, left] {
            check::require(factor > 0.0 && factor <= 1.0, "reduction", factor, valid)?;
        }
        check::require(fall >= 0.0 && fall.is_finite(), "reduction", fall, valid)?;
        let friction = contact.rolling_friction().filter(RollingFriction::falls);
        let speed = |friction: &RollingFriction| contact.scaling().slip * friction.speed();
        let friction = friction.map(|friction| (*friction.law(), speed(&friction)));
        let reduces = at_rest < 1.0 || left < 1.0;
        Ok(reduces.then_some(Self { at_rest, left, fall, friction }))
    }

    /// The factor where linear theory's force is `force` over `mu N`, and the rigid slip `slip` over that of the
    /// contact's units. Friction is that at the speed of this slip.
    pub(super) fn factor<R: Real>(&self, force: R, slip: f64) -> R {
        let share =
            self.friction.as_ref().map_or(1.0, |(law, speed)| law.at(speed * slip) / law.at_rest());
        let gradient = force * (FRAC_PI_4 * self.at_rest / share);
        let falling = R::constant(1.0 - self.left) / (gradient * self.fall + 1.0);
        (falling + self.left) * self.at_rest
    }
}
