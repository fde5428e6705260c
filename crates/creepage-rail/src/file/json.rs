//! Reader of JSON: arrays of points, or an array for each coordinate, anywhere in it.

use serde_json::{Map, Value};

use super::FileError;
use super::miniprof::unit;
use super::rows::{LARGEST, Point, Raw};
use crate::Role;

/// Nothing is deeper in the files that are read.
const DEPTH: usize = 6;

pub(super) fn parse(text: &str) -> Result<Raw, FileError> {
    let wrong = |error: serde_json::Error| FileError::Json {
        line: error.line().max(1),
        what: "it is no valid JSON",
    };
    let value: Value = serde_json::from_str(text).map_err(wrong)?;
    let mut raw = Raw::default();
    let mut found = Vec::new();
    walk(&value, DEPTH, &mut raw, &mut found);
    match found.len() {
        1 => raw.points = found.swap_remove(0),
        0 => {
            let what = "an array of pairs, or arrays y and z of one length, are read";
            return Err(FileError::Json { line: 1, what });
        }
        _ => return Err(FileError::Json { line: 1, what: "several profiles in one file" }),
    }
    let is_length = |value: &f64| value.is_nan() || value.abs() <= LARGEST;
    match raw.points.iter().flat_map(|point| point.at).find(|value| !is_length(value)) {
        Some(value) => Err(FileError::NotALength { line: 1, column: 1, value }),
        None => Ok(raw),
    }
}

fn walk(value: &Value, depth: usize, raw: &mut Raw, found: &mut Vec<Vec<Point>>) {
    if depth == 0 {
        return;
    }
    match value {
        Value::Array(rows) => match pairs(rows) {
            Some(points) => found.push(points),
            None => rows.iter().for_each(|row| walk(row, depth - 1, raw, found)),
        },
        Value::Object(object) => {
            said(object, raw);
            match columns(object, raw) {
                Some(points) => found.push(points),
                None => object.values().for_each(|value| walk(value, depth - 1, raw, found)),
            }
        }
        _ => {}
    }
}

/// Role and unit, where they are said in words.
fn said(object: &Map<String, Value>, raw: &mut Raw) {
    for (key, value) in object {
        let (key, Some(value)) = (key.to_lowercase(), value.as_str()) else { continue };
        let role = match value.to_lowercase().as_str() {
            "wheel" => Some(Role::Wheel),
            "rail" => Some(Role::Rail),
            _ => None,
        };
        raw.role = raw.role.or(role);
        if key.contains("unit")
            && let Some(unit) = unit(value)
        {
            (raw.unit, raw.unit_is_said) = (Some(unit), true);
        }
    }
}

/// An array of `[y, z]`, or of objects of both.
fn pairs(rows: &[Value]) -> Option<Vec<Point>> {
    let point = |row: &Value| {
        let at = match row {
            Value::Array(pair) => match pair.as_slice() {
                [y, z] => [number(y)?, number(z)?],
                _ => return None,
            },
            Value::Object(object) => {
                let [y, z, _] = keys(object)?;
                [number(object.get(y)?)?, number(object.get(z)?)?]
            }
            _ => return None,
        };
        Some(Point { line: 1, at })
    };
    let points: Option<Vec<Point>> = rows.iter().map(point).collect();
    points.filter(|points| !points.is_empty())
}

/// An array of `y` and one of `z`, of one length.
fn columns(object: &Map<String, Value>, raw: &mut Raw) -> Option<Vec<Point>> {
    let [y, z, named] = keys(object)?;
    let [y, z] = [y, z].map(|key| object.get(key).and_then(Value::as_array));
    let (y, z) = (y?, z?);
    if y.len() != z.len() || y.is_empty() {
        return None;
    }
    let rows = y.iter().zip(z);
    let points: Option<Vec<Point>> =
        rows.map(|(y, z)| Some(Point { line: 1, at: [number(y)?, number(z)?] })).collect();
    if points.is_some()
        && let Some(unit) = unit(named)
    {
        (raw.unit, raw.unit_is_said) = (Some(unit), true);
    }
    points
}

/// The keys of both coordinates, and the unit that they name: `y` and `z`, `lateral` and `vertical`
/// with or without one, else `x` and `y`.
fn keys(object: &Map<String, Value>) -> Option<[&str; 3]> {
    let named = |wanted: &str| {
        object.keys().find_map(|key| {
            let (stem, unit) = key.split_once('_').unwrap_or((key, ""));
            (stem.to_lowercase() == wanted).then_some((key.as_str(), unit))
        })
    };
    let pair = [["y", "z"], ["lateral", "vertical"], ["x", "y"]];
    pair.iter().find_map(|[y, z]| {
        let ((y, unit), (z, _)) = (named(y)?, named(z)?);
        Some([y, z, unit])
    })
}

/// A number; null where nothing was measured.
fn number(value: &Value) -> Option<f64> {
    if value.is_null() { Some(f64::NAN) } else { value.as_f64() }
}
