//! What a theory is made with: a contact and a specification, by the words of case files.

use creepage::theory::{ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Contact, Ellipse, InvalidValue, TheorySpec};
use pyo3::exceptions::{PyOverflowError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use serde::Deserialize;
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

/// The theory of that name, with its usual options. `automatic` is the full theory that is as fine
/// as an accuracy needs; underscores do for hyphens.
pub(crate) fn named(py: Python, name: &str) -> PyResult<TheorySpec> {
    if name == "automatic" {
        let resolution = ResolutionSpec::Named(NamedResolution::Auto);
        return Ok(TheorySpec::Exact(ExactOptions { resolution, accuracy: None }));
    }
    let named = TheorySpec::named(&name.replace('_', "-"));
    named.map_err(|error| errors::unknown(py, &error))
}

/// The theory of that name with the options that are not None.
///
/// Raises TypeError for an option that it does not have and for a value of another kind,
/// InvalidOption for another word.
pub(crate) fn spec(
    py: Python,
    name: &str,
    options: Option<&Bound<PyDict>>,
) -> PyResult<TheorySpec> {
    let mut spec = named(py, name)?;
    let facts = spec.facts();
    let mut table = toml::Table::try_from(&spec).map_err(|_| errors::internal("options"))?;
    for (option, value) in options.into_iter().flatten() {
        let option: String = option.extract()?;
        if !facts.options.contains(&option.as_str()) {
            let message = format!("{name}() got an unexpected keyword argument '{option}'");
            return Err(PyTypeError::new_err(message));
        }
        if value.is_none() {
            continue;
        }
        let value = read(&option, &value)?;
        table.insert(option.clone(), value.clone());
        let read = TheorySpec::deserialize(table.clone());
        spec = read.map_err(|error| wrong(py, &option, &value, error.message()))?;
    }
    Ok(spec)
}

fn wrong(py: Python, option: &str, value: &Value, reason: &str) -> PyErr {
    match value {
        Value::String(_) => errors::option(py, option, reason),
        Value::Integer(..0) => PyOverflowError::new_err(format!("{option}: {reason}")),
        _ => PyTypeError::new_err(format!("{option}: {reason}")),
    }
}

/// A word, a number, or several.
fn read(option: &str, value: &Bound<PyAny>) -> PyResult<Value> {
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
