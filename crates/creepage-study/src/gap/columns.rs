//! Columns of numbers from the CSV files beside a case, or from the case itself.

use std::collections::BTreeMap;
use std::path::Path;

use super::error::GapFileError;

/// The columns of a file by name, as many values each.
pub(crate) struct Columns {
    names: Vec<String>,
    values: Vec<Vec<f64>>,
}

impl Columns {
    /// Reads a file whose header has all of `needed` and none but these and `allowed`.
    pub(super) fn read(
        path: &Path,
        needed: &[&'static str],
        allowed: &[&'static str],
    ) -> Result<Self, GapFileError> {
        let text = std::fs::read_to_string(path).map_err(GapFileError::Read)?;
        let mut reader =
            csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
        let names: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
        check(&names, needed, allowed)?;
        let mut values = vec![Vec::new(); names.len()];
        for record in reader.records() {
            let record = record?;
            let line = record.position().map_or(0, csv::Position::line);
            for ((name, cell), column) in names.iter().zip(&record).zip(&mut values) {
                column.push(number(cell).ok_or_else(|| GapFileError::NotANumber {
                    line,
                    column: name.clone(),
                    cell: cell.into(),
                })?);
            }
        }
        Ok(Self { names, values })
    }

    /// Of a case that has the numbers itself; not-a-numbers are the gap's to refuse.
    pub(super) fn of(
        columns: &BTreeMap<String, Vec<f64>>,
        needed: &[&'static str],
        allowed: &[&'static str],
    ) -> Result<Self, GapFileError> {
        let names: Vec<String> = columns.keys().cloned().collect();
        check(&names, needed, allowed)?;
        let values: Vec<_> = columns.values().cloned().collect();
        let (other, expected) = (names.first(), values.first().map_or(0, Vec::len));
        let odd = names.iter().zip(&values).find(|(_, column)| column.len() != expected);
        if let (Some(other), Some((name, column))) = (other, odd) {
            let (name, other) = (name.clone(), other.clone());
            return Err(GapFileError::Lengths { name, found: column.len(), other, expected });
        }
        Ok(Self { names, values })
    }

    /// A column, if the file has it.
    pub(super) fn find(&self, name: &str) -> Option<&[f64]> {
        let at = self.names.iter().position(|known| known == name)?;
        self.values.get(at).map(Vec::as_slice)
    }

    /// A column that the file was read for; empty otherwise.
    pub(crate) fn column(&self, name: &str) -> &[f64] {
        self.find(name).unwrap_or_default()
    }
}

/// All of `needed`, and none but these and `allowed`, each once.
fn check(
    names: &[String],
    needed: &[&'static str],
    allowed: &[&'static str],
) -> Result<(), GapFileError> {
    if let Some(&name) = needed.iter().find(|name| !names.iter().any(|n| n == *name)) {
        return Err(GapFileError::NoColumn { name });
    }
    let known: Vec<_> = needed.iter().chain(allowed).copied().collect();
    for (i, name) in names.iter().enumerate() {
        if !known.contains(&&name[..]) {
            return Err(GapFileError::UnknownColumn { name: name.clone(), known });
        }
        if names[..i].contains(name) {
            return Err(GapFileError::ColumnTwice { name: name.clone() });
        }
    }
    Ok(())
}

fn number(cell: &str) -> Option<f64> {
    cell.parse().ok().filter(|value: &f64| value.is_finite())
}
