//! Steady rolling of two cylinders with parallel axes: `solve` of a case file with `[contact] line_load`.
//!
//! Forces are per length of the cylinders. Like bodies are Carter's problem in closed form, unlike ones that of Bentall
//! and Johnson by elements, viscoelastic ones that of Hunter and Morland with friction.

mod file;
mod output;
mod picture;
mod solved;
#[cfg(test)]
mod tests;

pub use file::{LineCase, LineFile, LineTheory};
use serde_json::Value;
pub use solved::{LinePoint, SolvedLine};

use crate::case::schema::schema_of;

/// The JSON schema of a case file with `line_load`.
#[must_use]
pub fn line_json_schema() -> Value {
    schema_of::<LineFile>()
}
