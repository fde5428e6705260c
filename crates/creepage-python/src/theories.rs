//! Python classes of the theories: their facts and constructors.

use pyo3::PyClass;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::theory::{Call, DifferentiableTheory, Theory};

/// What a theory's class is derived from.
pub(crate) trait Base: PyClass {
    fn of(theory: Theory) -> PyClassInitializer<Self>;
}

impl Base for Theory {
    fn of(theory: Theory) -> PyClassInitializer<Self> {
        theory.into()
    }
}

impl Base for DifferentiableTheory {
    fn of(theory: Theory) -> PyClassInitializer<Self> {
        PyClassInitializer::from(theory).add_subclass(Self)
    }
}

/// The class of a theory: name, base, arguments as Python shows them. Poisson's ratio may have a
/// default.
macro_rules! theory {
    (
        $(#[doc = $words:literal])*
        $class:ident: $base:ident, $name:literal, $arguments:literal, $($poisson:tt)+
    ) => {
        $(#[doc = $words])*
        #[pyclass(frozen, extends = $base, module = "creepage")]
        #[allow(missing_debug_implementations)] // Python has its own
        pub struct $class;

        #[pymethods]
        impl $class {
            #[new]
            #[pyo3(signature = (a_over_b, $($poisson)+, **options), text_signature = $arguments)]
            fn new(
                py: Python,
                a_over_b: f64,
                poisson: f64,
                options: Option<&Bound<PyDict>>,
            ) -> PyResult<PyClassInitializer<Self>> {
                let call = Call::read(py, $name, (a_over_b, poisson), options)?;
                Ok($base::of(call.prepare(py, $name)?).add_subclass(Self))
            }
        }
    };
}

theory! {
    /// The full theory, as fine as a wanted accuracy needs: the first of the three named resolutions
    /// whose error bars of fx and fy are within accuracy (in units of mu N; 0.001), else the finest.
    /// kappa_over_mu as of Exact.
    ///
    /// Raises InvalidValue as Exact, and unless accuracy is positive.
    Automatic: DifferentiableTheory, "automatic",
    "(a_over_b, poisson, *, accuracy=0.001, kappa_over_mu=0.0)", poisson
}

theory! {
    /// The numerical theory of chapter 5 (Kalker 1967): polynomial tractions that minimize the
    /// integral (5.9). Fails towards zero creepage, and says so in the status.
    ///
    /// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5. degree: of
    /// the polynomials, 0 to 12 (3). mesh: cells (along, across) of the box around the ellipse,
    /// (10, 10) up to degree 3. weight: "elliptic" (default), "uniform", "root-elliptic". bound:
    /// whether tractions are kept within it, "automatic" (default: where a/b >= 3), "unchecked" (as
    /// in the thesis: looked at afterwards), "kept" (the least loss of power, whatever the weight).
    /// integrand: a function of (x, y, a, b, t, s), lengths in units of c, in place of T S (5.22); it
    /// gives f and its derivatives by T and S (f, f_t, f_s, f_tt, f_ts, f_ss), f not negative; the bound is then
    /// unchecked. weight multiplies it too: an integrand that has a weight of its own goes with
    /// weight="uniform". kappa_over_mu as of Exact.
    ///
    /// Raises InvalidValue for numbers out of range and derivatives that are not those of f,
    /// InvalidOption for degree, mesh, weight and bound; what integrand raises.
    Variational: Theory, "variational",
    "(a_over_b, poisson, *, degree=None, mesh=None, weight=None, bound=None, integrand=None, kappa_over_mu=0.0)", poisson
}

theory! {
    /// FaStrip (Sichani, Enblom, Berg 2016): strip theory in the adhesion area, FASTSIM's direction
    /// of slip.
    ///
    /// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
    /// 0.5. grid: cells (along, across), (50, 50). variant: "consistent" (default), "modified",
    /// "original".
    ///
    /// Raises InvalidValue for numbers out of range, InvalidOption for another word.
    Fastrip: DifferentiableTheory, "fastrip",
    "(a_over_b, poisson, *, grid=None, variant=None)", poisson
}

theory! {
    /// FASTSIM (Kalker 1982) with the flexibilities of Vollebregt and Voltr (2023): a bed of springs.
    ///
    /// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
    /// 0.5. grid: cells (along, across), (50, 50). flexibility: "blended" (default), "three", "one".
    /// bound: "elliptic" (default), "parabolic" (that of 1982). reduction: factors (k0, alpha, beta) by
    /// which the slope falls with creepage on surfaces that are not clean and dry, (1, 1, 0).
    ///
    /// Raises InvalidValue for numbers out of range, InvalidOption for another word.
    Fastsim: DifferentiableTheory, "fastsim",
    "(a_over_b, poisson, *, grid=None, flexibility=None, bound=None, reduction=None)", poisson
}

theory! {
    /// Strip theory (Haines, Ollerton 1963; Kalker 1967): plane strips side by side, for contacts
    /// slender in the rolling direction (a << b) and little spin.
    ///
    /// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5.
    ///
    /// Raises InvalidValue for numbers out of range.
    Strip: DifferentiableTheory, "strip", "(a_over_b, poisson)", poisson
}

theory! {
    /// Polach (1999): traction that grows steadily from the leading edge; little spin.
    ///
    /// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
    /// 0.5. reduction: factors (adhesion, slip) by which the slope at small creepage is measured
    /// against that of a clean, dry surface, 0 < slip <= adhesion <= 1; (1, 1).
    ///
    /// Raises InvalidValue for numbers out of range.
    Polach: DifferentiableTheory, "polach",
    "(a_over_b, poisson, *, reduction=(1.0, 1.0))", poisson
}

theory! {
    /// Shen, Hedrick, Elkins (1983): linear forces with a cubic saturation; spin below 0.5.
    ///
    /// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
    /// 0.5.
    ///
    /// Raises InvalidValue for numbers out of range.
    ShenHedrickElkins: DifferentiableTheory, "shen-hedrick-elkins", "(a_over_b, poisson)", poisson
}

theory! {
    /// Vermeulen, Johnson (1964): an ellipse of adhesion that touches the leading edge; no spin.
    ///
    /// a_over_b: ratio a/b of the semi-axes. poisson: combined Poisson's ratio, 0 to 0.5.
    ///
    /// Raises InvalidValue for numbers out of range.
    VermeulenJohnson: DifferentiableTheory, "vermeulen-johnson", "(a_over_b, poisson)", poisson
}

theory! {
    /// The linear theory (Kalker 1967, 4.3): no slip anywhere; creepage and spin near zero. Forces
    /// grow beyond mu N.
    ///
    /// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson: combined Poisson's ratio, 0 to
    /// 0.5.
    ///
    /// Raises InvalidValue for numbers out of range.
    Linear: DifferentiableTheory, "linear", "(a_over_b, poisson)", poisson
}

theory! {
    /// Slip everywhere, as if the bodies were rigid (Kalker 1967, 4.4): large creepage or spin.
    ///
    /// a_over_b: ratio a/b of the semi-axes, 1e-3 to 1e3. poisson does not matter; it is taken so
    /// that all theories are made alike.
    ///
    /// Raises InvalidValue for a ratio out of range.
    Saturated: DifferentiableTheory, "saturated", "(a_over_b, poisson=0.0)", poisson = 0.0
}
