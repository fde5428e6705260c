//! Normalization of a profile's points to the house's form: metres, `y` to the field side, `z` down, in the order of the
//! role. What the file says is looked at beside what the shape shows.

use super::rows::{Point, Raw, move_all};
use super::shape::{self, Shape, extent, level};
use super::{Action, FileError, ReadOptions, SaidBy};
use crate::Role;

/// Lengths that profiles have, that most have, and widths that all have at most (m).
const SANE: std::ops::RangeInclusive<f64> = 0.005..=0.5;
const USUAL: std::ops::RangeInclusive<f64> = 0.02..=0.5;
const WIDEST: f64 = 0.22;
/// Units that a file without one may have (m), each with the lengths by which it is known; where
/// inches make it too wide it is in centimetres.
const UNITS: [(f64, std::ops::RangeInclusive<f64>); 4] =
    [(1e-3, 40.0..=500.0), (0.0254, 1.6..=19.7), (0.01, 4.0..=50.0), (1.0, 0.04..=0.5)];
/// Points that a profile may have.
const POINT_COUNTS: std::ops::RangeInclusive<usize> = 3..=20_000;
/// Where a wheel's flange back lies unless a case says otherwise, by how much it may differ, how
/// far its tread may lie from `z = 0`, and anything from the origin, before that is told (m).
const FLANGE_BACK: f64 = -0.070;
const BACK: f64 = 0.030;
const LEVEL: f64 = 0.012;
const FAR: f64 = 0.1;

/// Width of a wheel's profile below which it may be a part that does not show what is down (m).
const LEAST_OF_WHEEL: f64 = 0.06;

/// Points in the house's form.
pub(super) struct Turned {
    pub(super) points: Vec<Point>,
    pub(super) role: Role,
    /// Length of the file's unit (m).
    pub(super) unit: f64,
}

/// Brings the points to the house's form; `ending` is the role that the file's name has.
pub(super) fn turned(
    raw: Raw,
    ending: Option<Role>,
    wanted: &ReadOptions,
    actions: &mut Vec<Action>,
) -> Result<Turned, FileError> {
    let mut points = raw.points;
    let (first, last) = (line(points.first()), line(points.last()));
    if !POINT_COUNTS.contains(&points.len()) {
        return Err(FileError::Count { line: last, count: points.len() });
    }
    let known = wanted.unit.or(raw.unit.filter(|_| raw.unit_is_said));
    let unit = unit(&points, known, raw.unit, actions)?;
    move_all(&mut points, |at| at.map(|value| value * unit));
    let [width, height] = [0, 1].map(|axis| extent(&points, axis)).map(|[low, high]| high - low);
    if height > width {
        return Err(FileError::Axes { line: first, width, height });
    }
    // What looks like a wheel upside down is a rail's head on a wide foot, if the file says so.
    let is_head_on_foot = |shape: &Shape| {
        shape.role() == Role::Wheel && raw.role == Some(Role::Rail) && raw.down == Some(shape.up())
    };
    let shape = Shape::of(&points).filter(|shape| !is_head_on_foot(shape));
    let role = role(shape, [wanted.role, raw.role, ending], first, actions)?;
    if !down(&points, role, shape, wanted.down, raw.down, actions)? {
        move_all(&mut points, |[y, z]| [y, -z]);
        actions.push(Action::TurnedOver);
    }
    if !to_field_side(&points, role, shape, [wanted.field_side, raw.field_side], actions)? {
        move_all(&mut points, |[y, z]| [-y, z]);
        actions.push(Action::Mirrored);
    }
    // By most of its steps: a scan of two passes may end beside where it began.
    let up = points.windows(2).filter(|pair| pair[1].at[0] > pair[0].at[0]).count();
    if (2 * up > points.len()) != (role == Role::Rail) {
        points.reverse();
        actions.push(Action::Reversed);
    }
    tell_origin(&points, role, shape, actions);
    Ok(Turned { points, role, unit })
}

fn line(point: Option<&Point>) -> usize {
    point.map_or(1, |point| point.line)
}

/// The unit (m): as known, else the format's if it makes a sane profile, else by the profile's
/// size.
fn unit(
    points: &[Point],
    known: Option<f64>,
    usual: Option<f64>,
    actions: &mut Vec<Action>,
) -> Result<f64, FileError> {
    let (length, line) = (length(points), line(points.first()));
    let [low, high] = extent(points, 0);
    let by_size = || {
        let fits = |(unit, lengths): &&(f64, std::ops::RangeInclusive<f64>)| {
            lengths.contains(&length) && unit * (high - low) <= WIDEST
        };
        UNITS.iter().find(fits).map(|(unit, _)| *unit)
    };
    if let Some(unit) = known.or(usual.filter(|unit| USUAL.contains(&(unit * length)))) {
        return check_length(unit * length, unit, line).map(|()| unit).map_err(
            |error| match error {
                FileError::Length { line, length, unit, .. } => {
                    FileError::Length { line, length, unit, fitting: by_size() }
                }
                other => other,
            },
        );
    }
    let metres = by_size().or(usual).unwrap_or(1.0);
    actions.push(Action::UnitFound { metres });
    check_length(metres * length, metres, line).map(|()| metres)
}

/// The length of a profile (m) must be sane.
pub(super) fn check_length(length: f64, unit: f64, line: usize) -> Result<(), FileError> {
    if SANE.contains(&length) {
        return Ok(());
    }
    Err(FileError::Length { line, length, unit, fitting: None })
}

pub(super) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| distance(&pair[0], &pair[1])).sum()
}

pub(super) fn distance(a: &Point, b: &Point) -> f64 {
    (b.at[0] - a.at[0]).hypot(b.at[1] - a.at[1])
}

/// The role: as asked for, said by the content or by the name's ending, else as the shape shows.
/// None of them may contradict a shape that shows it, but for what the asker has put right.
fn role(
    shape: Option<Shape>,
    said: [Option<Role>; 3],
    line: usize,
    actions: &mut Vec<Action>,
) -> Result<Role, FileError> {
    let by = [SaidBy::Asker, SaidBy::Content, SaidBy::Ending];
    let mut said = said.into_iter().zip(by).filter_map(|(role, by)| Some((role?, by)));
    let Some((role, by)) = said.next() else {
        let what = "whether it is a wheel or a rail";
        let role = shape.map(Shape::role).ok_or(FileError::Ask { line, what })?;
        actions.push(Action::RoleFound { role });
        return Ok(role);
    };
    if let Some(shown) = shape.map(Shape::role).filter(|shown| *shown != role) {
        return Err(FileError::Role { line, by, said: role, shown });
    }
    if said.any(|(other, _)| other != role) {
        actions.push(Action::RoleAsked { role });
    }
    Ok(role)
}

/// Whether `z` points down.
fn down(
    points: &[Point],
    role: Role,
    shape: Option<Shape>,
    asked: Option<bool>,
    usual: Option<bool>,
    actions: &mut Vec<Action>,
) -> Result<bool, FileError> {
    let line = line(points.first());
    let Some(shape) = shape else {
        // A part of a wheel may be its flange alone, which looks like a tread with a flange upside down.
        let [low, high] = extent(points, 0);
        let is_whole = role == Role::Rail || high - low > LEAST_OF_WHEEL;
        let found =
            asked.or(usual).or_else(|| shape::up(points).map(|up| !up).filter(|_| is_whole));
        return found.ok_or(FileError::Ask { line, what: "whether z points up or down" });
    };
    let down = !shape.up();
    if asked == Some(!down) {
        let said = if down { "z = up" } else { "z = down" };
        return Err(FileError::UpsideDown { line, said, role: shape.role() });
    }
    if usual == Some(!down) {
        actions.push(Action::AgainstFormat { what: "z" });
    }
    Ok(down)
}

/// Whether `y` grows to the field side: a wheel shows by its flange where the track is; a rail
/// does not show it, and what the format or the house holds goes into the report.
fn to_field_side(
    points: &[Point],
    role: Role,
    shape: Option<Shape>,
    [asked, convention]: [Option<bool>; 2],
    actions: &mut Vec<Action>,
) -> Result<bool, FileError> {
    let line = line(points.first());
    if let Some(Shape::Wheel { low, .. }) = shape {
        if asked == Some(!low) {
            let said = if low { "y = track-side" } else { "y = field-side" };
            return Err(FileError::FlangeOutside { line, said });
        }
        return Ok(low);
    }
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
        None => Err(FileError::Ask { line, what: "on which side of the wheel the flange is" }),
    }
}

/// Tells where the running surface lies if that is far from where cases take it to be.
fn tell_origin(points: &[Point], role: Role, shape: Option<Shape>, actions: &mut Vec<Action>) {
    let [inner, outer] = extent(points, 0);
    let z = level(points, 0.5);
    let off = match (role, shape) {
        (Role::Wheel, Some(_)) => z.abs() > LEVEL || (inner - FLANGE_BACK).abs() > BACK,
        (Role::Wheel, None) => z.abs() > FAR,
        (Role::Rail, _) => z.abs() > FAR || inner > FAR || outer < -FAR,
    };
    if off {
        let y = if role == Role::Wheel { inner } else { inner.midpoint(outer) };
        actions.push(Action::FarOrigin { role, y, z });
    }
}
