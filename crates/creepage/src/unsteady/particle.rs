//! Particle paths: where the particle that is now at an element's centre was before, and between which points of
//! displacement.
//!
//! A particle moves against the rolling direction, and the contact may grow and shrink around it.
//! Its slip counts from where it entered the contact, or from where the past begins.

use super::elements::{Element, Elements, Row};
use super::history::Ages;
use crate::numerics::bisect;

/// Points of displacement and their weights.
pub(crate) type Spread = [(usize, f64); 9];

/// A particle at some distance back.
#[derive(Debug, Clone)]
pub(crate) struct Sample {
    /// Distance back.
    pub age: f64,
    /// Weight of the upstream point against the one before it.
    pub ahead: f64,
    /// Whether the particle was at the upstream point's distance from the leading edge.
    pub is_whole: bool,
    /// Where it was in between points; `None` at the upstream point.
    pub between: Option<Spread>,
}

/// A window is no longer than this, in steps of the elements.
const LONGEST: f64 = 1.5;
/// Nor shorter, in the shorter of steps of the elements and of the contact: a particle that the contact
/// has just grown over counts from where it entered, for its displacement is known at the edge alone.
const SHORTEST: f64 = 0.01;
pub(super) const BISECTIONS: usize = 45;

/// The particles of one step, on their way back.
pub(crate) struct Particles<'a> {
    pub elements: &'a Elements,
    pub ages: &'a Ages,
}

impl Particles<'_> {
    /// The particle now at the centre of an element, one step of elements further upstream than
    /// at `from`; `second` for the step after the first.
    pub(crate) fn sample(&self, element: &Element, second: bool, from: f64) -> Sample {
        let scale = self.ages.scales[0];
        let step = element.steps[usize::from(second)] * scale;
        let (reach, origin) = (from + step, self.ages.origin());
        if !self.ages.is_constant(reach.min(origin)) {
            return self.moving(element, second, from, step);
        }
        if reach <= origin {
            return Sample { age: reach, ahead: 1.0, is_whole: true, between: None };
        }
        self.between(element, second, origin)
    }

    /// The same in a contact that grows or shrinks.
    fn moving(&self, element: &Element, second: bool, from: f64, step: f64) -> Sample {
        let row = &self.elements.rows[element.strip];
        let upstream = row.x[element.nodes[1 + usize::from(second)] - row.first];
        let limit = (from + LONGEST * step).min(self.ages.origin());
        let is_behind = |age: f64| self.place(element, age)[0] < upstream;
        let mut age =
            if is_behind(limit) { limit } else { bisect(from, limit, BISECTIONS, is_behind) };
        let is_inside = |age: f64| self.is_inside(self.place(element, age));
        if !is_inside(age) {
            age = bisect(from, age, BISECTIONS, is_inside);
        }
        let age = age.max(from + SHORTEST * step.min(self.ages.back[1])).min(self.ages.origin());
        Sample { is_whole: !is_behind(age + 1e-6 * step), ..self.between(element, second, age) }
    }

    /// At any distance back.
    fn between(&self, element: &Element, second: bool, age: f64) -> Sample {
        let row = &self.elements.rows[element.strip];
        let [x, y] = self.place(element, age);
        let k = usize::from(second);
        let [down, up] = [k, k + 1].map(|k| row.x[element.nodes[k] - row.first]);
        let ahead = if up > down { ((x - down) / (up - down)).clamp(0.0, 1.0) } else { 1.0 };
        let between = Some(self.elements.spread(element.strip, [x, y]));
        Sample { age, ahead, is_whole: false, between }
    }

    /// Where the particle was, over the size of the contact then.
    fn place(&self, element: &Element, age: f64) -> [f64; 2] {
        let (now, then) = (self.ages.scales[0], self.ages.scale(age));
        [(element.x * now + age) / then, element.y * (now / then)]
    }

    fn is_inside(&self, [x, y]: [f64; 2]) -> bool {
        let [a, b] = self.elements.semi_axes;
        (x / a).powi(2) + (y / b).powi(2) <= 1.0
    }
}

impl Elements {
    /// Weights of the points of displacement around a position near a strip: quadratic across, and
    /// along each strip at the same fraction of its length.
    fn spread(&self, strip: usize, [x, y]: [f64; 2]) -> Spread {
        let own = &self.rows[strip];
        let mut spread = [(own.first, 0.0); 9];
        let across = self.across(strip, y);
        let length = self.half_length(y, own);
        for ((row, weight), points) in across.into_iter().zip(spread.chunks_exact_mut(3)) {
            let row = &self.rows[row];
            let along = row.along(x / length * row.half_length);
            for (point, (k, by)) in points.iter_mut().zip(along) {
                *point = (row.first + k, weight * by);
            }
        }
        spread
    }

    /// Half-length of the contact at some `y` as the strips have it.
    fn half_length(&self, y: f64, own: &Row) -> f64 {
        let [_, b] = self.semi_axes;
        let root = |y: f64| (1.0 - (y / b).powi(2)).max(1e-6).sqrt();
        own.half_length * root(y) / root(own.y)
    }

    /// Three strips around a strip, with their weights at `y`.
    #[allow(clippy::float_cmp)] // on its middle line a strip is alone, whatever is near
    fn across(&self, strip: usize, y: f64) -> [(usize, f64); 3] {
        let count = self.rows.len();
        if y == self.rows[strip].y || count < 3 {
            return [(strip, 1.0), (strip, 0.0), (strip, 0.0)];
        }
        let first = strip.clamp(1, count - 2) - 1;
        let at = [0, 1, 2].map(|k| self.rows[first + k].y);
        let y = y.clamp(self.rows[0].y, self.rows[count - 1].y);
        let weights = lagrange(at, y);
        [0, 1, 2].map(|k| (first + k, weights[k]))
    }
}

impl Row {
    /// Three points of the strip for a position along it, none downstream of the next one.
    fn along(&self, x: f64) -> [(usize, f64); 3] {
        let last = self.x.len() - 1;
        let behind = self.x.partition_point(|known| *known > x).min(last);
        let first = behind.max(2).min(last) - 2.min(last);
        let at = [0, 1, 2].map(|k| self.x[(first + k).min(last)]);
        let weights = lagrange(at, x);
        [0, 1, 2].map(|k| ((first + k).min(last), weights[k]))
    }
}

/// Weights of three values in quadratic interpolation.
fn lagrange([p, q, r]: [f64; 3], x: f64) -> [f64; 3] {
    [
        (x - q) * (x - r) / ((p - q) * (p - r)),
        (x - p) * (x - r) / ((q - p) * (q - r)),
        (x - p) * (x - q) / ((r - p) * (r - q)),
    ]
}
