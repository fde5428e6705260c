//! Coefficients of friction that depend on the speed of slip, or on the place across the contact.
//!
//! Measured friction falls as the surfaces slip faster. With `s` the absolute slip velocity, the
//! speed at which the upper body's surface moves over the lower's (m/s), a [`FrictionLaw`] is a
//! kinetic value and up to four [`Term`]s that fall from a drop to nothing:
//!
//! ```math
//! \mu(s) = \mu_k + \sum_i \mu_i \, g(s / s_i)
//! ```
//!
//! with `g` one half at `s_i`, except for the second and further terms of the rational law, by
//! the shape: `2^(-s/s_i)`, `max(0, 1 - s/(2 s_i))`, or `1/(1 + (s/s_i)^i)`, `i` counting the terms.
//!
//! Sources: E.A.H. Vollebregt, *User guide for CONTACT*, section 4.2 (the three laws and the memory);
//! O. Polach, Wear 258 (2005) 992-1000.
//!
//! ```
//! use creepage::friction_law::{FrictionLaw, Shape, Term};
//! let law = FrictionLaw::new(Shape::Exponential, 0.18, &[Term { drop: 0.12, half_speed: 0.1 }])?;
//! assert!((law.at(0.0) - 0.30).abs() < 1e-15);
//! assert!((law.at(0.1) - 0.24).abs() < 1e-15);
//! # Ok::<(), creepage::InvalidValue>(())
//! ```

mod across;
mod rolling;
mod thermal;

pub use across::FrictionAcross;
pub use rolling::{FrictionMemory, RollingFriction};
pub use thermal::FrictionByTemperature;
pub(crate) use thermal::Thermal;

use std::f64::consts::LN_2;

use crate::check::{self, InvalidValue};

/// Shape of a law's terms over the speed of slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shape {
    /// `2^(-s/s_i)`.
    Exponential,
    /// `1 - s/(2 s_i)` down to zero.
    Linear,
    /// `1/(1 + (s/s_i)^i)` for the term number `i`, from one.
    Rational,
}

/// One falling part of a law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Term {
    /// What the term adds at rest.
    pub drop: f64,
    /// The speed of slip at which half of it is left (m/s).
    pub half_speed: f64,
}

/// A coefficient of friction by the speed of slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionLaw {
    shape: Shape,
    kinetic: f64,
    /// Those beyond the last drop nothing.
    terms: [Term; FrictionLaw::MAX_TERMS],
    count: usize,
}

impl FrictionLaw {
    /// Most terms of a law.
    pub const MAX_TERMS: usize = 4;

    /// A law that falls from `kinetic` plus all drops, at rest, to `kinetic`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `kinetic >= 0`, every drop is `>= 0`, every half speed `> 0`, all are
    /// finite, the value at rest is positive, and there are at most [`FrictionLaw::MAX_TERMS`] terms.
    pub fn new(shape: Shape, kinetic: f64, terms: &[Term]) -> Result<Self, InvalidValue> {
        not_negative("kinetic", kinetic)?;
        let count = terms.len();
        check::require(count <= Self::MAX_TERMS, "terms", count as f64, "at most four terms")?;
        for term in terms {
            not_negative("drop", term.drop)?;
            check::positive("half_speed", term.half_speed)?;
        }
        let mut law = Self { shape, kinetic, terms: [Term::default(); Self::MAX_TERMS], count };
        law.terms[..count].copy_from_slice(terms);
        check::positive("friction at rest", law.at_rest())?;
        Ok(law)
    }

    /// Coulomb's: the same at every speed.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `friction` is finite and positive.
    pub fn constant(friction: f64) -> Result<Self, InvalidValue> {
        check::positive("friction", friction)?;
        Self::new(Shape::Linear, friction, &[])
    }

    /// Polach's `mu_0 ((1 - A) exp(-B s) + A)`: the exponential law with the kinetic value `A mu_0`
    /// and the half speed `ln 2 / B`. `rate` is `B` in **s/m** (some programs take s/mm).
    ///
    /// # Errors
    /// [`InvalidValue`] unless `at_rest` and `rate` are positive and `ratio` is between 0 and 1.
    pub fn polach(at_rest: f64, ratio: f64, rate: f64) -> Result<Self, InvalidValue> {
        check::positive("at_rest", at_rest)?;
        check::require((0.0..=1.0).contains(&ratio), "ratio", ratio, "between 0 and 1")?;
        check::positive("rate", rate)?;
        let term = Term { drop: (1.0 - ratio) * at_rest, half_speed: LN_2 / rate };
        Self::new(Shape::Exponential, ratio * at_rest, &[term])
    }

    /// The shape of the terms.
    #[must_use]
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The value at very high speed.
    #[must_use]
    pub fn kinetic(&self) -> f64 {
        self.kinetic
    }

    /// The falling terms.
    #[must_use]
    pub fn terms(&self) -> &[Term] {
        &self.terms[..self.count]
    }

    /// The value at rest, the largest: the `mu` of `xi`, `eta`, `chi` and of the forces.
    #[must_use]
    pub fn at_rest(&self) -> f64 {
        self.terms().iter().fold(self.kinetic, |sum, term| sum + term.drop)
    }

    /// The coefficient at the speed of slip `speed` (m/s); a negative speed counts as rest.
    #[must_use]
    pub fn at(&self, speed: f64) -> f64 {
        self.with_slope(speed)[0]
    }

    /// The coefficient at the speed of slip `speed` (m/s), and its derivative (s/m). At the kink of a
    /// linear law the derivative is that from above.
    #[must_use]
    pub fn with_slope(&self, speed: f64) -> [f64; 2] {
        let speed = speed.max(0.0);
        let mut sum = [self.kinetic, 0.0];
        let mut order = 0.0;
        for Term { drop, half_speed } in self.terms() {
            order += 1.0;
            let [value, slope] = self.shape.share(speed / half_speed, order);
            sum = [sum[0] + drop * value, sum[1] + drop / half_speed * slope];
        }
        sum
    }
}

impl Shape {
    /// What is left of the term number `order` at `ratio` times its half speed, and its derivative.
    fn share(self, ratio: f64, order: f64) -> [f64; 2] {
        match self {
            Self::Exponential => {
                let left = (-LN_2 * ratio).exp();
                [left, -LN_2 * left]
            }
            Self::Linear if ratio < 2.0 => [1.0 - 0.5 * ratio, -0.5],
            Self::Linear => [0.0; 2],
            Self::Rational => {
                let left = 1.0 / (1.0 + ratio.powf(order));
                // Of the second and later terms the slope at rest is zero, of the first it is not.
                let power = ratio.powf(order - 1.0);
                [left, -(left * order) * (power * left)]
            }
        }
    }
}

fn not_negative(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    let valid = "finite and not negative";
    check::require(value.is_finite() && value >= 0.0, quantity, value, valid)
}
