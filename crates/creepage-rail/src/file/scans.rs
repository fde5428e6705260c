//! Removal of scanner artefacts: values that are no numbers, spikes, parts measured twice.

use super::orientation::{distance, length};
use super::repair::{REACH, turn_at};
use super::rows::Point;
use super::shape::extent;
use super::{Action, FileError};

/// A spike turns by more than the first, and without it its neighbours turn by less than the
/// second (rad); each of them turns by more than that part of it.
const SPIKE: f64 = std::f64::consts::PI / 6.0;
const WITHOUT: f64 = std::f64::consts::PI / 9.0;
const SHARE: f64 = 0.15;
/// A scan that goes back turns by more than this (rad).
const BACK: f64 = 2.0 / 3.0 * std::f64::consts::PI;
/// Two passes over one part lie no further apart (m).
const PASSES: f64 = 2e-4;

/// Drops points without a number.
pub(super) fn measured(points: &mut Vec<Point>, actions: &mut Vec<Action>) {
    points.retain(|point| {
        let is_measured = point.at.iter().all(|value| value.is_finite());
        if !is_measured {
            actions.push(Action::Unmeasured { line: point.line });
        }
        is_measured
    });
}

/// Points further from the middle ones than this times the width and height of these are no part of the profile.
const OUTSIDE: f64 = 4.0;
/// One point of so many at either end of a coordinate may be such.
const ONE_POINT_OF: usize = 50;

/// Drops points far from all others, in any unit.
pub(super) fn without_outliers(points: &mut Vec<Point>, actions: &mut Vec<Action>) {
    let range = |axis: usize| {
        let mut values: Vec<f64> = points.iter().map(|point| point.at[axis]).collect();
        values.sort_by(f64::total_cmp);
        let few = values.len().div_ceil(ONE_POINT_OF);
        Some([*values.get(few)?, *values.get(values.len().checked_sub(few + 1)?)?])
    };
    let Some((y, z)) = range(0).zip(range(1)) else { return };
    let reach = OUTSIDE * (y[1] - y[0]).max(z[1] - z[0]);
    let is_far = |value: f64, [low, high]: [f64; 2]| value < low - reach || value > high + reach;
    points.retain(|point| {
        let is_outlier = reach > 0.0 && (is_far(point.at[0], y) || is_far(point.at[1], z));
        if is_outlier {
            actions.push(Action::Outlier { line: point.line, at: point.at });
        }
        !is_outlier
    });
}

/// Times the width and height of points that the line through them may be long; once around a whole rail is 2.
const LONGEST: f64 = 10.0;

/// Refuses points that follow each other in no order, in any unit.
pub(super) fn in_order(points: &[Point]) -> Result<(), FileError> {
    let size: f64 =
        [0, 1].iter().map(|&axis| extent(points, axis)).map(|[low, high]| high - low).sum();
    let times = length(points) / size;
    match points.first() {
        Some(first) if times > LONGEST => Err(FileError::Disorder { line: first.line, times }),
        _ => Ok(()),
    }
}

/// Drops single points that stand out of a smooth line, in any unit.
pub(super) fn without_spikes(points: &mut Vec<Point>, actions: &mut Vec<Action>) {
    let mut dropped = 0;
    let mut index = 1;
    while index + 1 < points.len() {
        if let Some(height) = spike(points, index) {
            let line = points.get(index).map_or(0, |point| point.line);
            actions.push(Action::Spike { line, point: index + dropped + 1, height });
            points.remove(index);
            dropped += 1;
        }
        index += 1;
    }
}

/// How far a point stands out, if it is a spike.
fn spike(points: &[Point], index: usize) -> Option<f64> {
    let turn = turn_at(points, index).abs();
    if turn < SPIKE {
        return None;
    }
    let beside = [index.checked_sub(1)?, index + 1];
    let start = index.saturating_sub(2);
    let without: Vec<Point> = [start, beside[0], beside[1], index + 2]
        .iter()
        .filter_map(|i| points.get(*i))
        .copied()
        .collect();
    let without = if start == beside[0] { &without[1..] } else { &without[..] };
    let is_smooth = (0..without.len()).all(|i| turn_at(without, i).abs() < WITHOUT);
    let inner = beside.iter().filter(|i| **i > 0 && **i + 1 < points.len());
    let mut turns = inner.map(|i| turn_at(points, *i).abs()).peekable();
    let is_bent = turns.peek().is_some() && turns.all(|beside| beside > SHARE * turn);
    let [a, b, c] = [points.get(beside[0])?, points.get(index)?, points.get(beside[1])?];
    (is_smooth && is_bent && without.len() > 2).then(|| off_line(b, a, c))
}

/// Drops what a scan measures again after it went back; `points` in metres.
pub(super) fn without_overlaps(
    points: &mut Vec<Point>,
    actions: &mut Vec<Action>,
) -> Result<(), FileError> {
    first_pass_first(points, actions);
    let mut index = 1;
    while index + 1 < points.len() {
        if turn_at(points, index).abs() > BACK && (jumps(points, index) || retraces(points, index))
        {
            drop_again(points, index, actions)?;
        }
        index += 1;
    }
    Ok(())
}

/// Whether the next point is far away.
fn jumps(points: &[Point], index: usize) -> bool {
    let pair = points.get(index).zip(points.get(index + 1));
    pair.is_some_and(|(a, b)| distance(a, b) > REACH)
}

/// Brings two passes into the order of the profile, where the second one leads up to where the first begins.
fn first_pass_first(points: &mut [Point], actions: &mut Vec<Action>) {
    // The end of a flange is steep: the turn back may be behind the jump.
    let turns = |index: usize| turn_at(points, index).abs() > BACK;
    let goes_back = |at: &usize| jumps(points, *at) && (turns(*at) || turns(*at + 1));
    let mut back = (1..points.len().saturating_sub(1)).filter(goes_back);
    let (Some(index), None) = (back.next(), back.next()) else { return };
    let (one, other) = points.split_at(index + 1);
    let ([begin, .., end], [start, .., last]) = (one, other) else { return };
    let is_on = |point: &Point, way: &[Point]| off_way(point, way) < 10.0 * PASSES;
    let leads_up = is_on(begin, other) || distance(last, begin) <= REACH;
    if leads_up && !is_on(end, other) && !is_on(start, one) {
        actions.push(Action::PassesSwapped { line: start.line });
        points.rotate_left(index + 1);
    }
}

/// Whether at least three points after a turn back lie on the way there.
fn retraces(points: &[Point], index: usize) -> bool {
    let (before, after) = points.split_at(index + 1);
    after.len() > 2 && after.iter().take(3).all(|point| off_way(point, before) < 0.1 * PASSES)
}

/// Drops the points after `index` that lie on the way up to it.
fn drop_again(
    points: &mut Vec<Point>,
    index: usize,
    actions: &mut Vec<Action>,
) -> Result<(), FileError> {
    let (before, after) = points.split_at((index + 1).min(points.len()));
    let line = after.first().map_or(0, |point| point.line);
    let Some(Direction { from, to }) = Direction::at(before) else { return Ok(()) };
    // Up to half a stretch beyond the first pass: nearer to its end, a small offset is a step.
    let along = |a: [f64; 2]| (0..2).map(|i| (a[i] - to[i]) * (to[i] - from[i])).sum::<f64>();
    let beyond = |point: &Point| along(point.at) > -0.5 * along(from);
    let off: Vec<f64> = after
        .iter()
        .take_while(|point| !beyond(point))
        .map(|point| off_way(point, before))
        .take_while(|off| *off < 10.0 * PASSES)
        .collect();
    let apart = off.iter().copied().fold(0.0, f64::max);
    if off.is_empty() {
        return Ok(());
    }
    if apart > PASSES {
        return Err(FileError::Overlap { line, apart });
    }
    actions.push(Action::Overlap { line, count: off.len(), apart });
    points.drain(index + 1..index + 1 + off.len());
    Ok(())
}

/// The last stretch of a way.
struct Direction {
    from: [f64; 2],
    to: [f64; 2],
}

impl Direction {
    fn at(way: &[Point]) -> Option<Self> {
        let [.., from, to] = way else { return None };
        Some(Self { from: from.at, to: to.at })
    }
}

/// Distance from a line of points.
fn off_way(point: &Point, way: &[Point]) -> f64 {
    way.windows(2).map(|pair| off_line(point, &pair[0], &pair[1])).fold(f64::INFINITY, f64::min)
}

/// Distance of a point from a stretch.
fn off_line(point: &Point, a: &Point, b: &Point) -> f64 {
    let along = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
    let to = [point.at[0] - a.at[0], point.at[1] - a.at[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let part = if square > 0.0 { (along[0] * to[0] + along[1] * to[1]) / square } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (to[0] - part * along[0]).hypot(to[1] - part * along[1])
}
