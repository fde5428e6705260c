//! The report as files: all of them or none.

use std::path::{Path, PathBuf};

use super::solve::SolvedGap;
use crate::error::ReportError;
use crate::write::write_contact;

impl SolvedGap {
    /// Writes `report.json`, `points.csv`, `contact.vtk`, `contact.svg` and `contact.png`, and
    /// where `[damage]` asks for them `wear.csv`, `wear.svg`, `shakedown.svg` and their `.png`, into `directory`,
    /// which is made when missing; files of those names are replaced, but none that the case was read from.
    /// Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.json())?;
        json.push('\n');
        let vtk = self.vtk();
        let wear = self.damage().map(|damage| damage.files()).transpose()?.unwrap_or_default();
        let mut others = vec![("contact.vtk", vtk.as_bytes())];
        others.extend(wear.iter().map(|(name, contents)| (*name, &contents[..])));
        let (points, svg) = (self.points_csv()?, self.contact_svg());
        write_contact(directory, [&json, &svg], &points, &others, &self.case.sources)
    }
}
