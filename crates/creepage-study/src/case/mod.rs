//! Files in TOML: cases, problems of statics, sweeps.
//!
//! Reading checks the form (sections and keys); every error names the section and the key.

mod body;
mod contact;
mod creepage;
mod error;
mod file;
mod keys;
mod options;
mod radius;
mod resolution;
mod schema;
mod solve;
mod statics;
mod sweep;
mod wanted;

pub use error::CaseError;
pub use file::{Case, CaseFile, InverseCase, json_schema};
pub use resolution::Resolution;
pub use solve::{Bound, Flexibility, Solve, Variant, Weight};
pub use statics::{StaticsCase, StaticsError, StaticsFile, statics_json_schema};
pub use sweep::{SecondStart, Sweep, SweepCase, sweep_json_schema};
