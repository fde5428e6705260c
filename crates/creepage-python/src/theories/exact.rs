//! The full theory.

use creepage::rolling::exact::{self, Known};
use creepage::rolling::{Creepage, FieldPoint};
use creepage_study::{PreparedTheory, Resolution, Solve, TheoryError};
use numpy::IntoPyArray;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::options::{arguments, pair, word};
use crate::theory::{DifferentiableTheory, Theory, prepare};
use crate::{errors, results};

/// The full theory: Coulomb's law at every element, no shape of the traction assumed. Its forces
/// are ExactForce: with error bars.
///
/// a_over_b: ratio a/b of the semi-axes, along over across the rolling direction, 1/64 to 64.
/// poisson: combined Poisson's ratio, 0 to 0.5. resolution: "fast" (14 x 12 elements, 0.5 ms a
/// case, rms error 0.2 % of mu N), "standard" (22 x 18, 2 ms, 0.06 %; the default), "fine"
/// (40 x 32, 25 ms, 0.01 %), or (along, across) on a circle, 4 to 200 each,
/// 10000 in all. kappa_over_mu: how unlike the bodies are, kappa of (2.10) over the coefficient of
/// friction; like ones have 0. Their pressure adds to the slip.
///
/// Raises InvalidValue for numbers out of range, InvalidOption for another word.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Exact;

/// The full theory, as fine as a wanted accuracy needs: the first of the three named resolutions
/// whose error bars of fx and fy are within accuracy (in units of mu N), else the finest.
/// kappa_over_mu as of Exact.
///
/// Raises InvalidValue as Exact, and unless accuracy is positive.
#[pyclass(frozen, extends = Theory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Automatic;

/// Seconds of a case with that number of elements, roughly.
fn cost([along, across]: [usize; 2]) -> f64 {
    2.5e-8 * ((along * across) as f64).powi(2)
}

fn resolution(value: Option<&Bound<PyAny>>) -> PyResult<Option<Resolution>> {
    if value.is_some_and(|value| !value.is_instance_of::<PyString>()) {
        return Ok(pair("resolution", value)?.map(Resolution::Elements));
    }
    let named = word("resolution", value)?;
    if named == Some(Resolution::Auto) {
        return Err(PyValueError::new_err("resolution: `auto` is the theory `automatic`"));
    }
    Ok(named)
}

#[pymethods]
impl Exact {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, resolution=None, kappa_over_mu=0.0))]
    fn new(
        py: Python,
        a_over_b: f64,
        poisson: f64,
        resolution: Option<Bound<PyAny>>,
        kappa_over_mu: f64,
    ) -> PyResult<PyClassInitializer<Self>> {
        let given = arguments(py, a_over_b, poisson, &[("resolution", resolution.as_ref())])?;
        let resolution = self::resolution(resolution.as_ref())?;
        let solve = Solve { resolution, ..Solve::default() };
        let made = prepare(py, "exact", a_over_b, poisson, &solve)?;
        let made = between_bodies(made, kappa_over_mu, &given)?;
        let cost = match &made {
            Ok(PreparedTheory::Exact(theory)) => cost(theory.elements()),
            _ => 1.0,
        };
        let theory = Theory::new(py, "exact", a_over_b, given, cost, made)?;
        Ok(theory.add_subclass(DifferentiableTheory).add_subclass(Self))
    }

    /// Elements along and across.
    #[getter]
    fn elements(slf: PyRef<Self>) -> PyResult<(usize, usize)> {
        let [along, across] = exact_of(&slf)?.elements();
        Ok((along, across))
    }

    /// The elements at one creepage: an ElementField, strip by strip from negative y, each from
    /// the leading edge.
    #[pyo3(signature = (xi=0.0, eta=0.0, chi=0.0))]
    fn element_field<'py>(
        slf: PyRef<'py, Self>,
        py: Python<'py>,
        xi: f64,
        eta: f64,
        chi: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let creepage = Creepage::new(xi, eta, chi).map_err(|error| errors::invalid(py, error))?;
        let theory = exact_of(&slf)?;
        let elements = py.detach(|| {
            let mut workspace = theory.workspace();
            theory.solve_with(creepage, &mut workspace);
            theory.element_fields(&workspace)
        });
        let ellipse = slf.as_super().as_super().ellipse;
        let points: Vec<FieldPoint> = elements.iter().map(|element| element.point).collect();
        let [position, traction, slip, region] =
            results::field_arrays(py, &[points.len()], ellipse, &points)?;
        let column = |of: fn(&exact::ElementField) -> f64| {
            elements.iter().map(of).collect::<Vec<_>>().into_pyarray(py)
        };
        let own = (column(|e| e.bound), column(|e| e.share), column(|e| e.power));
        let semi_axes = (ellipse.a(), ellipse.b());
        let fields = (position, traction, slip, region, semi_axes, own.0, own.1, own.2);
        results::make(py, "ElementField", fields)
    }

    /// The inverse problem: any three of the six quantities in, the other three out, by Newton's
    /// method. Gives a Found.
    ///
    /// Raises NotReachable where no creepage gives the force, TypeError unless exactly three are
    /// given, InvalidValue where one is not finite.
    #[pyo3(signature = (*, xi=None, eta=None, chi=None, fx=None, fy=None, mz=None))]
    #[allow(clippy::too_many_arguments)] // Python's are by name
    fn find<'py>(
        slf: PyRef<'py, Self>,
        py: Python<'py>,
        xi: Option<f64>,
        eta: Option<f64>,
        chi: Option<f64>,
        fx: Option<f64>,
        fy: Option<f64>,
        mz: Option<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let theory = exact_of(&slf)?;
        let known = Known { xi, eta, chi, fx, fy, mz };
        let found = py
            .detach(|| theory.find(known, &mut theory.workspace()))
            .map_err(|error| errors::inverse(py, error))?;
        let Creepage { xi, eta, chi } = found.creepage;
        let force = results::exact_force(py, results::exact_row(found.solution))?;
        results::make(py, "Found", (xi, eta, chi, force, found.steps))
    }
}

#[pymethods]
impl Automatic {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, accuracy=0.005, kappa_over_mu=0.0))]
    fn new(
        py: Python,
        a_over_b: f64,
        poisson: f64,
        accuracy: f64,
        kappa_over_mu: f64,
    ) -> PyResult<PyClassInitializer<Self>> {
        let given = arguments(py, a_over_b, poisson, &[])?;
        given.set_item("accuracy", accuracy)?;
        let (resolution, accuracy) = (Some(Resolution::Auto), Some(accuracy));
        let solve = Solve { resolution, accuracy, ..Solve::default() };
        let made = prepare(py, "exact", a_over_b, poisson, &solve)?;
        let made = between_bodies(made, kappa_over_mu, &given)?;
        let theory = Theory::new(py, "automatic", a_over_b, given, cost([22, 18]), made)?;
        Ok(theory.add_subclass(Self))
    }
}

/// The theory between unlike bodies, of which its arguments tell; between like ones as it is.
fn between_bodies(
    made: Result<PreparedTheory, TheoryError>,
    kappa_over_mu: f64,
    arguments: &Bound<PyDict>,
) -> PyResult<Result<PreparedTheory, TheoryError>> {
    if kappa_over_mu == 0.0 {
        return Ok(made);
    }
    arguments.set_item("kappa_over_mu", kappa_over_mu)?;
    Ok(made.and_then(|theory| Ok(theory.with_unlikeness(kappa_over_mu)?)))
}

fn exact_of<'a>(slf: &'a PyRef<'_, Exact>) -> PyResult<&'a exact::Exact> {
    match &*slf.as_super().as_super().model {
        PreparedTheory::Exact(theory) => Ok(theory),
        _ => Err(errors::internal("theory")),
    }
}
