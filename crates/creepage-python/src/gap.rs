//! Contacts of any shape.

use std::path::PathBuf;

use creepage_study::{GapCase, GapCaseError, GapFile, GapSolver, SolvedCase};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::errors;

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
        let case = py.detach(read).map_err(|error| errors::gap(py, error))?;
        Ok(Self { case })
    }

    /// Solves it by its own theory, or by the one of that name.
    fn solve(&self, py: Python, theory: Option<&str>) -> PyResult<SolvedGapData> {
        let solved = py.detach(|| solve(&GapSolver::default(), self.case.clone(), theory));
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
    let solver = GapSolver::default();
    let one = |case| solve(&solver, case, theory);
    let all = || cases.into_par_iter().map(one).collect::<Vec<_>>();
    let answers = py.detach(all).into_iter();
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
    /// `report.json` as text.
    fn json(&self) -> PyResult<String> {
        serde_json::to_string(&self.solved.json()).map_err(|e| errors::internal(&e.to_string()))
    }

    /// A short report for a terminal.
    fn text(&self) -> String {
        self.solved.text()
    }

    /// Contact areas, adhesion and slip, traction.
    fn svg(&self) -> String {
        self.solved.contact_svg()
    }

    /// Writes the files of the report.
    fn write(&self, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        self.solved.write(&directory).map_err(errors::report)
    }
}
