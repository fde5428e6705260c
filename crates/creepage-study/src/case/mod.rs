//! Files in TOML: cases, problems of statics, sweeps.
//!
//! Reading checks the form (sections and keys); every error names the section and the key.

pub(crate) mod body;
pub(crate) mod contact;
pub(crate) mod creepage;
mod error;
pub(crate) mod file;
pub(crate) mod friction;
pub(crate) mod keys;
pub(crate) mod layer;
pub(crate) mod motion;
pub(crate) mod radius;
pub(crate) mod schema;
pub(crate) mod sections;
pub(crate) mod slip;
pub(crate) mod solve;
mod statics;
mod sweep;
mod wanted;

pub use error::CaseError;
pub use file::{Case, CaseFile, Given, json_schema};
pub use solve::{SpecError, theory_spec};
pub use statics::{StaticsCase, StaticsError, StaticsFile, StaticsProblem, statics_json_schema};
pub use sweep::{SecondStart, Sweep, SweepCase, sweep_json_schema};
