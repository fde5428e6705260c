//! Columns of numbers from the CSV files beside a case.

use std::path::Path;

use super::error::GapFileError;

/// The columns of a file by name, as many values each.
pub(super) struct Columns {
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

    /// A column, if the file has it.
    pub(super) fn find(&self, name: &str) -> Option<&[f64]> {
        let at = self.names.iter().position(|known| known == name)?;
        self.values.get(at).map(Vec::as_slice)
    }

    /// A column that the file was read for; empty otherwise.
    pub(super) fn column(&self, name: &str) -> &[f64] {
        self.find(name).unwrap_or_default()
    }
}

fn number(cell: &str) -> Option<f64> {
    cell.parse().ok().filter(|value: &f64| value.is_finite())
}
