//! Query of one batch row, dimensionless or in SI units, and the columns that its answer appends.

use creepage_study::{BulkQuery, BulkRow, DamageWanted};
use csv::ByteRecord;

use super::columns::{CaseColumns, Columns, NoCase};

/// Reader of a row's query from the table's columns.
#[derive(Debug, Clone)]
pub(super) enum Ask {
    /// Without dimensions.
    Dimensionless(Columns),
    /// By what differs from a case, in SI units.
    Case(Box<CaseColumns>),
}

/// Query of a row.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum RowQuery {
    Dimensionless(BulkQuery),
    Case(BulkRow),
}

impl Ask {
    /// What a row asks.
    pub(super) fn of(&self, row: &ByteRecord) -> Result<RowQuery, NoCase> {
        match self {
            Self::Dimensionless(columns) => columns.query(row).map(RowQuery::Dimensionless),
            Self::Case(columns) => columns.row(row).map(RowQuery::Case),
        }
    }

    /// The columns that are appended for a theory with or without error bars.
    pub(super) fn appended(&self, error_bars: bool) -> Vec<&'static str> {
        let si = match self {
            Self::Dimensionless(_) => Vec::new(),
            Self::Case(columns) => columns.appended(),
        };
        [&si[..], answer_columns(error_bars)].concat()
    }

    /// The laws of wear and fatigue, where their numbers are wanted.
    pub(super) fn damage(&self) -> Option<DamageWanted> {
        match self {
            Self::Dimensionless(_) => None,
            Self::Case(columns) => columns.damage().copied(),
        }
    }
}

impl RowQuery {
    pub(super) fn query(&self) -> BulkQuery {
        match self {
            Self::Dimensionless(query) => query.clone(),
            Self::Case(row) => row.query(),
        }
    }
}

/// What is appended to each row of any kind.
fn answer_columns(error_bars: bool) -> &'static [&'static str] {
    if error_bars {
        &["fx", "fy", "mz", "fx_error", "fy_error", "mz_error", "status", "message"]
    } else {
        &["fx", "fy", "mz", "status", "message"]
    }
}
