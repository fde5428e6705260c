//! Text, JSON, points and files.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::StaticsReport;
use super::quantity::Quantity;
use crate::error::ReportError;
use crate::raster;
use crate::text::aligned;
use crate::write::write_all;

/// Cells across the box around the contact; each whose centre is in the contact is a point.
const CELLS: u32 = 40;

impl StaticsReport<'_> {
    /// A short report for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.title);
        for (heading, quantities) in [("Given", &self.given), ("Found", &self.found)] {
            text.push_str(&format!("\n{heading}\n"));
            for quantity in quantities {
                let line = format!("  {:<30}{}", quantity.name, aligned(&quantity.written(5)));
                text.push_str(line.trim_end());
                text.push('\n');
            }
        }
        if self.field.is_singular() {
            let name = self.field.name();
            text.push_str(&format!("\nThe {name} grows without bound towards the edge.\n"));
        }
        text
    }

    /// The same numbers for programs; one that is not finite is `null`.
    #[must_use]
    pub fn json(&self) -> Value {
        let object = |quantities: &[Quantity]| -> Map<String, Value> {
            quantities.iter().map(|q| (q.key.into(), json!(q.value))).collect()
        };
        json!({
            "creepage_version": env!("CARGO_PKG_VERSION"),
            "problem": self.problem,
            "given": object(&self.given),
            "found": object(&self.found),
        })
    }

    /// Writes `report.json`, `points.csv`, `contact.svg` and `contact.png` into `directory`, which
    /// is made when missing; files of those names are replaced. Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let json = format!("{:#}\n", self.json());
        let svg = self.svg();
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

    /// The field at points of the contact; a cell is empty where a number does not exist.
    fn points_csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record([&["x_m", "y_m"], self.field.header()].concat())?;
        for point in self.points() {
            let row = [point.to_vec(), self.field.row(point)].concat();
            writer.write_record(row.into_iter().map(cell))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        let unit = |k: u32| 2.0 * (f64::from(k) + 0.5) / f64::from(CELLS) - 1.0;
        let (a, b) = (self.ellipse.a(), self.ellipse.b());
        (0..CELLS)
            .flat_map(move |j| (0..CELLS).map(move |i| [unit(i), unit(j)]))
            .filter(|[x, y]| x.hypot(*y) < 1.0)
            .map(move |[x, y]| [a * x, b * y])
    }
}

/// The shortest text that reads back as the same number.
fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { String::new() }
}
