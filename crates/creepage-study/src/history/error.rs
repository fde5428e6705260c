//! What can be wrong with a case that rolls, or with its history.

use creepage::InvalidValue;

use crate::CaseError;

/// Why a case does not roll, or a table is no history.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HistoryError {
    /// What any case file may have wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A section whose place the history takes.
    #[error("section [{section}] does not go with a history: the table says how the bodies move")]
    Section {
        /// `creepage` or `wanted`.
        section: &'static str,
    },
    /// A theory of steady rolling only.
    #[error("[solve] theory = \"{theory}\" is one of steady rolling: a history needs \"exact\"")]
    Theory {
        /// Its name.
        theory: &'static str,
    },
    /// A resolution that depends on a solution.
    #[error("[solve] resolution = \"auto\" does not go with a history: name one")]
    Automatic,
    /// A key that goes with another kind of contact or start.
    #[error("[{section}] {key} {why}")]
    Foreign {
        /// The section's name.
        section: &'static str,
        /// The key.
        key: &'static str,
        /// Where it belongs.
        why: &'static str,
    },
    /// The starting force cannot be held.
    #[error(
        "[start] longitudinal_force and lateral_force, {force} together, are not reachable: friction \
         holds less than {most}"
    )]
    Start {
        /// Their size.
        force: f64,
        /// `mu N`.
        most: f64,
    },
    /// The table cannot be read.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// A column that is needed.
    #[error("column distance is missing: the first line names the columns, distance among them")]
    NoDistance,
    /// A column that a history does not have.
    #[error("unknown column `{name}`: {hint}")]
    UnknownColumn {
        /// Its name.
        name: String,
        /// A likely meaning, or the columns that there are.
        hint: String,
    },
    /// Two columns for one thing.
    #[error("columns {first} and {second} exclude each other: give one of them")]
    TwoColumns {
        /// One.
        first: &'static str,
        /// The other, or the same again.
        second: &'static str,
    },
    /// A column that the contact does not have.
    #[error("column {column} does not go with a line contact")]
    NotOfALine {
        /// Its name.
        column: &'static str,
    },
    /// A creepage of a line contact, which needs its length.
    #[error(
        "column {column} prescribes a creepage: a line contact needs [contact] length for that, by \
         whose logarithm the forces differ"
    )]
    NoLength {
        /// Its name.
        column: &'static str,
    },
    /// There is nothing to roll.
    #[error("the history has no rows")]
    Empty,
    /// A row that is too short or too long.
    #[error("row {row}: {found} fields, but the header has {expected}")]
    Fields {
        /// Number of the row, from 1.
        row: usize,
        /// Its fields.
        found: usize,
        /// Those of the header.
        expected: usize,
    },
    /// A field that is no number.
    #[error("row {row}: {column} = `{text}` is not a number")]
    NotANumber {
        /// Number of the row, from 1.
        row: usize,
        /// The column.
        column: &'static str,
        /// What stands there.
        text: String,
    },
    /// A number out of its range.
    #[error("row {row}: {invalid}")]
    Value {
        /// Number of the row, from 1.
        row: usize,
        /// The column, its value, and what it must be.
        invalid: InvalidValue,
    },
    /// Distances that do not grow.
    #[error("row {row}: distance = {value} is not valid: it must be greater than {before}")]
    Distance {
        /// Number of the row, from 1.
        row: usize,
        /// The distance.
        value: f64,
        /// That of the row before, or zero.
        before: f64,
    },
    /// A force that friction cannot give.
    #[error("row {row}: the force, {force} N, is not reachable: friction gives at most {most} N")]
    BeyondFriction {
        /// Number of the row, from 1.
        row: usize,
        /// Its size.
        force: f64,
        /// `mu N` of the row.
        most: f64,
    },
    /// The contact cannot be prepared.
    #[error("[contact] {0}")]
    Contact(InvalidValue),
    /// The table of an interrupted run is being written by another.
    #[error("another run writes there")]
    Busy,
}

impl HistoryError {
    /// Places an [`InvalidValue`] in a row.
    pub(super) fn value(row: usize) -> impl Fn(InvalidValue) -> Self {
        move |invalid| Self::Value { row, invalid }
    }
}
