//! Table of the strip kernel: displacement by what lies between a strip's side and the line through a point.
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

// So that all is compiled for each kind of processor; loops over lanes index several arrays at once.
#![allow(clippy::inline_always, clippy::needless_range_loop)]

use std::array::from_fn;
use std::sync::LazyLock;

use super::kernel::{self, log_integrals};
use crate::normal::lattice::whole;
use crate::numerics::simd_math::{LANES, Lanes, each, ln};

/// Most polynomials that are tabulated.
pub(super) const TABULATED: usize = 4;
/// Mean distance from the ends up to which the table reaches.
const REACH: f64 = 1.5;
/// Intervals of `tan(t/2)`, up to 1, and of `r`.
const INTERVALS: [usize; 2] = [96, 72];

pub(super) static TABLE: LazyLock<Table> = LazyLock::new(Table::new);

/// Where sides are seen from a point, in half lengths of their strips, on the positive side of both
/// axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Places {
    e: Lanes,
    /// Half the sum of the distances from the ends: `cosh l`.
    mean: Lanes,
    /// Half their difference: `sin t`.
    sin: Lanes,
    /// Their product: the square of `|cos(t + i l)|`.
    product: Lanes,
}

impl Places {
    #[inline(always)]
    pub(super) fn new(x: &Lanes, e: &Lanes) -> Self {
        let distance = |end: f64| each(|l| ((x[l] + end) * (x[l] + end) + e[l] * e[l]).sqrt());
        let [far, near] = [distance(1.0), distance(-1.0)];
        Self {
            e: *e,
            mean: each(|l| 0.5 * (far[l] + near[l])),
            sin: each(|l| 0.5 * (far[l] - near[l])),
            // Not zero on the end itself, where slopes would be no numbers.
            product: each(|l| (far[l] * near[l]).max(1e-200)),
        }
    }

    /// Half the sum of the distances from the ends.
    #[inline(always)]
    pub(super) fn mean(&self) -> Lanes {
        self.mean
    }

    #[inline(always)]
    pub(super) fn are_tabulated(&self) -> [bool; LANES] {
        self.mean.map(|mean| mean < REACH)
    }
}

/// Sums `G_k` of sides, and the derivatives of their sum weighted with pressures.
#[derive(Debug, Clone, Copy)]
pub(super) struct SideSums<const T: usize> {
    pub(super) value: [Lanes; T],
    pub(super) by_x: Lanes,
    /// By the logarithm of `e`.
    pub(super) by_e: Lanes,
}

/// `R_k` at the points of a grid.
#[derive(Debug)]
pub(super) struct Table {
    rest: [Vec<f64>; TABULATED],
    step: [f64; 2],
}

impl Table {
    fn new() -> Self {
        let [columns, rows] = INTERVALS;
        let step = [1.0 / columns as f64, (2.0 * (REACH - 1.0)).sqrt() / rows as f64];
        let at = |row: usize, column: usize| {
            let (q, r) = (step[0] * column as f64, step[1] * row as f64);
            let (sin, cos) = (2.0 * q / (1.0 + q * q), (1.0 - q * q) / (1.0 + q * q));
            let (x, e) = (sin * (1.0 + 0.5 * r * r), cos * r * half_cosh(r));
            if row == 0 {
                return log_integrals(x);
            }
            let value: [f64; TABULATED] =
                if column == columns { log_integrals(x) } else { kernel::side(x, e) };
            let all = |number: f64| [number; LANES];
            let harmonics = Harmonics::<TABULATED>::new(&all(sin), &all(cos));
            let with_log = harmonics.with_log(&all(e), &all(r));
            from_fn(|k| value[k] + 2.0 * with_log[k][0] * r.ln())
        };
        let places = (0..=rows).flat_map(|row| (0..=columns).map(move |column| (row, column)));
        let points: Vec<[f64; TABULATED]> = places.map(|(row, column)| at(row, column)).collect();
        Self { rest: from_fn(|k| points.iter().map(|point| point[k]).collect()), step }
    }

    /// With `SLOPES` the derivatives too, for some pressures. Beyond the table's reach it is no
    /// more than a number.
    #[inline(always)]
    pub(super) fn sides<const T: usize, const SLOPES: bool>(
        &self,
        Places { e, mean, sin, product }: &Places,
        pressure: &[Lanes; T],
    ) -> SideSums<T> {
        let cos = each(|l| ((1.0 - sin[l]) * (1.0 + sin[l])).max(0.0).sqrt());
        let q = each(|l| sin[l] / (1.0 + cos[l]));
        // A point on the side itself has r = 0, and e with it.
        let r = each(|l| (2.0 * (mean[l] - 1.0)).max(1e-30).sqrt());
        let log = each(|l| -2.0 * ln(r[l]));
        let [rest, by_q, by_r] = self.cubic::<T, SLOPES>([&q, &r]);
        let harmonics = Harmonics::<T>::new(sin, &cos);
        let with_log = harmonics.with_log(e, &r);
        let value = from_fn(|k| each(|l| rest[k][l] + with_log[k][l] * log[l]));
        let zero = [0.0; LANES];
        if !SLOPES {
            return SideSums { value, by_x: zero, by_e: zero };
        }
        let weighted =
            |f: &[Lanes; T]| each(|l| (0..T).map(|k| pressure[k][l] * f[k][l]).sum::<f64>());
        let half_cosh = each(|l| half_cosh(r[l]));
        let sinh = each(|l| r[l] * half_cosh[l]);
        let [log_by_t, log_by_l] = harmonics.slopes([&sinh, mean], [&r, &half_cosh]);
        let [by_q, by_r] = [weighted(&by_q), weighted(&by_r)];
        let [log_by_t, log_by_l] = [weighted(&log_by_t), weighted(&log_by_l)];
        let with_log = weighted(&with_log);
        let by_t = each(|l| 0.5 * (1.0 + q[l] * q[l]) * by_q[l] + log_by_t[l] * log[l]);
        let by_l =
            each(|l| half_cosh[l] * (by_r[l] - 2.0 * with_log[l] / r[l]) + log_by_l[l] * log[l]);
        // Real and imaginary part of 1/cos(t + i l).
        let along = each(|l| cos[l] * mean[l] / product[l]);
        let across = each(|l| sin[l] * sinh[l] / product[l]);
        SideSums {
            value,
            by_x: each(|l| by_t[l] * along[l] + by_l[l] * across[l]),
            by_e: each(|l| e[l] * (by_l[l] * along[l] - by_t[l] * across[l])),
        }
    }

    /// The rest at places, and with `SLOPES` its derivatives: Lagrange's cubics.
    #[inline(always)]
    fn cubic<const T: usize, const SLOPES: bool>(&self, at: [&Lanes; 2]) -> [[Lanes; T]; 3] {
        let [(columns, u), (rows, v)] =
            from_fn(|axis| cells(at[axis], self.step[axis], INTERVALS[axis]));
        let (along, along_slopes) = (weights(&u), slopes(&u));
        let (across, across_slopes) = (weights(&v), slopes(&v));
        let mut sums = [[[0.0; LANES]; T]; 3];
        for i in 0..4 {
            let starts = from_fn(|l| (rows[l] + i) * (INTERVALS[0] + 1) + columns[l]);
            for k in 0..T {
                let points = four(&self.rest[k], &starts);
                let of = |weights: &[Lanes; 4]| {
                    each(|l| (0..4).map(|j| weights[j][l] * points[j][l]).sum::<f64>())
                };
                let value = of(&along);
                add(&mut sums[0][k], &across[i], &value);
                if SLOPES {
                    add(&mut sums[1][k], &across[i], &of(&along_slopes));
                    add(&mut sums[2][k], &across_slopes[i], &value);
                }
            }
        }
        let [_, by_q, by_r] = &mut sums;
        by_q.iter_mut().flatten().for_each(|by| *by /= self.step[0]);
        by_r.iter_mut().flatten().for_each(|by| *by /= self.step[1]);
        sums
    }
}

/// The first of four points about each place, and how many steps the place lies beyond it.
#[inline(always)]
fn cells(at: &Lanes, step: f64, intervals: usize) -> ([usize; LANES], Lanes) {
    let steps = each(|l| at[l] / step);
    let first: [usize; LANES] = from_fn(|l| whole(steps[l]).clamp(1, intervals - 2) - 1);
    (first, each(|l| steps[l] - first[l] as f64))
}

/// Four neighbours from each start on.
#[inline(always)]
fn four(points: &[f64], starts: &[usize; LANES]) -> [Lanes; 4] {
    let mut found = [[0.0; LANES]; 4];
    for (l, &start) in starts.iter().enumerate() {
        let Some(own) = points.get(start..).and_then(<[f64]>::first_chunk::<4>) else { continue };
        for j in 0..4 {
            found[j][l] = own[j];
        }
    }
    found
}

#[inline(always)]
fn add(sum: &mut Lanes, weight: &Lanes, value: &Lanes) {
    for l in 0..LANES {
        sum[l] += weight[l] * value[l];
    }
}

/// `cosh(l/2)`.
#[inline(always)]
fn half_cosh(r: f64) -> f64 {
    (1.0 + 0.25 * r * r).sqrt()
}

/// Sines and cosines of `(k + 1) theta`.
struct Harmonics<const T: usize> {
    sin: [Lanes; T],
    cos: [Lanes; T],
}

impl<const T: usize> Harmonics<T> {
    /// Of the sine and cosine of `t`.
    #[inline(always)]
    fn new(sin: &Lanes, cos: &Lanes) -> Self {
        let mut harmonics = Self { sin: [*cos; T], cos: [*sin; T] };
        for k in 1..T {
            let (s, c) = (harmonics.sin[k - 1], harmonics.cos[k - 1]);
            harmonics.sin[k] = each(|l| s[l] * sin[l] + c[l] * cos[l]);
            harmonics.cos[k] = each(|l| c[l] * sin[l] - s[l] * cos[l]);
        }
        harmonics
    }

    /// What `-2 ln r` goes with.
    #[inline(always)]
    fn with_log(&self, e: &Lanes, r: &Lanes) -> [Lanes; T] {
        from_fn(|k| {
            let third = self.third(k);
            each(|l| e[l] * self.sin[k][l] + r[l] * r[l] * r[l] * third[l])
        })
    }

    #[inline(always)]
    fn third(&self, k: usize) -> Lanes {
        let (Self { sin, cos }, n) = (self, (k + 1) as f64);
        each(|l| n * (n * sin[0][l] * sin[k][l] - 5.0 * cos[0][l] * cos[k][l]) / 12.0)
    }

    /// Its derivatives by `t` and by `l`.
    #[inline(always)]
    fn slopes(&self, [sinh, cosh]: [&Lanes; 2], [r, half_cosh]: [&Lanes; 2]) -> [[Lanes; T]; 2] {
        let Self { sin, cos } = self;
        let by_t = from_fn(|k| {
            let n = (k + 1) as f64;
            each(|l| {
                let (one, own) = ([sin[0][l], cos[0][l]], [sin[k][l], cos[k][l]]);
                let third =
                    n * (6.0 * n * one[1] * own[0] + (n * n + 5.0) * one[0] * own[1]) / 12.0;
                -sinh[l] * (one[1] * own[0] + n * one[0] * own[1]) - r[l] * r[l] * r[l] * third
            })
        });
        let by_l = from_fn(|k| {
            let third = self.third(k);
            each(|l| sin[0][l] * cosh[l] * sin[k][l] + 3.0 * r[l] * r[l] * half_cosh[l] * third[l])
        });
        [by_t, by_l]
    }
}

/// Lagrange's weights of four points at 0, 1, 2, 3.
#[inline(always)]
fn weights(u: &Lanes) -> [Lanes; 4] {
    by_distances(u, |[a, b, c, d]| {
        [-b * c * d / 6.0, 0.5 * a * c * d, -0.5 * a * b * d, a * b * c / 6.0]
    })
}

/// Their derivatives.
#[inline(always)]
fn slopes(u: &Lanes) -> [Lanes; 4] {
    let of = |x: f64, y: f64, z: f64| x * y + y * z + z * x;
    by_distances(u, |[a, b, c, d]| {
        [-of(b, c, d) / 6.0, 0.5 * of(a, c, d), -0.5 * of(a, b, d), of(a, b, c) / 6.0]
    })
}

#[inline(always)]
fn by_distances(u: &Lanes, of: impl Fn([f64; 4]) -> [f64; 4]) -> [Lanes; 4] {
    let mut all = [[0.0; LANES]; 4];
    for (l, &u) in u.iter().enumerate() {
        for (lanes, own) in all.iter_mut().zip(of([u, u - 1.0, u - 2.0, u - 3.0])) {
            lanes[l] = own;
        }
    }
    all
}
