//! Source files of the user's, over which no result is written: the one rule for all that is written.
//!
//! A file that a command or a case has read is never replaced, by whatever name; nor is one that stands
//! where a working file goes ([`keep_foreign`]). Results of the same name are.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::error::ReportError;

/// Files that were read, over which no result is written.
///
/// ```
/// use creepage_study::{ReportError, Sources, write_all};
/// # let place = tempfile::tempdir()?;
/// let gap = place.path().join("points.csv");
/// std::fs::write(&gap, "y,gap\n")?;
/// let sources = Sources::new([&gap]);
/// let failed = write_all(place.path(), &[("points.csv", b"x,y\n")], &sources);
/// assert!(matches!(failed, Err(ReportError::OverSource { .. })));
/// assert_eq!(std::fs::read_to_string(gap)?, "y,gap\n");
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Sources(Vec<PathBuf>);

impl Sources {
    /// Of these files.
    pub fn new<P: Into<PathBuf>>(files: impl IntoIterator<Item = P>) -> Self {
        Self(files.into_iter().map(Into::into).collect())
    }

    /// These and others.
    #[must_use]
    pub fn with(mut self, others: &Self) -> Self {
        self.0.extend(others.0.iter().cloned());
        self
    }

    /// Checks that a file to be written is none of them, by whatever name.
    ///
    /// # Errors
    /// [`ReportError::OverSource`].
    pub fn ensure_not_overwritten(&self, target: &Path) -> Result<(), ReportError> {
        let real = |path: &Path| fs::canonicalize(path).ok();
        let is_target =
            |target: PathBuf| self.0.iter().any(|source| real(source) == Some(target.clone()));
        if real(target).filter(|target| target.is_file()).is_some_and(is_target) {
            return Err(ReportError::OverSource { path: target.into() });
        }
        Ok(())
    }
}

/// Checks that a working file at `path`, which goes when the work is done, begins as ours do: as much of
/// `head` as it is long. One that is empty or missing will do.
///
/// # Errors
/// [`io::ErrorKind::AlreadyExists`] for another file, which stays as it is; those of the system.
pub(crate) fn keep_foreign(path: &Path, head: &[u8]) -> io::Result<()> {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(error) => return Err(error),
    };
    let mut found = Vec::new();
    file.take(head.len() as u64).read_to_end(&mut found)?;
    if head.starts_with(&found) {
        return Ok(());
    }
    let words = "another file stands where the work so far is kept; move it";
    Err(io::Error::new(io::ErrorKind::AlreadyExists, words))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_working_file_is_ours_as_far_as_it_is_written() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("work");
        keep_foreign(&path, b"creepage").unwrap();
        for ours in ["", "cree", "creepage", "creepage and more"] {
            fs::write(&path, ours).unwrap();
            keep_foreign(&path, b"creepage").unwrap();
        }
        for foreign in ["my notes", "c,d", "creep it"] {
            fs::write(&path, foreign).unwrap();
            let error = keep_foreign(&path, b"creepage").unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::AlreadyExists);
            assert_eq!(fs::read_to_string(&path).unwrap(), foreign);
        }
    }
}
