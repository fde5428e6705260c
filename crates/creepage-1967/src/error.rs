//! Why an item cannot be made.

use creepage::rolling::variational::VariationalError;
use creepage::{HertzError, InvalidValue};
use creepage_report::ReportError;
use creepage_validation::{Table2Error, Table3Error, TableError};

/// Why a table or figure cannot be reproduced. None of these is the user's doing: what was printed
/// is part of the program, and the questions to the theories are fixed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GalleryError {
    /// A theory refuses its input.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The numerical theory cannot be prepared.
    #[error(transparent)]
    Variational(#[from] VariationalError),
    /// A contact that is none.
    #[error(transparent)]
    Hertz(#[from] HertzError),
    /// A damaged table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A damaged Table 2.
    #[error(transparent)]
    Table2(#[from] Table2Error),
    /// A damaged Table 3.
    #[error(transparent)]
    Table3(#[from] Table3Error),
    /// Printed numbers that cannot be read.
    #[error("printed numbers cannot be read: {0}")]
    Printed(#[from] serde_json::Error),
    /// Numbers that cannot be written.
    #[error("cannot make a table: {0}")]
    Csv(#[from] csv::Error),
    /// A picture that cannot be drawn.
    #[error(transparent)]
    Report(#[from] ReportError),
}
