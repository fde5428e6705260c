//! Plane waves of a traction: its part that varies in one direction of the surface only.
//!
//! A traction on the ellipse is a superposition over the directions of the surface: in each, it is
//! the sum over the lines across (Radon's transform), and the half-space answers with a field of
//! one complex variable (Whittaker's integral)
//!
//! ```math
//! \frac1r = \frac{1}{2\pi} \int_0^{2\pi} \frac{d\theta}{z + i (x \cos\theta + y \sin\theta)} .
//! ```
//!
//! Over a line at distance `h` from the centre, the ellipse taken for the unit disc, the sum of
//! the harmonic `Y_nm` times `(1 - r^2)^(-1/2)` is `pi P_n(h) Y_nm` with the latter on the edge, so
//! that a direction's potential is a series of Legendre functions of the second kind of one complex
//! number, [`Wave::variable`] plus one.

use nalgebra::Complex;

use super::legendre;
use crate::ellipse::Ellipse;
use crate::halfspace::{Edge, Traction, harmonics};

/// `X`, `Y`, `Z`, in the order of the components.
type Triple = [f64; 3];
/// The same, complex.
pub(super) type ComplexTriple = [Complex<f64>; 3];

/// What all directions of one traction have in common.
#[derive(Debug, Clone)]
pub(super) struct Source {
    pub ellipse: Ellipse,
    degree: usize,
    vanishing: bool,
    /// Coefficients of the even harmonics, with the unit and the sign of the body.
    tables: [Vec<f64>; 3],
}

/// One direction: its normal, and the sums over lines as Legendre series, with their derivatives.
#[derive(Debug, Clone)]
pub(super) struct Wave {
    /// Unit normal of the lines on the disc.
    pub circle: [f64; 2],
    /// Unit normal of the lines on the ellipse.
    pub normal: [f64; 2],
    /// Half the width of the ellipse along the normal.
    pub half_width: f64,
    value: Vec<Triple>,
    slope: Vec<Triple>,
    bend: Vec<Triple>,
    /// Values of the series at `h = 1` and at `h = -1`, then of their derivative.
    ends: [[Triple; 2]; 2],
}

/// The sum over `n` of a series times `Q_n`, and its first and second derivative by `zeta`.
pub(super) struct Potentials {
    pub value: ComplexTriple,
    pub slope: ComplexTriple,
    pub bend: ComplexTriple,
}

impl Source {
    /// `factors` are the unit of each component, with the sign of the body.
    pub(super) fn new(traction: &Traction, factors: Triple) -> Self {
        let tables = traction.singular();
        let scaled = |k: usize| tables[k].iter().map(|value| factors[k] * value).collect();
        Self {
            ellipse: traction.ellipse(),
            degree: traction.singular_degree(),
            vanishing: traction.edge() == Edge::Vanishing,
            tables: [scaled(0), scaled(1), scaled(2)],
        }
    }

    /// Largest coefficient: the size of the traction.
    pub(super) fn size(&self) -> f64 {
        self.tables.iter().flatten().fold(0.0_f64, |size, value| size.max(value.abs()))
    }

    /// Whether the traction grows beyond bounds at the edge.
    pub(super) fn is_singular(&self) -> bool {
        !self.vanishing
    }

    /// Degree of the polynomials.
    pub(super) fn degree(&self) -> usize {
        self.degree
    }

    /// Of tractions in proportion to Hertz's pressure: factors of `1 - h^2`, which is two thirds of
    /// `P_0 - P_2`, in the sums over lines of any direction.
    pub(super) fn parabola(&self) -> Triple {
        self.series([1.0, 0.0]).first().map_or([0.0; 3], |terms| terms.map(|term| 1.5 * term))
    }

    /// `[X, Y, Z]` times `(1 - r^2)^(1/2)` at a place of the disc.
    pub(super) fn polynomials(&self, place: [f64; 2]) -> Triple {
        harmonics::sum(self.degree, place, self.tables.each_ref().map(Vec::as_slice))
    }

    /// How many `Q_n` a direction needs.
    pub(super) fn terms(&self) -> usize {
        self.degree + 1
    }

    /// The direction whose normal on the disc is at `angle` from the `x` axis.
    pub(super) fn wave(&self, angle: f64) -> Wave {
        let (sin, cos) = angle.sin_cos();
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        let half_width = a * b / (b * cos).hypot(a * sin);
        let value = self.series([cos, sin]);
        let slope = derivative(&value);
        let bend = derivative(&slope);
        let at_ends = if self.vanishing { [[0.0; 3]; 2] } else { ends(&value) };
        Wave {
            circle: [cos, sin],
            normal: [half_width * cos / a, half_width * sin / b],
            half_width,
            ends: [at_ends, ends(&slope)],
            value,
            slope,
            bend,
        }
    }

    /// The polynomials' values at the edge's point in direction `toward` of the disc; none for a
    /// traction that vanishes there.
    pub(super) fn edge_strength(&self, toward: [f64; 2]) -> [f64; 2] {
        if self.vanishing {
            return [0.0; 2];
        }
        let [x, y, _] = self.tables.each_ref().map(Vec::as_slice);
        harmonics::sum(self.degree, toward, [x, y])
    }

    /// The sums over the lines across one direction as a Legendre series.
    fn series(&self, [cos, sin]: [f64; 2]) -> Vec<Triple> {
        let mut harmonic = vec![0.0; harmonics::count(self.degree)];
        harmonics::evaluate(self.degree, cos, sin, &mut harmonic);
        let term = |n: usize, table: &Vec<f64>| -> f64 {
            harmonics::even_orders(n)
                .map(|m| table[harmonics::position(n, m)] * harmonic[harmonics::index(n, m)])
                .sum()
        };
        (0..=self.degree).map(|n| self.tables.each_ref().map(|table| term(n, table))).collect()
    }
}

impl Wave {
    /// The complex variable of a point, less one: `toward_end` is its distance from the line that
    /// touches the disc, `h - 1`.
    pub(super) fn variable(&self, toward_end: f64, depth: f64) -> Complex<f64> {
        Complex::new(toward_end, -depth / self.half_width)
    }

    /// The distance from the line that touches the disc, `h - 1`, of a point on the disc.
    pub(super) fn toward_end(&self, [x, y]: [f64; 2]) -> f64 {
        self.circle[0] * x + self.circle[1] * y - 1.0
    }

    /// `q` is room for as many values as the source has terms.
    pub(super) fn potentials(&self, from_end: Complex<f64>, q: &mut [Complex<f64>]) -> Potentials {
        legendre::second_kind(from_end, q);
        // One over the distances from the ends of the cut.
        let near =
            [from_end, from_end + 2.0].map(|d| 1.0 / if d.norm() < 1e-30 { d + 1e-30 } else { d });
        let [ends, slope_ends] = &self.ends;
        let first = jump(ends, near);
        let second = jump(ends, near.map(|d| d * d));
        let third = jump(slope_ends, near);
        let (slope, bend) = (sum(&self.slope, q), sum(&self.bend, q));
        Potentials {
            value: sum(&self.value, q),
            slope: [0, 1, 2].map(|k| slope[k] - first[k]),
            bend: [0, 1, 2].map(|k| bend[k] + second[k] - third[k]),
        }
    }
}

/// Half of `f(1)/(zeta - 1) - f(-1)/(zeta + 1)`: what integration by parts leaves at the ends.
fn jump(ends: &[Triple; 2], near: [Complex<f64>; 2]) -> ComplexTriple {
    [0, 1, 2].map(|k| 0.5 * (near[0] * ends[0][k] - near[1] * ends[1][k]))
}

fn sum(series: &[Triple], q: &[Complex<f64>]) -> ComplexTriple {
    let mut sum = [Complex::new(0.0, 0.0); 3];
    for (terms, q) in series.iter().zip(q) {
        for (sum, term) in sum.iter_mut().zip(terms) {
            *sum += q * *term;
        }
    }
    sum
}

/// The derivative of a Legendre series: `P'_{n+1} - P'_{n-1} = (2n + 1) P_n`.
fn derivative(series: &[Triple]) -> Vec<Triple> {
    let mut slope = vec![[0.0; 3]; series.len().saturating_sub(1)];
    for n in (0..slope.len()).rev() {
        for k in 0..3 {
            let above = slope.get(n + 2).map_or(0.0, |next| next[k] / (2.0 * n as f64 + 5.0));
            slope[n][k] = (2.0 * n as f64 + 1.0) * (series[n + 1][k] + above);
        }
    }
    slope
}

/// Values at `h = 1` and at `h = -1`.
fn ends(series: &[Triple]) -> [Triple; 2] {
    let mut ends = [[0.0; 3]; 2];
    for (n, terms) in series.iter().enumerate() {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        for k in 0..3 {
            ends[0][k] += terms[k];
            ends[1][k] += sign * terms[k];
        }
    }
    ends
}
