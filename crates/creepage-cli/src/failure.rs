//! Failure of a command, and its exit code.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use creepage::InvalidValue;
use creepage::table::{BuildError, FileError};
use creepage::theory::{TheoryError, UnknownTheory};
use creepage_1967::GalleryError;
use creepage_rail::Standard;
use creepage_rail::file::FileError as ProfileFileError;
use creepage_study::{
    BearingCaseError, CaseError, FitError, GapCaseError, HistoryError, MapBuildError,
    MeasuredError, PointsError, ReferenceError, ReportError, SolveError, SpecError, StaticsError,
    StressError, WearError, WheelTableError, WheelsetFileError,
};

use crate::batch::columns::ColumnError;

/// Failure of a command.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error(
        "{0} is the file of a wheelset: make its map first, `creepage map {0} --out wheelset.nc`, and give that, or \
         solve it in the FMU itself by --exact",
        path.display()
    )]
    NoMap { path: PathBuf },
    #[error(
        "{name} is neither beside this program nor in ../lib: build it by `cargo build --release -p creepage-fmu` \
         and give it by --library"
    )]
    NoLibrary { name: String },
    #[error("{}: {source}", path.display())]
    Pack { path: PathBuf, source: Box<creepage_fmu::PackError> },
    #[error("--survey {pattern}: {why}")]
    Pattern { pattern: String, why: String },
    #[error("--unit must be positive and finite, got {value}")]
    Unit { value: f64 },
    #[error(
        "--reference is the profile of a rail: give that of a new wheel, from which wheels wear"
    )]
    ReferenceIsRail,
    #[error("--rail: {source}")]
    Survey { source: creepage_rail::GeometryError },
    #[error("cannot read {}: {source}", path.display())]
    Read { path: PathBuf, source: io::Error },
    #[error("{}: {source}", path.display())]
    Case { path: PathBuf, source: CaseError },
    #[error(
        "{}: a line contact is solved by \"exact\" or \"carter\", not by {name:?}",
        path.display()
    )]
    LineTheory { path: PathBuf, name: String },
    #[error("{}: {source}", path.display())]
    Bearing { path: PathBuf, source: BearingCaseError },
    #[error("{}: {source}", path.display())]
    Statics { path: PathBuf, source: StaticsError },
    #[error("{}: {source}", path.display())]
    Wheelset { path: PathBuf, source: Box<WheelsetFileError> },
    #[error("{}: {source}", path.display())]
    Import { path: PathBuf, source: creepage_import::ImportError },
    #[error(
        "{} is there already, with other contents: imported cases replace no file; give another --out",
        path.display()
    )]
    ImportExists { path: PathBuf },
    #[error("{}: {source}", path.display())]
    Wear { path: PathBuf, source: Box<WearError> },
    #[error("{}: {source}", path.display())]
    Map { path: PathBuf, source: Box<MapBuildError> },
    #[error("--{source}")]
    MapPlan { source: Box<MapBuildError> },
    #[error("{}: {source}", path.display())]
    History { path: PathBuf, source: Box<HistoryError> },
    #[error(
        "{} is of the history of another contact, whose files would stand beside those of these wheels: give another \
         --out",
        path.display()
    )]
    OfAnotherHistory { path: PathBuf },
    #[error("{}: {source}", path.display())]
    WheelTable { path: PathBuf, source: Box<WheelTableError> },
    #[error("{}: {source}{}", path.display(), how_to_say(source))]
    Profile { path: PathBuf, source: ProfileFileError },
    #[error("{}: there is no such file, and the standard profiles are {}", path.display(), standard_profiles())]
    NoProfile { path: PathBuf },
    #[error(
        "{profile} is a standard profile: --role, --side, --unit, --y, --z and --smooth are for files"
    )]
    NothingToRead { profile: &'static str },
    #[error("{} would be written twice: give profiles of one name one by one, each its own --out", path.display())]
    SameName { path: PathBuf },
    #[error(
        "{} and {} would both write to {}: solve them one by one, each with its own --out",
        first.display(), second.display(), directory.display()
    )]
    SameDirectory { first: PathBuf, second: PathBuf, directory: PathBuf },
    #[error("standard input (-) is given twice, and it can be read only once")]
    StdinTwice,
    #[error(
        "{} is there already, with other contents: a converted profile replaces no file; give another \
         --out", path.display()
    )]
    Exists { path: PathBuf },
    #[error("{}: {source}", path.display())]
    Points { path: PathBuf, source: PointsError },
    #[error("{}: {source}", path.display())]
    Measured { path: PathBuf, source: MeasuredError },
    #[error("{}: {source}", path.display())]
    Fit { path: PathBuf, source: FitError },
    #[error("{}: {source}", path.display())]
    Stresses { path: PathBuf, source: StressError },
    #[error("{}: {source}", path.display())]
    Gap { path: PathBuf, source: Box<GapCaseError> },
    #[error("{}: [gap] goes with a theory, for --table holds forces of ellipses", path.display())]
    TableOfEllipses { path: PathBuf },
    #[error(transparent)]
    Reproduce(#[from] GalleryError),
    #[error("--points goes with one picture: name just one")]
    PointsOfOne,
    #[error("{}: {source}", path.display())]
    OwnPoints { path: PathBuf, source: creepage_1967::PointsError },
    #[error(transparent)]
    UnknownTheory(#[from] UnknownTheory),
    #[error("{}: {source}", path.display())]
    Solve { path: PathBuf, source: SolveError },
    #[error("--option: {0}")]
    Option(SpecError),
    #[error("--option: {source}")]
    Value { source: TheoryError },
    #[error("{theory}: {source}")]
    Theory { theory: &'static str, source: TheoryError },
    #[error(transparent)]
    Argument(#[from] InvalidValue),
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    #[error("{input}: {source}")]
    Columns { input: String, source: ColumnError },
    #[error("cannot read rows from {input}: {source}")]
    Rows { input: String, source: csv::Error },
    #[error("{}: its name shows no format: give --format", path.display())]
    Format { path: PathBuf },
    #[error("{} is being written by another run", path.display())]
    Busy { path: PathBuf },
    #[error("{}: {source}", path.display())]
    Table { path: PathBuf, source: FileError },
    #[error("{} is a contact map, not a table of creep force", path.display())]
    IsMap { path: PathBuf },
    #[error("{} is a contact map; --exact takes the wheelset's file, from which the map was made", path.display())]
    ExactMap { path: PathBuf },
    #[error("{} is a table of creep force, not a contact map", path.display())]
    IsTable { path: PathBuf },
    #[error("{theory}: {source}")]
    Build { theory: &'static str, source: BuildError<TheoryError> },
    #[error("{option} is needed: the table has values from {low} to {high}")]
    Needed { option: &'static str, low: f64, high: f64 },
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
    #[error("{} would be written over what was read: give another --out or --table", path.display())]
    OverSource { path: PathBuf },
    #[error("cannot write to standard output: {0}")]
    Stdout(io::Error),
    #[error(transparent)]
    Report(ReportError),
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Write { path, source } => Self::Write { path, source },
            ReportError::OverSource { path } => Self::OverSource { path },
            other => Self::Report(other),
        }
    }
}

impl Failure {
    /// A failed write to a file, or to standard output where there is none.
    pub(crate) fn writing(file: Option<&Path>, source: io::Error) -> Self {
        match file {
            Some(path) => Self::Write { path: path.into(), source },
            None => Self::Stdout(source),
        }
    }

    /// The exit code; `None` where there is nothing to complain about: the reader of our output,
    /// such as `head`, has seen enough.
    pub(crate) fn code(&self) -> Option<u8> {
        match self {
            Self::Stdout(source) if source.kind() == ErrorKind::BrokenPipe => None,
            Self::Write { source, .. } if is_wrong_place(source.kind()) => Some(2),
            Self::Wear { source, .. } => Some(if source.is_wrong_input() { 2 } else { 1 }),
            Self::Stdout(_)
            | Self::Write { .. }
            | Self::Rows { .. }
            | Self::Report(_)
            | Self::Reference(_)
            | Self::Reproduce(_) => Some(1),
            _ => Some(2),
        }
    }
}

fn standard_profiles() -> String {
    Standard::NAMES.map(|(name, _)| name).join(", ")
}

/// The options that say what a profile's file does not show.
fn how_to_say(error: &ProfileFileError) -> &'static str {
    match error {
        ProfileFileError::Ask { .. } => " (--role, --side, --y, --z)",
        ProfileFileError::Role { .. } => " (--role)",
        ProfileFileError::UpsideDown { .. } => " (--z)",
        ProfileFileError::FlangeOutside { .. } => " (--y)",
        ProfileFileError::Length { .. } => " (--unit)",
        _ => "",
    }
}

/// Is the place that we were told to write to wrong, rather than the writing?
fn is_wrong_place(kind: ErrorKind) -> bool {
    matches!(
        kind,
        ErrorKind::NotFound
            | ErrorKind::PermissionDenied
            | ErrorKind::AlreadyExists
            | ErrorKind::NotADirectory
            | ErrorKind::IsADirectory
            | ErrorKind::ReadOnlyFilesystem
            | ErrorKind::InvalidFilename
            | ErrorKind::InvalidInput
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(kind: ErrorKind) -> [Option<u8>; 2] {
        [None, Some(Path::new("out"))].map(|file| Failure::writing(file, kind.into()).code())
    }

    #[test]
    fn a_wrong_place_is_wrong_input_and_a_full_disk_is_not() {
        assert_eq!(code(ErrorKind::NotADirectory)[1], Some(2));
        assert_eq!(code(ErrorKind::PermissionDenied)[1], Some(2));
        assert_eq!(code(ErrorKind::StorageFull), [Some(1), Some(1)]);
    }

    #[test]
    fn a_reader_that_has_seen_enough_is_no_failure() {
        assert_eq!(code(ErrorKind::BrokenPipe), [None, Some(1)]);
    }
}
