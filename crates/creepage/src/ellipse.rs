//! The contact ellipse.

use std::f64::consts::PI;

use crate::check::{self, InvalidValue};
use crate::special::CompleteIntegrals;

/// The contact ellipse `(x/a)^2 + (y/b)^2 <= 1`: `a` along the rolling direction, `b` across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    a: f64,
    b: f64,
    /// Kept, for the roots of [`Ellipse::from_ratio`] do not give it back to the last bit.
    ratio: f64,
}

impl Ellipse {
    /// Smallest and largest ratio `a/b` that the theories take: beyond, the contact is a line.
    pub const RATIO_RANGE: [f64; 2] = [1e-6, 1e6];

    /// An ellipse from its semi-axes along and across the rolling direction, of any unit.
    ///
    /// # Errors
    /// [`InvalidValue`] unless both are finite and positive and `a/b` lies within
    /// [`Ellipse::RATIO_RANGE`].
    pub fn new(a: f64, b: f64) -> Result<Self, InvalidValue> {
        check::positive("semi_axis_rolling", a)?;
        check::positive("semi_axis_lateral", b)?;
        check_ratio(a / b)?;
        Ok(Self { a, b, ratio: a / b })
    }

    /// The ellipse of ratio `a/b` whose `c = sqrt(a b)` is the unit of length.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `a_over_b` lies within [`Ellipse::RATIO_RANGE`].
    pub fn from_ratio(a_over_b: f64) -> Result<Self, InvalidValue> {
        check_ratio(a_over_b)?;
        Ok(Self { a: a_over_b.sqrt(), b: a_over_b.sqrt().recip(), ratio: a_over_b })
    }

    /// The ellipse of ratio `a/b` and size `c = sqrt(a b)`, of any unit: of all sizes the same ratio,
    /// to the last bit.
    pub(crate) fn of_size(c: f64, a_over_b: f64) -> Result<Self, InvalidValue> {
        let root = check_ratio(a_over_b)?.sqrt();
        Ok(Self { ratio: a_over_b, ..Self::new(c * root, c / root)? })
    }

    /// Semi-axis in the rolling direction.
    #[must_use]
    pub fn a(&self) -> f64 {
        self.a
    }

    /// Semi-axis across the rolling direction.
    #[must_use]
    pub fn b(&self) -> f64 {
        self.b
    }

    /// The ratio `a/b`.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// `c = sqrt(a b)`, the thesis's unit of length for creepage, spin and moment.
    #[must_use]
    pub fn c(&self) -> f64 {
        (self.a * self.b).sqrt()
    }

    /// The major semi-axis, the unit of length of chapter 5.
    #[must_use]
    pub fn major(&self) -> f64 {
        self.a.max(self.b)
    }

    /// The minor semi-axis `s`.
    #[must_use]
    pub fn minor(&self) -> f64 {
        self.a.min(self.b)
    }

    /// `g`, minor over major semi-axis.
    #[must_use]
    pub fn g(&self) -> f64 {
        self.minor() / self.major()
    }

    /// `|e| = sqrt(1 - g^2)`, the eccentricity.
    #[must_use]
    pub fn e(&self) -> f64 {
        let g = self.g();
        ((1.0 - g) * (1.0 + g)).sqrt()
    }

    /// The area `pi a b`.
    #[must_use]
    pub fn area(&self) -> f64 {
        PI * self.a * self.b
    }

    /// Mean distance from the middle under Hertz's pressure: the moment of a contact that slides all around its middle,
    /// the largest that friction gives, over `mu N`.
    ///
    /// ```
    /// let circle = creepage::Ellipse::new(1.0, 1.0)?;
    /// assert!((circle.friction_arm() - 3.0 * std::f64::consts::PI / 16.0).abs() < 1e-14);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    #[must_use]
    pub fn friction_arm(&self) -> f64 {
        0.375 * self.major() * self.integrals().e
    }

    /// The elliptic integrals that belong to this shape.
    #[must_use]
    pub fn integrals(&self) -> CompleteIntegrals {
        CompleteIntegrals::new(self.g())
    }
}

fn check_ratio(ratio: f64) -> Result<f64, InvalidValue> {
    let valid = "between 1e-6 and 1e6 (beyond, the contact is a line)";
    check::ratio(ratio, Ellipse::RATIO_RANGE, valid)
}
