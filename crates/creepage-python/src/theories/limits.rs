//! The two limits: no slip, and slip everywhere.

use pyo3::prelude::*;

use crate::theory::DifferentiableTheory;

/// The linear theory (Kalker 1967, 4.3): no slip anywhere; creepage and spin near zero. Forces
/// grow beyond mu N.
///
/// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
/// 0.5.
///
/// Raises InvalidValue for numbers out of range.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Linear;

/// Slip everywhere, as if the bodies were rigid (Kalker 1967, 4.4): large creepage or spin.
///
/// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson does not matter; it is taken so
/// that all theories are made alike.
///
/// Raises InvalidValue for a ratio out of range.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Saturated;

#[pymethods]
impl Linear {
    #[new]
    fn new(py: Python, a_over_b: f64, poisson: f64) -> PyResult<PyClassInitializer<Self>> {
        let theory = DifferentiableTheory::plain(py, "linear", a_over_b, poisson, 1.2e-8)?;
        Ok(theory.add_subclass(Self))
    }
}

#[pymethods]
impl Saturated {
    #[new]
    #[pyo3(signature = (a_over_b, poisson=0.0))]
    fn new(py: Python, a_over_b: f64, poisson: f64) -> PyResult<PyClassInitializer<Self>> {
        let theory = DifferentiableTheory::plain(py, "saturated", a_over_b, poisson, 9e-7)?;
        Ok(theory.add_subclass(Self))
    }
}
