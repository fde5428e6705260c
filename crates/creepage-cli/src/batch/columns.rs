//! Columns of a batch table: where they stand in a row, and how their numbers are read.

use creepage::{Contact, Creepage, Ellipse};
use creepage_study::{BulkQuery, CaseError, GapVaried, Varied};
use csv::ByteRecord;

use super::field::{NoCase, parse};

const QUESTION_COLUMNS: [&str; 5] = ["a_over_b", "poisson", "xi", "eta", "chi"];
/// May be missing: the bodies are like ones then.
const DISSIMILARITY: &str = "kappa_over_mu";

/// The places of `a_over_b`, `poisson`, `xi`, `eta`, `chi` in a row, and of `kappa_over_mu`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Columns {
    places: [Place; 5],
    dissimilarity: Option<usize>,
    count: usize,
}

/// Where a number of a row comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Column(usize),
    /// The same in all rows.
    Value(f64),
}

/// Error of a table that is no table of cases.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum ColumnError {
    #[error(
        "the input is empty: its first line must name the columns a_over_b, poisson, xi, eta, chi"
    )]
    Empty,
    #[error(
        "column {column} is missing: a_over_b, poisson, xi, eta, chi are needed, but found are \
         {found} (rows in SI units need --case)"
    )]
    Missing { column: &'static str, found: String },
    #[error(
        "none of the columns differs from the case file: there may be {}, but found are {found}",
        Varied::ALL.map(Varied::name).join(", ")
    )]
    NothingVaries { found: String },
    #[error(
        "none of the columns differs from the case file: with [gap] there may be {}, but found are {found}",
        GapVaried::ALL.map(GapVaried::name).join(", ")
    )]
    NoGapVaries { found: String },
    #[error(
        "none of the columns differs from the wheelset's file: there may be {known}, but found are {found}"
    )]
    NoneVaries { known: String, found: String },
    #[error("its rows are in UTF-16: save it as UTF-8")]
    Utf16,
    #[error(transparent)]
    Case(Box<CaseError>),
    #[error("column {0} is there twice")]
    Twice(&'static str),
    #[error("column {0} is there already: it is one of those to be appended")]
    Taken(&'static str),
}

impl Columns {
    /// The columns of a header; `only` are the values that need no column.
    pub(super) fn find(header: &ByteRecord, only: [Option<f64>; 2]) -> Result<Self, ColumnError> {
        let mut found = [Place::Value(f64::NAN); 5];
        for (k, column) in QUESTION_COLUMNS.into_iter().enumerate() {
            let only = only.get(k).copied().flatten();
            let place = place_of(header, column)?.map(Place::Column).or(only.map(Place::Value));
            let missing = || ColumnError::Missing { column, found: names(header) };
            found[k] = place.ok_or_else(missing)?;
        }
        let dissimilarity = place_of(header, DISSIMILARITY)?;
        Ok(Self { places: found, dissimilarity, count: header.len() })
    }

    /// What a row asks.
    pub(super) fn question(&self, row: &ByteRecord) -> Result<BulkQuery, NoCase> {
        if row.len() != self.count {
            return Err(NoCase::FieldCount { found: row.len(), expected: self.count });
        }
        let mut numbers = [0.0; 5];
        for ((number, place), column) in numbers.iter_mut().zip(self.places).zip(QUESTION_COLUMNS) {
            *number = match place {
                Place::Column(place) => parse(column, &row[place])?,
                Place::Value(value) => value,
            };
        }
        let [a_over_b, poisson, xi, eta, chi] = numbers;
        let dissimilarity = self.dissimilarity.map(|place| parse(DISSIMILARITY, &row[place]));
        let kappa_over_mu = dissimilarity.transpose()?.unwrap_or(0.0);
        let like = Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)?;
        let contact = like.with_kappa_over_mu(kappa_over_mu)?;
        Ok(BulkQuery { contact, creepage: Creepage::new(xi, eta, chi)?, touches: true })
    }
}

/// Where a column stands, if it is there.
pub(super) fn place_of(
    header: &ByteRecord,
    name: &'static str,
) -> Result<Option<usize>, ColumnError> {
    let mut places = (0..header.len()).filter(|i| header[*i].trim_ascii() == name.as_bytes());
    let first = places.next();
    if places.next().is_some() { Err(ColumnError::Twice(name)) } else { Ok(first) }
}

/// The names of all columns.
pub(super) fn names(header: &ByteRecord) -> String {
    let names = header.iter().map(|name| String::from_utf8_lossy(name.trim_ascii()));
    names.collect::<Vec<_>>().join(", ")
}
