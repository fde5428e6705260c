//! Parametric cubic, the piece of a spline; and the small rules that curves share.

use super::{CurvePoint, Piece};

/// A parametric cubic over `t` from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cubic {
    /// Coefficients of rising powers of `t`, of `y` and of `z`.
    y: [f64; 4],
    z: [f64; 4],
    length: f64,
    /// `dt/ds` times the length, at both ends.
    rates: [f64; 2],
}

impl Cubic {
    /// The cubic with the given coefficients of rising powers of `t` (m), `t` from 0 to 1.
    #[must_use]
    pub fn from_coefficients(y: [f64; 4], z: [f64; 4]) -> Piece {
        let mut cubic = Self { y, z, length: 0.0, rates: [1.0; 2] };
        cubic.length = gauss(|t| cubic.speed(t));
        cubic.rates = [0.0, 1.0].map(|t| cubic.length / cubic.speed(t));
        Piece::Cubic(cubic)
    }

    pub(super) fn length(&self) -> f64 {
        self.length
    }

    fn speed(&self, t: f64) -> f64 {
        derivatives(&self.y, t)[1].hypot(derivatives(&self.z, t)[1])
    }

    pub(super) fn at(&self, s: f64) -> CurvePoint {
        let t = hermite(s / self.length, [0.0, 1.0], self.rates).clamp(0.0, 1.0);
        let [y, y1, y2] = derivatives(&self.y, t);
        let [z, z1, z2] = derivatives(&self.z, t);
        let speed = y1.hypot(z1);
        CurvePoint {
            y,
            z,
            tangent: [y1 / speed, z1 / speed],
            curvature: (y1 * z2 - z1 * y2) / speed.powi(3),
        }
    }
}

fn derivatives(&[a, b, c, d]: &[f64; 4], t: f64) -> [f64; 3] {
    [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + t * 3.0 * d), 2.0 * c + 6.0 * t * d]
}

/// Gauss's rule of 5 points over 0 to 1.
pub(super) fn gauss(f: impl Fn(f64) -> f64) -> f64 {
    let rule = [
        (0.128_888_888_888_888_9, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let middle = rule[0].1 * f(0.5);
    let pairs: f64 =
        rule[1..].iter().map(|&(x, w)| w * (f(0.5 - 0.5 * x) + f(0.5 + 0.5 * x))).sum();
    0.5 * (middle + pairs)
}

/// Cubic over 0 to 1 from values and slopes at both ends.
pub(crate) fn hermite(t: f64, [a, b]: [f64; 2], [da, db]: [f64; 2]) -> f64 {
    let u = 1.0 - t;
    u * u * ((1.0 + 2.0 * t) * a + t * da) + t * t * ((1.0 + 2.0 * u) * b - u * db)
}
