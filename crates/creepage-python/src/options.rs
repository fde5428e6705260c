//! Options of the theories, by the words of case files.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};

use crate::errors;

/// What a theory is made with: those that are not None.
pub(crate) fn arguments<'py>(
    py: Python<'py>,
    a_over_b: f64,
    poisson: f64,
    options: &[(&str, Option<&Bound<'py, PyAny>>)],
) -> PyResult<Bound<'py, PyDict>> {
    let arguments = PyDict::new(py);
    arguments.set_item("a_over_b", a_over_b)?;
    arguments.set_item("poisson", poisson)?;
    for (name, value) in options {
        if let Some(value) = value {
            arguments.set_item(name, value)?;
        }
    }
    Ok(arguments)
}

/// An option that is one of several words.
pub(crate) fn word<T: for<'de> Deserialize<'de>>(
    name: &str,
    value: Option<&Bound<'_, PyAny>>,
) -> PyResult<Option<T>> {
    let Some(value) = value else {
        return Ok(None);
    };
    let Ok(text) = value.cast::<PyString>() else {
        let message = format!("{name} must be a word, not {}", value.get_type().name()?);
        return Err(PyTypeError::new_err(message));
    };
    let text = text.to_cow()?;
    let deserializer: StrDeserializer<'_, Error> = text.as_ref().into_deserializer();
    let read = T::deserialize(deserializer);
    read.map(Some).map_err(|error| errors::option(value.py(), name, &error.to_string()))
}

/// An option that is two counts.
pub(crate) fn pair(name: &str, value: Option<&Bound<'_, PyAny>>) -> PyResult<Option<[usize; 2]>> {
    let read = value.map(PyAnyMethods::extract::<[usize; 2]>);
    read.transpose().map_err(|_| PyTypeError::new_err(format!("{name} must be two counts")))
}
