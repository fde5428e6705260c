//! Errors of a table or figure that cannot be reproduced.

use creepage::coulomb::{InverseError, SlidingError};
use creepage::halfspace::{PolynomialError, ResponseError};
use creepage::variational::VariationalError;
use creepage::{HertzError, InvalidValue};
use creepage_plot::PlotError;

/// Error of a table or figure that cannot be reproduced. None of these is the user's doing: what was printed is
/// part of the program, and the questions to the theories are fixed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GalleryError {
    /// A theory refuses its input.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The numerical theory cannot be prepared.
    #[error(transparent)]
    Variational(#[from] VariationalError),
    /// Invalid contact.
    #[error(transparent)]
    Hertz(#[from] HertzError),
    /// Tractions or displacements without the other.
    #[error(transparent)]
    Response(#[from] ResponseError),
    /// Numbers that are no polynomial.
    #[error(transparent)]
    Polynomial(#[from] PolynomialError),
    /// A creepage that is not found.
    #[error(transparent)]
    Inverse(#[from] InverseError),
    /// Bodies whose gross sliding is not found.
    #[error(transparent)]
    Sliding(#[from] SlidingError),
    /// A printed entry that is not a number, or a row of which nothing is known.
    #[error("the printed table has an entry that means nothing: {quantity} = {printed}")]
    Entry {
        /// The row.
        quantity: String,
        /// The entry.
        printed: String,
    },
    /// Printed numbers that cannot be read.
    #[error("printed numbers cannot be read: {0}")]
    Printed(#[from] serde_json::Error),
    /// A table that cannot be read or written.
    #[error("cannot read or write a table: {0}")]
    Csv(#[from] csv::Error),
    /// A picture that cannot be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
}
