//! The library's errors as Python's exceptions, with their messages and fields.

use std::path::PathBuf;

use creepage::InvalidValue;
use creepage::rolling::exact::InverseError;
use creepage::rolling::variational::VariationalError;
use creepage::rolling::{Creepage, Force};
use creepage_study::{
    CaseError, ChoiceError, FindError, ReportError, StaticsError, TheoryError, Unreachable,
};
use creepage_table::FileError;
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
    index: usize,
    shape: Vec<usize>,
) -> PyErr {
    let Some(error) = error else {
        return internal("an element changed while it was used");
    };
    let mut rest = index;
    let mut place: Vec<usize> = shape
        .iter()
        .rev()
        .map(|size| {
            let along = rest % size;
            rest /= size;
            along
        })
        .collect();
    place.reverse();
    let message = format!("{error}, at index {place:?}");
    match PyTuple::new(py, place) {
        Ok(place) => {
            let fields = (message, error.quantity, error.value, error.valid, place);
            exception(py, "InvalidValue", fields)
        }
        Err(error) => error,
    }
}

pub(crate) fn option(py: Python, name: &str, reason: &str) -> PyErr {
    exception(py, "InvalidOption", (format!("{name}: {reason}"), name))
}

/// An option that the theory does not take: of those that its class has, a bound.
pub(crate) fn choice(py: Python, error: &ChoiceError) -> PyErr {
    exception(py, "InvalidOption", (error.to_string(), "bound"))
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

pub(crate) fn find(py: Python, error: FindError) -> PyErr {
    let message = error.to_string();
    match error {
        FindError::Unreachable(Unreachable { nearest, at, .. }) => {
            not_reachable(py, message, nearest, at)
        }
        FindError::Inverse(error) => inverse(py, error),
        _ => exception(py, "CaseError", (message, Some("wanted"))),
    }
}

fn not_reachable(py: Python, message: String, nearest: Force, at: Creepage) -> PyErr {
    let nearest = (nearest.fx, nearest.fy, nearest.mz);
    exception(py, "NotReachable", (message, nearest, (at.xi, at.eta, at.chi)))
}

pub(crate) fn inverse(py: Python, error: InverseError) -> PyErr {
    let message = error.to_string();
    match error {
        InverseError::InvalidValue(error) => invalid(py, error),
        InverseError::NotReachable { nearest, at } => not_reachable(py, message, nearest, at),
        _ => pyo3::exceptions::PyTypeError::new_err(message),
    }
}

/// Message, section, key and value, as far as the error has them.
pub(crate) fn case(py: Python, error: CaseError) -> PyErr {
    let message = error.to_string();
    let (section, key, value) = place(error);
    exception(py, "CaseError", (message, section, key, value))
}

fn place(error: CaseError) -> (Option<String>, Option<String>, Option<f64>) {
    match error {
        CaseError::Invalid { section, invalid } => {
            (Some(section.into()), Some(invalid.quantity.into()), Some(invalid.value))
        }
        CaseError::Radius { section, key, value, .. } => {
            (Some(section.into()), Some(key.into()), Some(value))
        }
        CaseError::Missing { section, key } => (Some(section), Some(key), None),
        CaseError::MissingSection { section, .. } => (Some(section), None, None),
        CaseError::MissingEither { section, keys } => {
            (Some(section.into()), Some(keys[0].into()), None)
        }
        CaseError::Conflict { first: (section, key), .. } => {
            (Some(section.into()), Some(key.into()), None)
        }
        CaseError::UnknownKey { key, .. } => (None, Some(key), None),
        CaseError::Variational { section, .. } => (Some(section.into()), None, None),
        CaseError::TooManyCases { key, cases, .. } => {
            (Some("creepage".into()), Some(key.into()), Some(cases))
        }
        CaseError::Tilted { angle, .. } => {
            (Some("contact".into()), Some("angle".into()), Some(angle))
        }
        _ => (None, None, None),
    }
}

pub(crate) fn statics(py: Python, error: StaticsError) -> PyErr {
    match error {
        StaticsError::Case(error) => case(py, error),
        other => exception(py, "CaseError", (other.to_string(), Some("statics"))),
    }
}

pub(crate) fn report(error: ReportError) -> PyErr {
    match error {
        ReportError::Write { path, source } => {
            let code = source.raw_os_error();
            let reason = source.to_string();
            match code {
                Some(code) => PyOSError::new_err((code, reason, path)),
                None => source.into(),
            }
        }
        other => PyRuntimeError::new_err(other.to_string()),
    }
}

pub(crate) fn table(py: Python, error: FileError, path: PathBuf) -> PyErr {
    match error {
        FileError::Io(source) => match source.raw_os_error() {
            Some(code) => PyOSError::new_err((code, source.to_string(), path)),
            None => source.into(),
        },
        other => no_table(py, &format!("{}: {other}", path.display())),
    }
}

pub(crate) fn no_table(py: Python, message: &str) -> PyErr {
    exception(py, "TableError", (message,))
}
