//! Report of a wheelset as files: all of them or none.

use std::path::{Path, PathBuf};

use creepage_wheelset::side_word;

use super::case::WheelsetCase;
use super::report::WheelsetReport;
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::gap::AreaField;
use crate::sources::Sources;

impl WheelsetReport {
    /// Writes `report.json`, the picture `wheelset.svg` and `.png` of the wheels on their rails,
    /// one of each place of contact, `left_1.svg` and so on, what happens in its elements (`left_1.csv`, `left_1.vtk`), and where `[damage]` asks for them
    /// (`[heat]`: temperatures) `wear.csv` and the depth of wear, `left_1_wear.svg`, into `directory`, which is made when
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
        let mut json = serde_json::to_string_pretty(&self.report())?;
        json.push('\n');
        let mut files = vec![("report.json".to_owned(), json.into_bytes())];
        // A solved position is one on this track.
        let whole = self.svg(&case.running).map(|svg| ("wheelset".to_owned(), svg)).ok();
        files.extend(self.wear_csv()?.map(|csv| ("wear.csv".to_owned(), csv)));
        files.extend(self.fields()?);
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

    /// What happens in the elements of each place of contact, in its plane about its reference point: `left_1.csv` and
    /// `left_1.vtk`, and so on.
    fn fields(&self) -> Result<Vec<(String, Vec<u8>)>, ReportError> {
        let mut files = Vec::new();
        for wheel in self.wheels() {
            for (contact, k) in wheel.contacts().iter().zip(1_usize..) {
                let elements = contact.elements();
                let field = AreaField {
                    elements: &elements,
                    scaling: contact.scaling,
                    friction: contact.friction,
                    theory: self.theory.name(),
                };
                let name = format!("{}_{k}", side_word(wheel.side));
                files.push((format!("{name}.csv"), field.csv()?));
                files.push((format!("{name}.vtk"), field.vtk().into_bytes()));
            }
        }
        Ok(files)
    }
}
