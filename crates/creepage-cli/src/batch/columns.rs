//! Columns of a batch table, dimensionless or by which rows differ from a case: where they stand in a row, how their numbers are read, and the error of a row that is no case.

use creepage::{Contact, Creepage, Ellipse, InvalidValue};
use creepage_study::{
    BulkCase, BulkQuery, BulkRow, CaseError, CaseFile, DamageWanted, GapVaried, RowError, Varied,
    misspelt,
};
use csv::ByteRecord;

use crate::output::say;

const QUERY_COLUMNS: [&str; 5] = ["a_over_b", "poisson", "xi", "eta", "chi"];
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
    #[error("a quote that is opened in the header is not closed on its line")]
    OpenQuote,
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
        for (k, column) in QUERY_COLUMNS.into_iter().enumerate() {
            let only = only.get(k).copied().flatten();
            let place = place_of(header, column)?.map(Place::Column).or(only.map(Place::Value));
            let missing = || ColumnError::Missing { column, found: names(header) };
            found[k] = place.ok_or_else(missing)?;
        }
        let dissimilarity = place_of(header, DISSIMILARITY)?;
        let known: Vec<_> = QUERY_COLUMNS.into_iter().chain([DISSIMILARITY]).collect();
        tell_misspelt(header, &known);
        Ok(Self { places: found, dissimilarity, count: header.len() })
    }

    /// What a row asks.
    pub(super) fn query(&self, row: &ByteRecord) -> Result<BulkQuery, NoCase> {
        if row.len() != self.count {
            return Err(NoCase::FieldCount { found: row.len(), expected: self.count });
        }
        let mut numbers = [0.0; 5];
        for ((number, place), column) in numbers.iter_mut().zip(self.places).zip(QUERY_COLUMNS) {
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

/// Cautions about columns that are passed through, though they look like one of `known` that is not there.
pub(super) fn tell_misspelt(header: &ByteRecord, known: &[&'static str]) {
    let is_there = |name: &&str| header.iter().any(|own| own.trim_ascii() == name.as_bytes());
    let missing: Vec<&str> = known.iter().copied().filter(|name| !is_there(name)).collect();
    for own in header.iter().map(|name| String::from_utf8_lossy(name.trim_ascii())) {
        if known.contains(&own.as_ref()) {
            continue;
        }
        if let Some(meant) = misspelt(&own, &missing) {
            say(&format!("caution: column `{own}` is not used: did you mean `{meant}`?"));
        }
    }
}

/// Cautions about columns that are passed through, though they are keys by which only a file differs.
pub(super) fn tell_of_file(header: &ByteRecord, keys: &[&str]) {
    for name in header.iter().map(|name| String::from_utf8_lossy(name.trim_ascii())) {
        if keys.contains(&name.as_ref()) {
            say(&format!("caution: column `{name}` is not used: it is the file's in all rows"));
        }
    }
}

/// Keys and quantities that rows of a case cannot have.
const OF_FILE: [&str; 8] =
    ["xi", "eta", "chi", "angle", "moment", "longitudinal_force", "lateral_force", "shear_modulus"];

/// The names of all columns.
pub(super) fn names(header: &ByteRecord) -> String {
    let names = header.iter().map(|name| String::from_utf8_lossy(name.trim_ascii()));
    names.collect::<Vec<_>>().join(", ")
}

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
        tell_misspelt(header, &Varied::ALL.map(Varied::name));
        tell_of_file(header, &OF_FILE);
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

/// Error of a row that is no case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum NoCase {
    #[error("the row has {found} fields, but the header {expected}")]
    FieldCount { found: usize, expected: usize },
    #[error("{column} is empty")]
    EmptyField { column: &'static str },
    #[error("{column} = `{text}` is not a number: decimals follow a point")]
    DecimalComma { column: &'static str, text: String },
    #[error("{column} = `{text}` is not a number")]
    NotANumber { column: &'static str, text: String },
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    #[error(transparent)]
    Row(#[from] RowError),
}

/// The number of a field.
pub(super) fn parse(column: &'static str, field: &[u8]) -> Result<f64, NoCase> {
    let text = String::from_utf8_lossy(field.trim_ascii());
    if text.is_empty() {
        return Err(NoCase::EmptyField { column });
    }
    text.parse().map_err(|_| {
        let (text, pointed) = (text.to_string(), text.replacen(',', ".", 1));
        if pointed.parse::<f64>().is_ok() {
            NoCase::DecimalComma { column, text }
        } else {
            NoCase::NotANumber { column, text }
        }
    })
}
