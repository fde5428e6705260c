//! Wear across the contact as a table.

use super::Damage;
use crate::error::ReportError;

const HEADER: [&str; 4] = ["y", "usfd_depth", "archard_depth", "archard_zone"];

impl Damage {
    /// `wear.csv`, the shakedown map as `shakedown.svg` and `.png`, and where there is wear to show
    /// `wear.svg` and `wear.png`.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, Vec<u8>)>, ReportError> {
        let mut files = vec![("wear.csv", self.csv()?)];
        let map = self.map_svg();
        let png = creepage_plot::png(&map)?;
        files.extend([("shakedown.svg", map.into_bytes()), ("shakedown.png", png)]);
        if let Some(svg) = self.svg() {
            let png = creepage_plot::png(&svg)?;
            files.extend([("wear.svg", svg.into_bytes()), ("wear.png", png)]);
        }
        Ok(files)
    }

    /// A row for each place across the contact: `y`, depths of one passage (m), and the worst zone of
    /// Archard's map; empty where the rolling velocity is not given.
    ///
    /// # Errors
    /// [`ReportError`] as of the writer of CSV.
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        for row in &self.across {
            let zone = row.zone.map_or("", |zone| zone.name());
            let archard = row.archard_depth.map_or(String::new(), |depth| format!("{depth:e}"));
            let [y, usfd] = [row.y, row.usfd_depth].map(|number| format!("{number:e}"));
            writer.write_record([&y[..], &usfd, &archard, zone])?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }
}
