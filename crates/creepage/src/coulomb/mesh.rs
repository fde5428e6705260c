//! Mesh of an ellipse: strips along the rolling direction, each cut into elements along its own length.
//!
//! A strip has its own ends, borders and number of elements. An element is a quadrilateral between
//! the cuts of its strip's two borders, for the ends of a strip are not the same on both:
//! rectangles would make the trailing edge a staircase, and the error of first order in the width
//! of a strip. Elements are counted strip by strip, each strip from its leading edge.

use std::ops::Range;
use std::sync::Arc;

use super::subdivision::{Pieces, SUBCELLS};
use crate::ellipse::Ellipse;

/// Largest `a/b` with elements that are fitted all the way, and with a wide corner of friction.
pub(super) const LONG: f64 = 10.0;

/// How strips narrow towards the sides: their density is as `1 / (1 - |t|^(p - 1))`, with `t` from
/// -1 to 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StripGrading {
    p: f64,
}

impl StripGrading {
    /// In the middle a quarter wider than equal strips: where slip begins all around the edge.
    pub(crate) const NARROW: Self = Self { p: 5.0 };

    /// For steady rolling. Nearly equal strips, for where the pole of the spin turns the slip around
    /// none must be wide; only the sides, where small creepage is decided, are cut more finely. The
    /// longer a contact is in the rolling direction the fewer are its strips, and the larger is the
    /// part of it that lies at the sides.
    pub(crate) fn steady(a_over_b: f64) -> Self {
        Self { p: (13.0 * a_over_b.powf(-0.6)).max(Self::NARROW.p) }
    }
}

/// One strip. Lengths are in the unit of length of the contact.
#[derive(Debug, Clone)]
pub(crate) struct Strip {
    /// `y` from the lower to the upper border, in between where its elements are cut into subcells.
    pub across: [f64; SUBCELLS + 1],
    /// `x` of the middle between its ends, on the lower and on the upper border.
    pub middle: [f64; 2],
    /// Half-length on the lower and on the upper border.
    pub half_length: [f64; 2],
    /// How it is cut along.
    pub along: Arc<Pieces>,
    /// The strips that are side by side with this one, itself included.
    pub patch: Range<usize>,
}

impl Strip {
    /// Number of elements.
    pub(crate) fn len(&self) -> usize {
        self.along.len()
    }

    /// `y` of the lower and the upper border.
    pub(crate) fn borders(&self) -> [f64; 2] {
        [self.across[0], self.across[SUBCELLS]]
    }

    /// `y` of the middle line.
    pub(crate) fn y(&self) -> f64 {
        0.5 * (self.across[0] + self.across[SUBCELLS])
    }

    /// Ends of cut `i` on the lower and the upper border.
    pub(crate) fn cut_ends(&self, i: usize) -> [[f64; 2]; 2] {
        let (cut, borders) = (self.along.cut(i), self.borders());
        [0, 1].map(|end| [self.middle[end] + self.half_length[end] * cut, borders[end]])
    }

    /// Where cut `i` crosses the middle line.
    pub(crate) fn middle_cut(&self, i: usize) -> [f64; 2] {
        let [[x0, y0], [x1, y1]] = self.cut_ends(i);
        [0.5 * (x0 + x1), 0.5 * (y0 + y1)]
    }

    /// The `x` on the middle line at an `x` over the half-length.
    pub(crate) fn middle_x(&self, along: f64) -> f64 {
        let mean = |ends: [f64; 2]| 0.5 * (ends[0] + ends[1]);
        mean(self.middle) + mean(self.half_length) * along
    }

    /// Area of an element.
    pub(crate) fn area(&self, i: usize) -> f64 {
        let [low, high] = self.borders();
        let mean = 0.5 * (self.half_length[0] + self.half_length[1]);
        mean * (self.along.cut(i) - self.along.cut(i + 1)) * (high - low)
    }

    /// Corners of an element, all around.
    pub(crate) fn corners(&self, i: usize) -> [[f64; 2]; 4] {
        let ([front, beside], [rear, across]) = (self.cut_ends(i), self.cut_ends(i + 1));
        [front, beside, across, rear]
    }
}

/// The elements of a contact.
#[derive(Debug, Clone)]
pub(crate) struct Mesh {
    pub strips: Vec<Strip>,
    /// First element of every strip, and the number of all.
    offsets: Vec<usize>,
    /// The strips in opposite order are their mirror images about the `x` axis.
    pub mirrored: bool,
}

impl Mesh {
    /// The elements of any strips.
    pub(crate) fn new(strips: Vec<Strip>) -> Self {
        let mut offsets = vec![0];
        offsets.extend(strips.iter().scan(0, |end, strip| {
            *end += strip.len();
            Some(*end)
        }));
        Self { strips, offsets, mirrored: false }
    }

    /// `strips` strips of `along` elements that fit an ellipse, for steady rolling.
    pub(crate) fn ellipse(ellipse: Ellipse, along: usize, strips: usize) -> Self {
        Self::with_sides(ellipse, along, strips, StripGrading::steady(ellipse.ratio()))
    }

    /// `strips` strips of `along` elements that fit an ellipse.
    ///
    /// Small creepage makes the traction infinite all along the trailing half of the edge, so the
    /// cuts are clustered towards it: along as cosines, across less.
    pub(crate) fn with_sides(
        ellipse: Ellipse,
        along: usize,
        strips: usize,
        sides: StripGrading,
    ) -> Self {
        let fit = fit(ellipse.ratio());
        let broken = |piece: usize| piece as f64 / SUBCELLS as f64;
        let pieces = Pieces::of_equal_angles(along);
        let strip = |j: usize| {
            let borders: [f64; SUBCELLS + 1] =
                std::array::from_fn(|k| border(broken(SUBCELLS * j + k), strips, fit, sides));
            Strip {
                across: borders.map(|t| ellipse.b() * t),
                middle: [0.0; 2],
                half_length: half_lengths(ellipse, borders[0], borders[SUBCELLS]),
                along: Arc::clone(&pieces),
                patch: 0..strips,
            }
        };
        Self { mirrored: true, ..Self::new((0..strips).map(strip).collect()) }
    }

    /// Number of elements.
    pub(crate) fn len(&self) -> usize {
        self.offsets[self.strips.len()]
    }

    pub(crate) fn offsets(&self) -> &[usize] {
        &self.offsets
    }

    /// The elements of a strip, from the leading edge.
    pub(crate) fn elements(&self, strip: usize) -> Range<usize> {
        self.offsets[strip]..self.offsets[strip + 1]
    }

    /// Every element as `(strip, number in the strip)`, in order.
    pub(crate) fn all(&self) -> impl Iterator<Item = (usize, usize)> {
        let strips = self.strips.iter().enumerate();
        strips.flat_map(|(strip, own)| (0..own.len()).map(move |i| (strip, i)))
    }

    /// Whether every strip is its own mirror image fore and aft, all about one `x`, with what is given of
    /// each element.
    pub(crate) fn is_like_reversed(&self, of_elements: &[f64]) -> bool {
        /// Of a half-length, or of the largest that is given: rounding.
        const SYMMETRY_TOLERANCE: f64 = 1e-11;
        let largest = of_elements.iter().fold(0.0, |most: f64, of| most.max(of.abs()));
        let axis = self.strips.first().map_or(0.0, |strip| strip.middle[0]);
        self.strips.iter().zip(self.offsets.windows(2)).all(|(strip, ends)| {
            let own = &of_elements[ends[0]..ends[1]];
            let centred = |end: usize| {
                (strip.middle[end] - axis).abs() <= SYMMETRY_TOLERANCE * strip.half_length[end]
            };
            let opposite = |(one, other): (&f64, &f64)| (one + other).abs() <= SYMMETRY_TOLERANCE;
            let like =
                |(one, other): (&f64, &f64)| (one - other).abs() <= SYMMETRY_TOLERANCE * largest;
            centred(0)
                && centred(1)
                && strip.along.cuts.iter().zip(strip.along.cuts.iter().rev()).all(opposite)
                && own.iter().zip(own.iter().rev()).all(like)
        })
    }

    /// The strip that holds a position, and its `x` over the half-length there.
    pub(crate) fn locate(&self, [x, y]: [f64; 2]) -> Option<(usize, f64)> {
        let inside = |(k, strip): (usize, &Strip)| {
            let [low, high] = strip.borders();
            let t = (y - low) / (high - low);
            let at = |[lower, upper]: [f64; 2]| lower + t * (upper - lower);
            let along = (x - at(strip.middle)) / at(strip.half_length);
            ((0.0..=1.0).contains(&t) && along.abs() <= 1.0).then_some((k, along))
        };
        self.strips.iter().enumerate().find_map(inside)
    }

    /// The two strips next to a `y` in a strip, or beyond its sides, with the weights of interpolation
    /// between their middle lines; at the sides of the contact of extrapolation.
    pub(crate) fn strips_across(&self, strip: usize, y: f64) -> [(usize, f64); 2] {
        let patch = &self.strips[strip].patch;
        let middle = |j: usize| self.strips[patch.start + j].y();
        let (other, weight) = next(strip - patch.start, patch.len(), y, middle);
        [(strip, 1.0 - weight), (patch.start + other, weight)]
    }

    /// The four elements around a position in a strip, given as its `y` and its `x` over the
    /// half-length, with the weights of interpolation between their middles, along in the angle
    /// whose sine is cut; at the edge of the contact the outermost counts on.
    pub(crate) fn around(&self, strip: usize, y: f64, along: f64) -> [(usize, f64); 4] {
        let patch = &self.strips[strip].patch;
        let middle = |j: usize| self.strips[patch.start + j].y();
        let strips = beside(strip - patch.start, patch.len(), y, middle);
        let along = along.clamp(-1.0, 1.0);
        let angle = along.asin();
        let around = strips.map(|(j, by_strip)| {
            let strip = patch.start + j;
            let Pieces { angles, .. } = &*self.strips[strip].along;
            let own = self.strips[strip].along.element_at(along);
            let elements = beside(own, angles.len(), -angle, |i| -angles[i]);
            elements.map(|(i, by_element)| (self.offsets[strip] + i, by_strip * by_element))
        });
        [around[0][0], around[0][1], around[1][0], around[1][1]]
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
    let root = |t: f64| (1.0 - t * t).max(0.0).sqrt();
    let area = |t: f64| 0.5 * (t * root(t) + t.asin());
    let (fit, mean) = (fit(ellipse.ratio()), (area(high) - area(low)) / (high - low));
    [low, high].map(|y| ellipse.a() * (fit * root(y) + (1.0 - fit) * mean))
}

/// Of `count` rising middles the two next to a position, which belongs to `own`, with their weights.
fn beside(
    own: usize,
    count: usize,
    position: f64,
    middle: impl Fn(usize) -> f64,
) -> [(usize, f64); 2] {
    let above = if middle(own) > position { own } else { own + 1 };
    if above == 0 || above == count {
        return [(own, 1.0), (own, 0.0)];
    }
    let [low, high] = [middle(above - 1), middle(above)];
    let weight = (position - low) / (high - low);
    [(above - 1, 1.0 - weight), (above, weight)]
}

/// The neighbour of piece `own` of `count` on the side of a position, and its weight in linear
/// interpolation, or extrapolation, between their middles.
pub(super) fn next(
    own: usize,
    count: usize,
    position: f64,
    middle: impl Fn(usize) -> f64,
) -> (usize, f64) {
    if count < 2 {
        return (own, 0.0);
    }
    let off = position - middle(own);
    let later = own == 0 || off * (middle(own) - middle(own - 1)) > 0.0;
    let other = if later && own + 1 < count { own + 1 } else { own - 1 };
    (other, off / (middle(other) - middle(own)))
}

/// Border `j` of `n` from -1 to 1, or with a broken `j` one between subcells.
pub(super) fn border(j: f64, n: usize, fit: f64, StripGrading { p }: StripGrading) -> f64 {
    let t = 2.0 * j / n as f64 - 1.0;
    t + fit / (p - 1.0) * (t - t * t.abs().powf(p - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The middle of an element, in the angle whose sine is cut, belongs to that element alone.
    #[test]
    fn every_middle_lies_in_its_element() {
        let mesh = Mesh::ellipse(Ellipse::from_ratio(0.4).unwrap(), 10, 14);
        for (element, (strip, i)) in mesh.all().enumerate() {
            let along = mesh.strips[strip].along.angles[i].sin();
            let around = mesh.around(strip, mesh.strips[strip].y(), along);
            let own = around.iter().filter(|(e, _)| *e == element).map(|(_, weight)| weight);
            // Rounding of the arc sine, over an angle of a twentieth.
            assert!((own.sum::<f64>() - 1.0).abs() < 1e-12, "{element}: {around:?}");
        }
    }

    /// On a circle the strips of the middle three quarters are equal to ten per cent; towards the sides
    /// strips only become narrower, on long contacts sooner.
    #[test]
    fn strips_narrow_at_the_sides_only() {
        let widths = |a_over_b: f64| {
            let border = |j: i32| border(f64::from(j), 40, 1.0, StripGrading::steady(a_over_b));
            let borders: Vec<f64> = (0..=40).map(border).collect();
            borders.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<f64>>()
        };
        let [circle, long] = [widths(1.0), widths(5.0)];
        // Rounding of forty terms.
        assert!((circle.iter().sum::<f64>() - 2.0).abs() < 1e-14);
        let narrows = |widths: &[f64]| widths[..19].windows(2).all(|w| w[0] <= w[1] + 1e-14);
        assert!(narrows(&circle) && narrows(&long));
        assert!(circle[5] > 0.9 * circle[19] && long[0] < circle[0] && long[4] < circle[4]);
    }
}
