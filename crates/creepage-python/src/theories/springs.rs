//! The theories on a bed of springs.

use creepage::rolling::fastrip;
use creepage::rolling::fastsim::{self, Settings};
use creepage::rolling::linear::CreepageCoefficients;
use pyo3::prelude::*;

use crate::model::Model;
use crate::options::{arguments, pair, word};
use crate::theory::{DifferentiableTheory, Theory};

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
fn cost(grid: [usize; 2], cell: f64) -> f64 {
    cell * grid[0] as f64 * grid[1] as f64
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
        let usual = Settings::default();
        let flexibility = word::<creepage_case::Flexibility>("flexibility", flexibility)?;
        let bound = word::<creepage_case::Bound>("bound", bound)?;
        let settings = Settings {
            flexibility: flexibility.map_or(usual.flexibility, Into::into),
            bound: bound.map_or(usual.bound, Into::into),
            grid: pair("grid", grid)?.unwrap_or(usual.grid),
        };
        let model = py.detach(|| {
            let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
            fastsim::Fastsim::new(a_over_b, poisson, &coefficients, settings)
        });
        let model = model.map(|theory| Model::Fastsim(Box::new(theory)));
        let cost = cost(settings.grid, 2.2e-9);
        let theory = Theory::new(py, "fastsim", a_over_b, given, cost, model)?;
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
        let variant = word::<creepage_case::Variant>("variant", variant.as_ref())?;
        let variant = variant.map(Into::into).unwrap_or_default();
        let grid = pair("grid", grid.as_ref())?.unwrap_or(Settings::default().grid);
        let model = py.detach(|| {
            let coefficients = CreepageCoefficients::new(a_over_b, poisson)?;
            fastrip::Fastrip::new(a_over_b, poisson, &coefficients, variant, grid)
        });
        let model = model.map(|theory| Model::Fastrip(Box::new(theory)));
        let theory = Theory::new(py, "fastrip", a_over_b, given, cost(grid, 7e-9), model)?;
        Ok(theory.add_subclass(DifferentiableTheory).add_subclass(Self))
    }
}
