//! Elements that fit the ellipse: strips along the rolling direction, each cut along its own length.
//!
//! Small creepage makes the traction infinite all along the trailing half of the edge, so the cuts
//! are clustered towards it: along as cosines; across less, for the strips in the middle, where
//! the pole of the spin turns the slip around, must not become wide. For the same reason an
//! element is a quadrilateral between the cuts of its two borders: rectangles would make the
//! trailing edge a staircase, and the error of first order in the width of a strip.
//!
//! Element `(strip, i)` is counted strip by strip, `i` from the leading edge.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

use super::load::{self, Load};
use crate::ellipse::Ellipse;

/// Largest `a/b` with elements that are fitted all the way.
const LONG: f64 = 10.0;

/// The elements of one contact. Lengths in units of `c`.
#[derive(Debug, Clone)]
pub(super) struct Elements {
    /// Elements along a strip.
    pub along: usize,
    /// Strips.
    pub strips: usize,
    /// Cuts of a strip over its half-length, from 1 at the leading edge to -1.
    cuts: Vec<f64>,
    /// Borders between strips over `b`, from -1 to 1.
    borders: Vec<f64>,
    /// Half-lengths of each strip at its lower and its upper border.
    half_lengths: Vec<[f64; 2]>,
    a: f64,
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
        let fit = fit(ellipse.ratio());
        let cuts = (0..=along).map(|i| cut(i as f64, along)).collect();
        let borders: Vec<f64> = (0..=strips).map(|j| border(j as f64, strips, fit)).collect();
        let ends = |y: &[f64]| half_lengths(ellipse, y[0], y[1]);
        let half_lengths = borders.windows(2).map(ends).collect();
        let mut elements = Self {
            along,
            strips,
            cuts,
            borders,
            half_lengths,
            a: ellipse.a(),
            b: ellipse.b(),
            shares: Vec::with_capacity(along * strips),
            centroids: Vec::with_capacity(along * strips),
            bounds: Vec::with_capacity(along * strips),
        };
        for strip in 0..strips {
            let across = load::across(elements.borders[strip], elements.borders[strip + 1]);
            for i in 0..along {
                let along = load::along(elements.cuts[i + 1], elements.cuts[i]);
                elements.shares.push(across.share * along.share);
                elements.bounds.push(across.bound * along.bound);
                elements.centroids.push(elements.centroid(across, along));
            }
        }
        elements
    }

    /// Where the pressure on a piece of a strip acts.
    pub(super) fn centroid(&self, across: Load, along: Load) -> [f64; 2] {
        [self.a * across.length * along.centroid, self.b * across.centroid]
    }

    /// The elements of a strip, from the leading edge.
    pub(super) fn of_strip(&self, strip: usize) -> Range<usize> {
        strip * self.along..(strip + 1) * self.along
    }

    pub(super) fn len(&self) -> usize {
        self.along * self.strips
    }

    /// Ends of a strip's cut `i` from the leading edge, on its lower and its upper border.
    pub(super) fn cut_ends(&self, strip: usize, i: usize) -> [[f64; 2]; 2] {
        [0, 1].map(|end| {
            [self.half_lengths[strip][end] * self.cuts[i], self.b * self.borders[strip + end]]
        })
    }

    /// Corners of an element, all around.
    pub(super) fn corners(&self, strip: usize, i: usize) -> [[f64; 2]; 4] {
        let ([front, beside], [rear, across]) =
            (self.cut_ends(strip, i), self.cut_ends(strip, i + 1));
        [front, beside, across, rear]
    }

    /// Where a strip's middle line is cut, from the leading edge.
    pub(super) fn middle_cut(&self, strip: usize, i: usize) -> [f64; 2] {
        let [[x0, y0], [x1, y1]] = self.cut_ends(strip, i);
        [0.5 * (x0 + x1), 0.5 * (y0 + y1)]
    }

    /// The four elements around a position inside the contact, with the weights of bilinear
    /// interpolation between their middles; at the edge of the contact the outermost counts on.
    pub(super) fn around(&self, ellipse: Ellipse, [x, y]: [f64; 2]) -> [(usize, f64); 4] {
        let across = y / ellipse.b();
        let length = ellipse.a() * load::root(across);
        let along = (x / length.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0);
        let strips = beside(across, self.strips, |j| 0.5 * (self.borders[j] + self.borders[j + 1]));
        let elements = beside(-along.asin(), self.along, |i| {
            FRAC_PI_2 * ((2 * i + 1) as f64 / self.along as f64 - 1.0)
        });
        [0, 1, 2, 3].map(|k: usize| {
            let ((strip, by_strip), (i, by_element)) = (strips[k / 2], elements[k % 2]);
            (strip * self.along + i, by_strip * by_element)
        })
    }
}

/// How far strips narrow towards the sides and cuts follow the edge, from 0 to 1.
///
/// On contacts very long in the rolling direction such elements would act far ahead of and behind
/// their middles, and sweeps would not settle; there strips become equal, elements rectangles.
pub(super) fn fit(a_over_b: f64) -> f64 {
    (LONG / a_over_b).min(1.0).powi(3)
}

/// Half-lengths of a strip at its lower and its upper border, `low` and `high` over `b`.
fn half_lengths(ellipse: Ellipse, low: f64, high: f64) -> [f64; 2] {
    let (fit, mean) = (fit(ellipse.ratio()), load::mean_length(low, high));
    [low, high].map(|y| ellipse.a() * (fit * load::root(y) + (1.0 - fit) * mean))
}

/// The two of `count` rising middles next to a place, with their weights.
fn beside(place: f64, count: usize, middle: impl Fn(usize) -> f64) -> [(usize, f64); 2] {
    let above = (0..count).find(|k| middle(*k) > place).unwrap_or(count);
    if above == 0 || above == count {
        let outermost = above.min(count - 1);
        return [(outermost, 1.0), (outermost, 0.0)];
    }
    let [low, high] = [middle(above - 1), middle(above)];
    let weight = (place - low) / (high - low);
    [(above - 1, 1.0 - weight), (above, weight)]
}

/// Cut `i` of `n` from 1 to -1, or with a broken `i` a place between cuts.
pub(super) fn cut(i: f64, n: usize) -> f64 {
    (FRAC_PI_2 * (1.0 - 2.0 * i / n as f64)).sin()
}

/// Border `j` of `n` from -1 to 1, or with a broken `j` a place between borders: fully fitted,
/// their density is as `1 / (1 - t^4)`, in the middle four fifths of that of equal strips.
pub(super) fn border(j: f64, n: usize, fit: f64) -> f64 {
    let t = 2.0 * j / n as f64 - 1.0;
    t + 0.25 * fit * (t - t.powi(5))
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
            let y = elements.middle_cut(strip, i)[1];
            let length = ellipse.a() * load::root(y / ellipse.b());
            let x = length * cut(i as f64 + 0.5, 10);
            let around = elements.around(ellipse, [x, y]);
            let own = around.iter().filter(|(e, _)| *e == element).map(|(_, weight)| weight);
            // Rounding of the arc sine, over an angle of a twentieth.
            assert!((own.sum::<f64>() - 1.0).abs() < 1e-12, "{element}: {around:?}");
        }
    }
}
