//! Case files: one rolling contact described in TOML, in SI units.
//!
//! [`CaseFile::read`] checks the file's form (its sections and keys), [`CaseFile::hertz`] what
//! the contact needs, [`CaseFile::case`] all that a theory of rolling needs, and
//! [`CaseFile::inverse`] the same where forces are wanted and creepages to be found. Every error
//! names the section and the key that it is about. [`json_schema`] describes the format to editors.
//!
//! ```
//! let text = r#"
//!     [upper]                  # a wheel
//!     shear_modulus = 82e9
//!     poisson = 0.28
//!     radius_rolling = 0.46
//!     radius_lateral = "flat"
//!     [lower]                  # a rail
//!     shear_modulus = 82e9
//!     poisson = 0.28
//!     radius_rolling = "flat"
//!     radius_lateral = 0.30
//!     [contact]
//!     normal_force = 80e3
//!     friction = 0.3
//!     [creepage]
//!     longitudinal = -1.5e-3
//! "#;
//! let case = creepage_case::CaseFile::read(text)?.case()?;
//! assert!((case.creepage.xi + 0.62).abs() < 0.01);
//!
//! let error = creepage_case::CaseFile::read(&text.replace("friction", "fricton")).unwrap_err();
//! assert_eq!(error.to_string(), "unknown key `fricton` in [contact]: did you mean `friction`?");
//! # Ok::<(), creepage_case::CaseError>(())
//! ```

mod body;
mod case;
mod contact;
mod creepage;
mod error;
mod keys;
mod options;
mod radius;
mod resolution;
mod schema;
mod solve;
mod statics;
mod sweep;
mod wanted;

pub use case::{Case, CaseFile, InverseCase, json_schema};
pub use error::CaseError;
pub use resolution::Resolution;
pub use solve::{Bound, Flexibility, Solve, Variant, Weight};
pub use statics::{StaticsCase, StaticsError, StaticsFile, statics_json_schema};
pub use sweep::{SecondStart, Sweep, SweepCase, sweep_json_schema};
