//! Errors of profile files.

use std::fmt;

use crate::{ProfileError, Role};

/// Error of a profile file; lines count from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// A number was wanted.
    #[error("line {line}: column {column} is not a number: {text:?}")]
    NotANumber {
        /// Line.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What stands there, its first letters.
        text: String,
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
        "line {line}: with the file's unit, {unit} m, the profile would be {length:.3} m long; \
         profiles are .005 to .5 m{}", fitting_words(*fitting)
    )]
    Length {
        /// First line of the points.
        line: usize,
        /// Length of the profile (m).
        length: f64,
        /// Length of the file's unit (m).
        unit: f64,
        /// Length of the unit that would fit (m).
        fitting: Option<f64>,
    },
    /// Commas part the numbers and stand inside of them.
    #[error(
        "line {line}: four whole numbers; with decimal commas the numbers must be parted by \
         blanks, tabs or semicolons"
    )]
    Commas {
        /// Line.
        line: usize,
    },
    /// A key that would change the shape, and is not known.
    #[error("line {line}: {key} is not known, and may change the shape")]
    UnknownKey {
        /// Line.
        line: usize,
        /// The key.
        key: String,
    },
    /// What is said of the role contradicts the shape.
    #[error(
        "line {line} and following: {by} says {said}, but the shape is that of a {shown} ({}): \
         say the role", shape_words(*shown)
    )]
    Role {
        /// First line of the points.
        line: usize,
        /// What says it.
        by: SaidBy,
        /// What it says.
        said: Role,
        /// What the shape shows.
        shown: Role,
    },
    /// What was asked for turns the profile upside down.
    #[error("line {line} and following: {said} contradicts the shape: {} would point up", hangs(*role))]
    UpsideDown {
        /// First line of the points.
        line: usize,
        /// What was asked for.
        said: &'static str,
        /// Wheel or rail.
        role: Role,
    },
    /// What was asked for puts the flange on the field side.
    #[error(
        "line {line} and following: {said} contradicts the shape: the flange would stand on the field side"
    )]
    FlangeOutside {
        /// First line of the points.
        line: usize,
        /// What was asked for.
        said: &'static str,
    },
    /// The outline of a whole wheel.
    #[error(
        "line {line} and following: a closed outline of a wheel: give the running surface from rim to flange back only"
    )]
    Outline {
        /// First line of the points.
        line: usize,
    },
    /// Points in no order.
    #[error(
        "line {line} and following: the points are not in order along the profile: the line through them is {times:.0} \
         times as long as they are wide and high"
    )]
    Disorder {
        /// First line of the points.
        line: usize,
        /// Length of the line through the points over their width and height.
        times: f64,
    },
    /// A part that was measured twice, not alike.
    #[error(
        "line {line}: the scan goes back and measures a part again, up to {:.2} mm from the first \
         pass: keep one of the two passes", 1e3 * apart
    )]
    Overlap {
        /// Line at which it goes back.
        line: usize,
        /// Greatest distance between both passes (m).
        apart: f64,
    },
    /// Segments that do not follow each other.
    #[error("line {line}: the segment starts {apart} mm from where the one before ends")]
    Apart {
        /// Line.
        line: usize,
        /// Distance in the file's unit.
        apart: f64,
    },
    /// JSON without points.
    #[error("line {line}: JSON in which no points are found: {what}")]
    Json {
        /// Line.
        line: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// Higher than wide: axes exchanged.
    #[error(
        "line {line}: {:.1} mm high and {:.1} mm wide: are y and z exchanged, or is it a part of a profile?",
        1e3 * height, 1e3 * width
    )]
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

/// Source of a profile's role, wheel or rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SaidBy {
    /// [`ReadOptions::role`](super::ReadOptions::role).
    Asker,
    /// The file's content.
    Content,
    /// The ending of the file's name.
    Ending,
}

impl fmt::Display for SaidBy {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Asker => "what was asked for",
            Self::Content => "the file's content",
            Self::Ending => "the ending of the file's name",
        })
    }
}

fn fitting_words(unit: Option<f64>) -> String {
    let words = |unit| format!("; a unit of {unit} m would fit");
    unit.map_or_else(|| String::from("; say the unit"), words)
}

fn shape_words(shown: Role) -> &'static str {
    match shown {
        Role::Wheel => "a flange on one side of a tread",
        Role::Rail => "a head between two steep sides",
    }
}

fn hangs(role: Role) -> &'static str {
    match role {
        Role::Wheel => "the flange",
        Role::Rail => "the sides of the head",
    }
}
