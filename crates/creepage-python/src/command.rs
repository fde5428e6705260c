//! The command `creepage`, which `pip install` brings.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the command with these arguments, of which the first is its own name; gives the exit code.
#[pyfunction]
pub(crate) fn command(py: Python, arguments: Vec<OsString>) -> u8 {
    py.detach(|| creepage_cli::command(arguments))
}
