//! The theories that the command knows by name. A new theory is a new entry of [`registry`].

mod choice;
mod prepare;
mod prepared;
mod registry;
mod table;

use creepage::InvalidValue;
use creepage::rolling::Theory;
use creepage::rolling::variational::VariationalError;
use creepage_case::Solve;

pub(crate) use choice::{ChoiceError, UnknownTheory, choose, find};
pub(crate) use prepare::wanted_accuracy;
pub(crate) use prepared::{Answered, Examination, FindError, PreparedTheory};
pub(crate) use registry::ENTRIES;
pub(crate) use table::table;

/// One theory: its name, what a user should know of it, and how to run it.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    /// Year of publication.
    pub(crate) year: u16,
    pub(crate) assumes: &'static str,
    /// One force on one core, by the library's benchmarks.
    pub(crate) cost: &'static str,
    /// Root mean square error of the force in per cent of `mu N`, by `creepage accuracy`.
    pub(crate) error: f64,
    pub(crate) good_for: &'static str,
    /// The options in `[solve]` that it knows.
    pub(crate) options: &'static [&'static str],
    /// Whether its forces come with error bars.
    pub(crate) error_bars: bool,
    /// Prepares the theory for `a/b` and the combined Poisson's ratio.
    pub(crate) prepare: fn(a_over_b: f64, poisson: f64, &Solve) -> Prepared,
}

pub(crate) type Prepared = Result<PreparedTheory, TheoryError>;

/// Why a theory cannot be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum TheoryError {
    #[error(transparent)]
    Variational(#[from] VariationalError),
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    #[error("`accuracy` needs resolution = \"auto\"")]
    AccuracyOfFixed,
}

impl Entry {
    /// The theory prepared, for those who ask what any theory can be asked.
    pub(crate) fn boxed(
        &self,
        a_over_b: f64,
        poisson: f64,
        solve: &Solve,
    ) -> Result<Box<dyn Theory>, TheoryError> {
        Ok(Box::new((self.prepare)(a_over_b, poisson, solve)?))
    }
}
