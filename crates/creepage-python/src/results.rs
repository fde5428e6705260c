//! The dataclasses of `creepage._results`, made from Rust.

use creepage::{Ellipse, FieldPoint, Force, Jacobian, Region, Solution, Status};
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

/// The statuses by their numbers in `creepage.Status`; that of no case, 4, has none.
const ORDER: [Option<Status>; 7] = [
    Some(Status::Solved),
    Some(Status::NotConverged),
    Some(Status::CreepageTooSmall),
    Some(Status::SpinTooLarge),
    None,
    Some(Status::SeveralSolutions),
    Some(Status::NoContact),
];

pub(crate) fn row(solution: &Solution) -> Row<3> {
    (solution.force.components(), code(solution.status))
}

pub(crate) fn row_with_errors(solution: &Solution) -> Row<6> {
    let nothing = Force { fx: f64::NAN, fy: f64::NAN, mz: f64::NAN };
    let [fx, fy, mz] = solution.force.components();
    let [ex, ey, ez] = solution.error.unwrap_or(nothing).components();
    ([fx, fy, mz, ex, ey, ez], code(solution.status))
}

pub(crate) fn matrix_row(matrix: &Jacobian) -> Row<9> {
    let mut row = [0.0; 9];
    row.copy_from_slice(matrix.as_flattened());
    (row, 0)
}

/// A status that Python does not know yet counts as not converged.
#[allow(clippy::cast_possible_truncation)] // of seven
pub(crate) fn code(status: Status) -> u8 {
    ORDER.iter().position(|known| *known == Some(status)).unwrap_or(1) as u8
}

fn status(py: Python, status: Status) -> PyResult<Bound<PyAny>> {
    let all = STATUSES.get_or_try_init(py, || {
        let class = py.import(MODULE)?.getattr("Status")?;
        class.try_iter()?.map(|member| Ok(member?.unbind())).collect::<PyResult<_>>()
    })?;
    all.get(usize::from(code(status)))
        .map(|one| one.bind(py).clone())
        .ok_or_else(|| errors::internal("status"))
}

/// A Force, or an ExactForce where there are error bars.
pub(crate) fn force<'py>(py: Python<'py>, solution: &Solution) -> PyResult<Bound<'py, PyAny>> {
    let (Force { fx, fy, mz }, status) = (solution.force, status(py, solution.status)?);
    match solution.error {
        None => FORCE.import(py, MODULE, "Force")?.call1((fx, fy, mz, status)),
        Some(error) => {
            let class = EXACT_FORCE.import(py, MODULE, "ExactForce")?;
            class.call1((fx, fy, mz, status, error.fx, error.fy, error.mz))
        }
    }
}

pub(crate) fn forces<'py>(
    py: Python<'py>,
    answers: Answers<'py, 3>,
) -> PyResult<Bound<'py, PyAny>> {
    let [fx, fy, mz] = answers.numbers;
    FORCE.import(py, MODULE, "Force")?.call1((fx, fy, mz, answers.codes))
}

pub(crate) fn forces_with_errors<'py>(
    py: Python<'py>,
    answers: Answers<'py, 6>,
) -> PyResult<Bound<'py, PyAny>> {
    let [fx, fy, mz, ex, ey, ez] = answers.numbers;
    let class = EXACT_FORCE.import(py, MODULE, "ExactForce")?;
    class.call1((fx, fy, mz, answers.codes, ex, ey, ez))
}

/// Position, traction, slip and region as arrays, the vectors in a last dimension of two.
pub(crate) fn field_arrays<'py>(
    py: Python<'py>,
    shape: &[usize],
    points: &[FieldPoint],
) -> PyResult<[Bound<'py, PyAny>; 4]> {
    let vectors = |of: fn(&FieldPoint) -> [f64; 2]| {
        let values: Vec<[f64; 2]> = points.iter().map(of).collect();
        values.into_flattened().into_pyarray(py).reshape([shape, &[2]].concat())
    };
    let regions: Vec<u8> = points.iter().map(|point| region(point.region)).collect();
    Ok([
        vectors(|point| point.position)?.into_any(),
        vectors(|point| point.traction)?.into_any(),
        vectors(|point| point.slip)?.into_any(),
        regions.into_pyarray(py).reshape(shape.to_vec())?.into_any(),
    ])
}

/// As in `creepage.Region`.
pub(crate) fn region(region: Region) -> u8 {
    match region {
        Region::Adhesion => 0,
        Region::Slip => 1,
        Region::Outside => 2,
    }
}

/// `creepage.Field` in units of `c`, with the semi-axes of its ellipse.
pub(crate) fn field<'py>(
    py: Python<'py>,
    shape: &[usize],
    ellipse: Ellipse,
    points: &[FieldPoint],
) -> PyResult<Bound<'py, PyAny>> {
    let [position, traction, slip, region] = field_arrays(py, shape, points)?;
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
