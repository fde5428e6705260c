//! Functions of numbers that broadcast: creepage coefficients, Carter's theory, line contacts.

use creepage::approximate::carter::{Carter, LineContact};
use creepage::approximate::linear::CreepageCoefficients;
use creepage::viscoelastic::{Relaxation, ViscoelasticCylinders, ViscoelasticError};
use creepage::{InvalidValue, Solid, SolidPair};
use creepage_study::Caution;
use pyo3::prelude::*;

use crate::batch::{Answers, solve_all};
use crate::number::{Inputs, Number};
use crate::{errors, options, results};

/// Columns as floats where all arguments are, else as arrays.
fn columns<'py, const W: usize>(
    py: Python<'py>,
    answers: Answers<'py, W>,
) -> PyResult<[Bound<'py, PyAny>; W]> {
    let scalar = answers.codes.getattr("ndim")?.extract::<usize>()? == 0;
    let mut columns = answers.numbers.map(Bound::into_any);
    if scalar {
        for column in &mut columns {
            *column = column.extract::<f64>()?.into_pyobject(py)?.into_any();
        }
    }
    Ok(columns)
}

/// Creepage coefficients C11, C22, C23, C32, C33 of the linear theory (Kalker 1967, Table 3), to
/// a relative accuracy of 1e-6. Gives a CreepageCoefficients.
///
/// a_over_b: ratio of the semi-axes, 1e-3 to 1e3; poisson: combined Poisson's ratio, 0 to 0.5;
/// floats or arrays, which broadcast. Each costs 1 to 50 ms. degree: None, or that of the
/// polynomials by which the thesis approximates them, 2 to 100; Table 3 is of degree 5, and c32 is
/// then not quite -c23.
///
/// Raises InvalidValue for numbers out of range.
#[pyfunction]
#[pyo3(signature = (a_over_b, poisson, *, degree=None))]
pub(crate) fn coefficients<'py>(
    py: Python<'py>,
    a_over_b: Number<'py>,
    poisson: Number<'py>,
    degree: Option<usize>,
) -> PyResult<Bound<'py, PyAny>> {
    let inputs = Inputs::new(py, ["a_over_b", "poisson"], [a_over_b, poisson])?;
    let answers = solve_all(py, &inputs, 1e-3, |[a_over_b, poisson]| {
        let contact = options::contact(a_over_b, poisson, 0.0)?;
        let found = match degree {
            Some(degree) => CreepageCoefficients::of_degree(&contact, degree)?,
            None => CreepageCoefficients::new(&contact)?,
        };
        Ok(([found.c11, found.c22, found.c23, found.c32, found.c33], 0))
    })?;
    results::make(py, "CreepageCoefficients", pyo3::types::PyTuple::new(py, columns(py, answers)?)?)
}

/// Half-width, peak pressure, rho, kappa, and what looks like a number in another unit.
type LineFound = (f64, f64, f64, f64, Option<String>);

/// Carter's theory at a dimensionless creepage: creepage, force, derivative, half-width and trailing
/// edge of the adhesion area.
#[pyfunction]
pub(crate) fn carter<'py>(
    py: Python<'py>,
    creepage: Number<'py>,
) -> PyResult<[Bound<'py, PyAny>; 5]> {
    let inputs = Inputs::new(py, ["creepage"], [creepage])?;
    let answers = solve_all(py, &inputs, 1e-8, |[creepage]| {
        let found = Carter::new(creepage)?;
        let edges = [found.adhesion_half_width(), found.trailing_edge()];
        Ok(([creepage, found.force(), found.derivative(), edges[0], edges[1]], 0))
    })?;
    columns(py, answers)
}

/// Traction and slip of Carter's theory at x (in units of the half-width, leading edge at 1):
/// traction over mu times the peak pressure, slip over mu a V / rho, region (0 adhesion, 1 slip,
/// 2 outside). Arguments broadcast.
#[pyfunction]
pub(crate) fn carter_field<'py>(
    py: Python<'py>,
    creepage: Number<'py>,
    x: Number<'py>,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let inputs = Inputs::new(py, ["creepage", "x"], [creepage, x])?;
    let answers = solve_all(py, &inputs, 1e-8, |[creepage, x]| {
        let point = Carter::new(creepage)?.at(finite("x", x)?);
        Ok(([point.traction[0], point.slip[0]], results::region(point.region)))
    })?;
    let codes = answers.codes.clone().into_any();
    let [traction, slip] = columns(py, answers)?;
    Ok((traction, slip, codes))
}

fn finite(quantity: &'static str, value: f64) -> Result<f64, InvalidValue> {
    let valid = "a finite number";
    if value.is_finite() { Ok(value) } else { Err(InvalidValue { quantity, value, valid }) }
}

/// Half-width (m), peak pressure (Pa) and rho (m) of two cylinders pressed together: shear moduli
/// (Pa), Poisson's ratios and radii (m) of upper and lower, and the load (N/m).
#[pyfunction]
pub(crate) fn line_contact(
    py: Python,
    shear_moduli: [f64; 2],
    poisson: [f64; 2],
    radii: [f64; 2],
    load: f64,
) -> PyResult<LineFound> {
    let make = || {
        let [upper, lower] = [0, 1].map(|k| Solid::new(shear_moduli[k], poisson[k]));
        let pair = SolidPair::new(upper?, lower?);
        Ok((LineContact::new(pair, radii, load)?, pair))
    };
    let (contact, pair) = make().map_err(|error| errors::invalid(py, error))?;
    let (half_width, peak) = (contact.half_width(), contact.peak_pressure());
    let smallest = radii.into_iter().map(f64::abs).fold(f64::INFINITY, f64::min);
    let cautions = Caution::line_units([half_width, smallest], [peak, pair.shear_modulus()]);
    let words = (!cautions.is_empty()).then(|| Caution::words(&cautions));
    Ok((half_width, peak, contact.rho(), pair.kappa(), words))
}

/// What becomes of cylinders whose area of contact is not found.
fn invalid(error: ViscoelasticError) -> InvalidValue {
    match error {
        ViscoelasticError::Value(invalid) => invalid,
        other => {
            let value = if let ViscoelasticError::NotFound { residual } = other {
                residual
            } else {
                f64::NAN
            };
            let valid = "zero: the area of contact was not found";
            InvalidValue { quantity: "residual of the area's equations", value, valid }
        }
    }
}

/// Trailing and leading edge (m), peak pressure (Pa) and its place (m), centre of pressure (m) and rolling
/// resistance (N/m) of two like viscoelastic cylinders; and the creepage at a tangential force (N/m). Arguments broadcast.
#[pyfunction]
pub(crate) fn viscoelastic_cylinders<'py>(
    py: Python<'py>,
    material: [f64; 4],
    radius: f64,
    friction: f64,
    speed: Number<'py>,
    load: Number<'py>,
    force: Number<'py>,
) -> PyResult<[Bound<'py, PyAny>; 7]> {
    let inputs = Inputs::new(py, ["speed", "load", "force"], [speed, load, force])?;
    let [modulus, poisson, ratio, time] = material;
    let answers = solve_all(py, &inputs, 1e-4, |[speed, load, force]| {
        let soft = Relaxation { ratio, time };
        let cylinders = ViscoelasticCylinders::new(modulus, poisson, soft, radius, speed)?;
        let pressure = cylinders.pressed(load).map_err(invalid)?;
        let ([trailing, leading], [peak, place]) = (pressure.ends(), pressure.largest());
        let creepage = cylinders.creepage(load, friction, force).map_err(invalid)?;
        let (centre, resistance) = (pressure.centre(), pressure.rolling_resistance());
        Ok(([trailing, leading, peak, place, centre, resistance, creepage], 0))
    })?;
    columns(py, answers)
}
