//! Output of statics problems: text, JSON, points and files.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::StaticsReport;
use super::field::Field;
use crate::error::ReportError;
use crate::report::{Report, ReportPart, words};
use crate::sources::Sources;
use crate::text::{Lines, aligned};
use crate::write::write_contact;

/// Cells across the box around the contact; each whose centre is in the contact is a point.
const CELLS: u32 = 40;

impl StaticsReport<'_> {
    /// A short report for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        // Writing to a String cannot fail.
        let mut lines = Lines::default();
        lines.line(self.title);
        for caution in &self.cautions {
            lines.caution(&caution.to_string());
        }
        let mut text = lines.into_text();
        for (heading, section) in [("Given", "given"), ("Found", "found")] {
            let _ = writeln!(text, "\n{heading}");
            for quantity in self.numbers.of_section(section) {
                let written = quantity.text().unwrap_or_default();
                let line = format!("  {:<30}{}", quantity.label, aligned(&written));
                let _ = writeln!(text, "{}", line.trim_end());
            }
        }
        text.push_str(&self.steps_text());
        if self.field.is_singular() {
            let name = self.field.name();
            let _ = writeln!(text, "\nThe {name} grows without bound towards the edge.");
        }
        text
    }

    /// What was given and found, and of a path every step, with words; ready for `serde_json`.
    #[must_use]
    pub fn report(&self) -> Report {
        let mut report = Report::default();
        report.part("", "creepage_version", env!("CARGO_PKG_VERSION").into());
        report.part("", "problem", self.problem.into());
        report.part("", "caution", ReportPart::Text(words(&self.cautions)));
        report.append(&self.numbers);
        if !self.path.is_empty() {
            report.part("", "steps", ReportPart::Reports(self.path.reports()));
        }
        report
    }

    /// The report for programs; a number that is not finite is `null`.
    #[must_use]
    pub fn json(&self) -> Value {
        json!(self.report())
    }

    /// Writes `report.json`, `points.csv`, `contact.svg` and `contact.png`, of a path also `path.csv`, `path.svg` and
    /// `path.png`, of a rectangle's `path.csv` alone, for force over shift is its picture, into `directory`, which is made when missing; files of those names are replaced, but none of `sources`. Gives the paths written.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let json = format!("{:#}\n", self.json());
        let (points, svg) = (self.points_csv()?, self.svg());
        let path = self.path_files()?;
        let others: Vec<_> = path.iter().map(|(name, bytes)| (*name, &bytes[..])).collect();
        write_contact(directory, [&json, &svg], &points, &others, sources)
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
        let is_rectangle = matches!(self.field, Field::Rectangle(_));
        (0..CELLS)
            .flat_map(move |j| (0..CELLS).map(move |i| [unit(i), unit(j)]))
            .filter(move |[x, y]| is_rectangle || x.hypot(*y) < 1.0)
            .map(move |[x, y]| [a * x, b * y])
    }
}

/// The shortest text that reads back as the same number.
pub(super) fn cell(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { String::new() }
}

#[cfg(test)]
mod tests {
    use creepage::Ellipse;
    use creepage::Solid;
    use creepage::statics::Die;

    use super::*;

    fn with_report(offset: [f64; 2], look: impl Fn(&StaticsReport)) {
        let (steel, base) = (Solid::new(82e9, 0.28).unwrap(), Ellipse::new(5e-3, 10e-3).unwrap());
        let die = Die::new(steel, base, 20e3, offset).unwrap();
        look(&StaticsReport::die(steel, base, 20e3, offset, &die).unwrap());
    }

    #[test]
    fn no_line_of_text_is_wider_than_a_terminal_or_carries_no_number() {
        with_report([0.0, 0.0], |report| {
            let text = report.text();
            assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
            assert_eq!(text.lines().filter(|line| line.starts_with("  ")).count(), 19);
            assert!(text.lines().all(|line| !line.ends_with(" -")), "{text}");
        });
    }

    /// A central load tilts nothing; the tilt stiffness is there all the same.
    #[test]
    fn a_tilt_is_moment_over_stiffness() {
        let stiffness = |report: &StaticsReport| {
            report.json()["found"]["stiffness_tilt_x_n_m_per_rad"].as_f64().unwrap()
        };
        with_report([0.0, 0.0], |central| {
            assert!(stiffness(central) > 0.0);
            with_report([1e-3, 0.0], |offset| {
                let tilt = offset.json()["found"]["tilt_x_rad"].as_f64().unwrap();
                // A few roundings.
                assert!((tilt * stiffness(central) / 20.0 - 1.0).abs() < 1e-13);
            });
        });
    }

    #[test]
    fn the_points_carry_the_load() {
        with_report([1e-3, -2e-3], |report| {
            let csv = String::from_utf8(report.points_csv().unwrap()).unwrap();
            let rows: Vec<Vec<f64>> = (csv.lines().skip(1))
                .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
                .collect();
            let cell = 4.0 * 5e-3 * 10e-3 / f64::from(CELLS * CELLS);
            let force: f64 = rows.iter().map(|row| row[2] * cell).sum();
            // Cells at the edge, where the pressure has no bound: some per cent.
            assert!((force / 20e3 - 1.0).abs() < 0.05, "{force}");
            // Under the die the surface is the plane of its base.
            let found = report.json()["found"].clone();
            let number = |key: &str| found[key].as_f64().unwrap();
            for row in &rows {
                let depth = number("indentation_m")
                    + number("tilt_x_rad") * row[0]
                    + number("tilt_y_rad") * row[1];
                assert!((row[5] / depth - 1.0).abs() < 1e-12, "{row:?}");
            }
        });
    }
}
