//! The command `creepage`, which `pip install` brings.

use std::ffi::OsString;

use pyo3::prelude::*;

use crate::pool::detached;

/// Runs the command with these arguments, of which the first is its own name; gives the exit code.
#[pyfunction]
pub(crate) fn command(py: Python, arguments: Vec<OsString>) -> PyResult<u8> {
    detached(py, || creepage_cli::command(arguments))
}
