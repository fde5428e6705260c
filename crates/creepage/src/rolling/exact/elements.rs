//! Elements that fit the ellipse: strips of equal width along the rolling direction, each cut
//! along its own length, the cuts clustered as cosines towards the leading and trailing edges.
//!
//! Narrower strips towards the sides would help small creepage a little, and cost accuracy in the
//! middle, where the pole of the spin turns the slip around.
//!
//! Element `(strip, i)` is counted strip by strip, `i` from the leading edge.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::ellipse::Ellipse;

/// The elements of one contact. Lengths in units of `c`.
#[derive(Debug, Clone)]
pub(super) struct Elements {
    /// Elements along a strip.
    pub along: usize,
    /// Strips.
    pub strips: usize,
    /// Cuts of a strip over its half-length, from 1 at the leading edge to -1.
    cuts: Vec<f64>,
    /// Cuts between strips over `b`, from -1 to 1.
    borders: Vec<f64>,
    /// Half-length of each strip: the mean over its width.
    half_lengths: Vec<f64>,
    b: f64,
    /// Share of the normal force that each element carries.
    pub shares: Vec<f64>,
    /// Centroid of the normal pressure in each element.
    pub centroids: Vec<[f64; 2]>,
    /// Mean over each element of the bound over its largest value, `mu Z / (mu Z)_max`.
    pub bounds: Vec<f64>,
}

impl Elements {
    pub(super) fn new(ellipse: Ellipse, along: usize, strips: usize) -> Self {
        let cuts: Vec<f64> = (0..=along).map(|i| cosine_cut(i, along)).collect();
        let borders: Vec<f64> =
            (0..=strips).map(|j| 2.0 * j as f64 / strips as f64 - 1.0).collect();
        let half_lengths = borders
            .windows(2)
            .map(|y| ellipse.a() * difference(disc, y[1], y[0]) / (y[1] - y[0]))
            .collect();
        let mut elements = Self {
            along,
            strips,
            cuts,
            borders,
            half_lengths,
            b: ellipse.b(),
            shares: Vec::with_capacity(along * strips),
            centroids: Vec::with_capacity(along * strips),
            bounds: Vec::with_capacity(along * strips),
        };
        for strip in 0..strips {
            for i in 0..along {
                elements.add_moments(ellipse, strip, i);
            }
        }
        elements
    }

    /// Integrals of the pressure over an element; they separate in `y` and `x / length(y)`.
    fn add_moments(&mut self, ellipse: Ellipse, strip: usize, i: usize) {
        let [low, high] = [self.borders[strip], self.borders[strip + 1]];
        let [rear, front] = [self.cuts[i + 1], self.cuts[i]];
        let across = difference(paraboloid, high, low);
        let along = difference(disc, front, rear);
        let area = difference(disc, high, low) * (front - rear);
        self.shares.push(1.5 / PI * across * along);
        self.bounds.push(across * along / area);
        self.centroids.push([
            ellipse.a() * difference(disc_cubed, high, low) / across
                * difference(disc_moment, front, rear)
                / along,
            ellipse.b() * difference(paraboloid_moment, high, low) / across,
        ]);
    }

    pub(super) fn len(&self) -> usize {
        self.along * self.strips
    }

    /// Where `x` is cut in a strip, from the leading edge.
    pub(super) fn cut(&self, strip: usize, i: usize) -> f64 {
        self.half_lengths[strip] * self.cuts[i]
    }

    /// Lower edge of a strip, or with `strip = strips` the upper edge of the last.
    pub(super) fn border(&self, strip: usize) -> f64 {
        self.b * self.borders[strip]
    }

    pub(super) fn middle(&self, strip: usize) -> f64 {
        0.5 * (self.border(strip) + self.border(strip + 1))
    }

    /// The four elements around a position inside the contact, with the weights of bilinear
    /// interpolation between their middles; at the edge of the contact the outermost counts on.
    // Counts of elements, small and positive.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(super) fn around(&self, ellipse: Ellipse, [x, y]: [f64; 2]) -> [(usize, f64); 4] {
        let across = y / ellipse.b();
        let length = ellipse.a() * root(across);
        let angle = (x / length.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0).asin();
        let beside = |place: f64, count: usize| {
            let place = (place * count as f64 - 0.5).clamp(0.0, (count - 1) as f64);
            let below = (place.floor() as usize).min(count - 1);
            [(below, 1.0 - place.fract()), ((below + 1).min(count - 1), place.fract())]
        };
        let strips = beside(0.5 * (across + 1.0), self.strips);
        let elements = beside(0.5 * (1.0 - angle / FRAC_PI_2), self.along);
        [0, 1, 2, 3].map(|k: usize| {
            let ((strip, by_strip), (i, by_element)) = (strips[k / 2], elements[k % 2]);
            (strip * self.along + i, by_strip * by_element)
        })
    }
}

/// Cut `i` of `n` from 1 to -1; symmetric to the last bit.
fn cosine_cut(i: usize, n: usize) -> f64 {
    (FRAC_PI_2 * (1.0 - 2.0 * i as f64 / n as f64)).sin()
}

fn difference(primitive: fn(f64) -> f64, high: f64, low: f64) -> f64 {
    primitive(high) - primitive(low)
}

/// Primitive of `sqrt(1 - t^2)`.
fn disc(t: f64) -> f64 {
    0.5 * (t * root(t) + t.asin())
}

/// Primitive of `sqrt(1 - t^2)^3`.
fn disc_cubed(t: f64) -> f64 {
    0.125 * (t * (5.0 - 2.0 * t * t) * root(t) + 3.0 * t.asin())
}

/// Primitive of `t sqrt(1 - t^2)`.
fn disc_moment(t: f64) -> f64 {
    -root(t).powi(3) / 3.0
}

/// Primitive of `1 - t^2`.
fn paraboloid(t: f64) -> f64 {
    t - t * t * t / 3.0
}

/// Primitive of `t (1 - t^2)`.
fn paraboloid_moment(t: f64) -> f64 {
    0.5 * t * t - 0.25 * t.powi(4)
}

fn root(t: f64) -> f64 {
    (1.0 - t * t).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_elements_carry_the_whole_load() {
        let elements = Elements::new(Ellipse::from_ratio(3.0).unwrap(), 12, 8);
        // Primitives differ by rounding only.
        assert!((elements.shares.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        let moment: f64 =
            elements.shares.iter().zip(&elements.centroids).map(|(w, c)| w * (c[0] + c[1])).sum();
        assert!(moment.abs() < 1e-14);
    }

    /// The middle of an element, in the angle whose sine is cut, belongs to that element alone.
    #[test]
    fn every_middle_lies_in_its_element() {
        let ellipse = Ellipse::from_ratio(0.4).unwrap();
        let elements = Elements::new(ellipse, 10, 14);
        for element in 0..elements.len() {
            let (strip, i) = (element / 10, element % 10);
            let y = elements.middle(strip);
            let length = ellipse.a() * root(y / ellipse.b());
            let x = length * cosine_cut(2 * i + 1, 20);
            let around = elements.around(ellipse, [x, y]);
            let own = around.iter().filter(|(e, _)| *e == element).map(|(_, weight)| weight);
            // Rounding of the arc sine, over an angle of a twentieth.
            assert!((own.sum::<f64>() - 1.0).abs() < 1e-12, "{element}: {around:?}");
        }
    }
}
