//! Lines of a profile file, split into numbers.

use super::{Action, FileError};
use crate::Role;

/// The largest number that may stand for a length, in any unit.
pub(super) const LARGEST: f64 = 1e5;

/// A point with the line that it comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) line: usize,
    pub(super) at: [f64; 2],
}

/// Content of a file, before anything is done to it.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Raw {
    pub(super) role: Option<Role>,
    pub(super) points: Vec<Point>,
    /// Length of the unit (m).
    pub(super) unit: Option<f64>,
    /// Whether the file itself says it, not only its format.
    pub(super) unit_is_said: bool,
    /// Whether `y` grows to the field side and `z` downwards.
    pub(super) field_side: Option<bool>,
    pub(super) down: Option<bool>,
    pub(super) actions: Vec<Action>,
}

/// Moves every point.
pub(super) fn move_all(points: &mut [Point], moved: impl Fn([f64; 2]) -> [f64; 2]) {
    for point in points {
        point.at = moved(point.at);
    }
}

/// Lines, counted from 1.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().map(|(index, line)| (index + 1, line))
}

/// Number of the last line.
pub(super) fn last_line(text: &str) -> usize {
    text.lines().count().max(1)
}

/// The part of a line before a comment that begins with one of `marks`, or with `//`.
pub(super) fn uncommented<'a>(line: &'a str, marks: &[char]) -> &'a str {
    let line = line.split_once("//").map_or(line, |(before, _)| before);
    line.split(marks).next().unwrap_or("").trim()
}

/// The fields of a line, parted by blanks, commas or semicolons.
pub(super) fn fields(text: &str) -> impl Iterator<Item = &str> {
    let parted = |c: char| c.is_whitespace() || c == ',' || c == ';';
    text.split(parted).filter(|field| !field.is_empty())
}

/// Whether a line has words in it: a title, a heading.
pub(super) fn has_words(text: &str) -> bool {
    let is_word = |field: &str| {
        let letters = field.chars().filter(|c| c.is_alphabetic()).count();
        field.parse::<f64>().is_err() && 2 * letters >= field.chars().count()
    };
    fields(text).any(is_word)
}

/// The numbers of a line; not-a-number where nothing was measured.
pub(super) fn numbers(line: usize, text: &str) -> Result<Vec<f64>, FileError> {
    fields(text).enumerate().map(|(index, field)| number(line, index + 1, field)).collect()
}

/// A number, perhaps between quotes, with Fortran's exponent or with a typographer's minus.
fn parsed(field: &str) -> Option<f64> {
    let plain = field.trim_matches(['"', '\'']);
    let usual = |c: char| match c {
        'd' | 'D' => 'e',
        '\u{2212}' => '-',
        other => other,
    };
    plain.parse().ok().or_else(|| plain.chars().map(usual).collect::<String>().parse().ok())
}

pub(super) fn number(line: usize, column: usize, field: &str) -> Result<f64, FileError> {
    let value: f64 = parsed(field).ok_or_else(|| {
        let text = field.chars().take(20).collect();
        FileError::NotANumber { line, column, text }
    })?;
    if value.is_nan() || value.abs() <= LARGEST {
        return Ok(value);
    }
    Err(FileError::NotALength { line, column, value })
}
