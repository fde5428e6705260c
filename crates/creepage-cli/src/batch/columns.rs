//! Where in a row the question stands, and how it is read.

use creepage::theory::TheoryError;
use creepage::{Contact, Creepage, Ellipse, InvalidValue};
use csv::ByteRecord;

const QUESTION_COLUMNS: [&str; 5] = ["a_over_b", "poisson", "xi", "eta", "chi"];
/// May be missing: the bodies are like ones then.
const DISSIMILARITY: &str = "kappa_over_mu";

/// The places of `a_over_b`, `poisson`, `xi`, `eta`, `chi` in a row, and of `kappa_over_mu`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Columns {
    places: [usize; 5],
    dissimilarity: Option<usize>,
    count: usize,
}

/// What a row asks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Question {
    pub(super) contact: Contact,
    pub(super) creepage: Creepage,
}

/// Why a table is no table of cases.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum ColumnError {
    #[error(
        "the input is empty: its first line must name the columns a_over_b, poisson, xi, eta, chi"
    )]
    Empty,
    #[error("column {0} is missing: a_over_b, poisson, xi, eta, chi are needed")]
    Missing(&'static str),
    #[error("column {0} is there twice")]
    Twice(&'static str),
    #[error("column {0} is there already: it is one of those to be appended")]
    Taken(&'static str),
}

/// Why a row is no case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum RowError {
    #[error("the row has {found} fields, but the header {expected}")]
    FieldCount { found: usize, expected: usize },
    #[error("{column} is empty")]
    EmptyField { column: &'static str },
    #[error("{column} = `{text}` is not a number")]
    NotANumber { column: &'static str, text: String },
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    #[error(transparent)]
    Theory(#[from] TheoryError),
}

impl Columns {
    /// The columns of a header that leaves room for those that are to be appended.
    pub(super) fn find(
        header: &ByteRecord,
        appended: &'static [&'static str],
    ) -> Result<Self, ColumnError> {
        if header.is_empty() {
            return Err(ColumnError::Empty);
        }
        let places = |name: &'static str| {
            let name = name.as_bytes();
            (0..header.len()).filter(move |i| header[*i].trim_ascii() == name)
        };
        if let Some(taken) = appended.iter().find(|name| places(name).next().is_some()) {
            return Err(ColumnError::Taken(taken));
        }
        let one = |name: &'static str| {
            let mut places = places(name);
            let first = places.next();
            if places.next().is_some() { Err(ColumnError::Twice(name)) } else { Ok(first) }
        };
        let mut found = [0; 5];
        for (place, name) in found.iter_mut().zip(QUESTION_COLUMNS) {
            *place = one(name)?.ok_or(ColumnError::Missing(name))?;
        }
        Ok(Self { places: found, dissimilarity: one(DISSIMILARITY)?, count: header.len() })
    }

    /// What a row asks.
    pub(super) fn question(&self, row: &ByteRecord) -> Result<Question, RowError> {
        if row.len() != self.count {
            return Err(RowError::FieldCount { found: row.len(), expected: self.count });
        }
        let mut numbers = [0.0; 5];
        for ((number, place), column) in numbers.iter_mut().zip(self.places).zip(QUESTION_COLUMNS) {
            *number = parse(column, &row[place])?;
        }
        let [a_over_b, poisson, xi, eta, chi] = numbers;
        let dissimilarity = self.dissimilarity.map(|place| parse(DISSIMILARITY, &row[place]));
        let kappa_over_mu = dissimilarity.transpose()?.unwrap_or(0.0);
        let like = Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)?;
        let contact = like.with_kappa_over_mu(kappa_over_mu)?;
        Ok(Question { contact, creepage: Creepage::new(xi, eta, chi)? })
    }
}

fn parse(column: &'static str, field: &[u8]) -> Result<f64, RowError> {
    let text = String::from_utf8_lossy(field.trim_ascii());
    if text.is_empty() {
        return Err(RowError::EmptyField { column });
    }
    text.parse().map_err(|_| RowError::NotANumber { column, text: text.into_owned() })
}
