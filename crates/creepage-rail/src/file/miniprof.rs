//! Reader of `MiniProf`: `Key=Value` lines or an older heading, an empty line, then columns, in mm.

use super::rows::{Point, Raw, fields, has_words, last_line, lines, number, numbers, uncommented};
use super::{Action, FileError, segments};
use crate::Role;

/// Whether a line reads `Key=Value`.
pub(super) fn is_key(line: &str) -> bool {
    line.split_once('=').is_some_and(|(key, _)| key.trim().starts_with(char::is_alphabetic))
}

pub(super) fn parse(text: &str) -> Result<Raw, FileError> {
    let mut raw = Raw { unit: Some(1e-3), field_side: Some(false), ..Raw::default() };
    raw.actions.push(Action::Assumed { what: "MiniProf: mm, y of rails to the track side" });
    let mut columns = [0, 1];
    let mut promised = None;
    let mut pieces = Vec::new();
    let mut rows = lines(text);
    for (line, row) in rows.by_ref() {
        if row.trim().is_empty() {
            break;
        }
        raw.role = raw.role.or_else(|| titled(row));
        let Some((key, value)) = row.split_once('=') else { continue };
        match key.trim().trim_matches('"').to_lowercase().as_str() {
            "columndef" => columns = places(line, value)?,
            "xypoints" => promised = Some(count(line, value)?),
            "units" | "unit" | "lengthunit" => {
                raw.unit = Some(unit(value).ok_or(FileError::Key { line, key: "Units" })?);
                raw.unit_is_said = true;
            }
            "xoffset" | "yoffset" if !is_nought(value) => {
                raw.actions.push(Action::Ignored { line, what: "an offset" });
            }
            key if is_segment(key) => pieces.push(segments::segment(line, value)?),
            _ => {}
        }
    }
    let skipped = points(&mut raw, rows, columns, promised)?;
    if raw.points.is_empty() && !pieces.is_empty() {
        raw.actions.push(Action::Segments { count: pieces.len() });
        raw.points = segments::chain(pieces)?;
    } else if raw.points.is_empty() && skipped == 0 {
        // Nothing parts the heading from the data.
        let is_data = |(line, row): &(usize, &str)| {
            numbers(*line, row)
                .is_ok_and(|row| row.len() > 1 && row.len() > columns[0].max(columns[1]))
        };
        points(&mut raw, lines(text).skip_while(|row| !is_data(row)), columns, promised)?;
    }
    let enough = promised.is_none_or(|promised| raw.points.len() + skipped >= promised);
    if raw.points.is_empty() || !enough && skipped + raw.points.len() > 0 && !by_segments(&raw) {
        return Err(FileError::Missing { line: last_line(text), block: "a point" });
    }
    Ok(raw)
}

fn by_segments(raw: &Raw) -> bool {
    raw.actions.iter().any(|action| matches!(action, Action::Segments { .. }))
}

/// `mpd1`, `mpd2` ...; `mpdc` is their count and `mpdn` a name.
fn is_segment(key: &str) -> bool {
    key.strip_prefix("mpd").is_some_and(|number| number.parse::<u32>().is_ok())
}

/// Length of a unit by its name (m).
pub(super) fn unit(name: &str) -> Option<f64> {
    match name.trim().trim_matches(['"', '\'']).to_lowercase().as_str() {
        "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => Some(1e-3),
        "in" | "inch" | "inches" => Some(0.0254),
        "cm" | "centimetre" | "centimetres" | "centimeter" | "centimeters" => Some(0.01),
        "m" | "metre" | "metres" | "meter" | "meters" => Some(1.0),
        _ => None,
    }
}

/// Sections of `[FileInfo]` and one of points each, as newer programs write several profiles.
pub(super) fn sections(text: &str) -> Result<Raw, FileError> {
    let mut raw = Raw { unit: Some(1e-3), field_side: Some(false), ..Raw::default() };
    raw.actions.push(Action::Assumed { what: "MiniProf: mm, y of rails to the track side" });
    let (mut profiles, mut inside) = (0, false);
    for (line, row) in lines(text) {
        let row = uncommented(row, &['"', '!', '%']);
        if row.starts_with('[') {
            inside = row.to_lowercase().contains("points");
            profiles += usize::from(inside);
        } else if inside && !row.is_empty() && !has_words(row) {
            // A key before the numbers, as in `1=0.5,0.3`, is no number of them.
            let row = row.split_once('=').map_or(row, |(_, row)| row);
            match numbers(line, row)?.as_slice() {
                [y, z, ..] => raw.points.push(Point { line, at: [*y, *z] }),
                row => return Err(FileError::Columns { line, found: row.len(), wanted: 2 }),
            }
        }
    }
    match profiles {
        0 => Err(FileError::Missing { line: last_line(text), block: "a section of points" }),
        1 => Ok(raw),
        _ => Err(FileError::Unsupported { line: 1, what: "MiniProf files of several profiles" }),
    }
}

/// The data; marked lines are comments, or points that were deselected, which are counted.
fn points<'a>(
    raw: &mut Raw,
    rows: impl Iterator<Item = (usize, &'a str)>,
    columns: [usize; 2],
    promised: Option<usize>,
) -> Result<usize, FileError> {
    let mut skipped = 0;
    let rows = rows.map(|(line, row)| (line, row.trim())).filter(|(_, row)| !row.is_empty());
    for (line, row) in rows {
        // What follows the promised points is points too, or something else.
        let is_beyond = promised.is_some_and(|promised| raw.points.len() + skipped >= promised);
        if row.starts_with(['"', '!', '%']) {
            skipped += usize::from(row.starts_with('"'));
            continue;
        }
        // The other columns may hold anything.
        let row: Vec<&str> = fields(uncommented(row, &['"', '!', '%'])).collect();
        let [Some(y), Some(z)] = columns.map(|column| row.get(column)) else {
            if is_beyond {
                break;
            }
            let wanted = columns.into_iter().max().unwrap_or(0) + 1;
            return Err(FileError::Columns { line, found: row.len(), wanted });
        };
        let [y, z] = [(columns[0], y), (columns[1], z)]
            .map(|(column, field)| number(line, column + 1, field));
        match (y, z) {
            (Ok(y), Ok(z)) => raw.points.push(Point { line, at: [y, z] }),
            _ if is_beyond => break,
            (y, z) => raw.points.push(Point { line, at: [y?, z?] }),
        }
    }
    let found = raw.points.len() + skipped;
    if let Some(said) = promised.filter(|said| found > *said) {
        raw.actions.push(Action::MorePoints { said, found });
    }
    if skipped > 0 {
        raw.actions.push(Action::Skipped { count: skipped });
    }
    Ok(skipped)
}

fn titled(row: &str) -> Option<Role> {
    let row = row.to_uppercase();
    if row.starts_with("#MINIWHEELPROF") {
        return Some(Role::Wheel);
    }
    row.starts_with("#MINIRAILPROF").then_some(Role::Rail)
}

/// Which columns `X` and `Y` are.
fn places(line: usize, value: &str) -> Result<[usize; 2], FileError> {
    let names: Vec<String> = value.split(',').map(|name| name.trim().to_uppercase()).collect();
    let place = |wanted: &str| names.iter().position(|name| name == wanted);
    match (place("X"), place("Y")) {
        (Some(x), Some(y)) => Ok([x, y]),
        _ => Err(FileError::Key { line, key: "ColumnDef" }),
    }
}

fn count(line: usize, value: &str) -> Result<usize, FileError> {
    value.trim().parse().map_err(|_| FileError::Key { line, key: "XYPoints" })
}

fn is_nought(value: &str) -> bool {
    let value = value.trim();
    value.is_empty() || value.parse::<f64>().is_ok_and(|value| value.abs() < f64::MIN_POSITIVE)
}
