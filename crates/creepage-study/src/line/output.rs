//! Report of a solved line contact: text, JSON and files.

use std::path::{Path, PathBuf};

use super::file::Given;
use super::solved::SolvedLine;
use crate::error::ReportError;
use crate::report::{
    Report, Shown,
    Unit::{JoulePerSquareMetre, LineLoad, Metre, MetrePerSecond, One, Pascal, Share},
    Written, words,
};
use crate::sources::Sources;
use crate::text::{Lines, status_words};
use crate::write::write_contact;

impl SolvedLine {
    /// Everything but the points; as `serde` sees it, `report.json`. Forces and energies are per metre of the cylinders'
    /// length, places from the line of the centres.
    #[must_use]
    pub fn report(&self) -> Report {
        let (case, [trailing, leading], [peak, place]) = (&self.case, self.edges, self.peak);
        let mut report = Report::solved(case.theory.name(), self.status, words(&self.cautions));
        let mut all = report.section("", Shown::Contact);
        all.number("line_load", "line load N", LineLoad, case.load)
            .shown(Shown::Nowhere)
            .number("half_width", "half width without friction", Metre, case.line.half_width())
            .shown(Shown::Contact)
            .number("trailing_edge", "trailing edge", Metre, trailing)
            .number("leading_edge", "leading edge", Metre, leading)
            .number("peak_pressure", "peak pressure", Pascal, peak)
            .shown(if place == 0.0 { Shown::Nowhere } else { Shown::Contact })
            .number("peak_place", "  ahead of the centres by", Metre, place)
            .number("pressure_centre", "centre of pressure ahead", Metre, self.pressure_centre)
            .shown(Shown::Contact)
            .number("rho", "curvature length rho", Metre, case.line.rho())
            .number("friction", "friction mu", One, case.friction)
            .shown(Shown::Nowhere)
            .number("kappa", "how unlike the bodies are", One, case.pair.kappa());
        let xi = self.creepage * case.line.rho() / (case.friction * case.line.half_width());
        all.shown(Shown::Motion)
            .number("longitudinal_creepage", "longitudinal", One, self.creepage)
            .shown(Shown::Nowhere)
            .number("xi", "longitudinal creepage xi", One, xi);
        let given = if matches!(case.given, Given::Force(_)) { "force" } else { "creepage" };
        report.part("", "given", given.into());
        report
            .section("", Shown::Force)
            .number("longitudinal_force", "longitudinal", LineLoad, self.force)
            .written(Written::FixedSize(100.0, "%", 2))
            .number("fx", "share of mu N used", One, self.force / (case.friction * case.load))
            .written(Written::USUAL)
            .number("adhesion_share", "adhesion, share of width", Share, self.adhesion_share)
            .number("friction_heat", "heat of friction", JoulePerSquareMetre, self.friction_heat)
            .number("rolling_resistance", "rolling resistance", LineLoad, self.rolling_resistance)
            .number("rolling_velocity", "rolling velocity", MetrePerSecond, case.speed);
        report
    }

    /// A short report.
    #[must_use]
    pub fn text(&self) -> String {
        let (report, mut lines) = (self.report(), Lines::default());
        let headline = format!("Theory {}: {}", self.case.theory.name(), status_words(self.status));
        lines.headline(&headline, self.status);
        for caution in &self.cautions {
            lines.caution(&caution.to_string());
        }
        lines.heading("Line contact, per metre of its length");
        report.rows(&mut lines, Shown::Contact);
        lines.heading("Creepage of the upper body relative to the lower");
        report.rows(&mut lines, Shown::Motion);
        lines.heading("Tangential force on the lower body");
        report.rows(&mut lines, Shown::Force);
        lines.into_text()
    }

    /// Writes `report.json`, `points.csv`, `contact.svg` and `contact.png` into `directory`, which is made when
    /// missing; none of `sources`.
    ///
    /// # Errors
    /// [`ReportError`]: nothing is written then.
    pub fn write(&self, directory: &Path, sources: &Sources) -> Result<Vec<PathBuf>, ReportError> {
        let mut json = serde_json::to_string_pretty(&self.report())?;
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
