//! Points brought to the house's form: metres, `y` to the field side, `z` down, in the order of
//! the role. What the file does not say is found in the shape.

use super::rows::{Point, Raw, move_all};
use super::{Action, FileError, Wanted};
use crate::Role;

/// Lengths that profiles have (m).
const SANE: std::ops::RangeInclusive<f64> = 0.02..=0.5;
/// Units that a file without one may have (m), each with the lengths by which it is known: they
/// exclude each other.
const UNITS: [(f64, std::ops::RangeInclusive<f64>); 3] =
    [(1e-3, 40.0..=500.0), (0.0254, 1.6..=19.7), (1.0, 0.04..=0.5)];
/// Points that a profile may have.
const POINTS: std::ops::RangeInclusive<usize> = 3..=20_000;

/// The points in the house's form, and the length of their unit (m).
pub(super) fn turned(
    raw: Raw,
    role: Role,
    wanted: &Wanted,
    actions: &mut Vec<Action>,
) -> Result<(Vec<Point>, f64), FileError> {
    let mut points = raw.points;
    let (first, last) = (line(points.first()), line(points.last()));
    if !POINTS.contains(&points.len()) {
        return Err(FileError::Count { line: last, count: points.len() });
    }
    let unit = unit(&points, wanted.unit.or(raw.unit), first, actions)?;
    move_all(&mut points, |at| at.map(|value| value * unit));
    let [width, height] = [0, 1].map(|axis| extent(&points, axis)).map(|[low, high]| high - low);
    if height > width {
        return Err(FileError::Axes { line: first, width, height });
    }
    if !down(&points, wanted.down.or(raw.down))? {
        move_all(&mut points, |[y, z]| [y, -z]);
        actions.push(Action::TurnedOver);
    }
    if !to_field_side(&points, role, wanted.field_side, raw.field_side, actions)? {
        move_all(&mut points, |[y, z]| [-y, z]);
        actions.push(Action::Mirrored);
    }
    let rises = points.first().zip(points.last()).is_some_and(|(a, b)| b.at[0] > a.at[0]);
    if rises != (role == Role::Rail) {
        points.reverse();
        actions.push(Action::Reversed);
    }
    Ok((points, unit))
}

fn line(point: Option<&Point>) -> usize {
    point.map_or(1, |point| point.line)
}

/// The unit (m): as known, else by the profile's length; either must make a sane profile.
fn unit(
    points: &[Point],
    known: Option<f64>,
    line: usize,
    actions: &mut Vec<Action>,
) -> Result<f64, FileError> {
    let length = length(points);
    let unit = known.unwrap_or_else(|| {
        let found = UNITS.iter().find(|(_, lengths)| lengths.contains(&length));
        let metres = found.map_or(1.0, |&(unit, _)| unit);
        actions.push(Action::UnitFound { metres });
        metres
    });
    check_length(unit * length, unit, line).map(|()| unit)
}

/// The length of a profile (m) must be sane.
pub(super) fn check_length(length: f64, unit: f64, line: usize) -> Result<(), FileError> {
    if SANE.contains(&length) {
        return Ok(());
    }
    Err(FileError::Length { line, length, unit })
}

pub(super) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| distance(&pair[0], &pair[1])).sum()
}

pub(super) fn distance(a: &Point, b: &Point) -> f64 {
    (b.at[0] - a.at[0]).hypot(b.at[1] - a.at[1])
}

fn extent(points: &[Point], axis: usize) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    points
        .iter()
        .fold(start, |[low, high], point| [low.min(point.at[axis]), high.max(point.at[axis])])
}

/// Whether `z` points down. The running surface is wide and level; what departs from it far and
/// has some width is the corners of a rail or the flange of a wheel, and both go down.
fn down(points: &[Point], known: Option<bool>) -> Result<bool, FileError> {
    if let Some(known) = known {
        return Ok(known);
    }
    let [low, level, high] = [0.03, 0.5, 0.97].map(|part| level(points, part));
    let (above, below) = (level - low, high - level);
    if below > 1.5 * above {
        return Ok(true);
    }
    if above > 1.5 * below {
        return Ok(false);
    }
    let line = line(points.first());
    Err(FileError::Ask { line, what: "whether z points up or down" })
}

/// The `z` below which a part of the profile lies, each stretch counted by its width.
fn level(points: &[Point], part: f64) -> f64 {
    let mut stretches: Vec<(f64, f64)> = points
        .windows(2)
        .map(|pair| (pair[0].at[1].midpoint(pair[1].at[1]), (pair[1].at[0] - pair[0].at[0]).abs()))
        .collect();
    stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
    let wanted = part * stretches.iter().map(|stretch| stretch.1).sum::<f64>();
    let mut passed = 0.0;
    let found = stretches.iter().find(|stretch| {
        passed += stretch.1;
        passed >= wanted
    });
    found.map_or(0.0, |stretch| stretch.0)
}

/// Whether `y` grows to the field side: a wheel shows by its flange where the track is; a rail
/// does not show it, and what the format or the house holds goes into the report.
fn to_field_side(
    points: &[Point],
    role: Role,
    asked: Option<bool>,
    convention: Option<bool>,
    actions: &mut Vec<Action>,
) -> Result<bool, FileError> {
    if let Some(asked) = asked {
        return Ok(asked);
    }
    if role == Role::Rail {
        let what = "y of the rail to the field side";
        return Ok(convention.unwrap_or_else(|| {
            actions.push(Action::Assumed { what });
            true
        }));
    }
    let tip = points.iter().max_by(|a, b| a.at[1].total_cmp(&b.at[1]));
    let tip = tip.map_or([0.0; 2], |point| point.at);
    let [inner, outer] = extent(points, 0);
    let part = (tip[0] - inner) / (outer - inner);
    let flange = tip[1] - level(points, 0.5) > 0.010;
    match convention {
        _ if flange && part < 0.4 => Ok(true),
        _ if flange && part > 0.6 => Ok(false),
        Some(known) => Ok(known),
        None => {
            let line = line(points.first());
            Err(FileError::Ask { line, what: "on which side of the wheel the flange is" })
        }
    }
}
