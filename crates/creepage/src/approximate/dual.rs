//! Exact derivatives: a formula written once for [`Real`] gives its value with `f64` and its
//! derivatives by creepage with [`Dual`].

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Creepage, Force};

/// A number that a formula can be computed with.
pub(crate) trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
    + Add<f64, Output = Self>
{
    /// A number that does not depend on the creepage.
    fn constant(value: f64) -> Self;
    /// The number itself.
    fn value(self) -> f64;
    /// Derivative by the creepage component `k`: 0, 1, 2 for `xi`, `eta`, `chi`.
    fn tangent(self, k: usize) -> f64;
    /// Square root; where it is zero, its derivative is taken as zero.
    fn sqrt(self) -> Self;
    /// The magnitude.
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
}

impl Real for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn tangent(self, _: usize) -> f64 {
        0.0
    }
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
}

/// A number with its derivatives by `xi`, `eta` and `chi`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Dual {
    v: f64,
    d: [f64; 3],
}

impl Dual {
    /// The independent variable number `k`.
    pub(crate) fn variable(value: f64, k: usize) -> Self {
        Self { v: value, d: std::array::from_fn(|i| f64::from(u8::from(i == k))) }
    }

    /// `f(self)`, given the value and the slope of `f` there.
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { v: value, d: self.d.map(|d| slope * d) }
    }

    fn zip(self, other: Self, v: f64, d: impl Fn(f64, f64) -> f64) -> Self {
        Self { v, d: std::array::from_fn(|i| d(self.d[i], other.d[i])) }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, self.v + other.v, |p, q| p + q)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, self.v - other.v, |p, q| p - q)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)] // the product rule adds
impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.zip(other, self.v * other.v, |p, q| p * other.v + self.v * q)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)] // the quotient rule subtracts
impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let ratio = self.v / other.v;
        self.zip(other, ratio, |p, q| (p - ratio * q) / other.v)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.v, -1.0)
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.chain(self.v * factor, factor)
    }
}

impl Add<f64> for Dual {
    type Output = Self;
    fn add(self, term: f64) -> Self {
        self.chain(self.v + term, 1.0)
    }
}

impl Real for Dual {
    fn constant(value: f64) -> Self {
        Self { v: value, d: [0.0; 3] }
    }
    fn value(self) -> f64 {
        self.v
    }
    fn tangent(self, k: usize) -> f64 {
        self.d[k]
    }
    fn sqrt(self) -> Self {
        let root = self.v.sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }
}

/// A creepage beyond which nothing changes but rounding: every strip slides everywhere.
const LARGEST: f64 = 1e100;

/// `xi`, `eta`, `chi` as plain numbers. Creepages so large that squares would overflow are
/// shortened: the direction is all that matters then.
pub(crate) fn plain(creepage: Creepage) -> [f64; 3] {
    let numbers = [creepage.xi, creepage.eta, creepage.chi];
    let largest = numbers.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if largest > LARGEST { numbers.map(|v| v / largest * LARGEST) } else { numbers }
}

/// `xi`, `eta`, `chi` as independent variables.
pub(crate) fn variables(creepage: Creepage) -> [Dual; 3] {
    let numbers = plain(creepage);
    std::array::from_fn(|k| Dual::variable(numbers[k], k))
}

/// The force of three numbers.
pub(crate) fn force(numbers: [f64; 3]) -> Force {
    Force { fx: numbers[0], fy: numbers[1], mz: numbers[2] }
}

/// Rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`.
pub(crate) fn jacobian(force: [Dual; 3]) -> [[f64; 3]; 3] {
    force.map(|component| component.d)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula<R: Real>([x, y, z]: [R; 3]) -> R {
        ((x * y + z * 2.0) / (z + 0.3)).sqrt() * x - (-z).abs() * y
    }

    /// Central differences of step 1e-5 are good to 1e-10 or so.
    #[test]
    fn derivatives_agree_with_central_differences() {
        let at = [0.7, 0.4, 1.3];
        let exact = formula(std::array::from_fn(|k| Dual::variable(at[k], k)));
        assert!((exact.value() - formula(at)).abs() < 1e-15);
        for k in 0..3 {
            let side = |h: f64| {
                let mut moved = at;
                moved[k] += h;
                formula(moved)
            };
            let difference = (side(1e-5) - side(-1e-5)) / 2e-5;
            assert!((exact.tangent(k) - difference).abs() < 1e-9);
        }
    }

    #[test]
    fn absurd_creepage_keeps_its_direction() {
        let shortened = plain(Creepage { xi: 3e300, eta: -4e300, chi: 0.0 });
        assert!((shortened[0] / shortened[1] + 0.75).abs() < 1e-15);
        assert!(shortened.iter().all(|v| v.abs() <= LARGEST));
    }
}
