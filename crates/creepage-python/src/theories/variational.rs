//! The numerical theory of chapter 5.

use creepage::rolling::variational::{self, Settings};
use pyo3::prelude::*;

use crate::errors;
use crate::model::Model;
use crate::options::{arguments, pair, word};
use crate::theory::Theory;

/// The numerical theory of chapter 5 (Kalker 1967): polynomial tractions that minimize the
/// integral (5.9). Fails towards zero creepage, and says so in the status.
///
/// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5. degree: of
/// the polynomials, 0 to 12 (3). mesh: cells (along, across) of the box around the ellipse,
/// (10, 10) up to degree 3. weight: "elliptic" (default), "uniform", "root-elliptic".
///
/// Raises InvalidValue for numbers out of range, InvalidOption for degree, mesh and weight.
#[pyclass(frozen, extends = Theory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Variational;

#[pymethods]
impl Variational {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, degree=None, mesh=None, weight=None))]
    fn new<'py>(
        py: Python<'py>,
        a_over_b: f64,
        poisson: f64,
        degree: Option<Bound<'py, PyAny>>,
        mesh: Option<Bound<'py, PyAny>>,
        weight: Option<Bound<'py, PyAny>>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let [degree, mesh, weight] = [&degree, &mesh, &weight].map(Option::as_ref);
        let options = [("degree", degree), ("mesh", mesh), ("weight", weight)];
        let given = arguments(py, a_over_b, poisson, &options)?;
        let degree: Option<usize> = degree.map(PyAnyMethods::extract).transpose()?;
        let usual = degree.map_or(Settings::default(), Settings::of_degree);
        let weight = word::<creepage_case::Weight>("weight", weight)?;
        let settings = Settings {
            mesh: pair("mesh", mesh)?.unwrap_or(usual.mesh),
            weight: weight.map_or(usual.weight, Into::into),
            ..usual
        };
        let model = variational::Variational::new(a_over_b, poisson, settings)
            .map_err(|error| errors::variational(py, error))?;
        let model = Ok(Model::Variational(Box::new(model)));
        let theory = Theory::new(py, "variational", a_over_b, given, cost(settings), model)?;
        Ok(theory.add_subclass(Self))
    }
}

/// Seconds of a case, roughly: points times unknowns squared.
fn cost(settings: Settings) -> f64 {
    let points = settings.mesh.iter().product::<usize>() as f64;
    let unknowns = ((settings.degree + 1) * (settings.degree + 2)) as f64;
    3e-9 * points * unknowns * unknowns
}
