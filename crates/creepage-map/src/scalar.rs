//! Scalars of the map: plain numbers, and dual numbers that carry derivatives (forward automatic differentiation).

use std::ops::{Add, Div, Mul, Neg, Sub};

use creepage::Creepage;
use creepage::table::Slice;

/// A number that a formula can be computed with.
pub(crate) trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// A number that depends on nothing.
    fn constant(value: f64) -> Self;
    /// The number itself.
    fn value(self) -> f64;
    /// A function of the number, by its value and its slope there.
    fn chain(self, value: f64, slope: f64) -> Self;
    /// Force and moment of an ellipse at dimensionless creepage and spin.
    fn creep_force(slice: &Slice<'_>, creepage: [Self; 3]) -> [Self; 3];

    fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        self.chain(root, 0.5 / root)
    }

    fn recip(self) -> Self {
        let inverse = self.value().recip();
        self.chain(inverse, -inverse * inverse)
    }

    fn exp(self) -> Self {
        let value = self.value().exp();
        self.chain(value, value)
    }

    fn ln(self) -> Self {
        self.chain(self.value().ln(), self.value().recip())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value().sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
}

/// Within what a table takes: beyond, everything slides.
fn creepage(parts: [f64; 3]) -> Creepage {
    let [xi, eta, chi] = parts.map(|part| part.clamp(-1e9, 1e9));
    Creepage::new(xi, eta, chi).unwrap_or_default()
}

impl Scalar for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn chain(self, value: f64, _: f64) -> Self {
        value
    }
    #[inline]
    fn creep_force(slice: &Slice<'_>, parts: [f64; 3]) -> [f64; 3] {
        slice.force(creepage(parts)).components()
    }
}

/// A number with its derivatives by `N` others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual<const N: usize> {
    pub(crate) v: f64,
    pub(crate) d: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The independent variable number `k`.
    pub(crate) fn variable(v: f64, k: usize) -> Self {
        Self { v, d: std::array::from_fn(|i| f64::from(u8::from(i == k))) }
    }

    #[inline]
    fn with(v: f64, d: impl Fn(usize) -> f64) -> Self {
        Self { v, d: std::array::from_fn(d) }
    }
}

impl<const N: usize> Scalar for Dual<N> {
    fn constant(v: f64) -> Self {
        Self { v, d: [0.0; N] }
    }
    fn value(self) -> f64 {
        self.v
    }
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self::with(value, |k| slope * self.d[k])
    }
    fn creep_force(slice: &Slice<'_>, parts: [Self; 3]) -> [Self; 3] {
        let (force, by) = slice.force_and_derivative(creepage(parts.map(|part| part.v)));
        let values = force.components();
        [0, 1, 2].map(|i: usize| {
            Self::with(values[i], |k| (0..3).map(|c| by[i][c] * parts[c].d[k]).sum())
        })
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::with(self.v + other.v, |k| self.d[k] + other.d[k])
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::with(self.v - other.v, |k| self.d[k] - other.d[k])
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    #[allow(clippy::suspicious_arithmetic_impl)] // the product's rule
    fn mul(self, other: Self) -> Self {
        Self::with(self.v * other.v, |k| self.d[k] * other.v + self.v * other.d[k])
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    #[allow(clippy::suspicious_arithmetic_impl)] // by the inverse
    fn div(self, other: Self) -> Self {
        self * other.recip()
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::with(-self.v, |k| -self.d[k])
    }
}

impl<const N: usize> Add<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, other: f64) -> Self {
        Self { v: self.v + other, ..self }
    }
}

impl<const N: usize> Sub<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: f64) -> Self {
        Self { v: self.v - other, ..self }
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: f64) -> Self {
        Self::with(self.v * other, |k| self.d[k] * other)
    }
}
