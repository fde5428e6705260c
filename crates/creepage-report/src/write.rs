//! The report as files: all of them or none.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::ReportError;
use crate::report::Report;

impl Report<'_> {
    /// Writes `report.json`, `points.csv`, `contact.vtk`, `contact.svg` and `contact.png` into
    /// `directory`, which is made when missing; files of those names are replaced. Gives the paths
    /// written.
    ///
    /// Everything is rendered before anything is written, and written under other names before
    /// the first file appears under its own.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.json())?;
        json.push('\n');
        let vtk = self.vtk();
        let field = [("contact.vtk", vtk.as_bytes())];
        write_contact(directory, &json, &self.points_csv()?, &self.contact_svg(), &field)
    }
}

/// The files of one contact: `report.json`, `points.csv`, the picture as SVG and PNG, and others.
pub(crate) fn write_contact(
    directory: &Path,
    json: &str,
    points: &[u8],
    svg: &str,
    others: &[(&str, &[u8])],
) -> Result<Vec<PathBuf>, ReportError> {
    let png = creepage_plot::png(svg)?;
    let files: [(&str, &[u8]); 4] = [
        ("report.json", json.as_bytes()),
        ("points.csv", points),
        ("contact.svg", svg.as_bytes()),
        ("contact.png", &png),
    ];
    write_all(directory, &[&files, others].concat())
}

/// Writes files, by name and contents, into `directory`, which is made when missing: all of them
/// or none. Files of those names are replaced. Gives the paths written.
///
/// # Errors
/// [`ReportError::Write`]; what was made until then is removed.
pub fn write_all(directory: &Path, files: &[(&str, &[u8])]) -> Result<Vec<PathBuf>, ReportError> {
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

#[cfg(test)]
mod tests {
    use std::error::Error as _;

    use super::*;
    use crate::testing::{CURVE, contact, report, sticking};

    fn names(directory: &Path) -> Vec<String> {
        let entries = fs::read_dir(directory).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn five_files_in_a_new_directory_the_same_each_time() {
        let root = tempfile::tempdir().unwrap();
        let (contact, theory) = (contact(1.5), sticking(1.5));
        let report = report(&contact, &theory, CURVE);
        let directories = ["one", "two/deeper"].map(|name| root.path().join(name));
        for directory in &directories {
            let paths = report.write(directory).unwrap();
            assert_eq!(paths.len(), 5);
            assert!(paths.iter().all(|path| path.is_file()));
            assert_eq!(
                names(directory),
                ["contact.png", "contact.svg", "contact.vtk", "points.csv", "report.json"]
            );
        }
        report.write(&directories[0]).unwrap(); // replaces what is there
        for name in names(&directories[0]) {
            let [one, two] = [0, 1].map(|k| fs::read(directories[k].join(&name)).unwrap());
            assert!(one == two && !one.is_empty(), "{name}");
        }
    }

    #[test]
    fn a_directory_that_cannot_be_made_is_named_with_its_cause() {
        let root = tempfile::tempdir().unwrap();
        let file = root.path().join("file");
        fs::write(&file, "in the way").unwrap();
        let (contact, theory) = (contact(1.0), sticking(1.0));
        let error = report(&contact, &theory, CURVE).write(&file.join("out")).unwrap_err();
        assert!(error.to_string().contains("file"), "{error}");
        assert!(error.source().unwrap().is::<io::Error>());
        assert_eq!(names(root.path()), ["file"]);
    }

    #[test]
    fn what_was_made_before_a_failure_is_removed() {
        let root = tempfile::tempdir().unwrap();
        let (contact, theory) = (contact(1.0), sticking(1.0));
        fs::create_dir(root.path().join("contact.png")).unwrap();
        let error = report(&contact, &theory, CURVE).write(root.path()).unwrap_err();
        assert!(matches!(error, ReportError::Write { path, .. } if path.ends_with("contact.png")));
        assert_eq!(names(root.path()), ["contact.png"]);

        let new = root.path().join("new/deep");
        let bad: [(&str, &[u8]); 2] = [("good", b"1"), ("no/such", b"2")];
        assert!(write_all(&new, &bad).is_err());
        assert_eq!(names(root.path()), ["contact.png"]);
    }
}
