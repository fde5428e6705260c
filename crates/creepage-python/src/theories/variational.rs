//! The numerical theory of chapter 5.

use creepage::rolling::variational::Settings;
use creepage_study::{Solve, variational_settings};
use pyo3::prelude::*;

use crate::options::{arguments, pair, word};
use crate::theory::{Theory, prepare};

/// The numerical theory of chapter 5 (Kalker 1967): polynomial tractions that minimize the
/// integral (5.9). Fails towards zero creepage, and says so in the status.
///
/// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5. degree: of
/// the polynomials, 0 to 12 (3). mesh: cells (along, across) of the box around the ellipse,
/// (10, 10) up to degree 3. weight: "elliptic" (default), "uniform", "root-elliptic". bound:
/// whether tractions are kept within it, "automatic" (default: where a/b >= 3), "unchecked" (as in
/// the thesis: looked at afterwards), "kept" (the least loss of power, whatever the weight).
///
/// Raises InvalidValue for numbers out of range, InvalidOption for degree, mesh, weight and bound.
#[pyclass(frozen, extends = Theory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Variational;

#[pymethods]
impl Variational {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, degree=None, mesh=None, weight=None, bound=None))]
    fn new<'py>(
        py: Python<'py>,
        a_over_b: f64,
        poisson: f64,
        degree: Option<Bound<'py, PyAny>>,
        mesh: Option<Bound<'py, PyAny>>,
        weight: Option<Bound<'py, PyAny>>,
        bound: Option<Bound<'py, PyAny>>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let [degree, mesh, weight, bound] = [&degree, &mesh, &weight, &bound].map(Option::as_ref);
        let options = [("degree", degree), ("mesh", mesh), ("weight", weight), ("bound", bound)];
        let given = arguments(py, a_over_b, poisson, &options)?;
        let solve = Solve {
            degree: degree.map(PyAnyMethods::extract).transpose()?,
            mesh: pair("mesh", mesh)?,
            weight: word("weight", weight)?,
            bound: word("bound", bound)?,
            ..Solve::default()
        };
        let made = prepare(py, "variational", a_over_b, poisson, &solve)?;
        let cost = cost(variational_settings(&solve));
        let theory = Theory::new(py, "variational", a_over_b, given, cost, made)?;
        Ok(theory.add_subclass(Self))
    }
}

/// Seconds of a case, roughly: points times unknowns squared.
fn cost(settings: Settings) -> f64 {
    let points = settings.mesh.iter().product::<usize>() as f64;
    let unknowns = ((settings.degree + 1) * (settings.degree + 2)) as f64;
    3e-9 * points * unknowns * unknowns
}
