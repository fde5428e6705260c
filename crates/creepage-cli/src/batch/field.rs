//! Parser of one field of a batch row, and the error of a row that is no case.

use creepage::InvalidValue;
use creepage_study::RowError;

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
