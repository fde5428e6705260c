//! Reads the input files (`.inp`) of the program CONTACT, modules 1 and 3, and writes case files of creepage,
//! one a case.
//!
//! The format is that of the program's public user guide: control digits say which numbers follow, and what is
//! left out stays as in the case before. Units become SI, signs those of creepage; what has no counterpart is told.
//!
//! ```no_run
//! let imported = creepage_import::import("bank.inp".as_ref(), "cases".as_ref())?;
//! for case in &imported.cases {
//!     println!("{}: {:?}", case.name, case.written);
//! }
//! # Ok::<(), creepage_import::ImportError>(())
//! ```

// Numbers of a file are checked for their range before they become counts.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
// Numbers are compared as the file has them: alike or not.
#![allow(clippy::float_cmp)]

mod bodies;
mod bodies_case;
mod lines;
mod profiles;
mod read;
mod text;
mod wheels;
mod wheels_case;
mod wheels_steps;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use bodies::Bodies;
use lines::Lines;
use profiles::Profiles;
use read::Control;
use wheels::Wheels;

/// Error of an input file that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ImportError {
    /// A file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A line that is not what the control digits say.
    #[error("line {line}: expected {expected}, found `{found}`")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What should stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// The file ends within a case.
    #[error("the file ends where {expected} should stand")]
    End {
        /// What should stand there.
        expected: String,
    },
    /// A file without a case.
    #[error("the file has no case")]
    Empty,
}

/// Why a case is not written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotWritten {
    /// No case file of creepage says it.
    #[error("it has no counterpart: {0}")]
    NoCounterpart(String),
    /// A file that it names is not there.
    #[error("file {file} was not found beside {beside}")]
    NotFound {
        /// The file, as the input names it.
        file: String,
        /// The file that names it.
        beside: String,
    },
    /// A list of slices that cannot be read.
    #[error("file {file} cannot be read: {why}")]
    Unread {
        /// The file, as the input names it.
        file: String,
        /// Why.
        why: String,
    },
    /// The input itself says so.
    #[error("that program skips it too (R = 2, 3)")]
    Skipped,
}

impl From<String> for NotWritten {
    fn from(cause: String) -> Self {
        Self::NoCounterpart(cause)
    }
}

impl From<&str> for NotWritten {
    fn from(cause: &str) -> Self {
        Self::NoCounterpart(cause.into())
    }
}

/// Output file: its name and contents.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its name in the directory.
    pub name: String,
    /// What is in it.
    pub contents: Vec<u8>,
}

impl File {
    fn text(name: String, text: String) -> Self {
        Self { name, contents: text.into_bytes() }
    }
}

/// Converted case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The command that solves it.
    pub command: String,
    /// The case file, and the table of its history where it has one.
    pub files: Vec<File>,
}

impl Written {
    fn of(command: String, file: File) -> Self {
        Self { command, files: vec![file] }
    }
}

/// A case of an input file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Case {
    /// The input file's name and the case's number, from 1.
    pub name: String,
    /// The line at which it begins.
    pub line: usize,
    /// The case file, or why it is not written.
    pub written: Result<Written, NotWritten>,
    /// What of it has no counterpart, and why.
    pub notes: Vec<String>,
}

/// All cases of an input file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Imported {
    /// In the file's order.
    pub cases: Vec<Case>,
    /// Profiles to be copied beside the case files.
    pub profiles: Vec<File>,
    /// The files that were read.
    pub sources: Vec<PathBuf>,
}

/// Reads an input file; its case files are to stand in `out`, which is not touched.
///
/// # Errors
/// [`ImportError`] with the line and what was expected there.
pub fn import(path: &Path, out: &Path) -> Result<Imported, ImportError> {
    let failed = |source| ImportError::Read { path: path.into(), source };
    let text = fs::read(path).map_err(failed)?;
    let text = creepage_rail::file::unicode(&text);
    let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let mut reader = Reader { file, stem, ..Reader::new(Profiles::new(path, out)) };
    let mut lines = Lines::new(&text);
    reader.read(&mut lines)?;
    if reader.cases.is_empty() {
        return Err(ImportError::Empty);
    }
    let profiles = reader.profiles.files()?;
    let mut sources = reader.profiles.paths();
    sources.push(path.into());
    Ok(Imported { cases: reader.cases, profiles, sources })
}

/// What is known while a file is read.
struct Reader {
    file: String,
    stem: String,
    profiles: Profiles,
    bodies: Bodies,
    /// The cases of which the history of the last one consists.
    chain: Vec<Bodies>,
    wheels: Wheels,
    /// The cases of module 1 of which the history of the last one consists.
    wheel_chain: Vec<Wheels>,
    cases: Vec<Case>,
}

impl Reader {
    fn new(profiles: Profiles) -> Self {
        Self {
            file: String::new(),
            stem: String::new(),
            profiles,
            bodies: Bodies::default(),
            chain: Vec::new(),
            wheels: Wheels::default(),
            wheel_chain: Vec::new(),
            cases: Vec::new(),
        }
    }

    fn read(&mut self, lines: &mut Lines) -> Result<(), ImportError> {
        while !lines.is_at_end() {
            let line = lines.number();
            let error = lines.expected("MODULE: 1, 3, or 0 at the end");
            let [module] = lines.array("MODULE: 1, 3, or 0 at the end")?;
            if module == 0.0 {
                return Ok(());
            }
            if module != 1.0 && module != 3.0 {
                return Err(error);
            }
            while self.case(module == 1.0, line, lines)?.goes_on() {}
        }
        Ok(())
    }

    /// Reads a case and writes it.
    fn case(
        &mut self,
        is_wheel: bool,
        line: usize,
        lines: &mut Lines,
    ) -> Result<Control, ImportError> {
        let number = self.cases.len() + 1;
        let name = format!("{}-{number}", self.stem);
        let module = if is_wheel { 1 } else { 3 };
        let title = format!("Case {number} of {} (CONTACT, module {module})", self.file);
        let mut notes = Vec::new();
        let (control, written) = if is_wheel {
            self.wheels = self.wheels.next(lines)?;
            let control = self.wheels.control;
            if matches!(control.tangential(), 0 | 3) || control.history() == 2 {
                self.wheel_chain.clear();
            }
            self.wheel_chain.push(self.wheels.clone());
            let (chain, profiles) = (&self.wheel_chain, &mut self.profiles);
            (control, wheels_case::write(chain, (&name, &title), profiles, &mut notes))
        } else {
            self.bodies = self.bodies.next(lines)?;
            let control = self.bodies.control;
            if control.tangential() == 3 || control.history() == 2 {
                self.chain.clear();
            }
            self.chain.push(self.bodies.clone());
            let written = bodies_case::write(&self.chain, &name, &title, &mut notes);
            (control, written.map_err(NotWritten::from))
        };
        let written = if control.is_skipped() { Err(NotWritten::Skipped) } else { written };
        self.cases.push(Case { name, line, written, notes });
        Ok(control)
    }
}
