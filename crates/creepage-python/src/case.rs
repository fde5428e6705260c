//! A case in SI units, from the text of a case file to its report.

use std::path::PathBuf;
use std::sync::Arc;

use creepage::Hertz;
use creepage::rolling::{Creepage, Scaling};
use creepage_study::{
    Case, CaseError, CaseFile, Entry, InverseCase, PreparedTheory, Report, Solve, find, hertz_json,
    kappa_over_mu,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::theory::Theory;
use crate::{errors, results};

/// What a case file asks for.
#[derive(Clone)]
enum Question {
    Forces(Case),
    /// The creepage that gives wanted forces.
    Creepage(InverseCase),
}

/// The text of a case file, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct CaseData {
    question: Question,
    scaling: Scaling,
    options: toml::Table,
}

/// A case solved by one theory.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedCase {
    solved: creepage_study::SolvedCase,
    theory: Py<Theory>,
}

impl Question {
    fn read(text: &str) -> Result<Self, CaseError> {
        let file = CaseFile::read(text)?;
        if file.is_inverse() {
            return file.inverse().map(Self::Creepage);
        }
        file.case().map(Self::Forces)
    }

    fn contact(&self) -> &Hertz {
        match self {
            Self::Forces(case) => &case.contact,
            Self::Creepage(case) => &case.contact,
        }
    }

    fn friction(&self) -> f64 {
        match self {
            Self::Forces(case) => case.friction,
            Self::Creepage(case) => case.friction,
        }
    }

    fn solve(&self) -> &Solve {
        match self {
            Self::Forces(case) => &case.solve,
            Self::Creepage(case) => &case.solve,
        }
    }

    /// The case, unless its creepage is yet to be found.
    fn forces(&self, py: Python) -> PyResult<&Case> {
        match self {
            Self::Forces(case) => Ok(case),
            Self::Creepage(_) => Err(errors::case(py, CaseError::Wanted)),
        }
    }
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
        let question = Question::read(text).map_err(|error| errors::case(py, error))?;
        let scaling = Scaling::new(question.contact(), question.friction())
            .map_err(|error| errors::invalid(py, error))?;
        let mut file: toml::Table = text.parse().map_err(|_| errors::internal("TOML"))?;
        let options = match file.remove("solve") {
            Some(toml::Value::Table(options)) => options,
            _ => toml::Table::new(),
        };
        Ok(Self { question, scaling, options })
    }

    /// Ratio of the semi-axes.
    #[getter]
    fn a_over_b(&self) -> f64 {
        self.question.contact().ellipse().ratio()
    }

    /// Combined Poisson's ratio.
    #[getter]
    fn poisson(&self) -> f64 {
        self.question.contact().pair().poisson()
    }

    /// Coefficient of friction.
    #[getter]
    fn friction(&self) -> f64 {
        self.question.friction()
    }

    /// How unlike the bodies are: kappa of (2.10) over the coefficient of friction.
    #[getter]
    fn kappa_over_mu(&self) -> f64 {
        kappa_over_mu(self.question.contact(), self.question.friction())
    }

    /// Whether the option of that name, as the case has it, is one of the theory's.
    fn takes(&self, theory: &str, option: &str) -> PyResult<bool> {
        Ok(entry(theory)?.takes(option, self.question.solve()))
    }

    /// What the theory leaves out of this case though it matters, in words.
    fn left_out(&self, theory: &str) -> PyResult<Option<String>> {
        Ok(entry(theory)?.leaves_out(self.kappa_over_mu()).map(|left_out| left_out.to_string()))
    }

    /// Whether forces are wanted and the creepage is to be found.
    #[getter]
    fn finds_creepage(&self) -> bool {
        matches!(self.question, Question::Creepage(_))
    }

    /// (xi, eta, chi). Raises CaseError where the creepage is to be found.
    #[getter]
    fn dimensionless(&self, py: Python) -> PyResult<(f64, f64, f64)> {
        let Creepage { xi, eta, chi } = self.question.forces(py)?.creepage;
        Ok((xi, eta, chi))
    }

    /// (longitudinal, lateral, spin (rad/m)). Raises CaseError where they are to be found.
    #[getter]
    fn creepage(&self, py: Python) -> PyResult<(f64, f64, f64)> {
        let si = self.question.forces(py)?.si_creepage;
        Ok((si.longitudinal, si.lateral, si.spin))
    }

    /// Units of length c (m), creepage, force mu N (N) and traction (Pa).
    #[getter]
    fn units(&self) -> (f64, f64, f64, f64) {
        (self.scaling.length, self.scaling.slip, self.scaling.force, self.scaling.traction)
    }

    /// The contact as JSON.
    fn hertz(&self) -> PyResult<String> {
        serde_json::to_string(&hertz_json(self.question.contact()))
            .map_err(|_| errors::internal("JSON"))
    }

    /// The section [solve]: the theory's name and its options.
    fn options<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let options = PyDict::new(py);
        for (name, value) in &self.options {
            match value {
                toml::Value::String(word) => options.set_item(name, word)?,
                toml::Value::Integer(count) => options.set_item(name, count)?,
                toml::Value::Float(number) => options.set_item(name, number)?,
                toml::Value::Array(counts) if counts.iter().all(toml::Value::is_integer) => {
                    let counts: Vec<_> = counts.iter().map(toml::Value::as_integer).collect();
                    options.set_item(name, counts)?;
                }
                // As counts and numbers mixed read too.
                toml::Value::Array(_) => options.set_item(name, self.question.solve().reduction)?,
                _ => return Err(errors::internal("[solve]")),
            }
        }
        Ok(options)
    }

    /// Solves by a theory that was prepared for this contact. Raises NotReachable where no creepage
    /// gives the wanted forces, CaseError where the theory does not find creepages.
    fn solve(&self, py: Python, theory: Py<Theory>) -> PyResult<SolvedCase> {
        let Theory { model, name, .. } = theory.get();
        let model = Arc::clone(model);
        let solve = || match self.question.clone() {
            Question::Forces(case) => Ok(creepage_study::SolvedCase::forces(case, model)),
            Question::Creepage(case) => creepage_study::SolvedCase::creepage(case, name, model),
        };
        let solved = py.detach(solve).map_err(|error| errors::find(py, error))?;
        Ok(SolvedCase { solved, theory })
    }
}

/// The theory of a class's name.
fn entry(name: &str) -> PyResult<&'static Entry> {
    let name = if name == "automatic" { "exact" } else { name };
    find(name).map_err(|_| errors::internal(name))
}

impl SolvedCase {
    /// Makes the report, which traces the areas of adhesion and slip, and uses it.
    fn report<T: Send>(&self, py: Python, with: impl FnOnce(&Report) -> T + Send) -> PyResult<T> {
        let Theory { model, name, .. } = self.theory.get();
        // As in case files.
        let theory_name =
            if matches!(**model, PreparedTheory::Automatic(_)) { "exact" } else { name };
        let used = py.detach(|| Report::of_case(&self.solved, theory_name).map(|r| with(&r)));
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
        let (points, ellipse) = (&self.solved.found.points, self.theory.get().ellipse);
        results::field(py, &[points.len()], ellipse, points)
    }
}
