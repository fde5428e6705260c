//! Wheelsets by their files.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use creepage::InvalidValue;
use creepage_study::{Sources, WheelsetCase, WheelsetError, WheelsetFile, WheelsetTable};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors;
use crate::pool::detached;
use crate::signals;

/// A wheelset in its track, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct WheelsetData {
    case: WheelsetCase,
}

/// A wheelset, solved.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedWheelset {
    solved: creepage_study::SolvedWheelset,
    case: WheelsetCase,
}

#[pymethods]
impl WheelsetData {
    /// From the text of a wheelset file whose profiles are in a directory.
    #[new]
    fn new(py: Python, text: &str, directory: PathBuf) -> PyResult<Self> {
        let read = || {
            let file = WheelsetFile::read(text).map_err(WheelsetError::from)?;
            file.case(&directory)
        };
        let case = detached(py, read)?.map_err(|error| errors::wheelset(py, error))?;
        Ok(Self { case })
    }

    /// What was found in the profile files and repaired.
    fn notes(&self) -> Vec<String> {
        let notes = self.case.notes.iter();
        let words = notes.flat_map(|note| {
            note.actions.iter().map(|action| format!("{}: {action}", note.path.display()))
        });
        words.collect()
    }

    /// Solves; with derivatives by position and motion where they are asked for.
    fn solve(&self, py: Python, derivatives: bool) -> PyResult<SolvedWheelset> {
        let case = self.case.clone();
        let solve = move || {
            let mut solved = case.solve()?;
            if derivatives {
                solved.derivatives = Some(case.derivatives(&solved)?);
            }
            Ok(solved)
        };
        let solved = signals::answered(py, solve)?.map_err(|error| errors::wheelset(py, error))?;
        Ok(SolvedWheelset { solved, case: self.case.clone() })
    }

    /// Columns over yaw and lateral position, each as one flat array.
    fn table<'py>(
        &self,
        py: Python<'py>,
        y: PyReadonlyArray1<'py, f64>,
        yaw: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let [y, yaw] = [y, yaw].map(|values| values.to_vec());
        let (y, yaw) = (y?, yaw?);
        let case = self.case.clone();
        let solve = move |stop: &AtomicBool| {
            WheelsetTable::solve(&case, &y, &yaw, || !stop.load(Ordering::Relaxed))
        };
        let table = signals::stoppable(py, solve)?.map_err(|error| errors::wheelset(py, error))?;
        let columns = PyDict::new(py);
        for (name, values) in table.columns() {
            columns.set_item(name, PyArray1::from_vec(py, values))?;
        }
        Ok(columns)
    }

    /// `y` and the right wheel's rolling radius less the left's (m).
    fn radius_difference(&self, py: Python, rolls: bool) -> PyResult<Vec<(f64, f64)>> {
        let found = detached(py, || self.case.radius_difference(rolls))?;
        Ok(found.map_err(|error| errors::wheelset(py, error))?.rows().collect())
    }

    /// The equivalent conicity at amplitudes (m); NaN where there is none. An amplitude that is
    /// none is refused.
    fn conicity(&self, py: Python, amplitudes: Vec<f64>, rolls: bool) -> PyResult<Vec<f64>> {
        let wrong = |amplitude: &&f64| !(**amplitude > 0.0 && amplitude.is_finite());
        if let Some(&value) = amplitudes.iter().find(wrong) {
            let (quantity, valid) = ("amplitude", "positive and finite");
            return Err(errors::invalid(py, InvalidValue { quantity, value, valid }));
        }
        let found = detached(py, || self.case.radius_difference(rolls))?;
        let difference = found.map_err(|error| errors::wheelset(py, error))?;
        let at = |amplitude: &f64| difference.conicity(*amplitude).unwrap_or(f64::NAN);
        Ok(amplitudes.iter().map(at).collect())
    }
}

#[pymethods]
impl SolvedWheelset {
    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        serde_json::to_string(&detached(py, || self.solved.json())?)
            .map_err(|e| errors::internal(&e.to_string()))
    }

    /// Derivatives of the forces and their errors, each of 2 wheels, 6 forces, by 8 numbers.
    fn derivatives<'py>(&self, py: Python<'py>) -> Option<[Bound<'py, PyArray1<f64>>; 2]> {
        let found = self.solved.derivatives.as_ref()?;
        let flat =
            |all: [[[f64; 8]; 6]; 2]| PyArray1::from_slice(py, all.as_flattened().as_flattened());
        Some([flat(found.values()), flat(found.errors())])
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        detached(py, || self.solved.text())
    }

    /// Both wheels on their rails.
    fn svg(&self) -> PyResult<String> {
        let picture = self.solved.svg(&self.case.running);
        picture.map_err(|error| errors::internal(&error.to_string()))
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        let write = || self.solved.write(&self.case, &directory, &Sources::default());
        detached(py, write)?.map_err(errors::report)
    }
}
