//! Displacement by what lies between a strip's side and the line through a point, from a table.
//!
//! With `e` the distance of the side from that line and `d = X - s`, the integrand of a strip is the
//! difference of `ln(e + sqrt(e^2 + d^2))` between its two sides, so that its integrals are those of
//!
//! ```math
//! G_k(X, e) = \int_{-1}^{1} \sqrt{1 - s^2} \, U_k(s) \ln\bigl(e + \sqrt{e^2 + (X - s)^2}\bigr) \, ds.
//! ```
//!
//! In elliptic coordinates, `X + i e = sin(t + i l)`, this is smooth but for a logarithm at small
//! `l`: with `n = k + 1`, `theta = pi/2 - t` and `r = 2 sinh(l/2)` it is
//!
//! ```math
//! G_k = R_k - 2 \ln r \left[ e \sin n\theta
//!     + \tfrac{n}{12} r^3 (n \sin\theta \sin n\theta - 5 \cos\theta \cos n\theta) + O(r^5) \right].
//! ```
//!
//! The rest `R` is tabulated over `tan(t/2)` and `r`, both of which cost a root and no more. Cubics
//! err by less than 5e-6, most next to the ends of the strip.

// So that all is compiled for each kind of processor.
#![allow(clippy::inline_always)]

use std::array::from_fn;
use std::sync::LazyLock;

use super::kernel::{RULES, Rules, log_integrals};
use crate::lanes::ln;
use crate::normal::lattice::whole;

/// Most polynomials that are tabulated.
pub(super) const TABULATED: usize = 4;
/// Mean distance from the ends up to which the table reaches.
const REACH: f64 = 1.5;
/// Intervals of `tan(t/2)`, up to 1, and of `r`.
const INTERVALS: [usize; 2] = [96, 48];

pub(super) static TABLE: LazyLock<Table> = LazyLock::new(|| Table::new(&RULES));

/// Where a side is seen from a point, in half lengths, on the positive side of both axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    e: f64,
    /// Half the sum of its distances from the ends: `cosh l`.
    mean: f64,
    /// Half their difference: `sin t`.
    sin: f64,
    /// Their product: the square of `|cos(t + i l)|`.
    product: f64,
}

impl Place {
    #[inline(always)]
    pub(super) fn new(x: f64, e: f64) -> Self {
        let (x, e) = (x.abs(), e.abs());
        let [far, near] = [x + 1.0, x - 1.0].map(|d| (d * d + e * e).sqrt());
        // Not zero on the end itself, where slopes would be no numbers.
        let product = (far * near).max(1e-200);
        Self { e, mean: 0.5 * (far + near), sin: 0.5 * (far - near), product }
    }

    #[inline(always)]
    pub(super) fn is_tabulated(&self) -> bool {
        self.mean < REACH
    }
}

/// `G_k`, and the derivatives of their sum weighted with pressures.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side<const T: usize> {
    pub(super) value: [f64; T],
    pub(super) by_x: f64,
    /// By the logarithm of `e`.
    pub(super) by_e: f64,
}

/// `R_k` at the points of a grid.
#[derive(Debug)]
pub(super) struct Table {
    rest: Vec<[f64; TABULATED]>,
    step: [f64; 2],
}

impl Table {
    fn new(rules: &Rules) -> Self {
        let [columns, rows] = INTERVALS;
        let step = [1.0 / columns as f64, (2.0 * (REACH - 1.0)).sqrt() / rows as f64];
        let at = |row: usize, column: usize| {
            let (q, r) = (step[0] * column as f64, step[1] * row as f64);
            let (sin, cos) = (2.0 * q / (1.0 + q * q), (1.0 - q * q) / (1.0 + q * q));
            let (x, e) = (sin * (1.0 + 0.5 * r * r), cos * r * half_cosh(r));
            if row == 0 {
                return log_integrals(x);
            }
            let value = if column == columns { log_integrals(x) } else { rules.side(x, e) };
            let with_log = Harmonics::<TABULATED>::new(sin, cos).with_log(e, r);
            from_fn(|k| value[k] + 2.0 * with_log[k] * r.ln())
        };
        let rest = (0..=rows).flat_map(|row| (0..=columns).map(move |column| at(row, column)));
        Self { rest: rest.collect(), step }
    }

    /// With `SLOPES` the derivatives too, for some pressures.
    #[inline(always)]
    pub(super) fn side<const T: usize, const SLOPES: bool>(
        &self,
        Place { e, mean, sin, product }: Place,
        pressure: &[f64; T],
    ) -> Side<T> {
        let cos = ((1.0 - sin) * (1.0 + sin)).max(0.0).sqrt();
        // A point on the side itself has r = 0, and e with it.
        let (q, r) = (sin / (1.0 + cos), (2.0 * (mean - 1.0)).max(1e-30).sqrt());
        let log = -2.0 * ln(r);
        let [rest, by_q, by_r] = self.cubic::<T, SLOPES>([q, r]);
        let harmonics = Harmonics::<T>::new(sin, cos);
        let with_log = harmonics.with_log(e, r);
        let value = from_fn(|k| rest[k] + with_log[k] * log);
        if !SLOPES {
            return Side { value, by_x: 0.0, by_e: 0.0 };
        }
        let weighted = |f: [f64; T]| -> f64 { (0..T).map(|k| pressure[k] * f[k]).sum() };
        let half_cosh = half_cosh(r);
        let sinh = r * half_cosh;
        let [log_by_t, log_by_l] = harmonics.slopes([sinh, mean], [r, half_cosh]);
        let by_t = 0.5 * (1.0 + q * q) * weighted(by_q) + weighted(log_by_t) * log;
        let by_l =
            half_cosh * (weighted(by_r) - 2.0 * weighted(with_log) / r) + weighted(log_by_l) * log;
        // Real and imaginary part of 1/cos(t + i l).
        let (along, across) = (cos * mean / product, sin * sinh / product);
        Side { value, by_x: by_t * along + by_l * across, by_e: e * (by_l * along - by_t * across) }
    }

    /// The rest at a place, and with `SLOPES` its derivatives: Lagrange's cubics.
    #[inline(always)]
    fn cubic<const T: usize, const SLOPES: bool>(&self, at: [f64; 2]) -> [[f64; T]; 3] {
        let steps = [at[0] / self.step[0], at[1] / self.step[1]];
        let first: [usize; 2] =
            from_fn(|axis| whole(steps[axis]).clamp(1, INTERVALS[axis] - 2) - 1);
        let [u, v] = [steps[0] - first[0] as f64, steps[1] - first[1] as f64];
        let (along, along_slopes) = (weights(u), slopes(u));
        let mut sums = [[0.0; T]; 3];
        for (i, (across, across_slope)) in weights(v).into_iter().zip(slopes(v)).enumerate() {
            let start = (first[1] + i) * (INTERVALS[0] + 1) + first[0];
            let Some(points) = self.rest[start..].first_chunk::<4>() else { return sums };
            for k in 0..T {
                let of =
                    |weights: &[f64; 4]| -> f64 { (0..4).map(|j| weights[j] * points[j][k]).sum() };
                let value = of(&along);
                sums[0][k] += across * value;
                if SLOPES {
                    sums[1][k] += across * of(&along_slopes) / self.step[0];
                    sums[2][k] += across_slope * value / self.step[1];
                }
            }
        }
        sums
    }
}

/// `cosh(l/2)`.
#[inline(always)]
fn half_cosh(r: f64) -> f64 {
    (1.0 + 0.25 * r * r).sqrt()
}

/// Sines and cosines of `(k + 1) theta`.
struct Harmonics<const T: usize> {
    sin: [f64; T],
    cos: [f64; T],
}

impl<const T: usize> Harmonics<T> {
    /// Of the sine and cosine of `t`.
    #[inline(always)]
    fn new(sin: f64, cos: f64) -> Self {
        let mut harmonics = Self { sin: [cos; T], cos: [sin; T] };
        for k in 1..T {
            let (s, c) = (harmonics.sin[k - 1], harmonics.cos[k - 1]);
            harmonics.sin[k] = s * sin + c * cos;
            harmonics.cos[k] = c * sin - s * cos;
        }
        harmonics
    }

    /// What `-2 ln r` goes with.
    #[inline(always)]
    fn with_log(&self, e: f64, r: f64) -> [f64; T] {
        from_fn(|k| e * self.sin[k] + r * r * r * self.third(k))
    }

    #[inline(always)]
    fn third(&self, k: usize) -> f64 {
        let (Self { sin, cos }, n) = (self, (k + 1) as f64);
        n * (n * sin[0] * sin[k] - 5.0 * cos[0] * cos[k]) / 12.0
    }

    /// Its derivatives by `t` and by `l`.
    #[inline(always)]
    fn slopes(&self, [sinh, cosh]: [f64; 2], [r, half_cosh]: [f64; 2]) -> [[f64; T]; 2] {
        let Self { sin, cos } = self;
        let by_t = from_fn(|k| {
            let n = (k + 1) as f64;
            let third = n * (6.0 * n * cos[0] * sin[k] + (n * n + 5.0) * sin[0] * cos[k]) / 12.0;
            -sinh * (cos[0] * sin[k] + n * sin[0] * cos[k]) - r * r * r * third
        });
        let by_l = from_fn(|k| sin[0] * cosh * sin[k] + 3.0 * r * r * half_cosh * self.third(k));
        [by_t, by_l]
    }
}

/// Lagrange's weights of four points at 0, 1, 2, 3.
#[inline(always)]
fn weights(u: f64) -> [f64; 4] {
    let [a, b, c, d] = [u, u - 1.0, u - 2.0, u - 3.0];
    [-b * c * d / 6.0, 0.5 * a * c * d, -0.5 * a * b * d, a * b * c / 6.0]
}

/// Their derivatives.
#[inline(always)]
fn slopes(u: f64) -> [f64; 4] {
    let [a, b, c, d] = [u, u - 1.0, u - 2.0, u - 3.0];
    let of = |x: f64, y: f64, z: f64| x * y + y * z + z * x;
    [-of(b, c, d) / 6.0, 0.5 * of(a, c, d), -0.5 * of(a, b, d), of(a, b, c) / 6.0]
}
