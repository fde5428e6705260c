//! The report as files: all of them or none.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::ReportError;
use crate::raster;
use crate::report::Report;

impl Report<'_> {
    /// Writes `report.json`, `points.csv`, `contact.svg` and `contact.png` into `directory`, which
    /// is made when missing; files of those names are replaced. Gives the paths written.
    ///
    /// Everything is rendered before anything is written, and written under other names before
    /// the first file appears under its own.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.json())?;
        json.push('\n');
        let svg = self.contact_svg();
        let png = raster::png(&svg)?;
        write_all(
            directory,
            &[
                ("report.json", json.as_bytes()),
                ("points.csv", &self.points_csv()?),
                ("contact.svg", svg.as_bytes()),
                ("contact.png", &png),
            ],
        )
    }
}

fn write_all(directory: &Path, files: &[(&str, &[u8])]) -> Result<Vec<PathBuf>, ReportError> {
    let mut made = Made::default();
    made.directory(directory)?;
    let mut renames = Vec::new();
    for (name, contents) in files {
        let partial = directory.join(format!(".{name}.{}.partial", std::process::id()));
        made.file(&partial, contents)?;
        renames.push((partial, directory.join(name)));
    }
    for (partial, path) in &renames {
        made.rename(partial, path)?;
    }
    made.keep();
    Ok(renames.into_iter().map(|(_, path)| path).collect())
}

/// What this call has made so far; dropped before [`Made::keep`], it removes it again.
#[derive(Default)]
struct Made {
    directories: Vec<PathBuf>,
    files: Vec<PathBuf>,
}

impl Made {
    fn directory(&mut self, directory: &Path) -> Result<(), ReportError> {
        let missing =
            directory.ancestors().take_while(|d| !d.as_os_str().is_empty() && !d.exists());
        self.directories = missing.map(Path::to_path_buf).collect();
        fs::create_dir_all(directory).map_err(|source| failure(directory, source))
    }

    fn file(&mut self, path: &Path, contents: &[u8]) -> Result<(), ReportError> {
        self.files.push(path.to_path_buf());
        fs::write(path, contents).map_err(|source| failure(path, source))
    }

    fn rename(&mut self, from: &Path, to: &Path) -> Result<(), ReportError> {
        fs::rename(from, to).map_err(|source| failure(to, source))?;
        self.files.push(to.to_path_buf());
        Ok(())
    }

    fn keep(mut self) {
        self.files.clear();
        self.directories.clear();
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        // Best effort: what cannot be removed was never made, or is in use by others.
        for file in &self.files {
            let _ = fs::remove_file(file);
        }
        for directory in &self.directories {
            let _ = fs::remove_dir(directory);
        }
    }
}

fn failure(path: &Path, source: io::Error) -> ReportError {
    ReportError::Write { path: path.to_path_buf(), source }
}
