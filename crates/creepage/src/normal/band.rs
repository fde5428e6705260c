//! A part of a contact area that every line along x crosses once: its ends, and the pressure in
//! it.
//!
//! At each `y` the area reaches from `x_0(y) - a(y)` to `x_0(y) + a(y)`, and with
//! `s = (x - x_0)/a` the pressure is
//!
//! ```math
//! p = a(y) \sqrt{1 - s^2} \, \rho(s, y),
//! ```
//!
//! in which `rho` varies slowly (for an ellipse it is a constant), and so does `a^2`, also where
//! the area ends in a tip.

use std::f64::consts::FRAC_PI_2;

use crate::gap::Cubic;

/// Force on a part of the area and its moments about the axes through the origin.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moments {
    /// Force (N).
    pub force: f64,
    /// Integral of `x p` (N m).
    pub by_x: f64,
    /// Integral of `y p` (N m).
    pub by_y: f64,
}

impl std::ops::AddAssign for Moments {
    fn add_assign(&mut self, other: Self) {
        self.force += other.force;
        self.by_x += other.by_x;
        self.by_y += other.by_y;
    }
}

/// The section of a band at one y: half length, centre, and `rho` at some `s`, increasing.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chord {
    pub(super) y: f64,
    pub(super) half: f64,
    pub(super) centre: f64,
    pub(super) density: Vec<[f64; 2]>,
}

impl Chord {
    fn density(&self, s: f64) -> f64 {
        let after = self.density.partition_point(|node| node[0] <= s);
        let (Some(first), Some(last)) = (self.density.first(), self.density.last()) else {
            return 0.0;
        };
        match (after.checked_sub(1).and_then(|i| self.density.get(i)), self.density.get(after)) {
            (Some(low), Some(high)) => {
                low[1] + (high[1] - low[1]) * (s - low[0]) / (high[0] - low[0])
            }
            (None, _) => first[1],
            (_, None) => last[1],
        }
    }

    /// Force per length across (N/m).
    pub(super) fn line_load(&self) -> f64 {
        self.half.powi(2) * arc_nodes([-1.0, 1.0]).map(|(s, w)| w * self.density(s)).sum::<f64>()
    }

    pub(super) fn scale(&mut self, factor: f64) {
        for node in &mut self.density {
            node[1] *= factor;
        }
    }
}

/// A part of a contact area that every line along x crosses once.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    y: [f64; 2],
    tips: [bool; 2],
    chords: Vec<Chord>,
    half_squared: Cubic,
    centre: Cubic,
}

impl Band {
    /// From chords of increasing y; a side is a tip, or where the band goes over into others.
    pub(super) fn new(chords: Vec<Chord>, y: [f64; 2], tips: [bool; 2]) -> Self {
        let centre = Cubic::new(
            chords.iter().map(|chord| chord.y).collect(),
            chords.iter().map(|chord| chord.centre).collect(),
        );
        let (mut places, mut squares) = (Vec::new(), Vec::new());
        let inner = chords.iter().map(|chord| (chord.y, chord.half.powi(2)));
        let tip = |side: usize| tips[side].then_some((y[side], 0.0));
        for (place, square) in tip(0).into_iter().chain(inner).chain(tip(1)) {
            places.push(place);
            squares.push(square);
        }
        Self { y, tips, chords, half_squared: Cubic::new(places, squares), centre }
    }

    /// Least and greatest y (m).
    #[must_use]
    pub fn y(&self) -> [f64; 2] {
        self.y
    }

    /// The y at which the solver knew its ends: the middles of its strips or rows (m).
    pub fn rows(&self) -> impl Iterator<Item = f64> {
        self.chords.iter().map(|chord| chord.y)
    }

    /// The two ends at `y` (m): trailing (low x) and leading (high x) for bodies that roll in
    /// +x. `None` beyond the band.
    #[must_use]
    pub fn ends(&self, y: f64) -> Option<[f64; 2]> {
        let inside = (self.y[0]..=self.y[1]).contains(&y);
        inside.then(|| {
            let (centre, half) = self.section(y);
            [centre - half, centre + half]
        })
    }

    /// Centre and half length at `y`.
    fn section(&self, y: f64) -> (f64, f64) {
        (self.centre(y), self.half_squared.at(y).max(0.0).sqrt())
    }

    /// Beyond the outermost chords the centre goes on in a straight line.
    fn centre(&self, y: f64) -> f64 {
        let (Some(first), Some(last)) = (self.chords.first(), self.chords.last()) else {
            return f64::NAN;
        };
        let inside = y.clamp(first.y, last.y);
        let inner = if y < first.y { self.chords.get(1) } else { self.chords.iter().rev().nth(1) };
        let outer = if y < first.y { first } else { last };
        let slope = inner.map_or(0.0, |inner| (outer.centre - inner.centre) / (outer.y - inner.y));
        self.centre.at(inside) + slope * (y - inside)
    }

    /// Pressure at a place (Pa), zero outside.
    #[must_use]
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        if !(self.y[0]..=self.y[1]).contains(&y) {
            return 0.0;
        }
        let (centre, half) = self.section(y);
        let s = (x - centre) / half;
        if s.abs() < 1.0 { half * (1.0 - s * s).sqrt() * self.density(s, y) } else { 0.0 }
    }

    /// `rho`, straight from chord to chord.
    fn density(&self, s: f64, y: f64) -> f64 {
        let after = self.chords.partition_point(|chord| chord.y <= y);
        let low = after.checked_sub(1).and_then(|i| self.chords.get(i));
        match (low, self.chords.get(after)) {
            (Some(low), Some(high)) => {
                let t = (y - low.y) / (high.y - low.y);
                (1.0 - t) * low.density(s) + t * high.density(s)
            }
            (Some(only), None) | (None, Some(only)) => only.density(s),
            (None, None) => 0.0,
        }
    }

    /// Force and its moments on the element between two `y` and between two parts `s` of the
    /// length, -1 at the trailing and +1 at the leading end.
    #[must_use]
    pub fn moments(&self, y: [f64; 2], s: [f64; 2]) -> Moments {
        let mut sum = Moments::default();
        for (y, weight) in self.rows_between(y) {
            let (centre, half) = self.section(y);
            for (s, share) in arc_nodes(s) {
                let force = weight * share * half * half * self.density(s, y);
                let by_x = force * (centre + half * s);
                sum += Moments { force, by_x, by_y: force * y };
            }
        }
        sum
    }

    /// Area between two y (m^2).
    #[must_use]
    pub fn area_between(&self, y: [f64; 2]) -> f64 {
        self.rows_between(y).map(|(y, weight)| 2.0 * weight * self.section(y).1).sum()
    }

    /// Area of the band (m^2).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area_between(self.y)
    }

    /// Force and moments on the whole band.
    #[must_use]
    pub fn total(&self) -> Moments {
        self.moments(self.y, [-1.0, 1.0])
    }

    /// Quadrature over y: between neighbouring chords, closer towards the tips, where the half
    /// length goes as a root: `y = a + (b - a) sin^2` has its own root there.
    fn rows_between(&self, [low, high]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> {
        let (low, high) = (low.max(self.y[0]), high.min(self.y[1]));
        let breaks: Vec<f64> = std::iter::once(low)
            .chain(self.rows().filter(move |y| *y > low && *y < high))
            .chain(std::iter::once(high))
            .collect();
        let parts: Vec<[f64; 2]> = breaks.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        parts.into_iter().flat_map(move |[from, to]| {
            let width = (to - from).max(0.0);
            GAUSS.into_iter().map(move |(t, w)| {
                let angle = FRAC_PI_2 * 0.5 * (1.0 + t);
                let (sin, cos) = angle.sin_cos();
                (from + width * sin * sin, w * FRAC_PI_2 * sin * cos * width)
            })
        })
    }

    /// Whether it ends in a tip at least and greatest y; else it goes over into other bands.
    #[must_use]
    pub fn tips(&self) -> [bool; 2] {
        self.tips
    }

    /// The same with its sides drawn in; chords that come to lie outside are left out, but the
    /// last one stays.
    pub(super) fn drawn_in(&self, by: [f64; 2]) -> Self {
        let y = [self.y[0] + by[0], self.y[1] - by[1]];
        let inside = |chord: &&Chord| chord.y > y[0] && chord.y < y[1];
        let chords: Vec<Chord> = self.chords.iter().filter(inside).cloned().collect();
        if chords.is_empty() { self.clone() } else { Self::new(chords, y, self.tips) }
    }

    pub(super) fn scale(&mut self, factor: f64) {
        for chord in &mut self.chords {
            chord.scale(factor);
        }
    }

    /// Least and greatest x at the chords (m).
    pub(super) fn x(&self) -> [f64; 2] {
        self.chords.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], chord| {
            [low.min(chord.centre - chord.half), high.max(chord.centre + chord.half)]
        })
    }
}

/// Gauss points and weights on (-1, 1).
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Quadrature of `sqrt(1 - s^2) f(s)` between two s, by the angle whose sine is s.
fn arc_nodes([low, high]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> {
    const PARTS: u32 = 3;
    let (from, to) = (low.clamp(-1.0, 1.0).asin(), high.clamp(-1.0, 1.0).asin());
    let half = 0.5 * (to - from) / f64::from(PARTS);
    (0..PARTS).flat_map(move |part| {
        let middle = from + half * (2.0 * f64::from(part) + 1.0);
        GAUSS.into_iter().map(move |(t, w)| {
            let (sin, cos) = (middle + half * t).sin_cos();
            (sin, w * half * cos * cos)
        })
    })
}
