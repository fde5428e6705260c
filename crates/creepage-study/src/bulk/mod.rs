//! Bulk solution of one case with varying quantities: some have a value of their own in every row, such as a measured
//! history of creepages and normal forces.
//!
//! A [`BulkCase`] is prepared from a case file and the quantities that vary ([`Varied`]); it makes a
//! [`BulkRow`] of the values of a row, which asks a [`BulkQuery`]. A [`Solver`] answers many queries
//! at a time. The command, Python and C all come this way, so that their numbers are the same.

mod answer;
mod case;
mod solver;
mod varied;

pub use answer::{BulkAnswer, BulkColumn};
pub use case::{BulkCase, BulkRow};
pub use solver::{BulkQuery, Reply, RowError, Solver};
pub use varied::Varied;
