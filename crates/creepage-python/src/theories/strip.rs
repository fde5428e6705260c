//! Strip theory.

use pyo3::prelude::*;

use crate::theory::DifferentiableTheory;

/// Strip theory (Haines, Ollerton 1963; Kalker 1967): plane strips side by side, for contacts
/// slender in the rolling direction (a << b) and little spin.
///
/// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5.
///
/// Raises InvalidValue for numbers out of range.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Strip;

#[pymethods]
impl Strip {
    #[new]
    fn new(py: Python, a_over_b: f64, poisson: f64) -> PyResult<PyClassInitializer<Self>> {
        let theory = DifferentiableTheory::plain(py, "strip", a_over_b, poisson, 9e-7)?;
        Ok(theory.add_subclass(Self))
    }
}
