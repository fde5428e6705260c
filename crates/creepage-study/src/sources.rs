//! Files that were read, over which no result is written.

use std::fs;
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

    /// Checks that a file to be written is none of them, by whatever name.
    ///
    /// # Errors
    /// [`ReportError::OverSource`].
    pub fn spare(&self, target: &Path) -> Result<(), ReportError> {
        let real = |path: &Path| fs::canonicalize(path).ok();
        let is_target =
            |target: PathBuf| self.0.iter().any(|source| real(source) == Some(target.clone()));
        if real(target).filter(|target| target.is_file()).is_some_and(is_target) {
            return Err(ReportError::OverSource { path: target.into() });
        }
        Ok(())
    }
}
