//! Failure of a C call: its status code and message.

use std::ffi::c_char;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

use creepage::halfspace::ResponseError;
use creepage::table::{BuildError, FileError};
use creepage::theory::{TheoryError, UnknownTheory};
use creepage::unsteady::SavedError;
use creepage::{HertzError, InvalidValue};
use creepage_map::MapError;
use creepage_study::{
    BearingCaseError, CaseError, GapCaseError, HistoryError, RowError, SolveError, SpecError,
    StaticsError, StressError, Varied, WheelTableError, WheelsetFileError,
};

/// Done.
pub const CREEPAGE_OK: i32 = 0;
/// A pointer that is needed is NULL.
pub const CREEPAGE_NULL: i32 = 1;
/// A number is out of range, or not finite.
pub const CREEPAGE_INVALID: i32 = 2;
/// A text is not UTF-8, names no theory, or holds no option of it.
pub const CREEPAGE_TEXT: i32 = 3;
/// A file cannot be read, or is not what it should be.
pub const CREEPAGE_FILE: i32 = 4;
/// So many cases that their arrays would not fit into memory.
pub const CREEPAGE_COUNT: i32 = 5;
/// The theory does not give what was asked for.
pub const CREEPAGE_UNSUPPORTED: i32 = 6;
/// A defect of the library; nothing can be said of what was written.
pub const CREEPAGE_DEFECT: i32 = 7;
/// No creepage gives the forces that are wanted.
pub const CREEPAGE_NOT_REACHABLE: i32 = 8;
/// There is less room than needed; nothing was written to it.
pub const CREEPAGE_ROOM: i32 = 9;

/// Why a call fails.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error("{0} is NULL")]
    Null(&'static str),
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    #[error("case {index}: {source}")]
    Case { index: usize, source: InvalidValue },
    #[error(transparent)]
    Theory(#[from] TheoryError),
    #[error("{0} is not UTF-8")]
    Text(&'static str),
    #[error(transparent)]
    Unknown(#[from] UnknownTheory),
    #[error("options: {0}")]
    Options(SpecError),
    #[error("cannot read {}: {source}", path.display())]
    Read { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    CaseFile { path: PathBuf, source: CaseError },
    #[error("{}: {source}", path.display())]
    Solve { path: PathBuf, source: SolveError },
    #[error("{}: {source}", path.display())]
    Table { path: PathBuf, source: FileError },
    #[error("{}: {source}", path.display())]
    Map { path: PathBuf, source: MapError },
    #[error("state {index}: {source}")]
    State { index: usize, source: MapError },
    #[error("the arrays of {0} cases do not fit into memory")]
    Count(usize),
    #[error("the theory {0} has no error bars")]
    NoErrorBars(&'static str),
    #[error("the theory {0} has no derivative")]
    NoDerivative(&'static str),
    #[error(transparent)]
    Hertz(HertzError),
    #[error("{0}")]
    Bulk(RowError),
    #[error(
        "`{name}` is not a quantity that varies: there are {}",
        Varied::ALL.map(Varied::name).join(", ")
    )]
    Quantity { name: String },
    #[error(
        "`{key}` is no quantity of this report: keys are those of report.json, as contact.normal_force_n"
    )]
    Key { key: String },
    #[error("no table of {theory}: {source}")]
    Build { theory: &'static str, source: BuildError<TheoryError> },
    #[error(transparent)]
    Wheelset(Box<WheelsetFileError>),
    #[error("row {row}: {source}")]
    Row { row: usize, source: Box<WheelsetFileError> },
    #[error(transparent)]
    WheelTable(#[from] WheelTableError),
    #[error("start = {0} is not valid: it must be 0, 1 or -1")]
    Start(i32),
    #[error(transparent)]
    Gap(Box<GapCaseError>),
    #[error(transparent)]
    Bearing(Box<BearingCaseError>),
    #[error("a bearing has the theory of its file: theory must be NULL")]
    BearingTheory,
    #[error("a problem without rolling is solved by no theory of rolling: theory must be NULL")]
    StaticsTheory,
    #[error("`{name}` is no theory of line contacts: there are exact and carter")]
    LineTheory { name: String },
    #[error(transparent)]
    History(Box<HistoryError>),
    #[error(transparent)]
    Saved(#[from] SavedError),
    #[error("{needed} coefficients are needed of each displacement: there is room for {room}")]
    Coefficients { room: usize, needed: usize },
    #[error(transparent)]
    HalfSpace(ResponseError),
    #[error(transparent)]
    Below(#[from] StressError),
    #[error(transparent)]
    Statics(Box<StaticsError>),
    #[error("the state has {needed} bytes: there is room for {size}")]
    Room { size: usize, needed: usize },
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
}

impl Failure {
    fn code(&self) -> i32 {
        match self {
            Self::Null(_) => CREEPAGE_NULL,
            Self::WheelTable(
                WheelTableError::Column { .. }
                | WheelTableError::Twice { .. }
                | WheelTableError::NoDistance,
            )
            | Self::Text(_)
            | Self::Quantity { .. }
            | Self::Key { .. }
            | Self::LineTheory { .. }
            | Self::Unknown(_)
            | Self::Options(_)
            | Self::Theory(
                TheoryError::AccuracyOfFixed
                | TheoryError::PrescribedOneWay
                | TheoryError::CoupledWithoutFriction,
            ) => CREEPAGE_TEXT,
            Self::Read { .. }
            | Self::Write { .. }
            | Self::CaseFile { .. }
            | Self::Table { .. }
            | Self::Map { .. } => CREEPAGE_FILE,
            Self::Count(_) => CREEPAGE_COUNT,
            Self::NoErrorBars(_)
            | Self::BearingTheory
            | Self::StaticsTheory
            | Self::NoDerivative(_)
            | Self::Solve { source: SolveError::FindsNothing { .. }, .. } => CREEPAGE_UNSUPPORTED,
            Self::Solve { source: SolveError::UnattainableForce(_), .. }
            | Self::HalfSpace(ResponseError::Unreachable { .. }) => CREEPAGE_NOT_REACHABLE,
            Self::History(source) if source.is_beyond_friction() => CREEPAGE_NOT_REACHABLE,
            Self::Gap(source) if matches!(**source, GapCaseError::UnattainableForce(_)) => {
                CREEPAGE_NOT_REACHABLE
            }
            Self::Room { .. } | Self::Coefficients { .. } => CREEPAGE_ROOM,
            Self::History(_)
            | Self::Saved(_)
            | Self::Invalid(_)
            | Self::Case { .. }
            | Self::State { .. }
            | Self::Hertz(_)
            | Self::HalfSpace(_)
            | Self::Below(_)
            | Self::Statics(_)
            | Self::Bulk(_)
            | Self::Build { .. }
            | Self::Wheelset(_)
            | Self::Row { .. }
            | Self::WheelTable(_)
            | Self::Start(_)
            | Self::Gap(_)
            | Self::Bearing(_)
            | Self::Theory(_)
            | Self::Solve { .. } => CREEPAGE_INVALID,
        }
    }
}

impl From<ResponseError> for Failure {
    fn from(error: ResponseError) -> Self {
        match error {
            ResponseError::Invalid(invalid) => Self::Invalid(invalid),
            other => Self::HalfSpace(other),
        }
    }
}

impl From<HistoryError> for Failure {
    fn from(error: HistoryError) -> Self {
        Self::History(Box::new(error))
    }
}

impl From<GapCaseError> for Failure {
    fn from(error: GapCaseError) -> Self {
        Self::Gap(Box::new(error))
    }
}

impl From<WheelsetFileError> for Failure {
    fn from(error: WheelsetFileError) -> Self {
        Self::Wheelset(Box::new(error))
    }
}

impl From<BearingCaseError> for Failure {
    fn from(error: BearingCaseError) -> Self {
        Self::Bearing(Box::new(error))
    }
}

/// Of a line contact: words and code are those of any other case.
impl From<CaseError> for Failure {
    fn from(error: CaseError) -> Self {
        Self::Gap(Box::new(error.into()))
    }
}

impl From<SpecError> for Failure {
    fn from(error: SpecError) -> Self {
        match error {
            SpecError::UnknownTheory(unknown) => Self::Unknown(unknown),
            other => Self::Options(other),
        }
    }
}

/// Does the work, and turns what goes wrong into a code and a message; no panic gets by.
///
/// # Safety
/// `message` is NULL or has room for `size` bytes.
pub(crate) unsafe fn guard(
    message: *mut c_char,
    size: usize,
    work: impl FnOnce() -> Result<(), Failure>,
) -> i32 {
    // SAFETY: the caller's promise is ours.
    unsafe { guard_words(message, size, || work().map(|()| String::new())) }
}

/// The same for work that ends with words.
///
/// # Safety
/// As of [`guard`].
pub(crate) unsafe fn guard_words(
    message: *mut c_char,
    size: usize,
    work: impl FnOnce() -> Result<String, Failure>,
) -> i32 {
    // What a panic may leave half-done is the caller's arrays only.
    let (code, words) = match catch_unwind(AssertUnwindSafe(work)) {
        Ok(Ok(words)) => (CREEPAGE_OK, words),
        Ok(Err(failure)) => (failure.code(), failure.to_string()),
        Err(_) => (CREEPAGE_DEFECT, "a defect of the library: please report it".into()),
    };
    // SAFETY: the caller's promise is ours.
    unsafe { write_words(message, size, &words) };
    code
}

/// Writes words and a zero byte, as many as there is room for, and no half character.
///
/// # Safety
/// `message` is NULL or has room for `size` bytes.
unsafe fn write_words(message: *mut c_char, size: usize, words: &str) {
    if message.is_null() || size == 0 {
        return;
    }
    let room = words.len().min(size - 1);
    let length = (0..=room).rev().find(|at| words.is_char_boundary(*at)).unwrap_or(0);
    // SAFETY: `length + 1 <= size` bytes fit, and a string of ours overlaps no buffer of theirs.
    unsafe {
        message.copy_from_nonoverlapping(words.as_ptr().cast(), length);
        message.add(length).write(0);
    }
}

#[cfg(test)]
// A panic is what is tested.
#[allow(clippy::panic)]
mod tests {
    use super::*;

    fn message(size: usize, words: &str) -> Vec<u8> {
        let mut buffer = vec![0x7f_u8; 40];
        // SAFETY: `size` is at most the buffer's.
        unsafe { write_words(buffer.as_mut_ptr().cast(), size, words) };
        buffer
    }

    #[test]
    fn a_panic_becomes_a_code() {
        // SAFETY: NULL may be given.
        let code = unsafe { guard(std::ptr::null_mut(), 0, || panic!("on purpose")) };
        assert_eq!(code, CREEPAGE_DEFECT);
    }

    #[test]
    fn a_message_fits_its_room_and_ends_with_zero() {
        assert_eq!(&message(40, "theory is NULL")[..16], b"theory is NULL\0\x7f");
        assert_eq!(&message(5, "theory is NULL")[..6], b"theo\0\x7f");
        // No half of a character of two bytes.
        assert_eq!(&message(4, "ab\u{e9}")[..4], b"ab\0\x7f");
        assert_eq!(message(0, "theory")[0], 0x7f);
    }
}
