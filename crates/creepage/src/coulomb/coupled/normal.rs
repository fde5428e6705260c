//! Normal problem of the coupled solution: strips with free ends, pressed into a paraboloid to which the tangential
//! tractions add.
//!
//! Lengths are in units of `c`, pressures in units of the frictionless peak, displacements in
//! units of `(1 - sigma) p_0 c / G`.

use std::f64::consts::FRAC_PI_2;

use super::Prescribed;
use super::chebyshev::ChebyshevSeries;
use crate::ellipse::Ellipse;
use crate::normal::strip_system::{self, MAX_TERMS, Strip, StripProblem};
use crate::numerics::anderson::AndersonAcceleration;

/// Borders are sines of equal parts of so much of a right angle: narrower strips at the tips.
const CLUSTER: f64 = 0.8 * FRAC_PI_2;
/// Least half-length of a strip, over that of the longest, from which it is solved.
const SHORTEST: f64 = 1e-3;
/// Largest residual of the strips' displacements, and of the load over itself.
const RESIDUAL_TOLERANCE: f64 = 1e-8;

/// Contact area with its pressure.
#[derive(Debug, Clone)]
pub(super) struct PressedArea {
    pub strips: Vec<Strip>,
    /// `y` halfway between the tips.
    pub middle: f64,
    /// Half the distance between the tips, over `b`.
    pub stretch: f64,
    pub approach: f64,
    pub load: f64,
}

impl PressedArea {
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let strips = self
            .strips
            .iter()
            .flat_map(|strip| strip.pressure.into_iter().chain([strip.centre, strip.half]));
        [self.middle, self.stretch, self.approach, self.load].into_iter().chain(strips)
    }

    fn numbers_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        let strips = self.strips.iter_mut().flat_map(|strip| {
            strip.pressure.iter_mut().chain([&mut strip.centre, &mut strip.half])
        });
        [&mut self.middle, &mut self.stretch, &mut self.approach, &mut self.load]
            .into_iter()
            .chain(strips)
    }

    /// The largest difference from another.
    pub(super) fn apart(&self, other: &Self) -> f64 {
        let apart = self.numbers().zip(other.numbers()).map(|(one, two)| one - two);
        apart.fold(0.0, |largest: f64, d| if d.is_nan() { d } else { largest.max(d.abs()) })
    }

    /// Whether it is another one to the last bit.
    pub(super) fn is(&self, other: &Self) -> bool {
        self.apart(other) == 0.0
    }

    /// Goes where the last turns lead to, given where this one led.
    pub(super) fn accelerate(&mut self, mixing: &mut AndersonAcceleration, image: &Self) {
        let mut numbers: Vec<f64> = self.numbers().collect();
        mixing.improve(&mut numbers, &image.numbers().collect::<Vec<f64>>());
        self.clone_from(image);
        let shortest = SHORTEST * image.strips.iter().fold(0.0, |most, s| s.half.max(most));
        for (own, number) in self.numbers_mut().zip(numbers) {
            *own = number;
        }
        for strip in &mut self.strips {
            strip.half = strip.half.max(shortest);
        }
    }
}

/// Normal problem, prepared once.
#[derive(Debug, Clone)]
pub(super) struct Normal {
    pub ellipse: Ellipse,
    /// Of the paraboloid, along and across.
    curvatures: [f64; 2],
    /// Of the strips, from -1 to 1.
    borders: Vec<f64>,
    /// Without friction; strips of finite width differ a little from Hertz.
    pub frictionless: PressedArea,
}

impl Normal {
    /// `None` when the strips do not find Hertz's contact.
    pub(super) fn new(ellipse: Ellipse, count: usize) -> Option<Self> {
        let integrals = ellipse.integrals();
        let root = ellipse.g().sqrt();
        let (tight, slack) = (integrals.b / root, ellipse.g().powi(2) * integrals.d / root);
        let along_is_tight = ellipse.a() <= ellipse.b();
        let curvatures = if along_is_tight { [tight, slack] } else { [slack, tight] };
        let border =
            |i: usize| (CLUSTER * (2.0 * i as f64 / count as f64 - 1.0)).sin() / CLUSTER.sin();
        let borders: Vec<f64> = (0..=count).map(border).collect();
        let hertz = PressedArea {
            strips: borders
                .windows(2)
                .map(|pair| hertz_strip(ellipse, [pair[0], pair[1]]))
                .collect(),
            middle: 0.0,
            stretch: 1.0,
            approach: ellipse.minor() * integrals.k,
            load: f64::NAN,
        };
        let mut normal = Self { ellipse, curvatures, borders, frictionless: hertz };
        let none: Vec<ChebyshevSeries> =
            normal.middles().map(|_| ChebyshevSeries::default()).collect();
        normal.frictionless =
            normal.touching(&normal.frictionless, &none, Prescribed::Approach).ok()?;
        Some(normal)
    }

    /// Middles of the strips, from -1 to 1.
    pub(super) fn middles(&self) -> impl Iterator<Item = f64> {
        self.borders.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]))
    }

    /// The area and its pressure when `more` is added to the normal displacement, from a start close by.
    /// Tips move once: near a solution the rest is for the next turn. `None` when the strips do not
    /// settle.
    pub(super) fn solve(
        &self,
        start: &PressedArea,
        more: impl Fn([f64; 2]) -> f64,
        prescribed: Prescribed,
    ) -> Option<PressedArea> {
        const PARTS: u32 = 8;
        if let Some(found) = self.step(start, &more, prescribed) {
            return Some(found);
        }
        // Too far at once: from the frictionless contact, bit by bit.
        let mut found = self.frictionless.clone();
        for part in 1..=PARTS {
            let part = f64::from(part) / f64::from(PARTS);
            found = self.step(&found, &|at: [f64; 2]| part * more(at), prescribed)?;
        }
        Some(found)
    }

    fn step(
        &self,
        start: &PressedArea,
        more: &impl Fn([f64; 2]) -> f64,
        prescribed: Prescribed,
    ) -> Option<PressedArea> {
        const ATTEMPTS: usize = 6;
        let mut pressed = self.laid(start);
        for _ in 0..ATTEMPTS {
            let along = |strip: &Strip| {
                ChebyshevSeries::new([strip.centre, strip.half], |x| more([x, strip.y]))
            };
            let more: Vec<ChebyshevSeries> = pressed.strips.iter().map(along).collect();
            match self.touching(&pressed, &more, prescribed) {
                Ok(mut found) => {
                    self.move_tips(&mut found);
                    return Some(found);
                }
                Err(stopped) => pressed = self.shrink(&pressed, &stopped)?,
            }
        }
        None
    }

    /// Shrinks: draws in the tips whose outermost strip has shrunk, for it touches nothing; `None` if there are
    /// none.
    fn shrink(&self, pressed: &PressedArea, stopped: &[Strip]) -> Option<PressedArea> {
        const SHRUNK: f64 = 0.6;
        const PART: f64 = 0.6;
        let by = |end: Option<(&Strip, &Strip)>| match end {
            Some((laid, stopped)) if stopped.half < SHRUNK * laid.half => 2.0 * PART * laid.width,
            _ => 0.0,
        };
        let mut pairs = pressed.strips.iter().zip(stopped);
        let (low, high) = (by(pairs.next()), by(pairs.next_back()));
        if low + high == 0.0 {
            return None;
        }
        let mut drawn = pressed.clone();
        drawn.middle += 0.5 * (low - high);
        drawn.stretch -= 0.5 * (low + high) / self.ellipse.b();
        Some(self.laid(&drawn))
    }

    /// The strips laid again between the tips.
    fn laid(&self, start: &PressedArea) -> PressedArea {
        let mut pressed = start.clone();
        for (strip, borders) in pressed.strips.iter_mut().zip(self.borders.windows(2)) {
            let half = start.stretch * self.ellipse.b();
            strip.y = start.middle + half * f64::midpoint(borders[0], borders[1]);
            strip.width = 0.5 * half * (borders[1] - borders[0]);
        }
        pressed
    }

    /// The strips that touch all along, or those where that failed.
    fn touching(
        &self,
        pressed: &PressedArea,
        more: &[ChebyshevSeries],
        prescribed: Prescribed,
    ) -> Result<PressedArea, Vec<Strip>> {
        let middles: Vec<f64> = pressed.strips.iter().map(|strip| strip.y).collect();
        let [along, across] = self.curvatures;
        let depth = |x: f64, y: f64| {
            let strip = middles.partition_point(|middle| *middle < y);
            let more = more.get(strip).map_or(f64::NAN, |more| more.at(x));
            pressed.approach - along * x * x - across * y * y - more
        };
        let load = (prescribed == Prescribed::Load).then_some(self.frictionless.load);
        // Of the stiffness only the sign is asked.
        let problem = StripProblem {
            depth: &depth,
            load,
            residual_tolerance: RESIDUAL_TOLERANCE,
            stiffness_tolerance: 0.1,
            known: None,
        };
        let found = strip_system::solve(pressed.strips.clone(), MAX_TERMS, problem)
            .map_err(|stopped| stopped.strips)?;
        if found.stiffness > 0.0 && found.deeper.is_finite() {
            let load = found.strips.iter().map(Strip::load).sum();
            let approach = pressed.approach + found.deeper;
            Ok(PressedArea { strips: found.strips, approach, load, ..*pressed })
        } else {
            Err(found.strips)
        }
    }

    /// Moves the tips to where the squared half-lengths go to zero as those of an ellipse do: the
    /// outermost two strips are then as much longer than without friction.
    fn move_tips(&self, pressed: &mut PressedArea) {
        const FARTHEST: f64 = 0.05;
        let middles: Vec<f64> = self.middles().collect();
        let longer = |k: usize| (pressed.strips[k].half / self.frictionless.strips[k].half).powi(2);
        let beyond = |outer: usize, inner: usize| {
            let ratio = longer(outer) / longer(inner);
            let [u, v] = [outer, inner].map(|k| 1.0 - middles[k] * middles[k]);
            let moved = 0.5 * u * v * (1.0 - ratio) / (ratio * u - v);
            if moved.is_finite() { moved.clamp(-FARTHEST, FARTHEST) } else { 0.0 }
        };
        let last = middles.len() - 1;
        let [low, high] = [beyond(0, 1), beyond(last, last - 1)];
        pressed.middle += 0.5 * pressed.stretch * self.ellipse.b() * (high - low);
        pressed.stretch *= 1.0 + 0.5 * (high + low);
    }
}

fn hertz_strip(ellipse: Ellipse, [low, high]: [f64; 2]) -> Strip {
    let middle = f64::midpoint(low, high);
    let root = ((1.0 - middle) * (1.0 + middle)).sqrt();
    let mut pressure = [0.0; MAX_TERMS];
    pressure[0] = root;
    Strip {
        y: ellipse.b() * middle,
        width: 0.5 * ellipse.b() * (high - low),
        centre: 0.0,
        half: ellipse.a() * root,
        pressure,
        band: 0,
    }
}
