//! The peak pressure. Where curvature changes next to it, strips as wide as the load needs are too
//! wide for the summit: about it they are cut into narrower ones, all others being held.

use super::newton::StripSolution;
use super::strip::{self, Strip};
use super::system::{Depth, System, zeros};

/// Strips to either side of the highest that are cut, and into how many.
const STRIPS_ASIDE: usize = 2;
const PARTS: u32 = 3;

/// The highest pressure of strips that touch; `None` at the end of a band.
pub(in crate::normal) fn height(
    touching: &StripSolution,
    terms: usize,
    depth: Depth<'_>,
) -> Option<f64> {
    cut(touching, terms, depth).map(|parts| strip::peak(&parts))
}

/// The parts of the strips about the highest, in order of y; `None` where that ends a band.
fn cut(touching: &StripSolution, terms: usize, depth: Depth<'_>) -> Option<Vec<Strip>> {
    let strips = &touching.strips;
    let top = strip::top(strips);
    three(strips, top)?;
    let inside = |&i: &usize| strips[i].band == strips[top].band && three(strips, i).is_some();
    let first = (top.saturating_sub(STRIPS_ASIDE)..=top).rev().take_while(inside).last()?;
    let last = (top..=top + STRIPS_ASIDE).take_while(|i| *i < strips.len() && inside(i)).last()?;
    let parts = (first..=last).flat_map(|i| (0..PARTS).map(move |k| (i, k)));
    let parts = parts.map(|(i, k)| part(three(strips, i)?, k)).collect::<Option<Vec<Strip>>>()?;
    let held = strips[..first].iter().chain(&strips[last + 1..]);
    let count = strips.len() - (last + 1 - first);
    let strips = held.chain(&parts).copied().collect();
    let points = zeros(terms).collect();
    let system = System { strips, terms, points, deeper: touching.deeper };
    system.with_pressures(count, depth).filter(|parts| parts.iter().all(Strip::is_compressive))
}

/// A strip between its neighbours in the same band.
fn three(strips: &[Strip], at: usize) -> Option<[Strip; 3]> {
    let three = [*strips.get(at.checked_sub(1)?)?, *strips.get(at)?, *strips.get(at + 1)?];
    three.iter().all(|strip| strip.band == three[1].band).then_some(three)
}

/// The `k`th part of a strip; its ends lie on parabolas through its neighbours'.
fn part([low, strip, high]: [Strip; 3], k: u32) -> Option<Strip> {
    let width = strip.width / f64::from(PARTS);
    let y = strip.y - strip.width + (2.0 * f64::from(k) + 1.0) * width;
    let between = |value: fn(&Strip) -> f64| {
        let [below, above] =
            [&low, &high].map(|other| (value(other) - value(&strip)) / (other.y - strip.y));
        let bend = (above - below) / (high.y - low.y);
        let slope = below - bend * (low.y - strip.y);
        value(&strip) + (y - strip.y) * (slope + bend * (y - strip.y))
    };
    let (centre, square) = (between(|s| s.centre), between(|s| s.half * s.half));
    let part = Strip { y, width, centre, half: square.max(0.0).sqrt(), ..strip };
    (square > 0.0).then_some(part)
}
