//! Arguments of a theory's constructor: a contact and a specification, by the words of case files.

use creepage::{Contact, Ellipse, InvalidValue, TheorySpec};
use creepage_study::theory_spec;
use pyo3::exceptions::{PyOverflowError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyString};
use toml::Value;

use crate::errors;

/// A contact without dimensions.
pub(crate) fn contact(
    a_over_b: f64,
    poisson: f64,
    kappa_over_mu: f64,
) -> Result<Contact, InvalidValue> {
    let ellipse = Ellipse::from_ratio(a_over_b)?;
    Contact::new(ellipse, poisson)?.with_kappa_over_mu(kappa_over_mu)
}

/// The theory of that name with the options that are not None. `automatic` is the full theory that
/// is as fine as an accuracy needs; underscores do for hyphens.
///
/// Raises UnknownTheory, TypeError for an option that it does not have and for a value of another
/// kind, InvalidOption for another word.
pub(crate) fn spec(
    py: Python,
    name: &str,
    options: Option<&Bound<PyDict>>,
) -> PyResult<TheorySpec> {
    let mut lines = Vec::new();
    for (option, value) in options.into_iter().flatten().filter(|(_, value)| !value.is_none()) {
        let option: String = option.extract()?;
        lines.push(format!("{option} = {}", read(&option, &value)?));
    }
    let name = match name {
        "automatic" => {
            lines.push("resolution = \"auto\"".into());
            "exact"
        }
        other => &other.replace('_', "-"),
    };
    theory_spec(name, &lines).map_err(|error| errors::spec(py, error))
}

/// A word, a yes or no, a number, or several.
fn read(option: &str, value: &Bound<PyAny>) -> PyResult<Value> {
    if let Ok(flag) = value.cast::<PyBool>() {
        return Ok(flag.is_true().into());
    }
    if let Ok(word) = value.cast::<PyString>() {
        return Ok(Value::from(word.to_cow()?.as_ref()));
    }
    if let Ok(items) = value.try_iter() {
        return items.map(|item| read(option, &item?)).collect::<PyResult<_>>().map(Value::Array);
    }
    match value.extract::<i64>() {
        Ok(count) => Ok(count.into()),
        Err(error) if error.is_instance_of::<PyOverflowError>(value.py()) => Err(error),
        Err(_) => value.extract::<f64>().map(Value::Float).map_err(|_| {
            PyTypeError::new_err(format!("{option} must be a word, a number, or several"))
        }),
    }
}
