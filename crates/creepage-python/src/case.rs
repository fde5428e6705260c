//! Python class of a case in SI units, from the text of a case file to its report.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::PathBuf;
use std::sync::atomic::Ordering;

use creepage::subsurface::{Body, Inside};
use creepage::{Creepage, SiCreepage};
use creepage_study::{
    AnyCaseFile, Case, CaseFile, Caution, Damage, Fit, FitOptions, Given, MeasuredPoints, Quantity,
    Report, Sources, Stresses, hertz_report, solve,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PySlice};
use serde::Serialize;

use crate::batch::solve_all;
use crate::number::{Inputs, Number};
use crate::pool::detached;
use crate::theory::{LONG, cost};
use crate::{errors, mesh, options, results, signals};

/// The text of a case file, read and checked.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct CaseData {
    text: String,
    file: CaseFile,
    case: Case,
}

/// A case solved by one theory.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedCase {
    solved: creepage_study::SolvedCase,
}

fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|_| errors::internal("JSON"))
}

/// Path, label, unit, value and error bar of a quantity.
pub(crate) type QuantityTuple = (String, &'static str, &'static str, Option<f64>, Option<f64>);

/// All quantities of a report.
pub(crate) fn quantities(report: &Report) -> Vec<QuantityTuple> {
    let tuple = |(path, one): (String, &Quantity)| {
        (path, one.label.trim(), one.unit.symbol(), one.value, one.error)
    };
    report.quantities().into_iter().map(tuple).collect()
}

/// The contact of a case file as JSON; needs neither friction nor creepage.
#[pyfunction]
pub(crate) fn hertz(py: Python, text: &str) -> PyResult<String> {
    let file = CaseFile::read(text).map_err(|error| errors::case(py, error))?;
    let contact = file.hertz().map_err(|error| errors::case(py, error))?;
    let creepage = SiCreepage::default();
    let cautions = Caution::units(&contact, file.smallest_radius(), creepage);
    json(&hertz_report(&contact, &cautions))
}

impl CaseData {
    pub(crate) fn file(&self) -> &CaseFile {
        &self.file
    }

    fn given(&self, py: Python) -> PyResult<Creepage> {
        self.case.creepage().map_err(|error| errors::case(py, error))
    }
}

#[pymethods]
impl CaseData {
    #[new]
    fn new(py: Python, text: String) -> PyResult<Self> {
        let wrong = |error| errors::case(py, error);
        let file = CaseFile::read(&text).map_err(wrong)?;
        let case = file.case().map_err(wrong)?;
        Ok(Self { text, file, case })
    }

    fn __getnewargs__(&self) -> (&str,) {
        (&self.text,)
    }

    /// The same case, however its file is written.
    fn __eq__(&self, other: &Bound<PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().case == self.case)
    }

    fn __hash__(&self) -> u64 {
        let contact = &self.case.contact;
        let numbers = [contact.ellipse().ratio(), contact.poisson(), contact.scaling().force];
        let mut hasher = DefaultHasher::new();
        numbers.map(f64::to_bits).hash(&mut hasher);
        hasher.finish()
    }

    /// Names of the wear and fatigue numbers that rows of the case have; none without `[damage]`.
    #[getter]
    fn damage_columns(&self) -> Vec<&'static str> {
        if self.file.has_damage() { Damage::OF_ROWS.to_vec() } else { Vec::new() }
    }

    /// The text.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// Ratio of the semi-axes.
    #[getter]
    fn a_over_b(&self) -> f64 {
        self.case.contact.ellipse().ratio()
    }

    /// Combined Poisson's ratio.
    #[getter]
    fn poisson(&self) -> f64 {
        self.case.contact.poisson()
    }

    /// Coefficient of friction.
    #[getter]
    fn friction(&self) -> f64 {
        self.case.friction
    }

    /// Rolling velocity (m/s), where it is given.
    #[getter]
    fn speed(&self) -> Option<f64> {
        self.case.speed
    }

    /// How unlike the bodies are: kappa of (2.10) over the coefficient of friction.
    #[getter]
    fn kappa_over_mu(&self) -> f64 {
        self.case.contact.kappa_over_mu()
    }

    /// Whether forces are wanted and the creepage is to be found.
    #[getter]
    fn finds_creepage(&self) -> bool {
        matches!(self.case.given, Given::Constraints(_))
    }

    /// (xi, eta, chi). Raises CaseError where the creepage is to be found.
    #[getter]
    fn dimensionless(&self, py: Python) -> PyResult<(f64, f64, f64)> {
        Ok(self.given(py)?.components().into())
    }

    /// (longitudinal, lateral, spin (rad/m)). Raises CaseError where they are to be found.
    #[getter]
    fn creepage(&self, py: Python) -> PyResult<(f64, f64, f64)> {
        let si = self.case.contact.scaling().si_creepage(self.given(py)?);
        Ok((si.longitudinal, si.lateral, si.spin))
    }

    /// Units of length c (m), creepage, force mu N (N) and traction (Pa).
    #[getter]
    fn units(&self) -> (f64, f64, f64, f64) {
        let scaling = self.case.contact.scaling();
        (scaling.length, scaling.slip, scaling.force, scaling.traction)
    }

    /// The contact as JSON.
    fn hertz(&self) -> PyResult<String> {
        json(&hertz_report(&self.case.hertz, &[]))
    }

    /// The section [solve] as JSON: the theory's name and its options.
    fn theory(&self) -> PyResult<String> {
        json(&self.case.theory)
    }

    /// What looks like a number in another unit, in words.
    #[getter]
    fn units_in_doubt(&self) -> Option<String> {
        let case = &self.case;
        let given = case.creepage().unwrap_or_default();
        let creepage = case.contact.scaling().si_creepage(given);
        let cautions = Caution::units(&case.hertz, case.smallest_radius, creepage);
        (!cautions.is_empty()).then(|| Caution::words(&cautions))
    }

    /// Friction, and where `slope` a factor of the initial slope, fitted to measured points: columns by
    /// name. The report as JSON, and rows that are no points in words.
    fn fit(
        &self,
        py: Python,
        theory: &str,
        options: &Bound<PyDict>,
        columns: Vec<(String, Vec<f64>)>,
        slope: bool,
    ) -> PyResult<(String, Vec<String>)> {
        let spec = options::spec(py, theory, Some(options))?;
        let given: Vec<_> =
            columns.iter().map(|(name, values)| (name.as_str(), values.as_slice())).collect();
        let value = |words: String| PyValueError::new_err(words);
        let measured =
            MeasuredPoints::from_columns(&given).map_err(|error| value(error.to_string()))?;
        let left_out = measured.left_out();
        let file = AnyCaseFile::Ellipse(Box::new(self.file.clone()));
        let fit = signals::stoppable(py, move |stop| {
            let mut proceeds = || !stop.load(Ordering::Relaxed);
            Fit::new(&file, "".as_ref(), &spec, &measured, FitOptions { slope }, &mut proceeds)
        })?;
        let fit = fit.map_err(|error| errors::fit(py, error))?;
        Ok((fit.json().to_string(), left_out))
    }

    /// What the theory of that name neglects in this case though it matters, in words.
    fn neglects(&self, py: Python, theory: &str) -> PyResult<Option<String>> {
        let spec = options::spec(py, theory, None)?;
        let caution = Caution::dissimilar(&spec, self.kappa_over_mu());
        Ok(caution.map(|caution| caution.to_string()))
    }

    /// Solves by the theory of that name with those options. Raises NotReachable where no creepage
    /// gives the wanted forces, CaseError where the theory does not find creepages.
    fn solve(&self, py: Python, theory: &str, options: &Bound<PyDict>) -> PyResult<SolvedCase> {
        let spec = options::spec(py, theory, Some(options))?;
        let solved = if cost(&spec) < LONG {
            py.detach(|| solve(&self.case, Some(&spec)))
        } else {
            let case = self.case.clone();
            signals::answered(py, move || solve(&case, Some(&spec)))?
        };
        Ok(SolvedCase { solved: solved.map_err(|error| errors::solve(py, error))? })
    }
}

#[pymethods]
impl SolvedCase {
    /// Force, with error bars where the theory has them, and status: a Force.
    #[getter]
    fn dimensionless<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        results::force(py, &self.solved.solution())
    }

    /// Cautions about the solution, in words.
    #[getter]
    fn caution(&self) -> Option<String> {
        let cautions = &self.solved.cautions;
        (!cautions.is_empty()).then(|| Caution::words(cautions))
    }

    /// On the lower body: longitudinal and lateral (N), moment (N m).
    #[getter]
    fn force(&self) -> (f64, f64, f64) {
        let force = self.solved.scaling().si_force(self.solved.solution().force);
        (force.longitudinal, force.lateral, force.moment)
    }

    /// Given or found: longitudinal, lateral, spin (rad/m).
    #[getter]
    fn creepage(&self) -> (f64, f64, f64) {
        let si = self.solved.scaling().si_creepage(self.solved.creepage());
        (si.longitudinal, si.lateral, si.spin)
    }

    /// Adhesion area over contact area.
    #[getter]
    fn adhesion_share(&self, py: Python) -> f64 {
        py.detach(|| self.solved.adhesion_share())
    }

    /// Frictional power per metre rolled (J/m), from force and creepage.
    #[getter]
    fn heat_per_metre(&self) -> f64 {
        self.solved.power_per_metre()
    }

    /// The same from traction and slip, where the theory gives it.
    #[getter]
    fn heat_per_metre_by_slip(&self) -> Option<f64> {
        self.solved.dissipation_per_metre()
    }

    /// Frictional power (W), where the rolling velocity is known.
    #[getter]
    fn power(&self) -> Option<f64> {
        self.solved.power()
    }

    /// Which of xi, eta, chi, fx, fy, mz were given, where forces were wanted.
    #[getter]
    fn known(&self) -> Option<Vec<&'static str>> {
        self.solved.known()
    }

    /// The theory's own figures by name.
    #[getter]
    fn details<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let details = PyDict::new(py);
        for diagnostic in self.solved.diagnostics() {
            details.set_item(diagnostic.key, diagnostic.value)?;
        }
        Ok(details)
    }

    /// Every quantity of the report: path, label, unit, value, error bar.
    fn quantities(&self, py: Python) -> PyResult<Vec<QuantityTuple>> {
        detached(py, || quantities(&self.solved.report()))
    }

    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        json(&detached(py, || self.solved.report())?)
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        detached(py, || self.solved.text())
    }

    /// The contact seen from above.
    fn svg(&self, py: Python) -> PyResult<String> {
        detached(py, || self.solved.contact_svg())
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        detached(py, || self.solved.write(&directory, &Sources::default()))?.map_err(errors::report)
    }

    /// Inside one body, at points (x, y, z) (m): stress xx, yy, zz, xy, yz, xz (Pa), displacement (m), and the
    /// depth (m) from which on the stresses have settled.
    fn below<'py>(
        &self,
        py: Python<'py>,
        body: &str,
        points: [Number<'py>; 3],
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>, f64)> {
        let [upper, lower] = self.solved.case.solids();
        let (solid, body) = match body {
            "upper" => (upper, Body::Upper),
            "lower" => (lower, Body::Lower),
            other => {
                let words =
                    format!("body = {other:?} is not valid: it must be \"upper\" or \"lower\"");
                return Err(PyValueError::new_err(words));
            }
        };
        let (interior, settled) = detached(py, || Stresses::interior(&self.solved, solid, body))?
            .map_err(|error| PyValueError::new_err(error.to_string()))?;
        let inputs = Inputs::new(py, ["x", "y", "z"], points)?;
        let at = |point: [f64; 3]| {
            let Inside { stress, displacement } = interior.at(point)?;
            let stress = stress.components();
            let numbers: [f64; 9] =
                std::array::from_fn(|k| if k < 6 { stress[k] } else { displacement[k - 6] });
            Ok((numbers, 0))
        };
        let found = solve_all(py, &inputs, 1e-3, at)?.stacked(py, &[9])?;
        let part = |from: usize, to: usize| {
            found.get_item((
                py.Ellipsis(),
                PySlice::new(py, from.cast_signed(), to.cast_signed(), 1),
            ))
        };
        Ok((part(0, 6)?, part(6, 9)?, settled))
    }

    /// The field at the middles of points x points cells of the box around the ellipse: a Field.
    fn field<'py>(&self, py: Python<'py>, points: usize) -> PyResult<Bound<'py, PyAny>> {
        let ellipse = self.solved.contact.ellipse();
        let (shape, positions) = mesh::cells(py, ellipse, points)?;
        results::field(py, &shape, ellipse, &py.detach(|| self.solved.field(&positions)))
    }

    /// The field at the theory's own points, or at those of a usual mesh: a Field.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let points = py.detach(|| self.solved.points());
        results::field(py, &[points.len()], self.solved.contact.ellipse(), &points)
    }
}
