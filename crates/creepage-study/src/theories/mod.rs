//! The theories of `creepage` by name: what each assumes, costs and errs by, which options of
//! `[solve]` it has, and how it is prepared from them.
//!
//! A new theory is a new entry of [`ENTRIES`] and a variant of [`PreparedTheory`]; the command,
//! the Python package and the C interface all take it from here.
//!

mod choice;
mod examination;
mod find;
mod left_out;
mod prepare;
mod prepared;
mod registry;
mod solved;
mod unlike;

pub use choice::{Choice, ChoiceError, UnknownTheory, choose, find};
pub use examination::{Detail, Examination};
pub use find::{FindError, Unreachable};
pub use left_out::LeftOut;
pub use prepare::{TheoryError, variational_settings, wanted_accuracy};
pub use prepared::{Answered, PreparedTheory};
pub use registry::{ENTRIES, Entry};
pub use solved::SolvedCase;
pub use unlike::kappa_over_mu;
