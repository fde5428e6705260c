//! Python class of contacts of any shape.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use creepage_study::{GapCase, GapCaseError, GapFile, GapSolver, SolvedCase, Sources};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::case::{QuantityTuple, quantities};
use crate::errors;
use crate::pool::detached;
use crate::signals;

/// A contact of any shape, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct GapData {
    case: GapCase,
}

/// A contact of any shape, solved.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedGapData {
    solved: SolvedCase,
}

#[pymethods]
impl GapData {
    /// From the text of a case file with `[gap]` whose files of points are in a directory.
    #[new]
    fn new(py: Python, text: &str, directory: PathBuf) -> PyResult<Self> {
        let read = || GapFile::read(text)?.case(&directory);
        let case = detached(py, read)?.map_err(|error| errors::gap(py, error))?;
        Ok(Self { case })
    }

    /// Solves it by its own theory, or by the one of that name.
    fn solve(&self, py: Python, theory: Option<&str>) -> PyResult<SolvedGapData> {
        let (case, theory) = (self.case.clone(), theory.map(str::to_owned));
        let work = move || solve(&GapSolver::default(), case, theory.as_deref());
        let solved = signals::answered(py, work)?;
        Ok(SolvedGapData { solved: solved.map_err(|error| errors::gap(py, error))? })
    }
}

/// Solves many on all cores; what cannot be solved stands as its exception.
#[pyfunction]
#[pyo3(signature = (cases, theory))]
pub(crate) fn solve_gaps(
    py: Python,
    cases: Vec<PyRef<GapData>>,
    theory: Option<&str>,
) -> PyResult<Vec<Py<PyAny>>> {
    let cases: Vec<_> = cases.iter().map(|data| data.case.clone()).collect();
    let theory = theory.map(str::to_owned);
    let all = move |stop: &AtomicBool| {
        let solver = GapSolver::default();
        let one =
            |case| (!stop.load(Ordering::Relaxed)).then(|| solve(&solver, case, theory.as_deref()));
        cases.into_par_iter().filter_map(one).collect::<Vec<_>>()
    };
    let answers = signals::stoppable(py, all)?.into_iter();
    let object = |answer| match answer {
        Ok(solved) => Ok(Py::new(py, SolvedGapData { solved })?.into_any()),
        Err(error) => Ok(errors::gap(py, error).into_value(py).into_any()),
    };
    answers.map(object).collect()
}

fn solve(
    solver: &GapSolver,
    case: GapCase,
    theory: Option<&str>,
) -> Result<SolvedCase, GapCaseError> {
    let case = match theory {
        Some(name) => case.by_theory(name)?,
        None => case,
    };
    solver.solve(&case)
}

#[pymethods]
impl SolvedGapData {
    /// Every quantity of the report: path, label, unit, value, error bar.
    fn quantities(&self, py: Python) -> PyResult<Vec<QuantityTuple>> {
        detached(py, || quantities(&self.solved.report()))
    }

    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        serde_json::to_string(&detached(py, || self.solved.report())?)
            .map_err(|e| errors::internal(&e.to_string()))
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        detached(py, || self.solved.text())
    }

    /// Contact areas, adhesion and slip, traction.
    fn svg(&self, py: Python) -> PyResult<String> {
        detached(py, || self.solved.contact_svg())
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        detached(py, || self.solved.write(&directory, &Sources::default()))?.map_err(errors::report)
    }
}
