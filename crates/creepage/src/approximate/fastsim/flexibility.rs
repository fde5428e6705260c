//! Flexibilities `L` of FASTSIM's springs, the slopes of the traction that they give, and Kalker's reduction factor of springs of surfaces that are not clean and dry.

use super::Flexibility;
use super::grid::Profile;
use crate::Ellipse;
use crate::approximate::dual::Real;
use crate::approximate::linear::CreepageCoefficients;
use crate::check::{self, InvalidValue};
use crate::contact::Contact;
use crate::friction_law::{FrictionLaw, RollingFriction};
use std::f64::consts::{FRAC_PI_4, PI};

/// The flexibilities that reproduce the linear theory; `c`, `G` and `mu N` are the units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flexibilities {
    /// `L1`, `L2`, `L3`.
    values: [f64; 3],
    /// Creepage and spin in those units, per `xi`, `eta`, `chi`.
    kappa: f64,
    /// `C11` and `C22`: the reciprocals of the creepages at which the linear force is `mu N`.
    coefficients: [f64; 2],
    /// Weight of the spin beside the creepages when blending: `3 pi a / 32`.
    spin_weight: f64,
    /// What a layer adds to each.
    layer: f64,
    /// What makes them larger as creepage grows.
    reduction: Option<Reduction>,
}

/// How fast the traction grows in adhesion, in the direction of the march:
/// `(x - spin * y', y + spin * x')` at `(x', y')`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slopes<R> {
    pub(crate) x: R,
    pub(crate) y: R,
    pub(crate) spin: R,
}

impl<R: Real> Slopes<R> {
    /// The slopes at a position.
    #[inline]
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> [R; 2] {
        [self.x - self.spin * y, self.y + self.spin * x]
    }
}

impl Flexibilities {
    /// `strip_slope` is that of [`strip_slope`](crate::approximate::strip::strip_slope).
    pub(crate) fn new(
        ellipse: &Ellipse,
        strip_slope: f64,
        coefficients: &CreepageCoefficients,
    ) -> Result<Self, InvalidValue> {
        Self::with_kappa(ellipse, 3.0 / PI * strip_slope, coefficients)
    }

    /// The same where `kappa C11 xi` is the linear force over `mu N`.
    pub(crate) fn with_kappa(
        ellipse: &Ellipse,
        kappa: f64,
        coefficients: &CreepageCoefficients,
    ) -> Result<Self, InvalidValue> {
        let c11 = coefficient("c11", coefficients.c11)?;
        let c22 = coefficient("c22", coefficients.c22)?;
        let c23 = coefficient("c23", coefficients.c23)?;
        let a = ellipse.a();
        Ok(Self {
            values: [8.0 * a / (3.0 * c11), 8.0 * a / (3.0 * c22), PI * a * a / (4.0 * c23)],
            kappa,
            coefficients: [c11, c22],
            spin_weight: 3.0 * PI / 32.0 * a,
            layer: 0.0,
            reduction: None,
        })
    }

    /// The same with a layer on the bed of springs, in units of slip times length over traction.
    pub(crate) fn with_layer(self, flexibility: f64) -> Self {
        Self { layer: self.kappa * flexibility / Profile::HERTZ_PEAK, ..self }
    }

    /// The same on a surface that is not clean and dry.
    pub(crate) fn with_reduction(self, reduction: Option<Reduction>) -> Self {
        Self { reduction, ..self }
    }

    pub(crate) fn kappa(&self) -> f64 {
        self.kappa
    }

    pub(crate) fn slopes<R: Real>(&self, use_of: Flexibility, creepage: [R; 3]) -> Slopes<R> {
        let [l1, l2, l3] = self.effective(use_of, creepage);
        let [x, y, spin] = creepage.map(|v| v * self.kappa);
        Slopes { x: x / l1, y: y / l2, spin: spin / l3 }
    }

    /// The three flexibilities in use at a creepage.
    pub(crate) fn effective<R: Real>(&self, use_of: Flexibility, creepage: [R; 3]) -> [R; 3] {
        let three = self.three(creepage);
        let largest = creepage.iter().fold(0.0_f64, |m, v| m.max(v.value().abs()));
        // All are ratios of creepages: scaled, no square of them underflows.
        let scaled = creepage.map(|v| v * largest.recip());
        match use_of {
            Flexibility::Three => three,
            _ if !(largest > 0.0 && largest.recip().is_finite()) => three,
            Flexibility::One => [one(three, scaled); 3],
            Flexibility::Blended => {
                let (common, share) = (self.common(three, scaled), self.share(creepage));
                three.map(|l| l + (common - l) * share)
            }
        }
    }

    /// All three, with what a layer and dirt add to them.
    fn three<R: Real>(&self, [x, y, _]: [R; 3]) -> [R; 3] {
        let Some(reduction) = &self.reduction else {
            return self.values.map(|value| R::constant(value + self.layer));
        };
        let [c11, c22] = self.coefficients;
        // The linear force over mu N, of the creepages alone.
        let [force_x, force_y] = [x * (self.kappa * c11), y * (self.kappa * c22)];
        let force = (force_x * force_x + force_y * force_y).sqrt();
        let factor = reduction.factor(force, x.value().hypot(y.value()));
        self.values.map(|value| R::constant(value) / factor + self.layer)
    }

    /// The common flexibility of Vollebregt and Voltr, a harmonic mean.
    fn common<R: Real>(&self, three: [R; 3], [x, y, spin]: [R; 3]) -> R {
        let [l1, l2, l3] = three.map(|l| R::constant(1.0) / l);
        let spin = spin * self.spin_weight;
        let squares = [x * x, y * y, spin * spin];
        (squares[0] + squares[1] + squares[2])
            / (squares[0] * l1 + squares[1] * l2 + squares[2] * l3)
    }

    /// Share of the common flexibility: grows with the creepages, not with the spin, and is one
    /// from three times the creepages at which linear theory reaches `mu N`.
    fn share<R: Real>(&self, [x, y, _]: [R; 3]) -> R {
        let [c11, c22] = self.coefficients;
        let unit = (c11.powi(-2) + c22.powi(-2)).sqrt();
        let share = (x * x + y * y).sqrt() * (self.kappa / (3.0 * unit));
        if share.value() < 1.0 { share } else { R::constant(1.0) }
    }
}

/// Kalker's single flexibility.
fn one<R: Real>([l1, l2, l3]: [R; 3], [x, y, spin]: [R; 3]) -> R {
    let norm = (x * x + y * y + spin * spin).sqrt();
    (x.abs() * l1 + y.abs() * l2 + spin.abs() * l3) / norm
}

/// No ellipse has coefficients that come near these limits.
fn coefficient(name: &'static str, value: f64) -> Result<f64, InvalidValue> {
    check::require((1e-12..=1e12).contains(&value), name, value, "between 1e-12 and 1e12")
}

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
