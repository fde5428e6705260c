//! Errors of a rolling case and of its history.

use creepage::InvalidValue;

use crate::CaseError;
use crate::gap::GapCaseError;

/// Error of a rolling case or of its table.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HistoryError {
    /// What any case file may have wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A section whose place the history takes.
    #[error(
        "section [{section}] does not go with a history: the table says how the bodies move, and \
         [creepage] may hold speed alone"
    )]
    Section {
        /// `creepage` or `wanted`.
        section: &'static str,
    },
    /// Friction that follows the slip at once: tractions would jump from step to step.
    #[error(
        "[contact] friction falls with the speed of slip: a history needs its memory_distance (m) and \
         memory_speed (m/s)"
    )]
    NoMemory,
    /// A section of steady rolling only.
    #[error("section [{section}] is for steady rolling: {why}")]
    Steady {
        /// `damage` or `heat`.
        section: &'static str,
        /// What does not hold in a history, and what to do instead.
        why: &'static str,
    },
    /// What a case file with `[gap]` may have wrong.
    #[error(transparent)]
    Gap(Box<GapCaseError>),
    /// A load that changes on areas of any shape.
    #[error(
        "column {column} does not go with [gap]: areas of any shape are solved for one load, the \
         normal_force or approach of [contact]"
    )]
    NotOfAnArea {
        /// Its name.
        column: &'static str,
    },
    /// A load that changes with a layer between the bodies.
    #[error(
        "column {column} does not go with [layer]: a contact that rolls with a layer keeps the load of [contact]"
    )]
    NotWithLayer {
        /// Its name.
        column: &'static str,
    },
    /// A theory of steady rolling only.
    #[error(
        "[solve] theory = \"{theory}\" is one of steady rolling: a history needs \"exact\", \"fastsim\" or \
         \"variational\""
    )]
    Theory {
        /// Its name.
        theory: &'static str,
    },
    /// A resolution that depends on a solution.
    #[error("[solve] resolution = \"auto\" does not go with a history: name one")]
    Automatic,
    /// What FASTSIM does not do.
    #[error(
        "{what} does not go with theory = \"fastsim\", which rolls ellipses, from no traction or \
         from steady rolling: use \"exact\""
    )]
    NotOfFastsim {
        /// A section or a key.
        what: &'static str,
    },
    /// What chapter 5 does not do.
    #[error(
        "{what} does not go with theory = \"variational\", which rolls ellipses under a constant load with one \
         coefficient of friction: use \"exact\""
    )]
    NotOfVariational {
        /// A section, a key or a column.
        what: &'static str,
    },
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
    /// A column twice.
    #[error("column {column} is there twice")]
    Twice {
        /// Its name.
        column: &'static str,
    },
    /// Two columns for one thing.
    #[error("columns {first} and {second} exclude each other: give one of them")]
    TwoColumns {
        /// One.
        first: &'static str,
        /// The other.
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
    /// A row whose numbers are no motion.
    #[error("row {row}: {source}")]
    Row {
        /// Number of the row, from 1.
        row: usize,
        /// What is wrong with it.
        source: MotionError,
    },
    /// A single step whose numbers are no motion.
    #[error(transparent)]
    Step(MotionError),
    /// The contact cannot be prepared.
    #[error("[contact] {0}")]
    Contact(InvalidValue),
    /// Chapter 5 cannot be prepared.
    #[error("[solve] {0}")]
    Variational(creepage::variational::VariationalError),
    /// The table of an interrupted run is being written by another.
    #[error("another run writes there")]
    Busy,
}

/// Error of numbers that do not say how bodies move.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A number out of its range.
    #[error(transparent)]
    Value(#[from] InvalidValue),
    /// Distances that do not grow.
    #[error("distance = {value} is not valid: it must be greater than {before}")]
    Distance {
        /// The distance.
        value: f64,
        /// That of the row before, or zero.
        before: f64,
    },
    /// A creepage and a force of one component, or neither, where a table has columns of both.
    #[error(
        "{first} and {second} exclude each other: one of the two is to be given, and {given} are"
    )]
    OneOfTwo {
        /// A column.
        first: &'static str,
        /// That of the same component.
        second: &'static str,
        /// How many of them a row gives.
        given: usize,
    },
    /// A force that friction cannot give.
    #[error("the force, {force} N, is not reachable: friction gives at most {most} N")]
    BeyondFriction {
        /// Its size.
        force: f64,
        /// `mu N` of the moment.
        most: f64,
    },
    /// A moment that friction cannot give.
    #[error(
        "the moment, {moment} N m, is not reachable: friction gives at most {most} N m, spinning on the spot"
    )]
    MomentBeyondFriction {
        /// Its size (N m).
        moment: f64,
        /// That of a contact that slides all around its middle (N m).
        most: f64,
    },
}

impl From<GapCaseError> for HistoryError {
    fn from(error: GapCaseError) -> Self {
        match error {
            GapCaseError::Case(error) => Self::Case(error),
            other => Self::Gap(Box::new(other)),
        }
    }
}

impl HistoryError {
    /// Whether it is a force, of a start, a row or a step, that friction cannot give.
    #[must_use]
    pub fn is_beyond_friction(&self) -> bool {
        let beyond = |source: &MotionError| {
            use MotionError::{BeyondFriction, MomentBeyondFriction};
            matches!(source, BeyondFriction { .. } | MomentBeyondFriction { .. })
        };
        match self {
            Self::Start { .. } => true,
            Self::Row { source, .. } | Self::Step(source) => beyond(source),
            _ => false,
        }
    }

    /// Places a [`MotionError`] in a row.
    pub(super) fn in_row(row: usize) -> impl Fn(MotionError) -> Self {
        move |source| Self::Row { row, source }
    }
}
