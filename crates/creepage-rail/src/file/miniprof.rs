//! `MiniProf`: `Key=Value` lines or an older heading, an empty line, then columns, in mm.

use super::rows::{Point, Raw, last_line, lines, numbers, uncommented};
use super::{Action, FileError};
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
    let mut rows = lines(text);
    for (line, row) in rows.by_ref() {
        if row.trim().is_empty() {
            break;
        }
        raw.role = raw.role.or_else(|| titled(row));
        let Some((key, value)) = row.split_once('=') else { continue };
        match key.trim().to_lowercase().as_str() {
            "columndef" => columns = places(line, value)?,
            "xypoints" => promised = Some(count(line, value)?),
            "xoffset" | "yoffset" if !is_nought(value) => {
                raw.actions.push(Action::Ignored { line, what: "an offset" });
            }
            key if key.starts_with("mpd") => {
                return Err(FileError::Unsupported { line, what: "MiniProf profiles by segments" });
            }
            _ => {}
        }
    }
    let skipped = points(&mut raw, rows, columns, promised)?;
    let enough = promised.is_none_or(|promised| raw.points.len() + skipped >= promised);
    if raw.points.is_empty() || !enough {
        return Err(FileError::Missing { line: last_line(text), block: "a point" });
    }
    Ok(raw)
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
        if promised.is_some_and(|promised| raw.points.len() + skipped >= promised) {
            break;
        }
        if row.starts_with(['"', '!', '%']) {
            skipped += usize::from(row.starts_with('"'));
            continue;
        }
        let row = numbers(line, uncommented(row, &['"', '!', '%']))?;
        let [Some(y), Some(z)] = columns.map(|column| row.get(column).copied()) else {
            let wanted = columns.into_iter().max().unwrap_or(0) + 1;
            return Err(FileError::Columns { line, found: row.len(), wanted });
        };
        raw.points.push(Point { line, at: [y, z] });
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
    value.trim().parse::<f64>().is_ok_and(|value| value.abs() < f64::MIN_POSITIVE)
}
