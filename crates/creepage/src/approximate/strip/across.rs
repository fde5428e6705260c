//! Gauss-Legendre quadrature across the strips.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use crate::approximate::dual::Real;

/// Gauss-Legendre quadrature over `t = y/b` with `tan(theta/2)`, `t = sin(theta)`, as variable: in
/// it both `t` and `s = sqrt(1 - t^2)` are rational, with no pole nearer than 1.
#[derive(Debug, Clone)]
pub(crate) struct Across {
    /// Rules of [`Across::FEWEST`] points and more, one more each.
    rules: [Vec<[f64; 2]>; 20],
}

impl Across {
    const FEWEST: usize = 5;

    pub(crate) fn new() -> Self {
        Self { rules: std::array::from_fn(|more| rule(Self::FEWEST + more)) }
    }

    /// The rule for a piece of that length, at most 2. `6 + 9 length` points leave an error of
    /// 1e-12 for polynomials of third degree of `t` and `s`, two fewer one of 2e-10.
    // A small positive number.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn rule(&self, length: f64, fewer: usize) -> &[[f64; 2]] {
        let more = ((6.0 + 9.0 * length) as usize).saturating_sub(fewer + Self::FEWEST);
        &self.rules[more.min(self.rules.len() - 1)]
    }

    /// Integral of `strip([t, s])` over `t`, between two values of the variable, with up to two
    /// points `fewer` than for full accuracy.
    #[inline]
    pub(crate) fn integrate<R: Real>(
        &self,
        [from, to]: [R; 2],
        fewer: usize,
        strip: impl Fn([R; 2]) -> [R; 3],
    ) -> [R; 3] {
        let mut sum = [R::constant(0.0); 3];
        let (middle, half) = ((from + to) * 0.5, (to - from) * 0.5);
        for &[node, weight] in self.rule(2.0 * half.value(), fewer) {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Integrals of `s`, `s t^2`, `s^2 t` from 0 to `sin(angle)`.
    fn closed_forms(variable: f64) -> [f64; 3] {
        let angle = 2.0 * variable.atan();
        let s2 = angle.cos().powi(2);
        [
            0.5 * angle + 0.25 * (2.0 * angle).sin(),
            0.125 * angle - 0.03125 * (4.0 * angle).sin(),
            -0.25 * s2 * s2,
        ]
    }

    #[test]
    fn the_rules_are_as_good_as_stated() {
        let across = Across::new();
        for (fewer, tolerance) in [(0, 1e-12), (2, 2e-10)] {
            for k in 0..=200 {
                let length = f64::from(k) / 100.0;
                for from in [-1.0, -0.3 * length, 1.0 - length] {
                    let piece = [from, from + length];
                    let found = across.integrate(piece, fewer, |[t, s]| [s, s * t * t, s * s * t]);
                    let [low, high] = piece.map(closed_forms);
                    for i in 0..3 {
                        let error = found[i] - (high[i] - low[i]);
                        assert!(error.abs() < tolerance, "{piece:?} {fewer} {i}: {error}");
                    }
                }
            }
        }
    }
}
