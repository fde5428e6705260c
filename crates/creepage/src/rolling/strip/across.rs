//! Quadrature across the strips.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use crate::rolling::dual::Real;

/// Gauss-Legendre quadrature over `t = y/b` with `tan(theta/2)`, `t = sin(theta)`, as variable: in
/// it both `t` and `s = sqrt(1 - t^2)` are rational, with no pole nearer than 1.
#[derive(Debug, Clone)]
pub(crate) struct Across {
    /// For pieces of length up to 1/4, 1/2, 1, and longer; the error for polynomials of `t` and
    /// `s` is about 1e-14.
    rules: [Vec<[f64; 2]>; 4],
}

impl Across {
    pub(crate) fn new() -> Self {
        Self { rules: [6, 9, 14, 26].map(rule) }
    }

    /// Integral of `strip([t, s])` over `t`, between two values of the variable.
    #[inline]
    pub(crate) fn integrate<R: Real>(
        &self,
        [from, to]: [R; 2],
        strip: impl Fn([R; 2]) -> [R; 3],
    ) -> [R; 3] {
        let mut sum = [R::constant(0.0); 3];
        let (middle, half) = ((from + to) * 0.5, (to - from) * 0.5);
        let length = 2.0 * half.value();
        let finer = [0.25, 0.5, 1.0].map(|limit| usize::from(length > limit));
        let rule = &self.rules[finer.iter().sum::<usize>()];
        for &[node, weight] in rule {
            let tangent = middle + half * node;
            let square = tangent * tangent;
            let inverse = R::constant(1.0) / (square + 1.0);
            let s = (-square + 1.0) * inverse;
            let part = strip([tangent * inverse * 2.0, s]);
            // dt = s dtheta = 2 s dtangent / (1 + tangent^2)
            let weight = half * s * inverse * (2.0 * weight);
            for i in 0..3 {
                sum[i] = sum[i] + part[i] * weight;
            }
        }
        sum
    }
}

/// The variable that belongs to `t`, `-1 <= t <= 1`.
pub(crate) fn half_tangent<R: Real>(t: R) -> R {
    let square = -(t * t) + 1.0;
    let s = if square.value() > 0.0 { square.sqrt() } else { R::constant(0.0) };
    t / (s + 1.0)
}

fn rule(points: usize) -> Vec<[f64; 2]> {
    let rule = GaussLegendre::new(NonZeroUsize::MIN.saturating_add(points - 1));
    rule.iter().map(|&(node, weight)| [node, weight]).collect()
}
