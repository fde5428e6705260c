//! The report of a wheelset as files: all of them or none.

use std::path::{Path, PathBuf};

use super::case::WheelsetCase;
use super::solved::SolvedWheelset;
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::sources::Sources;

impl SolvedWheelset {
    /// Writes `report.json`, the picture `wheelset.svg` and `.png` of the wheels on their rails,
    /// and one of each place of contact, `left_1.svg` and so on, and where `[damage]` asks for them
    /// `wear.csv` and the depth of wear, `left_1_wear.svg`, where `[heat]` does
    /// `temperature.csv` and `left_1_temperature.svg`, into `directory`, which is made when
    /// missing; files of those names are replaced, but none that `case` was read from and none of `sources`. Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(
        &self,
        case: &WheelsetCase,
        directory: &Path,
        sources: &Sources,
    ) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.json())?;
        json.push('\n');
        let mut files = vec![("report.json".to_owned(), json.into_bytes())];
        // A solved position is one on this track.
        let whole = self.svg(&case.running).map(|svg| ("wheelset".to_owned(), svg)).ok();
        files.extend(self.wear_csv()?.map(|csv| ("wear.csv".to_owned(), csv)));
        files.extend(self.temperature_csv()?.map(|csv| ("temperature.csv".to_owned(), csv)));
        let pictures = self.contact_svgs().into_iter().chain(self.wear_svgs());
        for (name, svg) in whole.into_iter().chain(pictures).chain(self.temperature_svgs()) {
            let png = creepage_plot::png(&svg)?;
            files.push((format!("{name}.svg"), svg.into_bytes()));
            files.push((format!("{name}.png"), png));
        }
        let files: Vec<(&str, &[u8])> =
            files.iter().map(|(name, content)| (&name[..], &content[..])).collect();
        write_all(directory, &files, &case.sources().with(sources))
    }
}
