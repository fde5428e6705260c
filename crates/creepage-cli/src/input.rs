//! The files that commands read, and the theories that these ask for.

use std::fs;
use std::path::Path;

use creepage_study::{CaseFile, Entry, Solve};

use crate::failure::Failure;
use crate::output::say;

/// A case file, its form checked.
pub(crate) fn read_case(path: &Path) -> Result<CaseFile, Failure> {
    let text = read_text(path)?;
    CaseFile::read(&text).map_err(|source| Failure::Case { path: path.into(), source })
}

/// The text of a file of any kind.
pub(crate) fn read_text(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })
}

/// The theories to use for a case, at least one; says which options have no effect.
pub(crate) fn choose(
    names: &[String],
    solve: &Solve,
    path: &Path,
) -> Result<Vec<&'static Entry>, Failure> {
    let choice = creepage_study::choose(names, solve)
        .map_err(|source| Failure::Choice { path: path.into(), source })?;
    if let Some(note) = choice.note() {
        say(&note);
    }
    Ok(choice.theories)
}
