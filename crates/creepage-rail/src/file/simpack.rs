//! Reader of Simpack's files: keys and points in blocks, and what the keys ask to be done to the points.

use super::rows::{Point, Raw, last_line, lines, move_all, numbers};
use super::{Action, FileError};
use crate::Role;

/// First words of keys that say what is to be done to the points.
const SHAPING: [&str; 15] = [
    "shift",
    "rotate",
    "rotation",
    "rot",
    "scale",
    "factor",
    "bound",
    "clip",
    "trim",
    "mirror",
    "inversion",
    "invert",
    "point",
    "units",
    "offset",
];

/// Numbers of the spline block, by their keys.
#[derive(Debug, Clone, Copy)]
struct Keys {
    least_distance: f64,
    shift: [f64; 2],
    rotate: f64,
    bounds: [[Option<f64>; 2]; 2],
    mirror: [bool; 2],
    invert: bool,
    /// The file's units in a metre and in a radian.
    lengths: f64,
    angles: f64,
}

pub(super) fn parse(text: &str) -> Result<Raw, FileError> {
    let mut raw = Raw { field_side: Some(true), down: Some(true), ..Raw::default() };
    let mut keys = Keys {
        least_distance: 0.0,
        shift: [0.0; 2],
        rotate: 0.0,
        bounds: [[None; 2]; 2],
        mirror: [false; 2],
        invert: false,
        lengths: 1.0,
        angles: 1.0,
    };
    let mut inside = false;
    let mut ended = false;
    let mut skipped = 0;
    for (line, row) in lines(text) {
        let row = without_comment(row);
        match row {
            "" => {}
            "point.begin" => inside = true,
            "point.end" => (inside, ended) = (false, true),
            // Programs beside Simpack take points out by other marks.
            _ if inside && row.starts_with(['%', '#']) => skipped += 1,
            _ if inside => raw.points.push(point(line, row)?),
            _ => key(line, row, &mut keys, &mut raw)?,
        }
    }
    if !ended {
        return Err(FileError::Missing { line: last_line(text), block: "point.end" });
    }
    (raw.unit, raw.unit_is_said) = (Some(1.0 / keys.lengths), true);
    if skipped > 0 {
        raw.actions.push(Action::Skipped { count: skipped });
    }
    keys.apply(&mut raw);
    Ok(raw)
}

/// The part before a `!` that stands outside of quotes.
fn without_comment(row: &str) -> &str {
    let mut quoted = false;
    let end = row.char_indices().find(|&(_, c)| {
        quoted ^= c == '\'';
        c == '!' && !quoted
    });
    row.get(..end.map_or(row.len(), |(index, _)| index)).unwrap_or("").trim()
}

fn point(line: usize, row: &str) -> Result<Point, FileError> {
    match *numbers(line, row)? {
        [y, z] | [y, z, _] => Ok(Point { line, at: [y, z] }),
        ref row => Err(FileError::Columns { line, found: row.len(), wanted: 2 }),
    }
}

/// One `key = value`.
fn key(line: usize, row: &str, keys: &mut Keys, raw: &mut Raw) -> Result<(), FileError> {
    let Some((key, value)) = row.split_once('=') else { return Ok(()) };
    let number = |key: &'static str| -> Result<f64, FileError> {
        let value = value.trim().parse().ok().filter(|value: &f64| value.is_finite());
        value.ok_or(FileError::Key { line, key })
    };
    let positive = |key: &'static str| {
        number(key)
            .and_then(|value| (value > 1e-9).then_some(value).ok_or(FileError::Key { line, key }))
    };
    let switch = |key: &'static str| Ok::<bool, FileError>(number(key)?.abs() > 0.5);
    match key.trim() {
        "type" if raw.role.is_none() => {
            raw.role = Some(if switch("type")? { Role::Wheel } else { Role::Rail });
        }
        "point.dist.min" => keys.least_distance = number("point.dist.min")?,
        "shift.y" => keys.shift[0] = number("shift.y")?,
        "shift.z" => keys.shift[1] = number("shift.z")?,
        "rotate" => keys.rotate = number("rotate")?,
        "bound.y.min" => keys.bounds[0][0] = Some(number("bound.y.min")?),
        "bound.y.max" => keys.bounds[0][1] = Some(number("bound.y.max")?),
        "bound.z.min" => keys.bounds[1][0] = Some(number("bound.z.min")?),
        "bound.z.max" => keys.bounds[1][1] = Some(number("bound.z.max")?),
        "mirror.y" => keys.mirror[0] = switch("mirror.y")?,
        "mirror.z" => keys.mirror[1] = switch("mirror.z")?,
        "inversion" => keys.invert = switch("inversion")?,
        "units.len.f" => keys.lengths = positive("units.len.f")?,
        "units.ang.f" => keys.angles = positive("units.ang.f")?,
        "approx.smooth" if number("approx.smooth")?.abs() > 0.0 => {
            raw.actions.push(Action::Ignored { line, what: "approx.smooth" });
        }
        "approx.smooth" | "type" | "version" | "file" | "file.mtime" | "comment" | "units.len"
        | "units.ang" => {}
        key if key.starts_with("meas.") => {}
        key => unknown(line, key, value, raw)?,
    }
    Ok(())
}

/// A key that is not known: it has no effect, and must not be one that changes the shape.
fn unknown(line: usize, key: &str, value: &str, raw: &mut Raw) -> Result<(), FileError> {
    let stem = key.split(['.', '_']).next().unwrap_or(key);
    let neutral = if stem == "scale" { 1.0 } else { 0.0 };
    let has_effect = value
        .trim()
        .parse::<f64>()
        .map_or(true, |value| (value - neutral).abs() > f64::MIN_POSITIVE || !value.is_finite());
    if has_effect && SHAPING.contains(&stem) {
        return Err(FileError::UnknownKey { line, key: key.into() });
    }
    raw.actions.push(Action::UnknownKey { line, key: key.into() });
    Ok(())
}

impl Keys {
    /// In Simpack's order: thin, shift, rotate, clip, mirror, invert.
    fn apply(self, raw: &mut Raw) {
        let mut done = |what: &'static str, applies: bool| {
            if applies {
                raw.actions.push(Action::Applied { what });
            }
            applies
        };
        let points = &mut raw.points;
        if done("point.dist.min", self.least_distance > 0.0) {
            thin(points, self.least_distance);
        }
        if done("shift", self.shift.iter().any(|shift| shift.abs() > 0.0)) {
            let [y, z] = self.shift;
            move_all(points, |at| [at[0] + y, at[1] + z]);
        }
        if done("rotate", self.rotate.abs() > 0.0) {
            let (sin, cos) = (self.rotate / self.angles).sin_cos();
            let turned = |[y, z]: [f64; 2]| [cos * y - sin * z, sin * y + cos * z];
            move_all(points, turned);
        }
        for (axis, bounds) in self.bounds.into_iter().enumerate() {
            let [least, most] = [(0, f64::NEG_INFINITY), (1, f64::INFINITY)]
                .map(|(end, none)| bounds[end].unwrap_or(none));
            // Bounds the wrong way round mean none.
            let count = points.len();
            if least <= most {
                points.retain(|point| (least..=most).contains(&point.at[axis]));
            }
            done("bound", points.len() < count);
        }
        if done("mirror.y", self.mirror[0]) {
            move_all(points, |[y, z]| [-y, z]);
        }
        if done("mirror.z", self.mirror[1]) {
            move_all(points, |[y, z]| [y, -z]);
        }
        if done("inversion", self.invert) {
            points.reverse();
        }
    }
}

/// Drops points nearer than `least` to the one kept before.
fn thin(points: &mut Vec<Point>, least: f64) {
    points.dedup_by(|next, kept| (next.at[0] - kept.at[0]).hypot(next.at[1] - kept.at[1]) < least);
}
