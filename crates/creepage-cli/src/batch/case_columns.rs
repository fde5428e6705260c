//! Columns of a batch table in SI units, by which rows differ from a case.

use creepage_study::{BulkCase, BulkRow, CaseFile, DamageWanted, Varied};
use csv::ByteRecord;

use super::columns::{ColumnError, names, place_of};
use super::field::{NoCase, parse};

/// The case, and the places of what varies.
#[derive(Debug, Clone)]
pub(super) struct CaseColumns {
    case: BulkCase,
    places: Vec<usize>,
    count: usize,
}

impl CaseColumns {
    /// The columns of a header by which rows differ from the case of a file.
    pub(super) fn find(header: &ByteRecord, file: &CaseFile) -> Result<Self, ColumnError> {
        let (mut varied, mut places) = (Vec::new(), Vec::new());
        for quantity in Varied::ALL {
            if let Some(place) = place_of(header, quantity.name())? {
                varied.push(quantity);
                places.push(place);
            }
        }
        if varied.is_empty() {
            return Err(ColumnError::NothingVaries { found: names(header) });
        }
        let case =
            BulkCase::new(file, varied).map_err(|error| ColumnError::Case(Box::new(error)))?;
        Ok(Self { case, places, count: header.len() })
    }

    /// What is appended besides the dimensionless answer.
    pub(super) fn appended(&self) -> Vec<&'static str> {
        self.case.columns()
    }

    /// The laws of wear and fatigue, where their numbers are wanted.
    pub(super) fn damage(&self) -> Option<&DamageWanted> {
        self.case.damage()
    }

    /// What a row asks.
    pub(super) fn row(&self, row: &ByteRecord) -> Result<BulkRow, NoCase> {
        if row.len() != self.count {
            return Err(NoCase::FieldCount { found: row.len(), expected: self.count });
        }
        let value = |(quantity, place): (&Varied, &usize)| {
            let field = &row[*place];
            let flat = quantity.is_radius() && field.trim_ascii() == b"flat";
            if flat { Ok(f64::INFINITY) } else { parse(quantity.name(), field) }
        };
        let values: Vec<_> =
            self.case.varied().iter().zip(&self.places).map(value).collect::<Result<_, _>>()?;
        self.case.row(&values).map_err(|error| NoCase::Row(error.into()))
    }
}
