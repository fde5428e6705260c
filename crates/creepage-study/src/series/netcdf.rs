//! A series as NetCDF (classic format): a variable a column, over the dimension `case`.

use std::path::Path;

use creepage::Status;
use netcdf3::{DataSet, FileWriter, Version};

use super::table::{COLUMNS, Cell};
use super::{SeriesHead, SeriesRow};
use crate::error::ReportError;

/// The statuses by their number in the file.
const STATUSES: [Status; 4] =
    [Status::Solved, Status::NotConverged, Status::CreepageTooSmall, Status::SpinTooLarge];

/// Writes a series to the NetCDF file `path`, which is replaced. `rows` is asked for all rows once
/// a column, so that only one column is in memory at a time.
///
/// # Errors
/// [`ReportError`] when a row cannot be read, or the file not written.
pub fn series_netcdf<E: Into<ReportError>, Rows: Iterator<Item = Result<SeriesRow, E>>>(
    head: &SeriesHead,
    mut rows: impl FnMut() -> Result<Rows, E>,
    path: &Path,
) -> Result<(), ReportError> {
    let definition = definition(head)?;
    let mut file = FileWriter::open(path)?;
    file.set_def(&definition, Version::Offset64Bit, 0)?;
    for column in &COLUMNS {
        let values = column_of(rows().map_err(Into::into)?, |row| real((column.value)(row)))?;
        file.write_var_f64(column.name, &values)?;
    }
    let statuses = column_of(rows().map_err(Into::into)?, |row| number(row.status))?;
    file.write_var_i32("status", &statuses)?;
    Ok(file.close()?)
}

fn column_of<T, E: Into<ReportError>>(
    rows: impl Iterator<Item = Result<SeriesRow, E>>,
    value: impl Fn(&SeriesRow) -> T,
) -> Result<Vec<T>, ReportError> {
    rows.map(|row| row.map(|row| value(&row)).map_err(Into::into)).collect()
}

/// Every column is of reals: NaN has no place among integers, and 2^53 counts are enough.
fn real(cell: Cell) -> f64 {
    match cell {
        Cell::Real(value) => value,
        Cell::Count(count) => count as f64,
    }
}

fn number(status: Status) -> i32 {
    (0..).zip(STATUSES).find(|(_, known)| *known == status).map_or(-1, |(number, _)| number)
}

fn definition(head: &SeriesHead) -> Result<DataSet, netcdf3::InvalidDataSet> {
    let mut set = DataSet::new();
    set.add_fixed_dim("case", head.cases)?;
    set.add_global_attr_f64("a_over_b", vec![head.a_over_b])?;
    set.add_global_attr_f64("poisson", vec![head.poisson])?;
    set.add_global_attr_f64("kappa_over_mu", vec![head.kappa_over_mu])?;
    let whole = |count: usize| i32::try_from(count).unwrap_or(i32::MAX);
    set.add_global_attr_i32("degree", vec![whole(head.degree)])?;
    set.add_global_attr_i32("mesh", head.mesh.map(whole).to_vec())?;
    for column in &COLUMNS {
        set.add_var_f64(column.name, &["case"])?;
        set.add_var_attr_string(column.name, "long_name", column.meaning)?;
    }
    set.add_var_i32("status", &["case"])?;
    let names = STATUSES.map(Status::name).join(" ");
    set.add_var_attr_i32("status", "flag_values", STATUSES.map(number).to_vec())?;
    set.add_var_attr_string("status", "flag_meanings", names)?;
    Ok(set)
}
