//! Gap in axes turned about a place.

use super::{Gap, Rectangle};

/// The gap at a place of axes that are turned by an angle against its own, about a place that keeps its
/// coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Turned {
    gap: Gap,
    about: [f64; 2],
    sin: f64,
    cos: f64,
    domain: Rectangle,
    /// A length along x over which the gap changes.
    length: f64,
}

impl Turned {
    /// What lies in `extent` is looked at.
    pub(super) fn new(gap: &Gap, about: [f64; 2], angle: f64, extent: &Rectangle) -> Self {
        let (sin, cos) = angle.sin_cos();
        let [length, width] = extent.size();
        let Rectangle { x, y } = gap.domain();
        let drawn_in = |[low, high]: [f64; 2], by: f64| [low + by, high - by];
        let domain = Rectangle {
            x: drawn_in(x, 0.5 * width * sin.abs()),
            y: drawn_in(y, 0.5 * length * sin.abs()),
        };
        Self { gap: gap.clone(), about, sin, cos, domain, length }
    }

    pub(super) fn gap(&self) -> &Gap {
        &self.gap
    }

    pub(super) fn at(&self, x: f64, y: f64) -> f64 {
        let [x, y] = self.outwards([x, y]);
        self.gap.at(x, y)
    }

    /// A place in the gap's own axes.
    fn outwards(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [x - self.about[0], y - self.about[1]];
        [self.about[0] + self.cos * x - self.sin * y, self.about[1] + self.sin * x + self.cos * y]
    }

    pub(super) fn domain(&self) -> Rectangle {
        self.domain
    }

    /// The rectangle around one of the gap's own axes.
    pub(super) fn around(&self, Rectangle { x, y }: Rectangle) -> Rectangle {
        let corners = x.into_iter().flat_map(|x| y.map(|y| [x - self.about[0], y - self.about[1]]));
        let inwards = corners.map(|[x, y]| {
            [
                self.about[0] + self.cos * x + self.sin * y,
                self.about[1] - self.sin * x + self.cos * y,
            ]
        });
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        inwards.fold(Rectangle { x: nothing, y: nothing }, |sum, [x, y]| Rectangle {
            x: [sum.x[0].min(x), sum.x[1].max(x)],
            y: [sum.y[0].min(y), sum.y[1].max(y)],
        })
    }

    /// Where the section along x at `y` is lowest, by parabolas through three places that draw together.
    pub(super) fn locus(&self, y: f64) -> f64 {
        const ROUNDS: i32 = 4;
        let mut x = self.about[0];
        for round in 0..ROUNDS {
            let d = 0.125 * self.length * 0.25_f64.powi(round);
            let [low, here, high] = [-d, 0.0, d].map(|d| self.at(x + d, y));
            let bend = low + high - 2.0 * here;
            if bend > 0.0 {
                x -= (0.5 * d * (high - low) / bend).clamp(-self.length, self.length);
            }
        }
        x
    }
}
