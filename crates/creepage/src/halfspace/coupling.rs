//! Half chords: what unlike bodies need, where the two sides of a point pull against each
//! other (2.2, 6.2).

use std::f64::consts::{FRAC_PI_2, PI};

use super::harmonics;

/// The difference of the integrals over both parts of a chord, for polynomials of one degree.
///
/// On the chord `cos alpha`, `0 < alpha < pi`, is the distance from its middle over half its
/// length, and the weight `(1 - r^2)^(-1/2)` leaves `d alpha`. The polynomial is a cosine sum
/// in `alpha`, known from as many values, which integrates term by term.
#[derive(Debug, Clone)]
pub(super) struct HalfChords {
    /// `cos alpha_j` of the values' places.
    places: Vec<f64>,
}

impl HalfChords {
    pub(super) fn new(degree: usize) -> Self {
        let count = degree + 1;
        let place = |j: usize| (PI * (j as f64 + 0.5) / count as f64).cos();
        Self { places: (0..count).map(place).collect() }
    }

    /// The integral over the part of the chord ahead of `point` in `direction`, less that over
    /// the part behind, over pi; `point` inside the unit disc.
    pub(super) fn difference<const N: usize>(
        &self,
        tables: [&[f64]; N],
        [x, y]: [f64; 2],
        direction: [f64; 2],
    ) -> [f64; N] {
        let ahead = x * direction[0] + y * direction[1];
        let off = x * direction[1] - y * direction[0];
        let half = ((1.0 - off) * (1.0 + off)).max(0.0).sqrt();
        let rest = ((1.0 - x.hypot(y)) * (1.0 + x.hypot(y))).max(0.0).sqrt();
        let split = rest.atan2(ahead);
        let mut difference = [0.0; N];
        for &place in &self.places {
            let step = half * place - ahead;
            let at = [x + step * direction[0], y + step * direction[1]];
            let weight = self.weight(place, split);
            let values = harmonics::sum(self.places.len() - 1, at, tables);
            difference.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
        }
        difference
    }

    /// Share of the value at `place` in the difference: `2 alpha - pi` from the constant,
    /// `2 sin(k alpha)/k` from `cos(k alpha)`, at the point's own `alpha`.
    fn weight(&self, place: f64, split: f64) -> f64 {
        let count = self.places.len();
        let (sin, cos) = split.sin_cos();
        let (mut wave, mut cosine) = ([0.0, sin], [1.0, place]);
        let mut sum = split - FRAC_PI_2;
        for k in 1..count {
            sum += 2.0 * cosine[1] * wave[1] / k as f64;
            wave = [wave[1], 2.0 * cos * wave[1] - wave[0]];
            cosine = [cosine[1], 2.0 * place * cosine[1] - cosine[0]];
        }
        2.0 * sum / (PI * count as f64)
    }
}
