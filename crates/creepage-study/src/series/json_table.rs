//! A series as JSON.

use std::io::Write;

use serde_json::{Map, Value};

use super::columns::{COLUMNS, Cell};
use super::{SeriesHead, SeriesRow};
use crate::error::ReportError;

/// Writes a series as JSON: an object with what the cases share, and `cases`, an array of an
/// object a case, a line each. A number that does not exist is `null`.
///
/// # Errors
/// [`ReportError::Series`] when a row cannot be read or written.
pub fn series_json<E: Into<ReportError>>(
    head: &SeriesHead,
    rows: impl Iterator<Item = Result<SeriesRow, E>>,
    mut out: impl Write,
) -> Result<(), ReportError> {
    let [nx, ny] = head.mesh;
    write!(
        out,
        "{{\"a_over_b\": {}, \"poisson\": {}, \"kappa_over_mu\": {}, \"degree\": {}, \"mesh\": [{nx}, {ny}], \"cases\": [",
        Value::from(head.a_over_b),
        Value::from(head.poisson),
        Value::from(head.kappa_over_mu),
        head.degree
    )
    .map_err(ReportError::Series)?;
    for (number, row) in rows.enumerate() {
        let comma = if number == 0 { "" } else { "," };
        write!(out, "{comma}\n{}", object(&row.map_err(Into::into)?))
            .map_err(ReportError::Series)?;
    }
    out.write_all(b"\n]}\n").and_then(|()| out.flush()).map_err(ReportError::Series)
}

fn object(row: &SeriesRow) -> Value {
    let numbers = COLUMNS.iter().map(|column| (column.name.into(), value((column.value)(row))));
    let status = ("status".into(), row.status.name().into());
    Value::Object(numbers.chain([status]).collect::<Map<String, Value>>())
}

fn value(cell: Cell) -> Value {
    match cell {
        Cell::Real(value) => value.into(),
        Cell::Count(count) => count.into(),
    }
}
