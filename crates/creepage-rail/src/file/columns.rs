//! Two columns, and GENSYS's own.

use super::rows::{Point, Raw, lines, numbers, uncommented};
use super::{Action, FileError};

/// Two columns `y z`, perhaps with a heading; `#`, `%`, `!` begin comments. Nothing is known of units and senses.
pub(super) fn parse(text: &str) -> Result<Raw, FileError> {
    let mut raw = Raw::default();
    for (line, row) in lines(text) {
        let row = uncommented(row, &['#', '%', '!']);
        if row.is_empty() {
            continue;
        }
        let heads = raw.points.is_empty() && raw.actions.is_empty();
        if heads && row.chars().all(|c| !c.is_ascii_digit()) {
            raw.actions.push(Action::Ignored { line, what: "heading" });
            continue;
        }
        raw.points.push(pair(line, &numbers(line, row)?)?);
    }
    Ok(raw)
}

/// GENSYS: the same in mm, `y` to the track side, `z` down.
pub(super) fn gensys(text: &str) -> Result<Raw, FileError> {
    let assumed = Action::Assumed { what: "GENSYS: mm, y to the track side, z down" };
    let known = Raw {
        unit: Some(1e-3),
        field_side: Some(false),
        down: Some(true),
        actions: vec![assumed],
        ..Raw::default()
    };
    Ok(Raw { points: parse(text)?.points, ..known })
}

fn pair(line: usize, row: &[f64]) -> Result<Point, FileError> {
    match *row {
        [y, z] => Ok(Point { line, at: [y, z] }),
        _ => Err(FileError::Columns { line, found: row.len(), wanted: 2 }),
    }
}
