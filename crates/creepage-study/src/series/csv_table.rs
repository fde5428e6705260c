//! A series as CSV.

use std::io::Write;

use super::columns::{COLUMNS, Cell};
use super::{SeriesHead, SeriesRow};
use crate::error::ReportError;

/// Writes a series as CSV, a row a case: `a_over_b`, `poisson`, `kappa_over_mu`, the columns, `status`. Numbers are
/// the shortest that read back the same; a cell is empty where the number does not exist.
///
/// # Errors
/// [`ReportError::Series`] when a row cannot be read or written.
pub fn series_csv<E: Into<ReportError>>(
    head: &SeriesHead,
    rows: impl Iterator<Item = Result<SeriesRow, E>>,
    out: impl Write,
) -> Result<(), ReportError> {
    let mut writer = csv::Writer::from_writer(out);
    let names = COLUMNS.iter().map(|column| column.name);
    let series = |source: csv::Error| ReportError::Series(source.into());
    writer
        .write_record(
            ["a_over_b", "poisson", "kappa_over_mu"].into_iter().chain(names).chain(["status"]),
        )
        .map_err(series)?;
    for row in rows {
        let row = row.map_err(Into::into)?;
        let shared = [head.a_over_b, head.poisson, head.kappa_over_mu];
        let shared = shared.map(|shared| text(Cell::Real(shared)));
        let cells = COLUMNS.iter().map(|column| text((column.value)(&row)));
        let status = std::iter::once(row.status.name().to_owned());
        writer.write_record(shared.into_iter().chain(cells).chain(status)).map_err(series)?;
    }
    writer.flush().map_err(ReportError::Series)
}

fn text(cell: Cell) -> String {
    match cell {
        Cell::Count(count) => count.to_string(),
        Cell::Real(value) if value.is_finite() => format!("{value:?}"),
        Cell::Real(_) => String::new(),
    }
}
