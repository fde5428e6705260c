//! Report of a fit: text, JSON, CSV and files.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::fitted::{Fit, Fitted, FittedPoint};
use crate::error::ReportError;
use crate::file_set::write_all;
use crate::sources::Sources;
use crate::text::Lines;

const HEADER: [&str; 11] = [
    "row",
    "longitudinal",
    "lateral",
    "spin_rad_per_m",
    "normal_force_n",
    "longitudinal_n",
    "lateral_n",
    "fitted_longitudinal_n",
    "fitted_lateral_n",
    "deviations",
    "use",
];

impl Fitted {
    fn words(&self) -> String {
        let [low, high] = self.interval;
        let Self { value, standard_error, .. } = self;
        format!("{value:.4} \u{b1} {standard_error:.4}   (95 %: {low:.4} to {high:.4})")
    }

    fn json(&self) -> Value {
        let Self { value, standard_error, interval } = self;
        json!({ "value": value, "standard_error": standard_error, "interval_95": interval })
    }
}

impl FittedPoint {
    /// Whether it counts: `fitted`, or `bad` where it was left out.
    #[must_use]
    pub fn word(&self) -> &'static str {
        if self.bad { "bad" } else { "fitted" }
    }
}

impl Fit {
    /// A short report for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let mut lines = Lines::default();
        let bad = self.points.iter().filter(|point| point.bad).count();
        let count = self.points.len() - bad;
        lines.line(&format!("Friction fitted to {count} measured points by {}", self.theory));
        for caution in &self.cautions {
            lines.caution(&caution.to_string());
        }
        lines.heading("Found");
        lines.row("mu", &self.friction.words());
        if let Some(slope) = &self.slope {
            lines.row("factor of the slope", &slope.words());
        }
        if let Some(correlation) = self.correlation {
            lines.row("their correlation", &format!("{correlation:.3}"));
        }
        let scatter = format!("{:.5}   (of the normal force, root mean square)", self.scatter);
        lines.row("scatter of the points", &scatter);
        lines.row("largest force", &format!("{:.3}   (of mu N)", self.reached));
        if bad > 0 {
            lines.heading("Points that do not belong to the others, in newtons");
            for point in self.points.iter().filter(|point| point.bad) {
                let names = ["longitudinal", "lateral"];
                let parts = names.iter().zip(point.measured).zip(point.fitted);
                let parts = parts.filter_map(|((name, measured), fitted)| {
                    Some(format!("{name} {:.5e} measured, {fitted:.5e} by the theory", measured?))
                });
                lines.line(&format!("row {}: {}", point.row, parts.collect::<Vec<_>>().join("; ")));
            }
        }
        lines.into_text()
    }

    /// The same for programs, with all points.
    #[must_use]
    pub fn json(&self) -> Value {
        let point = |point: &FittedPoint| {
            let creepage = point.creepage;
            json!({
                "row": point.row,
                "longitudinal": creepage.longitudinal,
                "lateral": creepage.lateral,
                "spin_rad_per_m": creepage.spin,
                "normal_force_n": point.normal_force,
                "measured_n": point.measured,
                "fitted_n": point.fitted,
                "deviations": point.deviations,
                "use": point.word(),
                "status": point.status.name(),
            })
        };
        json!({
            "creepage_version": env!("CARGO_PKG_VERSION"),
            "theory": self.theory,
            "friction": self.friction.json(),
            "slope": self.slope.as_ref().map(Fitted::json),
            "correlation": self.correlation,
            "scatter_over_normal_force": self.scatter,
            "largest_force_over_mu_n": self.reached,
            "degrees_of_freedom": self.degrees_of_freedom,
            "cautions": self.cautions.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "points": self.points.iter().map(point).collect::<Vec<_>>(),
        })
    }

    /// The points beside the theory, a row each; a force that was not measured is empty.
    ///
    /// # Errors
    /// [`ReportError::Points`], should memory not suffice.
    pub fn csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(HEADER)?;
        let number = |value: f64| format!("{value:e}");
        for point in &self.points {
            let creepage = point.creepage;
            writer.write_field(point.row.to_string())?;
            let given =
                [creepage.longitudinal, creepage.lateral, creepage.spin, point.normal_force];
            for value in given {
                writer.write_field(number(value))?;
            }
            for value in point.measured {
                writer.write_field(value.map_or_else(String::new, number))?;
            }
            for value in [point.fitted[0], point.fitted[1], point.deviations] {
                writer.write_field(number(value))?;
            }
            writer.write_record([point.word()])?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }

    /// Writes `fit.json`, `fit.csv`, `fit.svg` and `fit.png` into `directory`, which is made when
    /// missing: all of them or none. Files of those names are replaced, but none of `sources`.
    ///
    /// # Errors
    /// [`ReportError`]; what was made until then is removed.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let svg = self.svg();
        let png = creepage_plot::png(&svg)?;
        let json = serde_json::to_vec_pretty(&self.json())?;
        let files: [(&str, &[u8]); 4] = [
            ("fit.json", &json),
            ("fit.csv", &self.csv()?),
            ("fit.svg", svg.as_bytes()),
            ("fit.png", &png),
        ];
        write_all(directory, &files, sources)
    }
}
