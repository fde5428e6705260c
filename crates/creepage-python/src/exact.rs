//! Python class of the full theory, with what it alone can be asked.

use std::sync::Arc;

use creepage::coulomb::{self, Constraints};
use creepage::{Creepage, FieldPoint, TheorySpec};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::theories::Base;
use crate::theory::{Call, DifferentiableTheory};
use crate::{errors, results};

/// The full theory: Coulomb's law at every element, no shape of the traction assumed. Its forces
/// are ExactForce: with error bars.
///
/// a_over_b: ratio a/b of the semi-axes, along over across the rolling direction, 1/64 to 64.
/// poisson: combined Poisson's ratio, 0 to 0.5. resolution: "fast" (14 x 12 elements, 0.3 ms a
/// case, rms error 0.14 % of mu N), "standard" (22 x 18, 0.9 ms, 0.05 %; the default), "fine"
/// (40 x 32, 6 ms, 0.012 %), or (along, across) on a circle, 4 to 200 each,
/// 10000 in all. kappa_over_mu: how unlike the bodies are, kappa of (2.10) over the coefficient of
/// friction; like ones have 0. Their pressure adds to the slip.
///
/// Raises InvalidValue for numbers out of range, InvalidOption for another word.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Exact {
    theory: Arc<coulomb::Exact>,
}

/// Seconds of a case with that number of elements, roughly.
fn cost([along, across]: [usize; 2]) -> f64 {
    2.5e-8 * ((along * across) as f64).powi(2)
}

#[pymethods]
impl Exact {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, **options),
           text_signature = "(a_over_b, poisson, *, resolution=None, kappa_over_mu=0.0)")]
    fn new(
        py: Python,
        a_over_b: f64,
        poisson: f64,
        options: Option<&Bound<PyDict>>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let call = Call::read(py, "exact", (a_over_b, poisson), options)?;
        let TheorySpec::Exact(given) = &call.spec else {
            return Err(errors::internal("theory"));
        };
        // Its contact has no friction by itself: coupled bodies are an error.
        given.is_coupled(&call.contact).map_err(|error| errors::theory(py, error))?;
        let resolution = given.fixed_resolution().map_err(|error| errors::theory(py, error))?;
        let Some(resolution) = resolution else {
            return Err(PyValueError::new_err("resolution: `auto` is the theory `automatic`"));
        };
        let made = py.detach(|| coulomb::Exact::new(&call.contact, resolution));
        let theory = Arc::new(made.map_err(|error| errors::invalid(py, error))?);
        let cost = cost(theory.elements());
        let base = DifferentiableTheory::of(call.theory("exact", theory.clone(), cost));
        Ok(base.add_subclass(Self { theory }))
    }

    /// Elements along and across.
    #[getter]
    fn elements(&self) -> (usize, usize) {
        self.theory.elements().into()
    }

    /// The elements at one creepage: an ElementField, strip by strip from negative y, each from
    /// the leading edge.
    #[pyo3(signature = (xi=0.0, eta=0.0, chi=0.0))]
    fn element_field<'py>(
        &self,
        py: Python<'py>,
        xi: f64,
        eta: f64,
        chi: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let creepage = Creepage::new(xi, eta, chi).map_err(|error| errors::invalid(py, error))?;
        let elements = py.detach(|| self.theory.solve_contact(creepage).elements());
        let ellipse = creepage::Theory::contact(&*self.theory).ellipse();
        let points: Vec<FieldPoint> = elements.iter().map(|element| element.point).collect();
        let [position, traction, slip, region] =
            results::field_arrays(py, &[points.len()], &points)?;
        let column = |of: fn(&coulomb::ElementField) -> f64| {
            elements.iter().map(of).collect::<Vec<_>>().into_pyarray(py)
        };
        let own = (column(|e| e.bound), column(|e| e.share), column(|e| e.power));
        let count = elements.len();
        let corners = elements.iter().flat_map(|e| e.corners).flatten().collect::<Vec<_>>();
        let corners = corners.into_pyarray(py).reshape([count, 4, 2])?;
        let beyond = elements.iter().flat_map(|e| e.beyond).collect::<Vec<_>>();
        let beyond = beyond.into_pyarray(py).reshape([count, 4])?;
        let semi_axes = (ellipse.a(), ellipse.b());
        let fields =
            (position, traction, slip, region, semi_axes, own.0, own.1, own.2, corners, beyond);
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
        &self,
        py: Python<'py>,
        xi: Option<f64>,
        eta: Option<f64>,
        chi: Option<f64>,
        fx: Option<f64>,
        fy: Option<f64>,
        mz: Option<f64>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let constraints = Constraints { xi, eta, chi, fx, fy, mz };
        let found = py.detach(|| {
            let found = self.theory.find(constraints)?;
            Ok((found.creepage(), found.solution(), found.steps))
        });
        let (creepage, solution, steps) = found.map_err(|error| errors::inverse(py, error))?;
        let [xi, eta, chi] = creepage.components();
        results::make(py, "Found", (xi, eta, chi, results::force(py, &solution)?, steps))
    }
}
