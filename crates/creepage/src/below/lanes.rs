//! Four numbers at once, with the logarithm and the arctangent that sums over sides need.
//!
//! Every operation is one on each number, without branches, so that the compiler makes vector
//! instructions of it where the processor has them.

// What is not inlined is not compiled for the processor's vector instructions.
#![allow(clippy::inline_always)]

use std::f64::consts::{FRAC_PI_2, LN_2, PI, SQRT_2};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// How many numbers.
pub(super) const LANES: usize = 4;

/// Four numbers.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lanes([f64; LANES]);

impl Lanes {
    #[inline(always)]
    pub(super) fn all(value: f64) -> Self {
        Self([value; LANES])
    }

    #[inline(always)]
    pub(super) fn from_fn(value: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(value))
    }

    #[inline(always)]
    pub(super) fn sum(self) -> f64 {
        (self.0[0] + self.0[2]) + (self.0[1] + self.0[3])
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    pub(super) fn recip(self) -> Self {
        Self(self.0.map(|value| 1.0 / value))
    }

    #[inline(always)]
    pub(super) fn max(self, least: Self) -> Self {
        Self::from_fn(|i| if self.0[i] > least.0[i] { self.0[i] } else { least.0[i] })
    }

    /// At least the smallest normal number, to be divided by.
    #[inline(always)]
    pub(super) fn nonzero(self) -> Self {
        self.max(Self::all(f64::MIN_POSITIVE))
    }

    /// The natural logarithm of positive normal numbers.
    #[inline(always)]
    pub(super) fn ln(self) -> Self {
        Self(self.0.map(ln))
    }

    /// The angle of the points `(x, self)`.
    #[inline(always)]
    pub(super) fn atan2(self, x: Self) -> Self {
        Self::from_fn(|i| atan2(self.0[i], x.0[i]))
    }
}

/// Of `m 2^e` with `m` around one: the series of the inverse hyperbolic tangent.
#[inline(always)]
fn ln(value: f64) -> f64 {
    let bits = value.to_bits();
    let mantissa = f64::from_bits((bits & 0x000F_FFFF_FFFF_FFFF) | 0x3FF0_0000_0000_0000);
    // The exponent, made a number by the digits of 2^52.
    let exponent =
        f64::from_bits((bits >> 52) | 0x4330_0000_0000_0000) - (4_503_599_627_370_496.0 + 1023.0);
    let large = mantissa > SQRT_2;
    let m = if large { 0.5 * mantissa } else { mantissa };
    let e = if large { exponent + 1.0 } else { exponent };
    let s = (m - 1.0) / (m + 1.0);
    e * LN_2 + 2.0 * odd_series(s, 1.0)
}

/// Halved twice, the angle is a sixteenth of a turn at most.
#[inline(always)]
fn atan2(y: f64, x: f64) -> f64 {
    let (width, height) = (x.abs(), y.abs());
    let steep = height > width;
    let (low, high) = if steep { (width, height) } else { (height, width) };
    let ratio = low / if high > f64::MIN_POSITIVE { high } else { f64::MIN_POSITIVE };
    let half = ratio / (1.0 + (1.0 + ratio * ratio).sqrt());
    let quarter = half / (1.0 + (1.0 + half * half).sqrt());
    let acute = 4.0 * odd_series(quarter, -1.0);
    let first = if steep { FRAC_PI_2 - acute } else { acute };
    let turned = if x < 0.0 { PI - first } else { first };
    turned.copysign(y)
}

/// `s + sign s^3/3 + s^5/5 + sign s^7/7 ...` to `s^21`: rounding for `s < 0.2`.
#[inline(always)]
fn odd_series(s: f64, sign: f64) -> f64 {
    let square = s * s * sign;
    let mut sum = 1.0 / 21.0;
    for divisor in [19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0] {
        sum = sum * square + 1.0 / divisor;
    }
    s * sum
}

impl Add for Lanes {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::from_fn(|i| self.0[i] + other.0[i])
    }
}

impl Sub for Lanes {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::from_fn(|i| self.0[i] - other.0[i])
    }
}

impl Mul for Lanes {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::from_fn(|i| self.0[i] * other.0[i])
    }
}

impl Div for Lanes {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self::from_fn(|i| self.0[i] / other.0[i])
    }
}

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::from_fn(|i| -self.0[i])
    }
}

impl Mul<Lanes> for f64 {
    type Output = Lanes;

    #[inline(always)]
    fn mul(self, other: Lanes) -> Lanes {
        Lanes::from_fn(|i| self * other.0[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithm_and_angle_are_those_of_the_library() {
        for k in 0..4000 {
            let value = (f64::from(k) * 0.35 - 700.0).exp();
            // One unit of the last place, or of one where the logarithm vanishes.
            assert!((ln(value) - value.ln()).abs() <= 3e-16 * value.ln().abs().max(1.0), "{value}");
            let (sin, cos) = (f64::from(k) * 0.001_7).sin_cos();
            let (y, x) = (sin * 1e-3, cos * 1e-3);
            assert!((atan2(y, x) - y.atan2(x)).abs() < 1.5e-15, "{y} {x}");
        }
        for (y, x) in
            [(0.0, 0.0), (1e-300, 1.0), (1.0, 1e-300), (-1.0, 0.0), (0.0, -2.0), (-3.0, -3.0)]
        {
            assert!((atan2(y, x) - f64::atan2(y, x)).abs() < 1e-15, "{y} {x}");
        }
    }
}
