//! A solved line contact as text, JSON and files.

use std::path::{Path, PathBuf};

use creepage_plot::format::{fixed, quantity, significant};
use serde::Serialize;

use super::file::Given;
use super::solved::SolvedLine;
use crate::Caution;
use crate::error::ReportError;
use crate::sources::Sources;
use crate::text::{Lines, status_words};
use crate::write::write_contact;

/// `report.json` of a line contact; forces and energies are per metre of the cylinders' length.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LineReportJson {
    /// Version of this program.
    pub creepage_version: &'static str,
    /// `exact` or `carter`.
    pub theory: &'static str,
    /// One word: [`Status::name`](creepage::Status::name).
    pub status: &'static str,
    /// Cautions about the solution, in words; else `null`.
    pub caution: Option<String>,
    /// Load (N/m).
    pub line_load_n_per_m: f64,
    /// Half the width of the contact without friction, of elastic bodies (m).
    pub half_width_m: f64,
    /// Trailing edge (m), from the line of the centres.
    pub trailing_edge_m: f64,
    /// Leading edge (m).
    pub leading_edge_m: f64,
    /// The largest pressure (Pa).
    pub peak_pressure_pa: f64,
    /// Its place (m).
    pub peak_place_m: f64,
    /// How far the centre of pressure lies ahead (m).
    pub pressure_centre_m: f64,
    /// Curvature length `rho` (m).
    pub rho_m: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// How unlike the bodies are.
    pub kappa: f64,
    /// Creepage of the upper body relative to the lower.
    pub longitudinal_creepage: f64,
    /// The same, dimensionless.
    pub xi: f64,
    /// `creepage` or `force`: what was given.
    pub given: &'static str,
    /// Force on the lower body (N/m).
    pub longitudinal_force_n_per_m: f64,
    /// The same over `mu N`.
    pub fx: f64,
    /// Part of the width that adheres.
    pub adhesion_share: f64,
    /// Energy that friction turns to heat per metre rolled (J/m2).
    pub friction_heat_j_per_m2: f64,
    /// Force against which viscoelastic cylinders roll (N/m); else `null`.
    pub rolling_resistance_n_per_m: Option<f64>,
    /// Rolling velocity (m/s), where it is known.
    pub rolling_velocity_m_per_s: Option<f64>,
}

impl SolvedLine {
    /// Everything but the points.
    #[must_use]
    pub fn json(&self) -> LineReportJson {
        let case = &self.case;
        LineReportJson {
            creepage_version: env!("CARGO_PKG_VERSION"),
            theory: case.theory.name(),
            status: self.status.name(),
            caution: (!self.cautions.is_empty()).then(|| Caution::words(&self.cautions)),
            line_load_n_per_m: case.load,
            half_width_m: case.line.half_width(),
            trailing_edge_m: self.edges[0],
            leading_edge_m: self.edges[1],
            peak_pressure_pa: self.peak[0],
            peak_place_m: self.peak[1],
            pressure_centre_m: self.pressure_centre,
            rho_m: case.line.rho(),
            friction: case.friction,
            kappa: case.pair.kappa(),
            longitudinal_creepage: self.creepage,
            xi: self.creepage * case.line.rho() / (case.friction * case.line.half_width()),
            given: if matches!(case.given, Given::Force(_)) { "force" } else { "creepage" },
            longitudinal_force_n_per_m: self.force,
            fx: self.used(),
            adhesion_share: self.adhesion_share,
            friction_heat_j_per_m2: self.friction_heat,
            rolling_resistance_n_per_m: self.rolling_resistance,
            rolling_velocity_m_per_s: case.speed,
        }
    }

    /// The force over `mu N`.
    fn used(&self) -> f64 {
        self.force / (self.case.friction * self.case.load)
    }

    /// A short report.
    #[must_use]
    pub fn text(&self) -> String {
        let (case, mut lines) = (&self.case, Lines::default());
        let headline = format!("Theory {}: {}", case.theory.name(), status_words(self.status));
        lines.headline(&headline, self.status);
        for caution in &self.cautions {
            lines.caution(&caution.to_string());
        }
        lines.heading("Line contact, per metre of its length");
        lines.row("line load N", &quantity(case.load, "N/m", 5));
        lines.row("trailing edge", &quantity(self.edges[0], "m", 5));
        lines.row("leading edge", &quantity(self.edges[1], "m", 5));
        lines.row("peak pressure", &quantity(self.peak[0], "Pa", 5));
        if self.peak[1] != 0.0 {
            lines.row("  ahead of the centres by", &quantity(self.peak[1], "m", 5));
            lines.row("centre of pressure ahead", &quantity(self.pressure_centre, "m", 5));
        }
        lines.row("curvature length rho", &quantity(case.line.rho(), "m", 5));
        lines.row("friction mu", &significant(case.friction, 5));
        lines.heading("Creepage of the upper body relative to the lower");
        lines.row("longitudinal", &significant(self.creepage, 5));
        lines.heading("Tangential force on the lower body");
        lines.row("longitudinal", &quantity(self.force, "N/m", 5));
        lines.row("share of mu N used", &format!("{} %", fixed(100.0 * self.used().abs(), 2)));
        let share = format!("{} %", fixed(100.0 * self.adhesion_share, 2));
        lines.row("adhesion, share of width", &share);
        lines.row("heat of friction", &quantity(self.friction_heat, "J/m²", 5));
        if let Some(resistance) = self.rolling_resistance {
            lines.row("rolling resistance", &quantity(resistance, "N/m", 5));
        }
        if let Some(speed) = case.speed {
            lines.row("rolling velocity", &quantity(speed, "m/s", 5));
        }
        lines.into_text()
    }

    /// Writes `report.json`, `points.csv`, `contact.svg` and `contact.png` into `directory`, which is made when
    /// missing; none of `sources`.
    ///
    /// # Errors
    /// [`ReportError`]: nothing is written then.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.json())?;
        json.push('\n');
        write_contact(directory, [&json, &self.svg()], &self.points_csv()?, &[], sources)
    }

    fn points_csv(&self) -> Result<Vec<u8>, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(["x_m", "pressure_pa", "traction_pa", "region"])?;
        for point in &self.points {
            let numbers =
                [point.x, point.pressure, point.traction].map(|value| format!("{value:e}"));
            let region = if point.adheres { "adhesion" } else { "slip" };
            writer.write_record(numbers.into_iter().chain([region.to_owned()]))?;
        }
        writer.into_inner().map_err(|error| csv::Error::from(error.into_error()).into())
    }
}
