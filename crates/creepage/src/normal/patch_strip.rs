//! Band of a patch: a part of a contact area that every line along x crosses once; its ends and the pressure in it.
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
use crate::numerics::gauss::GAUSS_4;

use super::chord::{Chord, ChordPoint, ChordProfile, PLACES, arc_nodes};

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
        let line = self.line(y);
        let s = (x - line.centre) / line.half;
        if s.abs() < 1.0 { line.pressure(s) } else { 0.0 }
    }

    /// Pressure at a place (Pa) of the band; at its edge or just outside, that of the place next to it.
    pub(super) fn pressure_near(&self, x: f64, y: f64) -> f64 {
        const EDGE: f64 = 1.0 - 1e-6;
        let y = y.clamp(self.y[0], self.y[1]);
        let (centre, half) = self.section(y);
        // A waist between chords, where the parabolas of the half lengths fall below zero.
        if half == 0.0 {
            return 0.0;
        }
        let spot = ChordPoint::new(((x - centre) / half).clamp(-EDGE, EDGE));
        let density: f64 =
            self.around(y).map(|(weight, k)| weight * spot.of(&self.chords[k].density)).sum();
        half * spot.root() * density
    }

    /// Centre of the area, and its second moments `xx`, `xy`, `yy` about it (m^4).
    pub(super) fn second_moments(&self) -> ([f64; 2], [f64; 3]) {
        let rows: Vec<[f64; 4]> = self
            .rows_between(self.y)
            .map(|(y, weight)| {
                let (centre, half) = self.section(y);
                [2.0 * weight * half, centre, y, half]
            })
            .collect();
        let area: f64 = rows.iter().map(|row| row[0]).sum();
        let mean = |k: usize| rows.iter().map(|row| row[0] * row[k]).sum::<f64>() / area;
        let middle = [mean(1), mean(2)];
        let second = rows.iter().fold([0.0; 3], |sum, &[area, x, y, half]| {
            let [x, y] = [x - middle[0], y - middle[1]];
            [
                sum[0] + area * (x * x + half * half / 3.0),
                sum[1] + area * x * y,
                sum[2] + area * y * y,
            ]
        });
        (middle, second)
    }

    /// The band along one y: `rho` goes as a cubic through the four chords around it, and beyond
    /// the outermost it stays.
    pub(crate) fn line(&self, y: f64) -> ChordProfile {
        let (centre, half) = self.section(y);
        let mut density = [0.0; PLACES];
        for (weight, chord) in self.around(y) {
            for (sum, rho) in density.iter_mut().zip(&self.chords[chord].density) {
                *sum += weight * rho;
            }
        }
        ChordProfile { centre, half, density }
    }

    /// The weights of the four chords around a y, and which they are.
    fn around(&self, y: f64) -> impl Iterator<Item = (f64, usize)> {
        let all = &self.chords;
        let after = all.partition_point(|chord| chord.y <= y);
        let (first, end) = (after.saturating_sub(2), (after + 2).min(all.len()));
        let within = if first < end { y.clamp(all[first].y, all[end - 1].y) } else { y };
        (first..end).map(move |k| {
            let others = (first..end).filter(|other| *other != k);
            let part = |other: usize| (within - all[other].y) / (all[k].y - all[other].y);
            (others.map(part).product(), k)
        })
    }

    /// Force and its moments on the element between two `y` and between two parts `s` of the
    /// length, -1 at the trailing and +1 at the leading end.
    #[must_use]
    pub fn moments(&self, y: [f64; 2], s: [f64; 2]) -> Moments {
        let nodes = arc_nodes(s);
        let mut loads: Vec<Option<[f64; 2]>> = vec![None; self.chords.len()];
        let mut sum = Moments::default();
        for (y, weight) in self.rows_between(y) {
            let (centre, half) = self.section(y);
            let [mut load, mut by_s] = [0.0; 2];
            for (part, chord) in self.around(y) {
                let own = || self.chords[chord].load(&nodes);
                let [own_load, own_by_s] = *loads[chord].get_or_insert_with(own);
                load += part * half * half * own_load;
                by_s += part * half * half * own_by_s;
            }
            let (force, by_x) = (weight * load, weight * (centre * load + half * by_s));
            sum += Moments { force, by_x, by_y: force * y };
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
        let nodes = GAUSS_4.map(|(t, w)| {
            let (sin, cos) = (FRAC_PI_2 * 0.5 * (1.0 + t)).sin_cos();
            (sin * sin, w * FRAC_PI_2 * sin * cos)
        });
        let parts: Vec<[f64; 2]> = breaks.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        parts.into_iter().flat_map(move |[from, to]| {
            let width = (to - from).max(0.0);
            nodes.into_iter().map(move |(at, weight)| (from + width * at, weight * width))
        })
    }

    /// How far the centre moves from chord to chord, over the chords' length, both in the mean: a strip
    /// is a rectangle, and one that ought to be skew by so much has stairs for ends.
    pub(super) fn stairs(&self) -> f64 {
        let moves = self.chords.windows(2).map(|pair| (pair[1].centre - pair[0].centre).abs());
        let lengths = self.chords.iter().map(|chord| 2.0 * chord.half);
        moves.sum::<f64>() / lengths.sum::<f64>()
    }

    /// Whether it ends in a tip at least and greatest y; else it goes over into other bands.
    #[must_use]
    pub fn tips(&self) -> [bool; 2] {
        self.tips
    }

    /// The band trimmed at its sides (extended where negative); chords that come to lie outside are dropped, but at least
    /// one stays.
    pub(super) fn trimmed(&self, by: [f64; 2]) -> Self {
        let y = [self.y[0] + by[0], self.y[1] - by[1]];
        self.between(y, self.tips).unwrap_or_else(|| self.clone())
    }

    /// The part of it between two y, which ends in tips or goes over into others there; `None` without
    /// chords.
    pub(super) fn between(&self, y: [f64; 2], tips: [bool; 2]) -> Option<Self> {
        let inside = |chord: &&Chord| chord.y > y[0] && chord.y < y[1];
        let chords: Vec<Chord> = self.chords.iter().filter(inside).cloned().collect();
        (!chords.is_empty()).then(|| Self::new(chords, y, tips))
    }

    /// Whether another at greater y goes on from it: no more lies between them than beyond their outermost
    /// chords.
    pub(super) fn touches(&self, other: &Self) -> bool {
        let (Some(last), Some(first)) = (self.chords.last(), other.chords.first()) else {
            return false;
        };
        let between = other.y[0] - self.y[1];
        let is_near = between <= (self.y[1] - last.y) + (first.y - other.y[0]);
        let goes_on = (first.centre - last.centre).abs() < first.half + last.half;
        last.y < first.y && is_near && goes_on
    }

    /// Beyond which of its tips a place lies, and how far (m); `None` for one that lies aside, or farther
    /// off than half the band is wide.
    pub(super) fn beyond_tip(&self, x: f64, y: f64) -> Option<(usize, f64)> {
        let ([low, high], [from, to]) = (self.y, self.x());
        let (side, by) = if y > 0.5 * (low + high) { (1, y - high) } else { (0, low - y) };
        let is_near = by > 0.0 && by < 0.5 * (high - low) && (from..=to).contains(&x);
        (self.tips[side] && is_near).then_some((side, by))
    }

    /// One band of this and another at greater y.
    pub(super) fn merged(&self, other: &Self) -> Self {
        let chords = self.chords.iter().chain(&other.chords).cloned().collect();
        Self::new(chords, [self.y[0], other.y[1]], [self.tips[0], other.tips[1]])
    }

    /// The same with all lengths and pressures grown about a centre.
    pub(super) fn grown(&self, factor: f64, centre: [f64; 2]) -> Self {
        let place = |at: f64, k: usize| centre[k] + factor * (at - centre[k]);
        let chord = |chord: &Chord| Chord {
            y: place(chord.y, 1),
            half: factor * chord.half,
            centre: place(chord.centre, 0),
            density: chord.density,
        };
        let chords = self.chords.iter().map(chord).collect();
        Self::new(chords, self.y.map(|y| place(y, 1)), self.tips)
    }

    /// The same stretched across, its sides so much further out.
    pub(super) fn stretched(&self, [low, high]: [f64; 2]) -> Self {
        let [from, to] = self.y;
        let wider = (to - from + low + high) / (to - from);
        if wider <= 0.0 {
            return self.clone();
        }
        let across = |y: f64| from - low + wider * (y - from);
        let chord = |chord: &Chord| Chord { y: across(chord.y), ..chord.clone() };
        Self::new(self.chords.iter().map(chord).collect(), self.y.map(across), self.tips)
    }

    pub(super) fn scale(&mut self, factor: f64) {
        for chord in &mut self.chords {
            chord.scale(factor);
        }
    }

    /// Half of the shortest chord (m).
    pub(super) fn shortest(&self) -> f64 {
        self.chords.iter().map(|chord| chord.half).fold(f64::INFINITY, f64::min)
    }

    /// Least and greatest x at the chords (m).
    pub(super) fn x(&self) -> [f64; 2] {
        self.chords.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], chord| {
            [low.min(chord.centre - chord.half), high.max(chord.centre + chord.half)]
        })
    }
}
