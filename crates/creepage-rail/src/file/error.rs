//! What a profile file cannot be read for.

use crate::ProfileError;

/// A profile file that makes no sense; lines count from 1.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// A number was wanted.
    #[error("line {line}: column {column} is not a number")]
    NotANumber {
        /// Line.
        line: usize,
        /// Column, from 1.
        column: usize,
    },
    /// A number too large for a length in any unit.
    #[error("line {line}: {value} in column {column} is not a length")]
    NotALength {
        /// Line.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What stands there.
        value: f64,
    },
    /// A line has fewer or more columns than the format.
    #[error("line {line}: {found} columns, {wanted} wanted")]
    Columns {
        /// Line.
        line: usize,
        /// Columns in the line.
        found: usize,
        /// Columns of the format.
        wanted: usize,
    },
    /// A key has no sensible value.
    #[error("line {line}: {key} has no value that makes sense")]
    Key {
        /// Line.
        line: usize,
        /// The key.
        key: &'static str,
    },
    /// A block that ends nowhere, or is missing.
    #[error("line {line}: {block} is missing")]
    Missing {
        /// The last line.
        line: usize,
        /// What is missing.
        block: &'static str,
    },
    /// Points that no profile can have.
    #[error("line {line}: {count} points; a profile takes 3 to 20000")]
    Count {
        /// The last line.
        line: usize,
        /// Number of points.
        count: usize,
    },
    /// A length that no profile has: a wrong unit.
    #[error(
        "line {line}: the profile would be {length} m long, .02 to .5 is sane; say the unit \
         (the file's unit is held for {unit} m)"
    )]
    Length {
        /// First line of the points.
        line: usize,
        /// Length of the profile (m).
        length: f64,
        /// Length of the file's unit (m).
        unit: f64,
    },
    /// Higher than wide: axes exchanged.
    #[error("line {line}: {height} m high and {width} m wide: are y and z exchanged?")]
    Axes {
        /// First line of the points.
        line: usize,
        /// Extent in `y` (m).
        width: f64,
        /// Extent in `z` (m).
        height: f64,
    },
    /// The profile turns back at a point.
    #[error("line {line}: the profile turns back by {turn} rad")]
    TurnsBack {
        /// Line of the point.
        line: usize,
        /// Turn (rad).
        turn: f64,
    },
    /// The profile crosses itself.
    #[error("line {line}: the profile crosses itself, between lines {other} and {}", other + 1)]
    Crosses {
        /// Line at which it comes back.
        line: usize,
        /// Line before the place that it crosses.
        other: usize,
    },
    /// The file does not say, and its shape does not show.
    #[error("the file, from line {line}, does not show {what}: say it")]
    Ask {
        /// First line that should show it.
        line: usize,
        /// What must be said.
        what: &'static str,
    },
    /// A layout that is not read.
    #[error("line {line}: {what} are not read")]
    Unsupported {
        /// Line that shows it.
        line: usize,
        /// What it is.
        what: &'static str,
    },
    /// The points make no profile.
    #[error("line {line} and following: {source}")]
    Profile {
        /// First line of the points.
        line: usize,
        /// Why.
        source: ProfileError,
    },
}
