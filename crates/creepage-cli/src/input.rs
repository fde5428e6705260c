//! Input files of the commands: case files, tables, and the theories that they name.

use std::fs;
use std::io;
use std::path::Path;

use creepage::TheorySpec;
use creepage::table::{FileError, Table};
use creepage_map::ContactMap;
use creepage_study::{AnyCase, AnyCaseFile, Sources, WheelsetFile};

use crate::failure::Failure;
use crate::output::say;

/// A case file of any contact, its form checked.
pub(crate) fn read_any(path: &Path) -> Result<AnyCaseFile, Failure> {
    let wrong = |source| Failure::Gap { path: path.into(), source: Box::new(source) };
    AnyCaseFile::read(&read_text(path)?).map_err(wrong)
}

/// Whether a file is that of a wheelset; false where it cannot be read.
pub(crate) fn is_wheelset(path: &Path) -> bool {
    let text = fs::read_to_string(path).unwrap_or_default();
    WheelsetFile::is_one(&text)
}

/// A case of any contact.
pub(crate) fn read_any_case(path: &Path) -> Result<AnyCase, Failure> {
    any_case(path, &read_text(path)?)
}

/// A case of any contact, of a text that stood at `path`.
pub(crate) fn any_case(path: &Path, text: &str) -> Result<AnyCase, Failure> {
    let wrong = |source| Failure::Gap { path: path.into(), source: Box::new(source) };
    AnyCaseFile::read(text).and_then(|file| file.case(directory(path))).map_err(wrong)
}

/// A case file, and what it reads for its gap; what is wrong with it is found when it is solved.
pub(crate) fn sources_of(path: &Path) -> Sources {
    let own = Sources::new([path]);
    let Ok(text) = fs::read_to_string(path) else { return own };
    match AnyCaseFile::read(&text) {
        Ok(AnyCaseFile::Gap(file)) => own.with(&file.sources(directory(path))),
        Ok(AnyCaseFile::Ellipse(file)) => own.with(&file.sources(directory(path))),
        Err(_) => own,
    }
}

/// Where files stand that a case file names.
pub(crate) fn directory(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

/// The text of a file of any kind; that of standard input where the path is `-`.
pub(crate) fn read_text(path: &Path) -> Result<String, Failure> {
    let read = if path == Path::new("-") {
        io::read_to_string(io::stdin())
    } else {
        fs::read_to_string(path)
    };
    read.map_err(|source| Failure::Read { path: path.into(), source })
}

/// The theories of these names for a case, its own where there are none; says when the options of
/// the case file have no effect.
pub(crate) fn theories(names: &[String], case: &AnyCase) -> Result<Vec<TheorySpec>, Failure> {
    if names.is_empty() {
        return Ok(vec![case.theory().clone()]);
    }
    let theories =
        names.iter().map(|name| case.theory_named(name)).collect::<Result<Vec<_>, _>>()?;
    if case.gives_up_options(&theories) {
        let own = case.theory().facts().name;
        say(&format!("note: the options in [solve] are those of {own}, and have no effect"));
    }
    Ok(theories)
}

/// The table of creep force of a file.
pub(crate) fn read_table(path: &Path) -> Result<Table, Failure> {
    let bytes = fs::read(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    match Table::from_bytes(bytes.clone()) {
        // Contact maps have a format's number too.
        Err(FileError::Format { .. }) if ContactMap::from_bytes(bytes).is_ok() => {
            Err(Failure::IsMap { path: path.into() })
        }
        table => table.map_err(|source| Failure::Table { path: path.into(), source }),
    }
}
