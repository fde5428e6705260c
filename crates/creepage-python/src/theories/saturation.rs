//! The theories that saturate a force in closed form.

use creepage_study::Solve;
use pyo3::prelude::*;

use crate::options::arguments;
use crate::theory::{DifferentiableTheory, Theory, prepare};

/// Polach (1999): traction that grows steadily from the leading edge; little spin.
///
/// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
/// 0.5. reduction: factors (adhesion, slip) by which the slope at small creepage is measured
/// against that of a clean, dry surface, 0 < slip <= adhesion <= 1; (1, 1).
///
/// Raises InvalidValue for numbers out of range.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct Polach;

/// Shen, Hedrick, Elkins (1983): linear forces with a cubic saturation; spin below 0.5.
///
/// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
/// 0.5.
///
/// Raises InvalidValue for numbers out of range.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct ShenHedrickElkins;

/// Vermeulen, Johnson (1964): an ellipse of adhesion that touches the leading edge; no spin.
///
/// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5.
///
/// Raises InvalidValue for numbers out of range.
#[pyclass(frozen, extends = DifferentiableTheory, module = "creepage")]
#[allow(missing_debug_implementations)] // Python has its own
pub struct VermeulenJohnson;

#[pymethods]
impl Polach {
    #[new]
    #[pyo3(signature = (a_over_b, poisson, *, reduction=[1.0, 1.0]),
           text_signature = "(a_over_b, poisson, *, reduction=(1.0, 1.0))")]
    fn new(
        py: Python,
        a_over_b: f64,
        poisson: f64,
        reduction: [f64; 2],
    ) -> PyResult<PyClassInitializer<Self>> {
        let given = arguments(py, a_over_b, poisson, &[])?;
        given.set_item("reduction", (reduction[0], reduction[1]))?;
        let solve = Solve { reduction: Some(reduction), ..Solve::default() };
        let made = prepare(py, "polach", a_over_b, poisson, &solve)?;
        let theory = Theory::new(py, "polach", a_over_b, given, 4e-8, made)?;
        Ok(theory.add_subclass(DifferentiableTheory).add_subclass(Self))
    }
}

#[pymethods]
impl ShenHedrickElkins {
    #[new]
    fn new(py: Python, a_over_b: f64, poisson: f64) -> PyResult<PyClassInitializer<Self>> {
        let theory =
            DifferentiableTheory::plain(py, "shen-hedrick-elkins", a_over_b, poisson, 3e-8)?;
        Ok(theory.add_subclass(Self))
    }
}

#[pymethods]
impl VermeulenJohnson {
    #[new]
    fn new(py: Python, a_over_b: f64, poisson: f64) -> PyResult<PyClassInitializer<Self>> {
        let theory = DifferentiableTheory::plain(py, "vermeulen-johnson", a_over_b, poisson, 1e-8)?;
        Ok(theory.add_subclass(Self))
    }
}
