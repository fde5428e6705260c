//! A table of the thesis, entry by entry, beside what it should have been.

use serde::Deserialize;

use crate::error::GalleryError;

/// An entry as printed, beside the value computed today.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    /// The row of the table: `C`, `K`, ...
    pub(crate) quantity: String,
    /// The head of the column; zero is the limit.
    pub(crate) argument: f64,
    /// The entry as printed.
    pub(crate) printed: String,
    /// Today's value, to one digit more than printed.
    pub(crate) ours: String,
    /// How the two compare.
    pub(crate) verdict: Judgement,
}

/// Whether an entry is the true value, rounded to the digits printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Judgement {
    /// It is.
    Right,
    /// It is not: so many units of its last digit too large, or too small if negative.
    Off(i64),
}

/// A row of a file of printed entries.
#[derive(Debug, Deserialize)]
pub(crate) struct Row {
    pub(crate) quantity: String,
    pub(crate) argument: f64,
    pub(crate) printed: String,
}

impl Row {
    pub(crate) fn read(table: &str) -> Result<Vec<Self>, GalleryError> {
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        Ok(reader.deserialize().collect::<Result<_, _>>()?)
    }

    /// The entry beside the true value of the number printed.
    pub(crate) fn against(self, truth: f64) -> Result<Entry, GalleryError> {
        let (limit, number) = self.split();
        let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let Ok(printed) = number.parse::<f64>() else { return Err(self.meaningless()) };
        let unit = 10f64.powi(decimals.try_into().unwrap_or(0));
        let verdict = if printed.is_infinite() && truth.is_infinite() {
            Judgement::Right
        } else {
            // Whole numbers both, in units of the last digit.
            verdict((printed * unit).round() - (truth * unit).round())
        };
        let ours = format!("{limit}{truth:.*}", decimals + 1);
        let Self { quantity, argument, printed } = self;
        Ok(Entry { quantity, argument, printed, ours, verdict })
    }

    /// A limit and the number that follows it: `ln(4/g)` and `-2`.
    pub(crate) fn split(&self) -> (&str, &str) {
        let number = self.printed.strip_prefix(LIMIT);
        number.map_or(("", &self.printed), |number| (LIMIT, number))
    }

    pub(crate) fn meaningless(self) -> GalleryError {
        GalleryError::Entry { quantity: self.quantity, printed: self.printed }
    }
}

/// What `K`, `C` and `D` grow with as the ellipse becomes a line.
const LIMIT: &str = "ln(4/g)";

/// The verdict on an error in units of the last digit.
#[allow(clippy::cast_possible_truncation)] // a whole number; a table is not off by more
fn verdict(units: f64) -> Judgement {
    match units as i64 {
        0 => Judgement::Right,
        units => Judgement::Off(units),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judge(printed: &str, truth: f64) -> Judgement {
        let row = Row { quantity: "K".into(), argument: 1.0, printed: printed.into() };
        row.against(truth).unwrap().verdict
    }

    #[test]
    fn an_entry_is_right_when_it_is_the_rounded_truth() {
        assert_eq!(judge("0.79", 0.7949), Judgement::Right);
        assert_eq!(judge("0.79", 0.7951), Judgement::Off(-1));
        assert_eq!(judge("0.999", 0.99889), Judgement::Right);
        assert_eq!(judge("3.71", 3.61953), Judgement::Off(9));
        assert_eq!(judge("inf", f64::INFINITY), Judgement::Right);
        assert_eq!(judge("ln(4/g)-2", -2.0), Judgement::Right);
    }

    #[test]
    fn what_is_no_number_is_an_error() {
        let row = Row { quantity: "K".into(), argument: 1.0, printed: "1,5".into() };
        assert!(row.against(1.5).unwrap_err().to_string().contains("K = 1,5"));
    }
}
