//! VAMPIRE: four lines of heading, then left and right profile side by side, in mm.

use super::rows::{Point, Raw, last_line, lines, numbers};
use super::{Action, FileError};
use crate::{Role, Side};

pub(super) fn parse(text: &str, side: Option<Side>) -> Result<Raw, FileError> {
    let side =
        side.ok_or(FileError::Ask { line: 5, what: "which side of the two in it is wanted" })?;
    let mut rows = lines(text);
    let role = match rows.next().map_or("", |(_, first)| first.trim()) {
        first if first.starts_with("WHEELPROFILE") => Role::Wheel,
        first if first.starts_with("RAILPROFILE") => Role::Rail,
        _ => return Err(FileError::Missing { line: 1, block: "WHEELPROFILE or RAILPROFILE" }),
    };
    let keys: [&'static str; 2] = match role {
        Role::Wheel => ["TREADDATUM", "FLANGEBACK"],
        Role::Rail => ["GAUGEPOINT", "GAUGE"],
    };
    let mut raw = Raw { role: Some(role), unit: Some(1e-3), ..Raw::default() };
    raw.field_side = Some(true);
    for (key, (line, row)) in keys.into_iter().zip(rows.by_ref().skip(1)) {
        if row.split_whitespace().next() != Some(key) {
            return Err(FileError::Missing { line, block: key });
        }
        raw.actions.push(Action::Ignored { line, what: key });
    }
    for (line, row) in rows.filter(|(_, row)| !row.trim().is_empty()) {
        raw.points.push(Point { line, at: one_side(line, &numbers(line, row)?, side)? });
    }
    if raw.points.is_empty() {
        return Err(FileError::Missing { line: last_line(text), block: "a point" });
    }
    Ok(raw)
}

/// Both sides have `y` to the right.
fn one_side(line: usize, row: &[f64], side: Side) -> Result<[f64; 2], FileError> {
    match *row {
        [y, z, _, _] if side == Side::Left => Ok([-y, z]),
        [_, _, y, z] => Ok([y, z]),
        _ => Err(FileError::Columns { line, found: row.len(), wanted: 4 }),
    }
}
