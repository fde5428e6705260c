//! Python class of a ball bearing's file, and its solution.

use std::path::PathBuf;

use creepage_study::{BearingCaseError, BearingFile, BearingReport, Sources};
use pyo3::prelude::*;

use crate::case::{QuantityTuple, quantities};
use crate::pool::detached;
use crate::{errors, signals};

/// A ball bearing, solved.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedBearing {
    report: BearingReport,
}

#[pymethods]
impl SolvedBearing {
    #[new]
    fn new(py: Python, text: &str) -> PyResult<Self> {
        let text = text.to_owned();
        let solve = move || {
            let case = BearingFile::read(&text).and_then(|file| file.case());
            BearingReport::solve(case.map_err(BearingCaseError::from)?)
        };
        let report = signals::answered(py, solve)?.map_err(|error| errors::bearing(py, error))?;
        Ok(Self { report })
    }

    /// Every quantity of the report: path, label, unit, value, error bar.
    fn quantities(&self, py: Python) -> PyResult<Vec<QuantityTuple>> {
        detached(py, || quantities(&self.report.report()))
    }

    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        serde_json::to_string(&detached(py, || self.report.report())?)
            .map_err(|error| errors::internal(&error.to_string()))
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        detached(py, || self.report.text())
    }

    /// The inner contact of the hottest ball, seen from above; empty where nothing rolls.
    fn svg(&self, py: Python) -> PyResult<String> {
        let pictures = py.detach(|| self.report.contact_svgs());
        let pictures = pictures.map_err(|error| errors::bearing(py, error))?;
        Ok(pictures.into_iter().next().map(|(_, svg)| svg).unwrap_or_default())
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        py.detach(|| self.report.write(&directory, &Sources::default())).map_err(errors::report)
    }
}
