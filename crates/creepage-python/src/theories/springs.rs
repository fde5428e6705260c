//! The theories on a bed of springs.

use creepage::rolling::fastsim::Settings;
use creepage_study::Solve;
use pyo3::prelude::*;

use crate::options::{arguments, pair, word};
use crate::theory::{DifferentiableTheory, Theory, prepare};

/// FASTSIM (Kalker 1982) with the flexibilities of Vollebregt and Voltr (2023): a bed of springs.
///
/// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
/// 0.5. grid: cells (along, across), (50, 50). flexibility: "blended" (default), "three", "one".
/// bound: "elliptic" (default), "parabolic" (that of 1982).
///
/// Raises InvalidValue for numbers out of range, InvalidOption for another word.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Fastsim;

/// FaStrip (Sichani, Enblom, Berg 2016): strip theory in the adhesion area, FASTSIM's direction
/// of slip.
///
/// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
/// 0.5. grid: cells (along, across), (50, 50). variant: "consistent" (default), "modified",
/// "original".
///
/// Raises InvalidValue for numbers out of range, InvalidOption for another word.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Fastrip;

/// Seconds of a case, roughly, at so many seconds a cell.
fn cost(solve: &Solve, cell: f64) -> f64 {
    let [along, across] = solve.grid.unwrap_or(Settings::default().grid);
    cell * along as f64 * across as f64
}

#[pymethods]
impl Fastsim {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, grid=None, flexibility=None, bound=None))]
    fn new<'py>(
        py: Python<'py>,
        a_over_b: f64,
        poisson: f64,
        grid: Option<Bound<'py, PyAny>>,
        flexibility: Option<Bound<'py, PyAny>>,
        bound: Option<Bound<'py, PyAny>>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let [grid, flexibility, bound] = [&grid, &flexibility, &bound].map(Option::as_ref);
        let options = [("grid", grid), ("flexibility", flexibility), ("bound", bound)];
        let given = arguments(py, a_over_b, poisson, &options)?;
        let solve = Solve {
            grid: pair("grid", grid)?,
            flexibility: word("flexibility", flexibility)?,
            bound: word("bound", bound)?,
            ..Solve::default()
        };
        let made = prepare(py, "fastsim", a_over_b, poisson, &solve)?;
        let theory = Theory::new(py, "fastsim", a_over_b, given, cost(&solve, 2.2e-9), made)?;
        Ok(theory.add_subclass(DifferentiableTheory).add_subclass(Self))
    }
}

#[pymethods]
impl Fastrip {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, grid=None, variant=None))]
    fn new<'py>(
        py: Python<'py>,
        a_over_b: f64,
        poisson: f64,
        grid: Option<Bound<'py, PyAny>>,
        variant: Option<Bound<'py, PyAny>>,
    ) -> PyResult<PyClassInitializer<Self>> {
        let options = [("grid", grid.as_ref()), ("variant", variant.as_ref())];
        let given = arguments(py, a_over_b, poisson, &options)?;
        let (grid, variant) = (pair("grid", grid.as_ref())?, word("variant", variant.as_ref())?);
        let solve = Solve { grid, variant, ..Solve::default() };
        let made = prepare(py, "fastrip", a_over_b, poisson, &solve)?;
        let theory = Theory::new(py, "fastrip", a_over_b, given, cost(&solve, 7e-9), made)?;
        Ok(theory.add_subclass(DifferentiableTheory).add_subclass(Self))
    }
}
