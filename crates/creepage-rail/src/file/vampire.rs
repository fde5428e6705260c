//! Reader of VAMPIRE's files: lines of heading, then left and right profile side by side, in mm; some programs write one
//! side alone, or titles of their own.

use super::rows::{Point, Raw, has_words, last_line, lines, numbers, uncommented};
use super::{Action, FileError};
use crate::{Role, Side};

/// Keys of the heading that place the profile; here the case does.
const KEYS: [&str; 4] = ["TREADDATUM", "FLANGEBACK", "GAUGEPOINT", "GAUGE"];

pub(super) fn parse(text: &str, side: Option<Side>) -> Result<Raw, FileError> {
    let mut raw = Raw { unit: Some(1e-3), field_side: Some(true), ..Raw::default() };
    let mut rows = lines(text).peekable();
    raw.role = rows.peek().and_then(|(_, first)| match first.trim() {
        first if first.starts_with("WHEEL") => Some(Role::Wheel),
        first if first.starts_with("RAIL") => Some(Role::Rail),
        _ => None,
    });
    let mut is_title = raw.role.is_some();
    let rows = rows.map(|(line, row)| (line, uncommented(row, &['#', '%', '!'])));
    for (line, row) in rows.filter(|(_, row)| !row.is_empty()) {
        let key = row.split_whitespace().next().unwrap_or("");
        if raw.points.is_empty()
            && let Some(what) = KEYS.into_iter().find(|known| *known == key)
        {
            raw.actions.push(Action::Ignored { line, what });
        } else if raw.points.is_empty() && (is_title || has_words(row)) {
            // The line after the first is a title, whatever stands in it.
            is_title = is_title && line < 2;
            if line > 2 || raw.role.is_none() {
                raw.actions.push(Action::Ignored { line, what: "title" });
            }
        } else {
            raw.points.push(Point { line, at: one_side(line, &numbers(line, row)?, side)? });
        }
    }
    if raw.points.is_empty() {
        return Err(FileError::Missing { line: last_line(text), block: "a point" });
    }
    Ok(raw)
}

/// Of two sides both have `y` to the right.
fn one_side(line: usize, row: &[f64], side: Option<Side>) -> Result<[f64; 2], FileError> {
    match (row, side) {
        ([_, _, _, _], None) => {
            Err(FileError::Ask { line, what: "which side of the two in it is wanted" })
        }
        ([y, z, _, _], Some(Side::Left)) => Ok([-y, *z]),
        ([y, z], _) | ([_, _, y, z], Some(Side::Right)) => Ok([*y, *z]),
        _ => Err(FileError::Columns { line, found: row.len(), wanted: 4 }),
    }
}
