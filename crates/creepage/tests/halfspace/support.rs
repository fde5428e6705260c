//! What the tests of the half-space share.

use creepage::Ellipse;
use creepage::halfspace::Polynomial;

/// Evenly distributed numbers between -1 and 1.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A polynomial whose terms are all of order one on the ellipse.
    pub(crate) fn polynomial(&mut self, ellipse: Ellipse, degree: usize) -> Polynomial {
        let mut coefficients = Polynomial::zero(degree).coefficients().to_vec();
        for p in 0..=degree {
            for q in 0..=degree - p {
                let unit = ellipse.a().powi(p as i32) * ellipse.b().powi(q as i32);
                coefficients[Polynomial::index(p, q)] = self.next() / unit;
            }
        }
        Polynomial::new(coefficients).unwrap()
    }

    pub(crate) fn polynomials(&mut self, ellipse: Ellipse, degree: usize) -> [Polynomial; 3] {
        [0; 3].map(|_| self.polynomial(ellipse, degree))
    }
}

/// The largest size among numbers.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}
