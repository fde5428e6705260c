//! A case in SI units, from the text of a case file to its report.

use std::path::PathBuf;

use creepage::Hertz;
use creepage::rolling::{Creepage, Scaling};
use creepage_case::CaseFile;
use creepage_report::{Answer, Report, hertz_json};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::model::Examination;
use crate::theory::Theory;
use crate::{errors, mesh, results};

/// The text of a case file, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct CaseData {
    case: creepage_case::Case,
    scaling: Scaling,
    options: toml::Table,
}

/// A case solved by one theory.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedCase {
    contact: Hertz,
    friction: f64,
    creepage: Creepage,
    theory: Py<Theory>,
    found: Examination,
}

/// The contact of a case file as JSON; needs neither friction nor creepage.
#[pyfunction]
pub(crate) fn hertz(py: Python, text: &str) -> PyResult<String> {
    let contact = CaseFile::read(text).and_then(|file| file.hertz());
    let contact = contact.map_err(|error| errors::case(py, error))?;
    serde_json::to_string(&hertz_json(&contact)).map_err(|_| errors::internal("JSON"))
}

#[pymethods]
impl CaseData {
    #[new]
    fn new(py: Python, text: &str) -> PyResult<Self> {
        let case = CaseFile::read(text).and_then(|file| file.case());
        let case = case.map_err(|error| errors::case(py, error))?;
        let scaling = Scaling::new(&case.contact, case.friction)
            .map_err(|error| errors::invalid(py, error))?;
        let mut file: toml::Table = text.parse().map_err(|_| errors::internal("TOML"))?;
        let options = match file.remove("solve") {
            Some(toml::Value::Table(options)) => options,
            _ => toml::Table::new(),
        };
        Ok(Self { case, scaling, options })
    }

    /// Ratio of the semi-axes.
    #[getter]
    fn a_over_b(&self) -> f64 {
        self.case.contact.ellipse().ratio()
    }

    /// Combined Poisson's ratio.
    #[getter]
    fn poisson(&self) -> f64 {
        self.case.contact.pair().poisson()
    }

    /// Coefficient of friction.
    #[getter]
    fn friction(&self) -> f64 {
        self.case.friction
    }

    /// (xi, eta, chi).
    #[getter]
    fn dimensionless(&self) -> (f64, f64, f64) {
        let Creepage { xi, eta, chi } = self.case.creepage;
        (xi, eta, chi)
    }

    /// (longitudinal, lateral, spin (rad/m)).
    #[getter]
    fn creepage(&self) -> (f64, f64, f64) {
        let si = self.case.si_creepage;
        (si.longitudinal, si.lateral, si.spin)
    }

    /// Units of length c (m), creepage, force mu N (N) and traction (Pa).
    #[getter]
    fn units(&self) -> (f64, f64, f64, f64) {
        (self.scaling.length, self.scaling.slip, self.scaling.force, self.scaling.traction)
    }

    /// The contact as JSON.
    fn hertz(&self) -> PyResult<String> {
        serde_json::to_string(&hertz_json(&self.case.contact)).map_err(|_| errors::internal("JSON"))
    }

    /// The section [solve]: the theory's name and its options.
    fn options<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let options = PyDict::new(py);
        for (name, value) in &self.options {
            match value {
                toml::Value::String(word) => options.set_item(name, word)?,
                toml::Value::Integer(count) => options.set_item(name, count)?,
                toml::Value::Array(counts) => {
                    let counts: Vec<_> = counts.iter().map(toml::Value::as_integer).collect();
                    options.set_item(name, counts)?;
                }
                _ => return Err(errors::internal("[solve]")),
            }
        }
        Ok(options)
    }

    /// Solves by a theory that was prepared for this contact.
    fn solve(&self, py: Python, theory: Py<Theory>) -> SolvedCase {
        let model = theory.get();
        let mesh = mesh::of_case(model.ellipse);
        let (contact, friction, creepage) =
            (self.case.contact, self.case.friction, self.case.creepage);
        let found = py.detach(|| model.model.examine(creepage, &mesh));
        SolvedCase { contact, friction, creepage, theory, found }
    }
}

impl SolvedCase {
    /// Makes the report, which traces the areas of adhesion and slip, and uses it.
    fn report<T: Send>(&self, py: Python, with: impl FnOnce(&Report) -> T + Send) -> PyResult<T> {
        let theory = self.theory.get();
        let used = py.detach(|| {
            let answer = Answer {
                creepage: self.creepage,
                theory_name: theory.name,
                theory: theory.model.theory(),
                solution: self.found.solution,
                points: self.found.points.clone(),
                details: self.found.details.clone(),
            };
            Report::new(&self.contact, self.friction, answer).map(|report| with(&report))
        });
        used.map_err(|error| errors::invalid(py, error))
    }
}

// A method of all reports is not general enough for its lifetimes.
#[allow(clippy::redundant_closure_for_method_calls)]
#[pymethods]
impl SolvedCase {
    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        let json = self.report(py, |report| serde_json::to_string(&report.json()))?;
        json.map_err(|_| errors::internal("JSON"))
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        self.report(py, |report| report.text())
    }

    /// The contact seen from above.
    fn svg(&self, py: Python) -> PyResult<String> {
        self.report(py, |report| report.contact_svg())
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        self.report(py, |report| report.write(&directory))?.map_err(errors::report)
    }

    /// The field at the theory's own points, or at those of a usual mesh: a Field.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (points, ellipse) = (&self.found.points, self.theory.get().ellipse);
        results::field(py, &[points.len()], ellipse, points)
    }
}
