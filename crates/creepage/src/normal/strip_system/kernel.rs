//! Kernel of the strip method: displacement by a strip whose pressure vanishes as a root at both ends.
//!
//! For the pressure `sqrt(1 - s^2) U_k(s)`, with Chebyshev's polynomials of the second kind, on a
//! strip between two `y`, the integral over `y` is done in closed form and leaves
//!
//! ```math
//! I_k(X, e_-, e_+) = \int_{-1}^{1} \sqrt{1 - s^2} \, U_k(s)
//!     \left[ \sinh^{-1} \frac{e_+}{|X - s|} - \sinh^{-1} \frac{e_-}{|X - s|} \right] ds.
//! ```
//!
//! Far away few Gauss-Chebyshev points integrate it. Near by the integrand is singular at
//! `s = X +- i e` close to the interval; with `s = sin(t + l sinh v)`, `t + i l` the arc sine of
//! that place, it is smooth in `v` (Johnston & Elliott 2005). On the strip itself the logarithm
//! of `|X - s|` has a closed form.

// So that all is compiled for each kind of processor; loops over lanes index several arrays at once.
#![allow(clippy::inline_always, clippy::needless_range_loop)]

use std::f64::consts::{FRAC_PI_2, LN_2, PI};

use super::rules::{MAX_TERMS, RULES, Rules, polynomials};
use crate::numerics::simd_math::{LANES, Lanes, each, exp, ln, sin};

/// The integrals of one strip at one point with `T` polynomials, and the derivatives of their sum
/// weighted with the strip's pressures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Integrals<const T: usize> {
    /// `I_k`.
    pub(super) value: [f64; T],
    /// By `X`; zero on the strip itself, whose points move with it.
    pub(super) by_x: f64,
    /// By the logarithm of a common factor of both `e`.
    pub(super) by_e: f64,
}

/// Where the two sides of a strip are seen from a point, in half lengths of the strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    pub(super) x: f64,
    pub(super) low: f64,
    pub(super) high: f64,
    /// Whether the point lies on the strip's own middle line.
    pub(super) own: bool,
}

/// What a sum over the strip's points adds up.
struct Sums<const T: usize> {
    value: [Lanes; T],
    by_x: Lanes,
    by_e: Lanes,
}

impl<const T: usize> Sums<T> {
    /// `SLOPES` asks for the derivatives too.
    #[inline(always)]
    fn add<const SLOPES: bool>(
        &mut self,
        [log, ratio, slope]: &[Lanes; 3],
        weights: &[Lanes; T],
        pressure: &[f64],
    ) {
        for k in 0..T {
            for l in 0..LANES {
                self.value[k][l] += weights[k][l] * log[l];
            }
        }
        if SLOPES {
            let weight = each(|l| (0..T).map(|k| pressure[k] * weights[k][l]).sum());
            for l in 0..LANES {
                self.by_x[l] += weight[l] * slope[l];
                self.by_e[l] += weight[l] * ratio[l];
            }
        }
    }
}

impl View {
    /// Seen from the side on which both are as far up as possible: the integrals are the same.
    #[cfg(test)]
    pub(super) fn upright(self) -> Self {
        if self.low.abs() > self.high.abs() {
            Self { low: -self.high, high: -self.low, ..self }
        } else {
            self
        }
    }

    /// The integrals by quadrature, of an upright view; with `SLOPES` also their derivatives, for the
    /// strip's pressures.
    #[inline(always)]
    pub(super) fn by_quadrature<const T: usize, const SLOPES: bool>(
        self,
        rules: &Rules,
        pressure: &[f64],
    ) -> Integrals<T> {
        let (view, distances) = (self, self.distances());
        let zero = [0.0; LANES];
        let mut sums = Sums { value: [zero; T], by_x: zero, by_e: zero };
        if let Some(blocks) = rules.reaching::<T>(mean(distances)) {
            for block in blocks {
                let weights = std::array::from_fn(|k| block.weights[k]);
                let seen = view.seen::<SLOPES>(&block.s);
                sums.add::<SLOPES>(&seen, &weights, pressure);
            }
        } else {
            let rule = |half| rules.legendre::<T>(half);
            view.add_near::<T, SLOPES>(&mut sums, rule, distances, pressure);
        }
        let total = |lanes: Lanes| lanes.iter().sum::<f64>();
        let mut value = sums.value.map(total);
        if view.own {
            for (value, log) in value.iter_mut().zip(log_integrals::<T>(view.x)) {
                *value -= 2.0 * log;
            }
        }
        Integrals { value, by_x: total(sums.by_x), by_e: total(sums.by_e) }
    }

    /// Distances of the nearest singularity from the strip's two ends.
    #[inline(always)]
    fn distances(&self) -> [f64; 2] {
        let nearest = if self.own { self.high } else { self.low.max(0.0) };
        [1.0, -1.0].map(|end| ((self.x + end).powi(2) + nearest * nearest).sqrt())
    }

    #[inline(always)]
    fn add_near<'a, const T: usize, const SLOPES: bool>(
        &self,
        sums: &mut Sums<T>,
        rule: impl Fn(f64) -> &'a [(Lanes, Lanes)],
        [left, right]: [f64; 2],
        pressure: &[f64],
    ) {
        let mean = mean([left, right]);
        let angle = (0.5 * (left - right)).clamp(-1.0, 1.0).asin();
        let depth = ln(mean + ((mean - 1.0) * (mean + 1.0)).sqrt()).max(1e-7);
        let [from, to] = [-FRAC_PI_2 - angle, FRAC_PI_2 - angle].map(|side| {
            let ratio = (side / depth).abs();
            ln(ratio + (ratio * ratio + 1.0).sqrt()).copysign(side)
        });
        let (middle, half) = (f64::midpoint(from, to), 0.5 * (to - from));
        for (nodes, shares) in rule(half) {
            let grown = each(|l| exp(middle + half * nodes[l]));
            let s = each(|l| sin(angle + depth * 0.5 * (grown[l] - 1.0 / grown[l])));
            let scale = half * depth * 0.5;
            let weight = each(|l| {
                let spread = grown[l] + 1.0 / grown[l];
                shares[l] * scale * spread * (1.0 - s[l]) * (1.0 + s[l])
            });
            let mut weights = [[0.0; LANES]; T];
            for l in 0..LANES {
                let u = polynomials::<T>(s[l]);
                for k in 0..T {
                    weights[k][l] = weight[l] * u[k];
                }
            }
            let seen = self.seen::<SLOPES>(&s);
            sums.add::<SLOPES>(&seen, &weights, pressure);
        }
    }

    /// The difference of the inverse hyperbolic sines, its derivative by a common factor of both
    /// `e`, and that by `X`.
    #[inline(always)]
    fn seen<const SLOPES: bool>(&self, s: &Lanes) -> [Lanes; 3] {
        let Self { x, low, high, own } = *self;
        let d = each(|l| x - s[l]);
        let above = each(|l| (high * high + d[l] * d[l]).sqrt());
        if own {
            let log = each(|l| 2.0 * ln(high + above[l]));
            let ratio = each(|l| if SLOPES { 2.0 * high / above[l] } else { 0.0 });
            return [log, ratio, [0.0; LANES]];
        }
        // Nothing of size is as small as this; it keeps a point on a corner finite.
        let below = each(|l| (low * low + d[l] * d[l] + 1e-200).sqrt());
        if low < 0.0 {
            let log = each(|l| ln((high + above[l]) * (below[l] - low) / (d[l] * d[l] + 1e-200)));
            let ratio = each(|l| high / above[l] - low / below[l]);
            return [log, ratio, each(|l| -ratio[l] / d[l])];
        }
        let log = each(|l| ln((high + above[l]) / (low + below[l])));
        if !SLOPES {
            return [log, [0.0; LANES], [0.0; LANES]];
        }
        // high/above - low/below over d, where nothing cancels.
        let square = (high - low) * (high + low);
        let slope = each(|l| {
            let product = above[l] * below[l] * (high * below[l] + low * above[l]);
            d[l] * square / (product + 1e-200)
        });
        [log, each(|l| d[l] * slope[l]), each(|l| -slope[l])]
    }
}

/// `G_k` for the table: half of what two sides give without the logarithm of the distance.
pub(super) fn side<const T: usize>(x: f64, e: f64) -> [f64; T] {
    let view = View { x, low: -e, high: e, own: true };
    let zero = [0.0; LANES];
    let mut sums = Sums { value: [zero; T], by_x: zero, by_e: zero };
    let rule = |half| RULES.legendre::<MAX_TERMS>(half);
    view.add_near::<T, false>(&mut sums, rule, view.distances(), &[]);
    sums.value.map(|lanes| 0.5 * lanes.iter().sum::<f64>())
}

#[inline(always)]
fn mean([left, right]: [f64; 2]) -> f64 {
    (0.5 * (left + right)).max(1.0)
}

/// `U_k(s)`, weighted by coefficients.
pub(crate) fn profile(coefficients: &[f64; MAX_TERMS], s: f64) -> f64 {
    polynomials::<MAX_TERMS>(s).iter().zip(coefficients).map(|(u, c)| u * c).sum()
}

/// `int sqrt(1 - s^2) U_k(s) ln|x - s| ds`: its derivative is `pi T_(k+1)(x)` inside the interval, and
/// `pi (x - sqrt(x^2 - 1))^(k+1)` beyond its upper end.
#[inline(always)]
pub(super) fn log_integrals<const T: usize>(x: f64) -> [f64; T] {
    let first = beyond(x);
    let mut t = [1.0, first, 2.0 * x * first - 1.0];
    std::array::from_fn(|k| {
        if k == 0 {
            let far = if x > 1.0 { -FRAC_PI_2 * ln(first) } else { 0.0 };
            return PI * (0.25 * t[2] - 0.5 * LN_2) + far;
        }
        t = [t[1], t[2], 2.0 * x * t[2] - t[1]];
        FRAC_PI_2 * (t[2] / (k + 2) as f64 - t[0] / k as f64)
    })
}

/// The derivative of [`log_integrals`] weighted with pressures.
#[inline(always)]
pub(super) fn log_slopes<const T: usize>(x: f64, pressure: &[f64; T]) -> f64 {
    let first = beyond(x);
    let (mut before, mut last, mut sum) = (1.0, first, 0.0);
    for pressure in pressure {
        sum += PI * pressure * last;
        (before, last) = (last, 2.0 * x * last - before);
    }
    sum
}

/// `x` inside the interval; beyond its end what powers of it stand for Chebyshev's polynomials there.
#[inline(always)]
fn beyond(x: f64) -> f64 {
    if x > 1.0 { x - ((x - 1.0) * (x + 1.0)).sqrt() } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By brute force: midpoints in the angle, whose clustering eases the ends; the logarithm
    /// stays, so many are needed.
    fn brute(view: View, k: usize) -> f64 {
        const MIDPOINTS: u32 = 2_000_000;
        let step = PI / f64::from(MIDPOINTS);
        (0..MIDPOINTS)
            .map(|i| {
                let (s, cos) = (-FRAC_PI_2 + (f64::from(i) + 0.5) * step).sin_cos();
                let d = (view.x - s).abs();
                let kernel = (view.high / d).asinh() - (view.low / d).asinh();
                step * cos * cos * polynomials::<MAX_TERMS>(s)[k] * kernel
            })
            .sum()
    }

    #[test]
    fn agrees_with_brute_force_near_and_far() {
        for (x, low, high, own) in [
            (0.3, -0.005, 0.005, true),
            (-0.966, -0.2, 0.2, true),
            (0.9, 0.003, 0.01, false),
            (1.02, 0.01, 0.05, false),
            (-0.4, -0.6, -0.1, false),
            (1.3, -0.3, 0.2, false),
            (0.1, 1.0, 1.6, false),
            (9.0, -5.0, 3.0, false),
            (0.2, 30.0, 31.0, false),
        ] {
            let view = View { x, low, high, own };
            let found = view.upright().by_quadrature::<MAX_TERMS, false>(&RULES, &[]);
            for k in 0..MAX_TERMS {
                let expected = brute(view, k);
                let difference = (found.value[k] - expected).abs();
                // Half a step of the brute sum is lost at the logarithm.
                assert!(difference < 2e-6, "{view:?} {k}: {difference}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values() {
        const DIFFERENCE_STEP: f64 = 1e-5;
        for (x, low, high, own) in
            [(0.7, 0.02, 0.09, false), (1.4, -0.3, 0.2, false), (0.3, -0.05, 0.05, true)]
        {
            let at = |dx: f64, factor: f64| {
                let view = View { x: x + dx, low: low * factor, high: high * factor, own };
                view.upright().by_quadrature::<MAX_TERMS, false>(&RULES, &[]).value
            };
            let (ahead, behind) = (at(DIFFERENCE_STEP, 1.0), at(-DIFFERENCE_STEP, 1.0));
            let (more, less) = (at(0.0, DIFFERENCE_STEP.exp()), at(0.0, (-DIFFERENCE_STEP).exp()));
            for k in 0..MAX_TERMS {
                let pressure: [f64; MAX_TERMS] =
                    std::array::from_fn(|i| f64::from(u8::from(i == k)));
                let view = View { x, low, high, own };
                let found = view.upright().by_quadrature::<MAX_TERMS, true>(&RULES, &pressure);
                let by_e = (more[k] - less[k]) / (2.0 * DIFFERENCE_STEP);
                assert!((found.by_e - by_e).abs() < 2e-5, "{k}: {} {by_e}", found.by_e);
                let by_x = (ahead[k] - behind[k]) / (2.0 * DIFFERENCE_STEP);
                assert!(own || (found.by_x - by_x).abs() < 1e-4, "{k}: {by_x}");
            }
        }
    }
}
