//! Reader of two-column files, and of GENSYS's own.

use super::rows::{Point, Raw, fields, has_words, lines, numbers, uncommented};
use super::{Action, FileError};

/// Two columns `y z`, perhaps under titles and headings; `#`, `%`, `!`, `//` begin comments.
/// Nothing is known of units and senses.
pub(super) fn parse(text: &str) -> Result<Raw, FileError> {
    let mut raw = Raw::default();
    let mut places = None;
    let mut count: Option<(usize, f64)> = None;
    for (line, row) in lines(text) {
        let row = uncommented(row, &['#', '%', '!']);
        if row.is_empty() {
            continue;
        }
        if raw.points.is_empty() && has_words(row) {
            places = named(row).or(places);
            raw.actions.push(Action::Ignored { line, what: "heading" });
            continue;
        }
        let row = numbers(line, row)?;
        match row[..] {
            [number] if raw.points.is_empty() && count.is_none() => count = Some((line, number)),
            _ => raw.points.push(pair(line, &row, places)?),
        }
    }
    match count {
        Some((line, number)) if (number - raw.points.len() as f64).abs() < 0.5 => {
            raw.actions.push(Action::Ignored { line, what: "number of points" });
        }
        Some((line, _)) => return Err(FileError::Columns { line, found: 1, wanted: 2 }),
        None => {}
    }
    Ok(raw)
}

/// The columns of `y` and `z`, and how many there are, where a heading names them.
fn named(heading: &str) -> Option<[usize; 3]> {
    let letters = |field: &str| {
        let word = field.split(|c: char| !c.is_alphanumeric()).find(|word| !word.is_empty());
        word.map(str::to_lowercase)
    };
    // Between commas a name may be followed by its unit.
    let names: Vec<String> = if heading.contains([',', ';']) {
        heading.split([',', ';']).filter_map(letters).collect()
    } else {
        fields(heading).filter_map(letters).collect()
    };
    let place = |wanted: &str| names.iter().position(|name| name == wanted);
    let pair = place("y").zip(place("z")).or_else(|| place("x").zip(place("y")));
    pair.map(|(y, z)| [y, z, names.len()])
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

/// `y` and `z` of a row: its only two numbers, else those that the heading names.
fn pair(line: usize, row: &[f64], named: Option<[usize; 3]>) -> Result<Point, FileError> {
    let named = named.filter(|[.., count]| *count == row.len());
    match (row, named) {
        (_, Some([y, z, _])) if row.len() > 2 => {
            let [y, z] = [y, z].map(|place| row.get(place).copied().unwrap_or(f64::NAN));
            Ok(Point { line, at: [y, z] })
        }
        ([y, z], _) => Ok(Point { line, at: [*y, *z] }),
        // "1,5,-2,5": commas part the numbers and stand inside of them.
        ([a, b, c, d], _) if [a, b, c, d].iter().all(|v| v.fract() == 0.0) => {
            Err(FileError::Commas { line })
        }
        _ => Err(FileError::Columns { line, found: row.len(), wanted: 2 }),
    }
}
