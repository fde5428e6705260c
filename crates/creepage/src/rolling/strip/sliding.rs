//! Strips without adhesion: the traction is at its bound, along the slip of the rigid bodies.

use std::f64::consts::PI;

use crate::rolling::dual::Real;

/// Averages over a strip's length, weighted with the pressure, by Gauss-Chebyshev quadrature.
#[derive(Debug, Clone)]
pub(crate) struct Sliding {
    rules: Vec<Rule>,
}

/// A quadrature rule `(node, weight)`, and from where on it is good enough.
#[derive(Debug, Clone)]
struct Rule {
    /// `|z - 1| + |z + 1|` of the spin pole `z` from which the rule is good to [`ACCURACY`].
    pole_distance: f64,
    points: Vec<[f64; 2]>,
}

/// Aimed relative error of the averages; where the pole is so near that no rule reaches it, the
/// error of the finest is about `1e-4` of that strip's force.
const ACCURACY: f64 = 1e-12;

impl Sliding {
    pub(crate) fn new() -> Self {
        Self { rules: [2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 256].map(Rule::new).to_vec() }
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
        let mut average = [R::constant(0.0); 3];
        for &[node, weight] in &rule.points {
            let direction = unit([slip_x, eta + reach * node]);
            average[0] = average[0] + direction[0] * weight;
            average[1] = average[1] + direction[1] * weight;
            average[2] = average[2] + direction[1] * (weight * node);
        }
        let bound = s * s;
        let [fx, fy] = [average[0] * bound, average[1] * bound];
        [fx, fy, average[2] * bound * half_length - y * fx]
    }

    /// The direction is analytic along the strip but for the spin pole, where the slip
    /// `(slip_x, slip_y + reach u)` is zero, at `u = (-slip_y +- i slip_x) / reach`.
    fn rule(&self, slip_x: f64, slip_y: f64, reach: f64) -> &Rule {
        let [behind, ahead] = [slip_y - reach, slip_y + reach];
        let across = slip_x * slip_x;
        let sum = (across + behind * behind).sqrt() + (across + ahead * ahead).sqrt();
        let good = |rule: &&Rule| sum >= rule.pole_distance * reach.abs();
        self.rules.iter().find(good).unwrap_or(&self.rules[self.rules.len() - 1])
    }
}

impl Rule {
    /// Gauss-Chebyshev rule of the second kind with `n` points, for the weight `sqrt(1 - u^2)`
    /// normalised to one. Its error falls like `r^-2n`, for the moment and its derivative like
    /// `r^(2-2n)`, where the pole lies on the ellipse with foci -1 and 1 and semi-axes' sum `r`:
    /// `|z - 1| + |z + 1|` is `r + 1/r`.
    fn new(n: u32) -> Self {
        let r = ACCURACY.powf(-1.0 / f64::from(2 * n - 2));
        let points = (1..=n).map(|k| {
            let (sin, cos) = (PI * f64::from(k) / f64::from(n + 1)).sin_cos();
            [cos, 2.0 * sin * sin / f64::from(n + 1)]
        });
        Self { pole_distance: r + r.recip(), points: points.collect() }
    }
}

/// The vector's direction; zero for the zero vector.
pub(crate) fn unit<R: Real>([x, y]: [R; 2]) -> [R; 2] {
    let length = (x * x + y * y).sqrt();
    if length.value() == 0.0 {
        return [R::constant(0.0); 2];
    }
    let inverse = R::constant(1.0) / length;
    [x * inverse, y * inverse]
}
