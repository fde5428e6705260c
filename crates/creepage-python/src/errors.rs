//! The library's errors as Python's exceptions, with their messages and fields.

use std::io;
use std::path::PathBuf;

use creepage::coulomb::InverseError;
use creepage::table::FileError;
use creepage::theory::{TheoryError, UnknownTheory};
use creepage::variational::VariationalError;
use creepage::{Creepage, Force, InvalidValue};
use pyo3::BoundObject;
use pyo3::exceptions::{PyOSError, PyRuntimeError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// An exception of `creepage._errors`.
fn exception<'py>(
    py: Python<'py>,
    name: &str,
    arguments: impl IntoPyObject<'py, Target = PyTuple>,
) -> PyErr {
    let make = || -> PyResult<Bound<'py, PyAny>> {
        let arguments = arguments.into_pyobject(py).map_err(Into::into)?;
        let class = py.import("creepage._errors")?.getattr(name)?;
        class.call1(arguments.into_bound())
    };
    make().map_or_else(|error| error, PyErr::from_value)
}

/// What cannot happen.
pub(crate) fn internal(what: &str) -> PyErr {
    PyRuntimeError::new_err(format!("internal error of creepage: {what}"))
}

pub(crate) fn invalid(py: Python, error: InvalidValue) -> PyErr {
    let InvalidValue { quantity, value, valid } = error;
    exception(py, "InvalidValue", (error.to_string(), quantity, value, valid))
}

/// An element of an array; the message says which.
pub(crate) fn invalid_element(
    py: Python,
    error: Option<InvalidValue>,
    mut index: usize,
    shape: &[usize],
) -> PyErr {
    let Some(error) = error else {
        return internal("an element changed while it was used");
    };
    let mut place = vec![0; shape.len()];
    for (along, size) in place.iter_mut().zip(shape).rev() {
        (*along, index) = (index % size, index / size);
    }
    let message = format!("{error}, at index {place:?}");
    match PyTuple::new(py, place) {
        Ok(place) => {
            let fields = (message, error.quantity, error.value, error.valid, place);
            exception(py, "InvalidValue", fields)
        }
        Err(error) => error,
    }
}

pub(crate) fn unknown(py: Python, error: &UnknownTheory) -> PyErr {
    exception(py, "UnknownTheory", (error.to_string(), &error.name))
}

pub(crate) fn option(py: Python, name: &str, reason: &str) -> PyErr {
    exception(py, "InvalidOption", (format!("{name}: {reason}"), name))
}

pub(crate) fn theory(py: Python, error: TheoryError) -> PyErr {
    match error {
        TheoryError::Invalid(error) => invalid(py, error),
        TheoryError::Variational(error) => variational(py, error),
        other => exception(py, "InvalidOption", (other.to_string(), "accuracy")),
    }
}

fn variational(py: Python, error: VariationalError) -> PyErr {
    match error {
        VariationalError::Invalid(error) => invalid(py, error),
        VariationalError::Degree { .. } => {
            exception(py, "InvalidOption", (error.to_string(), "degree"))
        }
        other => exception(py, "InvalidOption", (other.to_string(), "mesh")),
    }
}

fn not_reachable(py: Python, message: String, nearest: Force, at: Creepage) -> PyErr {
    exception(py, "NotReachable", (message, tuple(nearest.components()), tuple(at.components())))
}

pub(crate) fn inverse(py: Python, error: InverseError) -> PyErr {
    let message = error.to_string();
    match error {
        InverseError::InvalidValue(error) => invalid(py, error),
        InverseError::NotReachable { nearest, at } => not_reachable(py, message, nearest, at),
        _ => pyo3::exceptions::PyTypeError::new_err(message),
    }
}

pub(crate) fn table(py: Python, error: FileError, path: PathBuf) -> PyErr {
    match error {
        FileError::Io(source) => os(source, path),
        other => no_table(py, &format!("{}: {other}", path.display())),
    }
}

/// OSError, with the path where the system gave a number.
pub(crate) fn os(error: io::Error, path: PathBuf) -> PyErr {
    match error.raw_os_error() {
        Some(code) => PyOSError::new_err((code, error.to_string(), path)),
        None => error.into(),
    }
}

fn tuple([x, y, z]: [f64; 3]) -> (f64, f64, f64) {
    (x, y, z)
}

pub(crate) fn no_table(py: Python, message: &str) -> PyErr {
    exception(py, "TableError", (message,))
}
