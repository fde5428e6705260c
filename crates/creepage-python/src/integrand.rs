//! An integrand of the user's own in place of `T S` (5.22), as a function in Python.

use std::sync::{Arc, Mutex, PoisonError};

use creepage::Contact;
use creepage::variational::{
    IntegrandArguments, IntegrandTerms, Settings, Variational, VariationalError,
};
use pyo3::prelude::*;

/// The first exception of a function that is asked where none can be raised.
pub(crate) type Raised = Arc<Mutex<Option<PyErr>>>;

/// Chapter 5 with the integrand `function(x, y, a, b, t, s)`, which gives `f` and its derivatives
/// `f*`, `f.`, `f**`, `f*.`, `f..`.
pub(crate) fn prepare(
    py: Python,
    contact: &Contact,
    settings: Settings,
    function: Py<PyAny>,
) -> (Result<Variational, VariationalError>, Raised) {
    let raised = Raised::default();
    let kept = Arc::clone(&raised);
    let integrand = move |at| asked(&function, &kept, at);
    (py.detach(|| Variational::with_integrand(contact, settings, integrand)), raised)
}

/// Raises what the function has raised since the last time.
pub(crate) fn check(raised: &Raised) -> PyResult<()> {
    let error = raised.lock().unwrap_or_else(PoisonError::into_inner).take();
    error.map_or(Ok(()), Err)
}

/// What the function answers; no numbers once it raises, which end the iteration.
fn asked(function: &Py<PyAny>, raised: &Raised, at: IntegrandArguments) -> IntegrandTerms {
    let ([x, y], [a, b]) = (at.position, at.semi_axes);
    let answer = Python::attach(|py| -> PyResult<[f64; 6]> {
        function.call1(py, (x, y, a, b, at.t, at.s))?.extract(py)
    });
    let [f, t, s, tt, ts, ss] = answer.unwrap_or_else(|error| {
        raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
        [f64::NAN; 6]
    });
    IntegrandTerms { f, t, s, tt, ts, ss }
}
