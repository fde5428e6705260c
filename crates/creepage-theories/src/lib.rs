//! The theories of `creepage` by name: what each assumes, costs and errs by, which options of
//! `[solve]` it has, and how it is prepared from them.
//!
//! A new theory is a new entry of [`ENTRIES`] and a variant of [`PreparedTheory`]; the command,
//! the Python package and the C interface all take it from here.
//!
//! ```
//! use creepage::rolling::Creepage;
//! use creepage_case::Solve;
//! use creepage_theories::{choose, find};
//!
//! let solve = Solve::read(&["theory=fastsim", "grid=[20, 20]"])?;
//! let fastsim = choose(&[], &solve)?.theories[0];
//! assert_eq!(fastsim.name, "fastsim");
//! // For a/b = 1.5 and Poisson's ratio 0.28; asked as often as one likes.
//! let prepared = fastsim.prepare(1.5, 0.28, &solve)?;
//! let answered = prepared.answer(Creepage::new(9.0, 0.0, 0.0)?);
//! assert!((answered.solution.force.fx - 1.0).abs() < 0.01);
//!
//! let unknown = find("fastsm").unwrap_err();
//! assert_eq!(unknown.nearest, Some("fastsim"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A whole case, with what its report tells:
//!
//! ```
//! use std::sync::Arc;
//! use creepage_case::CaseFile;
//! use creepage_theories::{Examination, choose};
//! # let text = "
//! # upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
//! # lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
//! # contact = { normal_force = 80e3, friction = 0.3 }
//! # creepage = { longitudinal = 1e-3 }
//! # [solve]
//! # resolution = 'fast'
//! # ";
//! let case = CaseFile::read(text)?.case()?;
//! let theory = choose(&[], &case.solve)?.theories[0];
//! let found = Examination::new(Arc::new(theory.for_contact(&case.contact, case.friction,
//!                                                     &case.solve)?),
//!                              case.contact.ellipse(), case.creepage);
//! assert!(found.dissipation.is_some_and(|power| power > 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

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
