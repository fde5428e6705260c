//! Errors of building a table.

use crate::InvalidValue;

#[cfg(doc)]
use super::spec::Spec;

/// Error of a table's build.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BuildError<E: std::error::Error> {
    /// A number of the [`Spec`] makes no sense.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The theory cannot be prepared for a node.
    #[error("{0}")]
    Theory(E),
    /// Doubling a tiny creepage does not double the force.
    #[error(
        "the theory's force is not in proportion to tiny creepage at a/b = {a_over_b}, as \
             interpolation from zero needs"
    )]
    NotLinearAtZero {
        /// The ratio of the node.
        a_over_b: f64,
    },
    /// The force at infinite creepage is above `mu N`.
    #[error(
        "the theory's force is {size} mu N at infinite creepage, a/b = {a_over_b}: there is no \
             table to infinity of it"
    )]
    Unbounded {
        /// The ratio of the node.
        a_over_b: f64,
        /// Largest force in parts of `mu N`.
        size: f64,
    },
}
