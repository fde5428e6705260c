//! Accuracy of each theory of rolling contact against the full one.
//!
//! ```
//! use creepage::TheorySpec;
//! use creepage_study::{measure, steady_rolling};
//! let theory = TheorySpec::named("variational")?;
//! let accuracy = measure(&steady_rolling()?, |contact| theory.prepare(contact))?;
//! // Chapter 5 with its degree 3: a median error of two per cent of mu N.
//! assert!(accuracy.force.median < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod grid;
mod reference;
mod spread;
mod square_grid;

pub use grid::grid;
pub use reference::{ReferenceCase, ReferenceError, steady_rolling};
pub use spread::{Accuracy, Spread, measure};
pub use square_grid::SquareGrid;
