//! Repair of measured profiles: repeated points, zig-zags, gaps, corners.

use std::f64::consts::PI;

use super::orientation::distance;
use super::rows::Point;
use super::{Action, FileError, scans};
use crate::curve::turn;
use crate::profile::longest_spacing;

/// Points nearer than this repeat each other (m).
const REPEATED: f64 = 1e-8;
/// Turns of a zig-zag, and the largest turn between short stretches (rad).
const ZIG_ZAG: f64 = 5.0 / 6.0 * PI;
const LARGEST_TURN: f64 = 2.0 / 3.0 * PI;
/// What is near on a measured profile (m).
pub(super) const REACH: f64 = 2e-3;

/// What is a true corner of a profile rather than its roughness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerSearch {
    /// A corner turns by more than this (rad),
    pub turn: f64,
    /// while its neighbours within the reach turn by less than this (rad).
    pub rest: f64,
    /// The reach (m), to both sides; zero makes every such turn a corner.
    pub reach: f64,
}

impl Default for CornerSearch {
    /// 30 and 6 degrees, and 2 mm.
    fn default() -> Self {
        Self { turn: PI / 6.0, rest: PI / 30.0, reach: REACH }
    }
}

/// Drops repeated points, takes zig-zags out; refuses what turns back or crosses itself.
pub(super) fn repaired(
    mut points: Vec<Point>,
    actions: &mut Vec<Action>,
) -> Result<Vec<Point>, FileError> {
    without_repeated(&mut points, actions);
    without_zig_zags(&mut points, actions);
    scans::without_overlaps(&mut points, actions)?;
    without_turns_back(&mut points, actions)?;
    without_repeated(&mut points, actions);
    match crossing(&points) {
        Some((line, other)) => Err(FileError::Crosses { line, other }),
        None if points.len() < 3 => {
            let line = points.last().map_or(1, |point| point.line);
            Err(FileError::Count { line, count: points.len() })
        }
        None => Ok(points),
    }
}

fn without_repeated(points: &mut Vec<Point>, actions: &mut Vec<Action>) {
    points.dedup_by(|next, kept| {
        let repeated = distance(next, kept) < REPEATED;
        if repeated {
            actions.push(Action::Repeated { line: next.line });
        }
        repeated
    });
}

/// Stitched scans go a little forth and back by two points: their mean takes their place.
fn without_zig_zags(points: &mut Vec<Point>, actions: &mut Vec<Action>) {
    let mut index = 1;
    while index + 2 < points.len() {
        let sharp = |i: usize| turn_at(points, i).abs() > ZIG_ZAG;
        let near = points.get(index).zip(points.get(index + 1));
        let near = near.is_some_and(|(a, b)| distance(a, b) < REACH);
        if !(near && sharp(index) && sharp(index + 1)) {
            index += 1;
            continue;
        }
        if let [first, second] = points[index..index + 2] {
            let mean = [0, 1].map(|axis| first.at[axis].midpoint(second.at[axis]));
            points.splice(index..index + 2, [Point { line: first.line, at: mean }]);
            actions.push(Action::ZigZag { line: first.line });
        }
    }
}

/// Scans go back here and there: of the points about a turn back the one without which the rest
/// turns least is dropped, as long as that closes no more than a short gap. Between long stretches it is a corner,
/// unless it turns as sharply as a zig-zag.
fn without_turns_back(points: &mut Vec<Point>, actions: &mut Vec<Action>) -> Result<(), FileError> {
    let most = 10 + points.len() / 50;
    for _ in 0..=most {
        let turns_back = |&i: &usize| {
            let turn = turn_at(points, i).abs();
            turn > ZIG_ZAG || (turn > LARGEST_TURN && droppable(points, i).next().is_some())
        };
        let Some(index) = (1..points.len().saturating_sub(1)).find(turns_back) else {
            return Ok(());
        };
        let sharpest = |i: usize| sharpest_without(points, i);
        let dropped = droppable(points, index).min_by(|&i, &j| sharpest(i).total_cmp(&sharpest(j)));
        let Some((i, point)) = dropped.and_then(|i| Some((i, *points.get(i)?))) else { break };
        actions.push(Action::TurnedBack { line: point.line });
        points.remove(i);
    }
    let back = (1..points.len()).find(|&i| turn_at(points, i).abs() > LARGEST_TURN).unwrap_or(0);
    let line = points.get(back).map_or(1, |point| point.line);
    Err(FileError::TurnsBack { line, turn: turn_at(points, back) })
}

/// The points about a turn without which no long gap is left.
fn droppable(points: &[Point], index: usize) -> impl Iterator<Item = usize> {
    let inner = 1..points.len().saturating_sub(1);
    (index.saturating_sub(1)..=index + 1)
        .filter(move |i| inner.contains(i) && reach(points, *i) < REACH)
}

/// Distance between the neighbours of a point.
fn reach(points: &[Point], index: usize) -> f64 {
    let neighbours = points.get(index.wrapping_sub(1)).zip(points.get(index + 1));
    neighbours.map_or(f64::INFINITY, |(a, b)| distance(a, b))
}

/// The sharpest turn about a point when it is left out.
fn sharpest_without(points: &[Point], index: usize) -> f64 {
    let start = index.saturating_sub(3);
    let around = points.iter().enumerate().skip(start).take(7);
    let left: Vec<Point> = around.filter(|(i, _)| *i != index).map(|(_, point)| *point).collect();
    (0..left.len()).map(|i| turn_at(&left, i).abs()).fold(0.0, f64::max)
}

/// Turn at an inner point (rad).
pub(super) fn turn_at(points: &[Point], index: usize) -> f64 {
    let [Some(a), Some(b), Some(c)] =
        [index.checked_sub(1), Some(index), Some(index + 1)].map(|i| points.get(i?))
    else {
        return 0.0;
    };
    let between = |a: &Point, b: &Point| [b.at[0] - a.at[0], b.at[1] - a.at[1]];
    turn(between(a, b), between(b, c))
}

/// Lines of two stretches that cross: sweeps over `y`, each stretch against those it overlaps.
fn crossing(points: &[Point]) -> Option<(usize, usize)> {
    let span = |i: usize| {
        let (a, b) = (points.get(i)?, points.get(i + 1)?);
        Some([a.at[0].min(b.at[0]), a.at[0].max(b.at[0])])
    };
    let mut order: Vec<(usize, [f64; 2])> =
        (0..points.len()).filter_map(|i| Some((i, span(i)?))).collect();
    order.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    for (place, (i, reach)) in order.iter().enumerate() {
        let later = order.iter().skip(place + 1).take_while(|(_, other)| other[0] <= reach[1]);
        for (j, _) in later {
            let (first, second) = (*i.min(j), *i.max(j));
            if second > first + 1 && cross(points, first, second) {
                let line = |i: usize| points.get(i).map_or(0, |point| point.line);
                return Some((line(second), line(first)));
            }
        }
    }
    None
}

/// Whether the stretches from points `i` and `j` cross.
fn cross(points: &[Point], i: usize, j: usize) -> bool {
    let [Some(a), Some(b), Some(c), Some(d)] = [i, i + 1, j, j + 1].map(|i| points.get(i)) else {
        return false;
    };
    let side = |a: &Point, b: &Point, c: &Point| {
        (b.at[0] - a.at[0]) * (c.at[1] - a.at[1]) - (b.at[1] - a.at[1]) * (c.at[0] - a.at[0])
    };
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Indices at which the curve is broken: true corners and the ends of gaps.
pub(super) fn corners(
    points: &[Point],
    search: CornerSearch,
    actions: &mut Vec<Action>,
) -> Vec<usize> {
    let spacings: Vec<f64> = points.windows(2).map(|pair| distance(&pair[0], &pair[1])).collect();
    let longest = longest_spacing(&spacings);
    let gap = |i: usize| {
        let length = points.get(i).zip(points.get(i + 1)).map_or(0.0, |(a, b)| distance(a, b));
        (length > longest).then_some(length)
    };
    let mut corners = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let before = index.checked_sub(1).and_then(gap);
        let inside = index > 0 && index + 1 < points.len();
        let turn = turn_at(points, index);
        if let Some(length) = before {
            actions.push(Action::Bridged { line: point.line, length });
        }
        if inside && (before.is_some() || gap(index).is_some()) {
            corners.push(index);
        } else if turn.abs() > search.turn && alone(points, index, search) {
            actions.push(Action::Corner { line: point.line, turn });
            corners.push(index);
        } else if turn.abs() > search.turn {
            actions.push(Action::Rough { line: point.line, turn });
        }
    }
    corners
}

/// Whether the neighbours of a point within reach hardly turn.
fn alone(points: &[Point], index: usize, search: CornerSearch) -> bool {
    let Some(point) = points.get(index) else { return false };
    let near =
        |i: &usize| points.get(*i).is_some_and(|other| distance(point, other) < search.reach);
    let before = (1..index).rev().take_while(near);
    let after = (index + 1..points.len()).take_while(near);
    before.chain(after).all(|i| turn_at(points, i).abs() < search.rest)
}
