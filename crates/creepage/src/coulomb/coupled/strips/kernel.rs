//! Displacement by a strip whose pressure vanishes as a root at both ends.
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

use std::f64::consts::{FRAC_PI_2, LN_2, PI};
use std::sync::LazyLock;

use gauss_quad::GaussLegendre;

/// Most polynomials in a strip's pressure.
pub(in crate::coulomb::coupled) const MOST: usize = 8;
/// So many are quicker.
const FEW: usize = 4;

/// The integrals and their derivatives for one strip and one point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Integrals {
    /// `I_k`.
    pub(super) value: [f64; MOST],
    /// By `X`; zero on the strip itself, whose points move with it.
    pub(super) by_x: [f64; MOST],
    /// By the logarithm of a common factor of both `e`.
    pub(super) by_e: [f64; MOST],
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

impl View {
    /// Seen from the side on which both are as far up as possible: the integrals are the same.
    fn upright(self) -> Self {
        if self.low.abs() > self.high.abs() {
            Self { low: -self.high, high: -self.low, ..self }
        } else {
            self
        }
    }

    /// The integrals of the first `terms` polynomials.
    pub(super) fn integrals(self, terms: usize) -> Integrals {
        if terms <= FEW { self.sums::<FEW>() } else { self.sums::<MOST>() }
    }

    fn sums<const N: usize>(self) -> Integrals {
        let view = self.upright();
        let nearest = if view.own { view.high } else { view.low.max(0.0) };
        let (left, right) = ((view.x + 1.0).hypot(nearest), (view.x - 1.0).hypot(nearest));
        let mean = (0.5 * (left + right)).max(1.0);
        let depth = (mean + ((mean - 1.0) * (mean + 1.0)).sqrt()).ln();
        let mut sum = Integrals::default();
        if let Some(rule) = Rule::reaching(depth, N) {
            for node in &rule.nodes {
                view.add::<N>(&mut sum, node.s, &node.weights);
            }
        } else {
            let angle = (0.5 * (left - right)).clamp(-1.0, 1.0).asin();
            view.add_near::<N>(&mut sum, angle, depth.max(1e-7));
        }
        if view.own {
            for (value, log) in sum.value.iter_mut().zip(log_integrals(view.x)) {
                *value -= 2.0 * log;
            }
        }
        sum
    }

    fn add_near<const N: usize>(&self, sum: &mut Integrals, angle: f64, depth: f64) {
        let [from, to] = [-FRAC_PI_2 - angle, FRAC_PI_2 - angle].map(|side| (side / depth).asinh());
        let (middle, half) = (f64::midpoint(from, to), 0.5 * (to - from));
        let finer = usize::from(N > FEW) + usize::from(half >= 2.5) + usize::from(half > 4.5);
        let rule = &LEGENDRE[finer];
        for &(t, w) in rule {
            let v = middle + half * t;
            let grown = v.exp();
            let (sinh, cosh) = (0.5 * (grown - 1.0 / grown), 0.5 * (grown + 1.0 / grown));
            let (s, cos) = (angle + depth * sinh).sin_cos();
            let weight = w * half * depth * cosh * cos * cos;
            self.add::<N>(sum, s, &polynomials(s).map(|u| u * weight));
        }
    }

    fn add<const N: usize>(&self, sum: &mut Integrals, s: f64, weights: &[f64; MOST]) {
        let d = self.x - s;
        let high = self.high.hypot_fast(d);
        let (log, ratio, slope) = if self.own {
            (2.0 * (self.high + high).ln(), 2.0 * self.high / high, 0.0)
        } else {
            let low = self.low.hypot_fast(d);
            let ratio = self.high / high - self.low / low;
            let log = if self.low >= 0.0 {
                ((self.high + high) / (self.low + low)).ln()
            } else {
                ((self.high + high) * (low - self.low) / (d * d)).ln()
            };
            (log, ratio, if d == 0.0 { 0.0 } else { -ratio / d })
        };
        for (k, weight) in weights.iter().enumerate().take(N) {
            sum.value[k] += weight * log;
            sum.by_x[k] += weight * slope;
            sum.by_e[k] += weight * ratio;
        }
    }
}

/// The root of a sum of squares where neither over- nor underflows.
trait Hypot {
    fn hypot_fast(self, other: Self) -> Self;
}

impl Hypot for f64 {
    fn hypot_fast(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }
}

fn polynomials(s: f64) -> [f64; MOST] {
    let mut values = [0.0; MOST];
    [values[0], values[1]] = [1.0, 2.0 * s];
    for k in 2..MOST {
        values[k] = 2.0 * s * values[k - 1] - values[k - 2];
    }
    values
}

/// `U_k(s)`, weighted by coefficients.
pub(in crate::coulomb::coupled) fn profile(coefficients: &[f64], s: f64) -> f64 {
    polynomials(s).iter().zip(coefficients).map(|(u, c)| u * c).sum()
}

/// `int sqrt(1 - s^2) U_k(s) ln|x - s| ds` inside the interval: its derivative is `pi T_(k+1)`.
fn log_integrals(x: f64) -> [f64; MOST] {
    let mut t = [0.0; MOST + 2];
    [t[0], t[1]] = [1.0, x];
    for k in 2..t.len() {
        t[k] = 2.0 * x * t[k - 1] - t[k - 2];
    }
    let mut logs = [0.0; MOST];
    logs[0] = PI * (0.25 * t[2] - 0.5 * LN_2);
    for k in 1..MOST {
        logs[k] = FRAC_PI_2 * (t[k + 2] / (k + 2) as f64 - t[k] / k as f64);
    }
    logs
}

#[derive(Debug, Clone)]
struct Node {
    s: f64,
    weights: [f64; MOST],
}

/// Gauss-Chebyshev points of the second kind.
#[derive(Debug, Clone)]
struct Rule {
    nodes: Vec<Node>,
}

static RULES: LazyLock<Vec<Rule>> = LazyLock::new(|| [4, 6, 8, 12, 16, 24].map(Rule::new).into());

impl Rule {
    fn new(count: usize) -> Self {
        let nodes = (1..=count).map(|k| {
            let angle = PI * k as f64 / (count + 1) as f64;
            let (sin, s) = angle.sin_cos();
            let weight = PI / (count + 1) as f64 * sin * sin;
            Node { s, weights: polynomials(s).map(|u| u * weight) }
        });
        Self { nodes: nodes.collect() }
    }

    /// The first that bears a singularity at some depth. The error falls as `exp(-2 count depth)`, and a
    /// polynomial of higher degree takes as many points as it has waves.
    fn reaching(depth: f64, terms: usize) -> Option<&'static Self> {
        const DIGITS: f64 = 15.0;
        let lost = if terms > FEW { terms } else { 0 };
        let bears =
            |rule: &&Self| depth * (2 * rule.nodes.len()).saturating_sub(lost) as f64 >= DIGITS;
        RULES.iter().find(bears)
    }
}

/// Gauss-Legendre points and weights on (-1, 1).
static LEGENDRE: LazyLock<[Vec<(f64, f64)>; 4]> = LazyLock::new(|| [16, 24, 36, 48].map(legendre));

fn legendre(count: usize) -> Vec<(f64, f64)> {
    std::num::NonZeroUsize::new(count)
        .map(|count| GaussLegendre::new(count).as_node_weight_pairs().to_vec())
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By brute force: midpoints in the angle, whose clustering eases the ends; the logarithm
    /// stays, so many are needed.
    fn brute(view: View, k: usize) -> f64 {
        const POINTS: u32 = 2_000_000;
        let step = PI / f64::from(POINTS);
        (0..POINTS)
            .map(|i| {
                let (s, cos) = (-FRAC_PI_2 + (f64::from(i) + 0.5) * step).sin_cos();
                let d = (view.x - s).abs();
                let kernel = (view.high / d).asinh() - (view.low / d).asinh();
                step * cos * cos * polynomials(s)[k] * kernel
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
            let found = view.integrals(MOST);
            for k in 0..MOST {
                let expected = brute(view, k);
                let difference = (found.value[k] - expected).abs();
                // Half a step of the brute sum is lost at the logarithm.
                assert!(difference < 2e-6, "{view:?} {k}: {difference}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values() {
        const STEP: f64 = 1e-5;
        for (x, low, high, own) in
            [(0.7, 0.02, 0.09, false), (1.4, -0.3, 0.2, false), (0.3, -0.05, 0.05, true)]
        {
            let at = |dx: f64, factor: f64| {
                View { x: x + dx, low: low * factor, high: high * factor, own }
                    .integrals(MOST)
                    .value
            };
            let found = View { x, low, high, own }.integrals(MOST);
            let (ahead, behind) = (at(STEP, 1.0), at(-STEP, 1.0));
            let (more, less) = (at(0.0, STEP.exp()), at(0.0, (-STEP).exp()));
            for k in 0..MOST {
                let by_e = (more[k] - less[k]) / (2.0 * STEP);
                assert!((found.by_e[k] - by_e).abs() < 2e-5, "{k}: {} {by_e}", found.by_e[k]);
                let by_x = (ahead[k] - behind[k]) / (2.0 * STEP);
                assert!(own || (found.by_x[k] - by_x).abs() < 1e-4, "{k}: {by_x}");
            }
        }
    }
}
