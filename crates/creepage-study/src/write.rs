//! Writer of the report's files: all of them or none.

use std::path::{Path, PathBuf};

use crate::error::ReportError;
use crate::file_set::write_all;
use crate::sources::Sources;
use crate::{Damage, Heat, SolvedCase};

impl SolvedCase {
    /// Writes `report.json`, `points.csv`, `contact.vtk`, `contact.svg` and `contact.png`, and where
    /// it is a roller `along.csv`, `along.svg` and its `.png`, where
    /// `[damage]` asks for them `wear.csv`, `wear.svg`, `shakedown.svg` and their `.png`, where
    /// `[heat]` does `temperature.csv`, `.svg` and `.png`, into
    /// `directory`, which is made when missing; files of those names are replaced, but none that the
    /// case was read from and none of `sources`. Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.report())?;
        json.push('\n');
        let vtk = self.vtk();
        let wear = self.damage().ok().flatten().map(Damage::files).transpose()?;
        let heat = self.heat().map(Heat::files).transpose()?;
        let mut others = vec![("contact.vtk", vtk.as_bytes())];
        for (name, contents) in wear.iter().flatten().chain(heat.iter().flatten()) {
            others.push((*name, &contents[..]));
        }
        let along = self.along_roller().transpose()?;
        let along_png = along.as_ref().map(|(_, svg)| creepage_plot::png(svg)).transpose()?;
        if let (Some((table, svg)), Some(png)) = (&along, &along_png) {
            others.push(("along.csv", table));
            others.push(("along.svg", svg.as_bytes()));
            others.push(("along.png", png));
        }
        let (points, svg) = (self.points_csv()?, self.contact_svg());
        write_contact(
            directory,
            [&json, &svg],
            &points,
            &others,
            &self.case.sources().with(sources),
        )
    }
}

/// The files of one contact: `report.json`, `points.csv`, the picture as SVG and PNG, and others.
pub(crate) fn write_contact(
    directory: &Path,
    [json, svg]: [&str; 2],
    points: &[u8],
    others: &[(&str, &[u8])],
    sources: &Sources,
) -> Result<Vec<PathBuf>, ReportError> {
    let png = creepage_plot::png(svg)?;
    let files: [(&str, &[u8]); 4] = [
        ("report.json", json.as_bytes()),
        ("points.csv", points),
        ("contact.svg", svg.as_bytes()),
        ("contact.png", &png),
    ];
    write_all(directory, &[&files, others].concat(), sources)
}

#[cfg(test)]
mod tests {
    use std::error::Error as _;
    use std::{fs, io};

    use super::*;
    use crate::testing::{CURVE, Trial, report};

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
        let report = report(1.5, Trial::Sticking, CURVE);
        let directories = ["one", "two/deeper"].map(|name| root.path().join(name));
        for directory in &directories {
            let paths = report.write(directory, &Sources::default()).unwrap();
            assert_eq!(paths.len(), 5);
            assert!(paths.iter().all(|path| path.is_file()));
            assert_eq!(
                names(directory),
                ["contact.png", "contact.svg", "contact.vtk", "points.csv", "report.json"]
            );
        }
        report.write(&directories[0], &Sources::default()).unwrap(); // replaces what is there
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
        let error = report(1.0, Trial::Sticking, CURVE)
            .write(&file.join("out"), &Sources::default())
            .unwrap_err();
        assert!(error.to_string().contains("file"), "{error}");
        assert!(error.source().unwrap().is::<io::Error>());
        assert_eq!(names(root.path()), ["file"]);
    }

    #[test]
    fn what_was_made_before_a_failure_is_removed() {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir(root.path().join("contact.png")).unwrap();
        let error = report(1.0, Trial::Sticking, CURVE)
            .write(root.path(), &Sources::default())
            .unwrap_err();
        assert!(matches!(error, ReportError::Write { path, .. } if path.ends_with("contact.png")));
        assert_eq!(names(root.path()), ["contact.png"]);
    }
}
