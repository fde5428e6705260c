//! Chebyshev series of a function along a strip.

use std::f64::consts::PI;

/// Chebyshev nodes, and as many terms of the series.
const TERMS: usize = 20;
/// How far it is known, in half-lengths: the ends of a strip move.
const REACH: f64 = 1.1;

/// A sum of Chebyshev's polynomials; beyond its reach it stays as it is there.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ChebyshevSeries {
    centre: f64,
    reach: f64,
    coefficients: [f64; TERMS],
}

impl ChebyshevSeries {
    pub(super) fn new([centre, half]: [f64; 2], function: impl Fn(f64) -> f64) -> Self {
        let reach = REACH * half;
        let angle = |i: usize| PI * (i as f64 + 0.5) / TERMS as f64;
        let values: [f64; TERMS] =
            std::array::from_fn(|i| function(centre + reach * angle(i).cos()));
        let coefficients = std::array::from_fn(|k| {
            let terms = values.iter().enumerate().map(|(i, v)| v * (k as f64 * angle(i)).cos());
            terms.sum::<f64>() * if k == 0 { 1.0 } else { 2.0 } / TERMS as f64
        });
        Self { centre, reach, coefficients }
    }

    /// Zero unless made by [`ChebyshevSeries::new`].
    pub(super) fn at(&self, x: f64) -> f64 {
        if self.reach == 0.0 {
            return 0.0;
        }
        let s = ((x - self.centre) / self.reach).clamp(-1.0, 1.0);
        let (mut next, mut after) = (0.0, 0.0);
        for coefficient in self.coefficients.iter().skip(1).rev() {
            (next, after) = (coefficient + 2.0 * s * next - after, next);
        }
        self.coefficients[0] + s * next - after
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_met() {
        let cubic = |x: f64| 1.0 + x - 2.0 * x * x + 0.5 * x * x * x;
        let along = ChebyshevSeries::new([0.3, 0.8], cubic);
        for x in [-0.5, -0.1, 0.3, 1.0, 1.1] {
            // Rounding of a dozen terms.
            assert!((along.at(x) - cubic(x)).abs() < 1e-13, "{x}");
        }
    }
}
