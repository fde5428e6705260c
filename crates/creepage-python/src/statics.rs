//! Python class of problems without rolling, by their files.

use std::path::PathBuf;

use creepage::InvalidValue;
use creepage::statics::{ShearedRectangle, ShiftAxis};
use creepage_study::{
    Sources, StaticsCase, StaticsError, StaticsFile, StaticsProblem, StaticsReport,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::batch::solve_all;
use crate::case::{QuantityTuple, quantities};
use crate::errors;
use crate::number::{Inputs, Number};

/// Whether a point (m) is on a rectangle.
fn is_inside(rectangle: &ShearedRectangle, [x, y]: [f64; 2]) -> bool {
    let [a, b] = rectangle.half_lengths();
    x.abs() <= a && y.abs() <= b
}

/// A problem without rolling, solved.
#[pyclass(frozen, module = "creepage._creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct SolvedStatics {
    case: StaticsCase,
}

impl SolvedStatics {
    fn report(&self, py: Python) -> PyResult<StaticsReport<'_>> {
        py.detach(|| StaticsReport::new(&self.case)).map_err(|error| errors::statics(py, error))
    }

    /// A vector at every point `(x, y)`, in a last dimension.
    fn vectors<'py, const W: usize>(
        py: Python<'py>,
        points: [Number<'py>; 2],
        at: impl Fn([f64; 2]) -> [f64; W] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let inputs = Inputs::new(py, ["x", "y"], points)?;
        let at = |point: [f64; 2]| {
            for (quantity, value) in ["x", "y"].into_iter().zip(point) {
                if !value.is_finite() {
                    return Err(InvalidValue { quantity, value, valid: "finite" });
                }
            }
            Ok((at(point), 0))
        };
        solve_all(py, &inputs, 1e-5, at)?.stacked(py, &[W])
    }
}

#[pymethods]
impl SolvedStatics {
    #[new]
    fn new(py: Python, text: &str) -> PyResult<Self> {
        let solve = || StaticsFile::read(text).map_err(StaticsError::from)?.solve();
        let case = py.detach(solve).map_err(|error| errors::statics(py, error))?;
        Ok(Self { case })
    }

    /// `report.json` as text.
    fn json(&self, py: Python) -> PyResult<String> {
        Ok(self.report(py)?.json().to_string())
    }

    /// All quantities of the report: path, label, unit, value, error bar.
    fn quantities(&self, py: Python) -> PyResult<Vec<QuantityTuple>> {
        Ok(quantities(&self.report(py)?.report()))
    }

    /// A short report for a terminal.
    fn text(&self, py: Python) -> PyResult<String> {
        Ok(self.report(py)?.text())
    }

    /// The contact seen from above.
    fn svg(&self, py: Python) -> PyResult<String> {
        Ok(self.report(py)?.svg())
    }

    /// Writes the files of the report.
    fn write(&self, py: Python, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        self.report(py)?.write(&directory, &Sources::default()).map_err(errors::report)
    }

    /// Tangential traction on the lower body (Pa) at points (m), in a last dimension of two.
    fn traction<'py>(
        &self,
        py: Python<'py>,
        x: Number<'py>,
        y: Number<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        match &self.case.problem {
            StaticsProblem::Die { .. } => {
                Err(PyValueError::new_err("a die has no tangential traction: ask its pressure"))
            }
            StaticsProblem::Shift { bonded, .. } | StaticsProblem::Twist { bonded, .. } => {
                Self::vectors(py, [x, y], |point| bonded.traction(point))
            }
            StaticsProblem::PartialSlip { partial, .. } => {
                Self::vectors(py, [x, y], |point| partial.traction(point))
            }
            StaticsProblem::ShiftPath { axis, steps, .. } => Self::vectors(py, [x, y], |point| {
                let traction = steps.last().map_or(0.0, |path| path.traction(point));
                match axis {
                    ShiftAxis::X => [traction, 0.0],
                    ShiftAxis::Y => [0.0, traction],
                }
            }),
            StaticsProblem::ShearedRectangle { steps, .. } => Self::vectors(py, [x, y], |point| {
                let inside = steps.last().filter(|path| is_inside(path, point));
                let traction = inside.map_or(0.0, ShearedRectangle::traction);
                match inside.map(ShearedRectangle::axis) {
                    Some(ShiftAxis::Y) => [0.0, traction],
                    _ => [traction, 0.0],
                }
            }),
            StaticsProblem::Compression { compression, .. } => {
                Self::vectors(py, [x, y], |[x, y]| {
                    let radius = x.hypot(y);
                    let [_, traction] = compression.at(radius);
                    if radius > 0.0 {
                        [x, y].map(|part| part / radius * traction)
                    } else {
                        [0.0; 2]
                    }
                })
            }
        }
    }

    /// Pressure under a die, between balls or on a rectangle (Pa), at points (m).
    fn pressure<'py>(
        &self,
        py: Python<'py>,
        x: Number<'py>,
        y: Number<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        match &self.case.problem {
            StaticsProblem::Die { die, .. } => {
                Self::vectors(py, [x, y], |point| [die.pressure(point)])?
                    .call_method1("__getitem__", ((py.Ellipsis(), 0),))
            }
            StaticsProblem::Compression { compression, .. } => {
                Self::vectors(py, [x, y], |[x, y]| [compression.at(x.hypot(y))[0]])?
                    .call_method1("__getitem__", ((py.Ellipsis(), 0),))
            }
            StaticsProblem::ShearedRectangle { steps, .. } => Self::vectors(py, [x, y], |point| {
                let inside = steps.last().filter(|path| is_inside(path, point));
                [inside.map_or(0.0, ShearedRectangle::pressure)]
            })?
            .call_method1("__getitem__", ((py.Ellipsis(), 0),)),
            _ => Err(PyValueError::new_err(
                "only a die, balls and a rectangle have their pressure as an answer",
            )),
        }
    }

    /// Displacement (m) at points (m), in a last dimension of three: of the lower body under a
    /// die, of the upper relative to the lower body else.
    fn displacement<'py>(
        &self,
        py: Python<'py>,
        x: Number<'py>,
        y: Number<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        match &self.case.problem {
            StaticsProblem::Die { die, .. } => {
                Self::vectors(py, [x, y], |point| die.displacement(point))
            }
            StaticsProblem::Shift { bonded, .. } | StaticsProblem::Twist { bonded, .. } => {
                Self::vectors(py, [x, y], |point| bonded.displacement(point))
            }
            StaticsProblem::PartialSlip { partial, .. } => {
                Self::vectors(py, [x, y], |point| partial.displacement(point))
            }
            StaticsProblem::ShiftPath { .. } | StaticsProblem::ShearedRectangle { .. } => {
                Err(PyValueError::new_err(
                    "of a path the displacement is not known at points: found has the shift",
                ))
            }
            StaticsProblem::Compression { .. } => Err(PyValueError::new_err(
                "of balls the displacement is not known at points: found has the approach",
            )),
        }
    }
}
