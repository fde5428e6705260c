//! Sliding strips: without adhesion the traction is at its bound, along the slip of the rigid bodies.

use std::f64::consts::PI;

use crate::approximate::dual::Real;

/// Averages over a strip's length, weighted with the pressure, by Gauss-Chebyshev quadrature.
#[derive(Debug, Clone)]
pub(crate) struct Sliding {
    rules: Vec<Rule>,
}

/// A quadrature rule `(node, weight)`, and from where on it is good enough.
#[derive(Debug, Clone)]
struct Rule {
    /// `1/A^2`, `1/B^2`: the rule is good to [`ACCURACY`] when the spin pole lies outside the
    /// ellipse with these semi-axes and the foci -1 and 1.
    inverse_squares: [f64; 2],
    points: Vec<Points>,
}

/// Nodes that are taken together.
const LANES: usize = 4;

/// Nodes and weights of a rule, filled up with weights of zero.
#[derive(Debug, Clone, Default)]
struct Points {
    nodes: [f64; LANES],
    weights: [f64; LANES],
}

/// Aimed relative error of the averages. With the pole in a sliding strip no rule reaches it for
/// the nearest strips; the contact's force is good to 1e-5 then.
const ACCURACY: f64 = 1e-10;

impl Sliding {
    pub(crate) fn new() -> Self {
        Self { rules: [2, 4, 8, 12, 16, 24, 32, 64, 256].map(Rule::new).to_vec() }
    }

    /// Force and moment of the strip at `t = y/b` of half-length `a s`, scaled as those of
    /// [`Strip::force`](super::numbers::Strip::force).
    ///
    /// `creepage` is `xi, eta, chi`, or any positive multiple of it.
    pub(crate) fn force<R: Real>(
        &self,
        creepage: [R; 3],
        [t, s]: [R; 2],
        [a, b]: [f64; 2],
    ) -> [R; 3] {
        let [xi, eta, chi] = creepage;
        let (y, half_length) = (t * b, s * a);
        let slip_x = xi - chi * y;
        let reach = chi * half_length;
        let rule = self.rule(slip_x.value(), eta.value(), reach.value());
        // Moments of weight over slip, four nodes at a time.
        let mut sums = [[R::constant(0.0); LANES]; 3];
        let across = slip_x * slip_x;
        for Points { nodes, weights } in &rule.points {
            for l in 0..LANES {
                let along = eta + reach * nodes[l];
                let mut part = inverse_root(across + along * along) * weights[l];
                for sum in &mut sums {
                    sum[l] = sum[l] + part;
                    part = part * nodes[l];
                }
            }
        }
        let [zeroth, first, second] = sums.map(|[p, q, r, s]| (p + q) + (r + s));
        let bound = s * s;
        let [fx, fy] = [slip_x * zeroth * bound, (eta * zeroth + reach * first) * bound];
        [fx, fy, (eta * first + reach * second) * bound * half_length - y * fx]
    }

    /// The direction is analytic along the strip but for the spin pole, where the slip
    /// `(slip_x, slip_y + reach u)` is zero, at `u = (-slip_y +- i slip_x) / reach`.
    fn rule(&self, slip_x: f64, slip_y: f64, reach: f64) -> &Rule {
        let squares = [slip_y * slip_y, slip_x * slip_x, reach * reach];
        let good = |rule: &&Rule| {
            let [along, across] = rule.inverse_squares;
            along * squares[0] + across * squares[1] >= squares[2]
        };
        self.rules.iter().find(good).unwrap_or(&self.rules[self.rules.len() - 1])
    }
}

impl Rule {
    /// Gauss-Chebyshev rule of the second kind with `n` points, for the weight `sqrt(1 - u^2)`
    /// normalised to one. Its error falls like `r^-2n`, for the moment and its derivative like
    /// `r^(2-2n)`, where the pole lies on the ellipse with foci -1 and 1 and semi-axes
    /// `(r + 1/r)/2`, `(r - 1/r)/2`.
    fn new(n: usize) -> Self {
        let r = ACCURACY.powf(-1.0 / (2 * n - 2) as f64);
        let mut points = vec![Points::default(); n.div_ceil(LANES)];
        for k in 0..n {
            let (sin, cos) = (PI * (k + 1) as f64 / (n + 1) as f64).sin_cos();
            let Points { nodes, weights } = &mut points[k / LANES];
            nodes[k % LANES] = cos;
            weights[k % LANES] = 2.0 * sin * sin / (n + 1) as f64;
        }
        let inverse_squares = [r + r.recip(), r - r.recip()].map(|axis| 4.0 / (axis * axis));
        Self { inverse_squares, points }
    }
}

/// The vector's direction; zero for the zero vector.
pub(crate) fn unit<R: Real>([x, y]: [R; 2]) -> [R; 2] {
    let inverse = inverse_root(x * x + y * y);
    [x * inverse, y * inverse]
}

/// `1 / sqrt(square)`; zero for zero.
#[inline]
fn inverse_root<R: Real>(square: R) -> R {
    let inverse = R::constant(1.0) / square.sqrt();
    if square.value() > 0.0 { inverse } else { R::constant(0.0) }
}
