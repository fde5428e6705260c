//! The dataclasses of `creepage._results`, made from Rust.

use creepage::Ellipse;
use creepage::rolling::exact::ExactSolution;
use creepage::rolling::{FieldPoint, Region, Solution, Status};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::BoundObject;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyTuple, PyType};

use crate::batch::{Answers, Row};
use crate::errors;

const MODULE: &str = "creepage._results";

static FORCE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static EXACT_FORCE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static STATUSES: PyOnceLock<Vec<Py<PyAny>>> = PyOnceLock::new();

/// The statuses in the order of `creepage.Status`.
const ORDER: [Status; 4] =
    [Status::Solved, Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge];

pub(crate) fn plain_row(solution: Solution) -> Row<3> {
    let force = solution.force;
    ([force.fx, force.fy, force.mz], code(solution.status))
}

pub(crate) fn exact_row(solution: ExactSolution) -> Row<6> {
    let (force, error) = (solution.force, solution.error);
    ([force.fx, force.fy, force.mz, error.fx, error.fy, error.mz], code(solution.status))
}

/// A status that Python does not know yet counts as not converged.
#[allow(clippy::cast_possible_truncation)] // of four
fn code(status: Status) -> u8 {
    ORDER.iter().position(|known| *known == status).unwrap_or(1) as u8
}

fn status(py: Python, code: u8) -> PyResult<Bound<PyAny>> {
    let all = STATUSES.get_or_try_init(py, || {
        let class = py.import(MODULE)?.getattr("Status")?;
        class.try_iter()?.map(|member| Ok(member?.unbind())).collect::<PyResult<_>>()
    })?;
    all.get(usize::from(code))
        .map(|one| one.bind(py).clone())
        .ok_or_else(|| errors::internal("status"))
}

pub(crate) fn force(py: Python, row: Row<3>) -> PyResult<Bound<PyAny>> {
    let ([fx, fy, mz], code) = row;
    FORCE.import(py, MODULE, "Force")?.call1((fx, fy, mz, status(py, code)?))
}

pub(crate) fn exact_force(py: Python, row: Row<6>) -> PyResult<Bound<PyAny>> {
    let ([fx, fy, mz, ex, ey, ez], code) = row;
    let class = EXACT_FORCE.import(py, MODULE, "ExactForce")?;
    class.call1((fx, fy, mz, status(py, code)?, ex, ey, ez))
}

pub(crate) fn forces<'py>(
    py: Python<'py>,
    answers: Answers<'py, 3>,
) -> PyResult<Bound<'py, PyAny>> {
    let [fx, fy, mz] = answers.numbers;
    FORCE.import(py, MODULE, "Force")?.call1((fx, fy, mz, answers.codes))
}

pub(crate) fn exact_forces<'py>(
    py: Python<'py>,
    answers: Answers<'py, 6>,
) -> PyResult<Bound<'py, PyAny>> {
    let [fx, fy, mz, ex, ey, ez] = answers.numbers;
    let class = EXACT_FORCE.import(py, MODULE, "ExactForce")?;
    class.call1((fx, fy, mz, answers.codes, ex, ey, ez))
}

/// Position, traction, slip and region as arrays, the vectors in a last dimension of two.
/// Region 2 is outside the ellipse.
pub(crate) fn field_arrays<'py>(
    py: Python<'py>,
    shape: &[usize],
    ellipse: Ellipse,
    points: &[FieldPoint],
) -> PyResult<[Bound<'py, PyAny>; 4]> {
    let vectors = |of: fn(&FieldPoint) -> [f64; 2]| {
        let values: Vec<[f64; 2]> = points.iter().map(of).collect();
        values.into_flattened().into_pyarray(py).reshape([shape, &[2]].concat())
    };
    let regions: Vec<u8> = points.iter().map(|point| region(ellipse, point)).collect();
    Ok([
        vectors(|point| point.position)?.into_any(),
        vectors(|point| point.traction)?.into_any(),
        vectors(|point| point.slip)?.into_any(),
        regions.into_pyarray(py).reshape(shape.to_vec())?.into_any(),
    ])
}

fn region(ellipse: Ellipse, point: &FieldPoint) -> u8 {
    let [x, y] = point.position;
    let inside = (x / ellipse.a()).hypot(y / ellipse.b()) < 1.0;
    match point.region {
        _ if !inside => 2,
        Region::Adhesion => 0,
        Region::Slip => 1,
    }
}

/// `creepage.Field` in units of `c`, with the semi-axes of its ellipse.
pub(crate) fn field<'py>(
    py: Python<'py>,
    shape: &[usize],
    ellipse: Ellipse,
    points: &[FieldPoint],
) -> PyResult<Bound<'py, PyAny>> {
    let [position, traction, slip, region] = field_arrays(py, shape, ellipse, points)?;
    let semi_axes = (ellipse.a(), ellipse.b());
    make(py, "Field", (position, traction, slip, region, semi_axes))
}

/// One of the other dataclasses.
pub(crate) fn make<'py>(
    py: Python<'py>,
    class: &str,
    fields: impl IntoPyObject<'py, Target = PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    let fields = fields.into_pyobject(py).map_err(Into::into)?;
    py.import(MODULE)?.getattr(class)?.call1(fields.into_bound())
}
