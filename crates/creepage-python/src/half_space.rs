//! Python class of the load-displacement equations of chapters 2 and 3, both ways.

use creepage::halfspace::{
    DisplacementField, DisplacementLoad, Edge, LoadDisplacement, Polynomial, ResponseError,
    Traction,
};
use creepage::{Ellipse, InvalidValue};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::batch::solve_all;
use crate::errors;
use crate::number::{Inputs, Number};

/// Coefficients of three polynomials.
type Three = (Vec<f64>, Vec<f64>, Vec<f64>);

/// The half-space under tractions on an ellipse: prepared up to a degree.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct HalfSpaceData {
    response: LoadDisplacement,
    inverse: DisplacementLoad,
    poisson: f64,
    /// Combined shear modulus (Pa).
    modulus: f64,
}

fn failed(py: Python, error: ResponseError) -> PyErr {
    match error {
        ResponseError::Invalid(invalid) => errors::invalid(py, invalid),
        other => PyValueError::new_err(other.to_string()),
    }
}

fn edge(name: &str) -> PyResult<Edge> {
    match name {
        "vanishing" => Ok(Edge::Vanishing),
        "singular" => Ok(Edge::Singular),
        other => Err(PyValueError::new_err(format!(
            "edge = {other:?} is not valid: it must be \"vanishing\" or \"singular\""
        ))),
    }
}

fn polynomial(coefficients: &[f64], over: f64) -> Result<Polynomial, ResponseError> {
    if coefficients.is_empty() {
        return Ok(Polynomial::zero(0));
    }
    Ok(Polynomial::new(coefficients.iter().map(|value| value / over).collect())?)
}

fn three([one, two, three]: &[Polynomial; 3], by: f64) -> Three {
    let list = |of: &Polynomial| of.coefficients().iter().map(|value| value * by).collect();
    (list(one), list(two), list(three))
}

impl HalfSpaceData {
    fn of(&self, (x, y, z): &Three, edge: Edge) -> Result<Traction, ResponseError> {
        let [x, y, z] = [x, y, z].map(|part| polynomial(part, self.modulus));
        Ok(Traction::new(self.response.ellipse(), edge, [&x?, &y?, &z?])?)
    }

    fn caused(&self, traction: &Three, edge: Edge) -> Result<Three, ResponseError> {
        let found = self.response.displacement(&self.of(traction, edge)?)?;
        Ok(three(&found, 1.0))
    }

    fn causing(&self, (u, v, w): &Three, edge: Edge) -> Result<Three, ResponseError> {
        let [u, v, w] = [u, v, w].map(|part| polynomial(part, 1.0));
        let given = [&u?, &v?, &w?];
        let found = match edge {
            Edge::Singular => self.inverse.singular(given)?,
            Edge::Vanishing => self.inverse.vanishing(given)?,
        };
        Ok(three(&found.polynomials()?, self.modulus))
    }
}

#[pymethods]
impl HalfSpaceData {
    #[new]
    fn new(
        py: Python,
        semi_axes: [f64; 2],
        poisson: f64,
        modulus: f64,
        degree: usize,
    ) -> PyResult<Self> {
        let valid = "finite and greater than zero";
        if !(modulus.is_finite() && modulus > 0.0) {
            let error = InvalidValue { quantity: "shear_modulus", value: modulus, valid };
            return Err(errors::invalid(py, error));
        }
        let prepare = || -> Result<_, ResponseError> {
            let ellipse = Ellipse::new(semi_axes[0], semi_axes[1])?;
            let response = LoadDisplacement::new(ellipse, poisson, degree)?;
            let inverse = response.inverse()?;
            Ok((response, inverse))
        };
        let (response, inverse) = py.detach(prepare).map_err(|error| failed(py, error))?;
        Ok(Self { response, inverse, poisson, modulus })
    }

    /// Coefficients of the displacement differences (u, v, w) that a traction (X, Y, Z) causes.
    fn displacement(&self, py: Python, traction: Three, edge: &str) -> PyResult<Three> {
        let edge = self::edge(edge)?;
        py.detach(|| self.caused(&traction, edge)).map_err(|error| failed(py, error))
    }

    /// Coefficients of the traction (X, Y, Z) that causes displacement differences (u, v, w).
    fn traction(&self, py: Python, displacement: Three, edge: &str) -> PyResult<Three> {
        let edge = self::edge(edge)?;
        py.detach(|| self.causing(&displacement, edge)).map_err(|error| failed(py, error))
    }

    /// Forces F_x, F_y, N and the moment M_z of a traction.
    fn resultants(&self, py: Python, traction: Three, edge: &str) -> PyResult<[f64; 4]> {
        let traction = self.of(&traction, self::edge(edge)?).map_err(|error| failed(py, error))?;
        let found = traction.resultants();
        Ok([found.fx, found.fy, found.n, found.mz].map(|number| number * self.modulus))
    }

    /// Displacement differences (u, v, w) at points of the surface, in a last dimension of three; of
    /// bodies that differ by kappa too.
    fn displacement_at<'py>(
        &self,
        py: Python<'py>,
        traction: Three,
        edge: &str,
        points: [Number<'py>; 2],
        kappa: f64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let traction = self.of(&traction, self::edge(edge)?).map_err(|error| failed(py, error))?;
        let field = DisplacementField::new(&traction, self.poisson, kappa)
            .map_err(|error| errors::invalid(py, error))?;
        Self::at(py, points, |point| field.at(point))
    }

    /// The traction (X, Y, Z) at points of the surface, in a last dimension of three.
    fn traction_at<'py>(
        &self,
        py: Python<'py>,
        traction: Three,
        edge: &str,
        points: [Number<'py>; 2],
    ) -> PyResult<Bound<'py, PyAny>> {
        let traction = self.of(&traction, self::edge(edge)?).map_err(|error| failed(py, error))?;
        let modulus = self.modulus;
        Self::at(py, points, |point| traction.at(point).map(|part| part * modulus))
    }
}

impl HalfSpaceData {
    fn at<'py>(
        py: Python<'py>,
        points: [Number<'py>; 2],
        value: impl Fn([f64; 2]) -> [f64; 3] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let inputs = Inputs::new(py, ["x", "y"], points)?;
        let at = |point: [f64; 2]| {
            for (quantity, value) in ["x", "y"].into_iter().zip(point) {
                if !value.is_finite() {
                    return Err(InvalidValue { quantity, value, valid: "finite" });
                }
            }
            Ok((value(point), 0))
        };
        solve_all(py, &inputs, 1e-5, at)?.stacked(py, &[3])
    }
}
