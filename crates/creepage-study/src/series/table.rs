//! A series as a table: its columns, the same in every format, and CSV and JSON of them.

use std::io::Write;

use Cell::{Count, Real};
use serde_json::{Map, Value};

use super::{SeriesHead, SeriesRow};
use crate::error::ReportError;

/// A number of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell {
    Real(f64),
    Count(usize),
}

/// One column of numbers.
pub(super) struct Column {
    pub(super) name: &'static str,
    /// What it is, with its unit.
    pub(super) meaning: &'static str,
    pub(super) value: fn(&SeriesRow) -> Cell,
}

/// All columns but the status, which is a word.
pub(super) const COLUMNS: [Column; 15] = [
    column("chi", "spin, phi rho / mu", |row| Real(row.creepage.chi())),
    column("alpha", "angle from the rolling direction to the creepage [degrees]", |row| {
        Real(row.alpha)
    }),
    column("upsilon", "magnitude of the creepage (xi, eta)", |row| Real(row.upsilon)),
    column("xi", "longitudinal creepage, upsilon_x rho / (mu c)", |row| Real(row.creepage.xi())),
    column("eta", "lateral creepage, upsilon_y rho / (mu c)", |row| Real(row.creepage.eta())),
    column("fx", "longitudinal force on the lower body over mu N", |row| Real(row.force.fx)),
    column("fy", "lateral force on the lower body over mu N", |row| Real(row.force.fy)),
    column("mz", "moment on the lower body over mu N c", |row| Real(row.force.mz)),
    column("iterations", "iterations", |row| Count(row.iterations)),
    column("steps_from_previous", "steps in which the previous case was left", |row| {
        Count(row.steps_from_previous)
    }),
    column("mean_integrand", "mean of W T S over the mesh", |row| Real(row.mean_integrand)),
    column("residual", "mean of W T S over that of rigid bodies", |row| Real(row.residual)),
    column("aberrations", "mesh points with T > S and traction above its bound", |row| {
        Count(row.aberrations)
    }),
    column("adhesion_share", "share of the mesh points that adhere", |row| {
        Real(row.adhesion_share)
    }),
    column("second_start_difference", "largest change of a force by a second start", |row| {
        Real(row.second_start_difference)
    }),
];

const fn column(
    name: &'static str,
    meaning: &'static str,
    value: fn(&SeriesRow) -> Cell,
) -> Column {
    Column { name, meaning, value }
}

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
