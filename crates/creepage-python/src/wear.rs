//! Python class of wear over a distance.

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use creepage_rail::Role;
use creepage_study::{
    Sources, WearError, WearPlan, WearStop, WheelsetCase, WheelsetFile, WornBody,
};
use numpy::PyArray1;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors;
use crate::pool::detached;
use crate::signals;
use crate::wheelset::WheelsetData;

/// Wear over a distance, run.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct WearData {
    wear: creepage_study::Wear,
    case: WheelsetCase,
    plan: WearPlan,
}

/// Points `(y, z)` one after another, and the depth at each.
type Profile<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl WearData {
    /// Runs a wheelset with the `[wear]` of a text, or that of its own file.
    #[staticmethod]
    fn run(
        py: Python,
        wheelset: PyRef<WheelsetData>,
        text: Option<&str>,
        directory: PathBuf,
        state: Option<PathBuf>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let case = wheelset.case.clone();
        let plan = plan_of(py, &wheelset, text, &directory)?;
        let asked = plan.clone();
        let work = move |stop: &AtomicBool| {
            let failed = Mutex::new(None);
            let mut hear = |part: f64, _: &[WearStop]| {
                if stop.load(Ordering::Relaxed) {
                    return false;
                }
                let Some(progress) = &progress else { return true };
                let heard = Python::attach(|py| progress.call1(py, (part,)).map(drop));
                let goes_on = heard.is_ok();
                if let (Err(error), Ok(mut failed)) = (heard, failed.lock()) {
                    *failed = Some(error);
                }
                goes_on
            };
            let wear = creepage_study::wear(&case, &plan, state.as_deref(), &mut hear);
            (wear, case, failed.into_inner().ok().flatten())
        };
        let (wear, case, failed) = signals::stoppable(py, work)?;
        if let Some(error) = failed {
            return Err(error);
        }
        let wear = wear.map_err(|error| raised(py, error))?;
        Ok(Self { wear, case, plan: asked })
    }

    /// The same of what [`WearData::saved`] gave: nothing is run again.
    #[staticmethod]
    fn restored(
        py: Python,
        wheelset: PyRef<WheelsetData>,
        text: Option<&str>,
        directory: PathBuf,
        saved: &str,
    ) -> PyResult<Self> {
        let plan = plan_of(py, &wheelset, text, &directory)?;
        let wear = serde_json::from_str(saved).map_err(|e| errors::internal(&e.to_string()))?;
        Ok(Self { wear, case: wheelset.case.clone(), plan })
    }

    /// All that it found, as text.
    fn saved(&self) -> PyResult<String> {
        serde_json::to_string(&self.wear).map_err(|e| errors::internal(&e.to_string()))
    }

    /// Names of the bodies that wear.
    fn bodies(&self) -> Vec<&'static str> {
        let first = self.wear.stops.first();
        let wears = |body: &WornBody| first.is_some_and(|stop| stop.of(*body).is_some());
        WornBody::ALL.into_iter().filter(wears).map(WornBody::name).collect()
    }

    /// Distance, passages, steps and conicity of each stop; NaN where there is no conicity.
    fn stops<'py>(&self, py: Python<'py>) -> Vec<Bound<'py, PyArray1<f64>>> {
        let column = |value: fn(&WearStop) -> f64| {
            PyArray1::from_vec(py, self.wear.stops.iter().map(value).collect())
        };
        vec![
            column(|stop| stop.distance),
            column(|stop| stop.passages),
            column(|stop| stop.steps as f64),
            column(|stop| stop.conicity.unwrap_or(f64::NAN)),
        ]
    }

    /// Numbers of a body at each stop by their names, NaN where there is none.
    fn numbers<'py>(&self, py: Python<'py>, body: &str) -> PyResult<Bound<'py, PyDict>> {
        let rows: Vec<_> = self.wear.stops.iter().flat_map(WearStop::rows).collect();
        let own: Vec<_> = rows.iter().filter(|row| row.body == body).collect();
        let columns = PyDict::new(py);
        let or = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let all = [
            ("greatest_depth", own.iter().map(|row| row.depth_m).collect()),
            ("area", own.iter().map(|row| row.area_m2).collect()),
            ("volume", own.iter().map(|row| row.volume_m3).collect()),
            ("flange_height", own.iter().map(|row| or(row.flange_height_m)).collect()),
            ("flange_thickness", own.iter().map(|row| or(row.flange_thickness_m)).collect()),
            ("flange_slope", own.iter().map(|row| or(row.flange_slope_m)).collect()),
            ("hollow", own.iter().map(|row| or(row.hollow_m)).collect::<Vec<f64>>()),
        ];
        for (name, values) in all {
            columns.set_item(name, PyArray1::from_vec(py, values))?;
        }
        Ok(columns)
    }

    /// Its profile at each stop.
    fn profiles<'py>(&self, py: Python<'py>, body: &str) -> Vec<Profile<'py>> {
        let Some(body) = WornBody::ALL.into_iter().find(|one| one.name() == body) else {
            return Vec::new();
        };
        let worn = self.wear.stops.iter().filter_map(|stop| stop.of(body));
        worn.map(|worn| {
            let points = PyArray1::from_slice(py, worn.points.as_flattened());
            (points, PyArray1::from_slice(py, &worn.depth))
        })
        .collect()
    }

    /// Whether all situations converged, and the cautions about it.
    fn outcome(&self) -> (bool, Vec<String>) {
        (self.wear.is_solved, self.wear.cautions.clone())
    }

    /// Where and why it ended before its distance.
    fn ended(&self) -> Option<String> {
        self.wear.end_in_words()
    }

    /// `report.json` as text.
    fn json(&self) -> PyResult<String> {
        serde_json::to_string(&self.wear.json()).map_err(|e| errors::internal(&e.to_string()))
    }

    /// A table for a terminal.
    fn text(&self) -> String {
        self.wear.text()
    }

    /// Wheels or rails; nothing where none wear.
    fn svg(&self, role: &str) -> PyResult<Option<String>> {
        let role = [Role::Wheel, Role::Rail].into_iter().find(|one| one.to_string() == role);
        let role =
            role.ok_or_else(|| PyValueError::new_err("role must be \"wheel\" or \"rail\""))?;
        Ok(self.wear.svg(role))
    }

    /// Writes the files of the command.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        let write = || self.wear.write(&self.case, &self.plan, &directory, &Sources::default());
        detached(py, write)?.map_err(|error| raised(py, error))
    }
}

/// The plan of the `[wear]` of a text, or of the wheelset's own file.
fn plan_of(
    py: Python,
    wheelset: &WheelsetData,
    text: Option<&str>,
    directory: &Path,
) -> PyResult<WearPlan> {
    let plan = match text {
        Some(text) => WearPlan::read(text, &wheelset.case, directory),
        None => WheelsetFile::read(&wheelset.text)
            .map_err(WearError::from)
            .and_then(|file| file.wear(&wheelset.case, directory)),
    };
    plan.map_err(|error| raised(py, error))
}

fn raised(py: Python, error: WearError) -> PyErr {
    let words = error.to_string();
    match error {
        WearError::Case(error) => errors::case(py, error),
        WearError::Wheelset(error) => errors::wheelset(py, error),
        WearError::Report(error) => errors::report(error),
        WearError::State { path, source } => errors::os(source, path),
        WearError::Table { .. } => PyOSError::new_err(words),
        error if error.is_wrong_input() => errors::in_section(py, words, "wear"),
        _ => PyRuntimeError::new_err(words),
    }
}
