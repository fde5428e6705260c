//! Outlines of whole rails, of which the head is taken.

use super::orientation::{distance, length};
use super::rows::Point;
use super::shape::extent;
use super::{Action, FileError};
use crate::Role;

/// Ends of a closed outline are no further apart than this part of its length, or than two of its
/// stretches.
const CLOSED: f64 = 0.02;
/// Of the outline's height, the parts by which foot and head are known.
const ENDS: [f64; 2] = [0.03, 0.97];
/// An outline comes back under the head by this part of its height.
const BACK: f64 = 0.01;

/// The head of a closed outline in any unit, in order; anything else as it is.
pub(super) fn opened(
    points: Vec<Point>,
    role: Option<Role>,
    actions: &mut Vec<Action>,
) -> Result<Vec<Point>, FileError> {
    let Some((first, last)) = points.first().zip(points.last()) else { return Ok(points) };
    let [width, height] = [0, 1].map(|axis| extent(&points, axis)).map(|[low, high]| high - low);
    let all = length(&points);
    let near = distance(first, last) <= (CLOSED * all).min(2.0 * longest(&points));
    if !near || all < 2.0 * width.max(height) || points.len() < 12 {
        return Ok(points);
    }
    if role == Some(Role::Wheel) {
        return Err(FileError::Outline { line: first.line });
    }
    let head = head(&points, height);
    // Both sides meet again where nothing turns back: no rail.
    let Some(count) = points.len().checked_sub(head.len()) else { return Ok(points) };
    actions.push(Action::Outline { count });
    Ok(head)
}

fn longest(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| distance(&pair[0], &pair[1])).fold(0.0, f64::max)
}

/// From the crown down both sides to where they turn back under the head.
fn head(points: &[Point], height: f64) -> Vec<Point> {
    let [low, high] = extent(points, 1);
    // The foot is wider and flatter than the head.
    let span = |inside: &dyn Fn(f64) -> bool| {
        let inside: Vec<Point> = points.iter().filter(|p| inside(p.at[1])).copied().collect();
        let [from, to] = extent(&inside, 0);
        to - from
    };
    let [below, above] = ENDS.map(|part| low + part * (high - low));
    let is_up = span(&|z| z <= below) > span(&|z| z >= above);
    let up = |point: &Point| if is_up { point.at[1] } else { -point.at[1] };
    let top = points.iter().map(up).fold(f64::NEG_INFINITY, f64::max);
    // The crown may be a line: its middle.
    let crown: Vec<Point> =
        points.iter().filter(|point| up(point) > top - 1e-3 * height).copied().collect();
    let [from, to] = extent(&crown, 0);
    let off = |point: &Point| (point.at[0] - from.midpoint(to)).abs();
    let mut start = (0, f64::INFINITY);
    for (index, point) in points.iter().enumerate() {
        if up(point) > top - 1e-3 * height && off(point) < start.1 {
            start = (index, off(point));
        }
    }
    let middle = points.get(start.0).map_or(0.0, |point| point.at[0]);
    let (before, after) = points.split_at(start.0);
    let around: Vec<Point> = after.iter().chain(before).copied().collect();
    let one = side(around.iter(), middle, BACK * height);
    let other = side(around.iter().take(1).chain(around.iter().rev()), middle, BACK * height);
    one.into_iter().rev().chain(other.into_iter().skip(1)).collect()
}

/// The points of one side as far as it is widest, once it has come back by more than `back`.
fn side<'a>(walk: impl Iterator<Item = &'a Point>, middle: f64, back: f64) -> Vec<Point> {
    let mut side: Vec<Point> = Vec::new();
    let (mut widest, mut count) = (0.0, 1);
    for point in walk {
        let out = (point.at[0] - middle).abs();
        side.push(*point);
        if out >= widest {
            (widest, count) = (out, side.len());
        } else if out < widest - back {
            break;
        }
    }
    side.truncate(count);
    side
}
