//! The library's errors as Python's exceptions, with their messages and fields.

use std::ffi::CString;
use std::io;
use std::path::PathBuf;

use creepage::coulomb::InverseError;
use creepage::theory::{TheoryError, UnknownTheory};
use creepage::unsteady::SavedError;
use creepage::variational::VariationalError;
use creepage::{Creepage, Force, InvalidValue};
use creepage_study::{
    BearingCaseError, CaseError, FitError, GapCaseError, HistoryError, MotionError, ReportError,
    SolveError, SpecError, StaticsError, UnattainableForce, WheelsetFileError, plain_words,
};
use pyo3::BoundObject;
use pyo3::exceptions::{
    PyFileExistsError, PyOSError, PyOverflowError, PyRuntimeError, PyTypeError, PyValueError,
};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use toml::Value;

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

/// Warns the caller with a class of `creepage._errors`.
pub(crate) fn warn(py: Python, name: &str, words: &str) -> PyResult<()> {
    let class = py.import("creepage._errors")?.getattr(name)?;
    PyErr::warn(py, &class, &CString::new(words)?, 1)
}

/// What cannot happen.
pub(crate) fn internal(what: &str) -> PyErr {
    PyRuntimeError::new_err(format!("internal error of creepage: {what}"))
}

pub(crate) fn invalid(py: Python, error: InvalidValue) -> PyErr {
    let InvalidValue { quantity, value, valid } = error;
    exception(py, "InvalidValue", (error.to_string(), quantity, value, valid))
}

/// Why nothing was fitted: what is wrong with the case is a CaseError, all else a ValueError.
pub(crate) fn fit(py: Python, error: FitError) -> PyErr {
    match error {
        FitError::Case(source) => gap(py, *source),
        FitError::Theory(source) => theory(py, source),
        FitError::Invalid(source) => invalid(py, source),
        other => PyValueError::new_err(other.to_string()),
    }
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

/// What is wrong with the name or an option of a theory.
pub(crate) fn spec(py: Python, error: SpecError) -> PyErr {
    let message = error.to_string();
    match error {
        SpecError::UnknownTheory(UnknownTheory { name, .. }) => {
            exception(py, "UnknownTheory", (message, name))
        }
        SpecError::Value { option, value: Value::String(_), .. } => {
            exception(py, "InvalidOption", (message, option))
        }
        SpecError::Value { value: Value::Integer(count), .. } if count < 0 => {
            PyOverflowError::new_err(message)
        }
        SpecError::UnknownOption { key, .. } => {
            PyTypeError::new_err(format!("got an unexpected keyword argument '{key}'"))
        }
        _ => PyTypeError::new_err(message),
    }
}

pub(crate) fn theory(py: Python, error: TheoryError) -> PyErr {
    match error {
        TheoryError::Invalid(error) => invalid(py, error),
        TheoryError::Variational(error) => variational(py, error),
        other @ TheoryError::PrescribedOneWay => {
            exception(py, "InvalidOption", (other.to_string(), "prescribed"))
        }
        other @ TheoryError::CoupledWithoutFriction => {
            exception(py, "InvalidOption", (other.to_string(), "coupled"))
        }
        other => exception(py, "InvalidOption", (other.to_string(), "accuracy")),
    }
}

fn variational(py: Python, error: VariationalError) -> PyErr {
    match error {
        VariationalError::Invalid(error) => invalid(py, error),
        VariationalError::Degree { .. } => {
            exception(py, "InvalidOption", (error.to_string(), "degree"))
        }
        VariationalError::Derivative { .. } => {
            exception(py, "InvalidOption", (error.to_string(), "integrand"))
        }
        other => exception(py, "InvalidOption", (other.to_string(), "mesh")),
    }
}

/// Why a case was not solved.
pub(crate) fn solve(py: Python, error: SolveError) -> PyErr {
    let message = error.to_string();
    match error {
        SolveError::Theory(error) => theory(py, error),
        SolveError::UnattainableForce(UnattainableForce { nearest, at, .. }) => {
            not_reachable(py, message, nearest, at)
        }
        SolveError::Inverse(error) => inverse(py, error),
        _ => exception(py, "CaseError", (message, Some("wanted"))),
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
        _ => PyTypeError::new_err(message),
    }
}

/// What the reader of TOML says of a line: the line, which Python may never have seen as such, in place of
/// its number, and the key of it.
fn line(error: &toml::de::Error) -> (String, Option<String>) {
    let (shown, message) = (error.to_string(), plain_words(error.message()));
    let is_of_a_value = ["invalid", "missing", "unknown"].iter().any(|w| message.starts_with(w));
    let message = if is_of_a_value { message } else { format!("not TOML: {message}") };
    // The second of the lines with a bar, " 12 | key = value".
    let bars = shown.lines().filter_map(|line| line.split_once('|'));
    let text = bars.map(|(_, text)| text.trim()).find(|text| !text.is_empty());
    let Some(text) = text else { return (message, None) };
    let key = text.split_once('=').map(|(key, _)| key.trim().trim_matches('"').to_owned());
    (format!("`{}`: {message}", text.replacen('"', "", if key.is_some() { 2 } else { 0 })), key)
}

/// Message, section, key and value, as far as the error has them.
pub(crate) fn case(py: Python, error: CaseError) -> PyErr {
    if let CaseError::Toml(error) = &error {
        let (message, key) = line(error);
        return exception(py, "CaseError", (message, None::<String>, key));
    }
    let message = error.to_string();
    let (section, key, value) = match error {
        CaseError::Spec(
            error
            @ (SpecError::UnknownTheory(_) | SpecError::Value { value: Value::String(_), .. }),
        ) => return spec(py, error),
        other => place(other),
    };
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
        CaseError::UnknownKey { key, .. }
        | CaseError::Spec(SpecError::UnknownOption { key, .. }) => (None, Some(key), None),
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

pub(crate) fn bearing(py: Python, error: BearingCaseError) -> PyErr {
    match error {
        BearingCaseError::Case(error) => case(py, error),
        other => exception(py, "CaseError", (other.to_string(), Some("bearing"))),
    }
}

pub(crate) fn wheelset(py: Python, error: WheelsetFileError) -> PyErr {
    match error {
        WheelsetFileError::Case(error) => case(py, error),
        other => exception(py, "CaseError", (other.to_string(), Some("wheelset"))),
    }
}

/// What is wrong in a section of a file.
pub(crate) fn in_section(py: Python, message: String, section: &'static str) -> PyErr {
    exception(py, "CaseError", (message, Some(section)))
}

/// Invalid contact of any shape, or unattainable forces.
pub(crate) fn gap(py: Python, error: GapCaseError) -> PyErr {
    let message = error.to_string();
    let section = match error {
        GapCaseError::Case(error) => return case(py, error),
        GapCaseError::UnattainableForce(UnattainableForce { nearest, at, .. }) => {
            return not_reachable(py, message, nearest, at);
        }
        GapCaseError::Inverse(error) => return inverse(py, error),
        GapCaseError::Foreign { section, .. } => section,
        GapCaseError::Normal { .. } => "contact",
        GapCaseError::Theory(_) => "solve",
        _ => "gap",
    };
    exception(py, "CaseError", (message, Some(section)))
}

/// Case that cannot roll, or invalid motion.
pub(crate) fn history(py: Python, error: HistoryError) -> PyErr {
    let message = error.to_string();
    match error {
        HistoryError::Case(error) => case(py, error),
        HistoryError::Contact(error) => {
            exception(py, "CaseError", (message, Some("contact"), error.quantity, error.value))
        }
        HistoryError::Step(MotionError::Value(error)) => invalid(py, error),
        HistoryError::Row { source: MotionError::Value(error), .. } => {
            exception(py, "InvalidValue", (message, error.quantity, error.value, error.valid))
        }
        HistoryError::Theory { .. }
        | HistoryError::Automatic
        | HistoryError::NotOfVariational { .. }
        | HistoryError::Variational(_) => exception(py, "CaseError", (message, Some("solve"))),
        HistoryError::Foreign { section, key, .. } => {
            exception(py, "CaseError", (message, Some(section), Some(key)))
        }
        HistoryError::Gap(_) | HistoryError::NotOfAnArea { .. } => {
            exception(py, "CaseError", (message, Some("gap")))
        }
        HistoryError::Section { section } | HistoryError::Steady { section, .. } => {
            exception(py, "CaseError", (message, Some(section)))
        }
        HistoryError::NoMemory => {
            exception(py, "CaseError", (message, Some("contact"), Some("friction")))
        }
        HistoryError::Start { .. } => exception(py, "CaseError", (message, Some("start"))),
        _ => PyValueError::new_err(message),
    }
}

pub(crate) fn no_state(error: SavedError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

pub(crate) fn report(error: ReportError) -> PyErr {
    match error {
        ReportError::Write { path, source } => os(source, path),
        ReportError::OverSource { .. } => PyFileExistsError::new_err(error.to_string()),
        other => PyRuntimeError::new_err(other.to_string()),
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
