//! The points at which stresses are asked: a table with columns `x,y,z`.

use csv::StringRecord;

use crate::separator::Separator;

const COLUMNS: [&str; 3] = ["x", "y", "z"];

/// Error of a table without points. Rows count from one, without the header.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PointsError {
    /// No header, or one without this column.
    #[error("column {column} is missing: x, y, z are needed")]
    Missing {
        /// The column.
        column: &'static str,
    },
    /// Two columns of one name.
    #[error("column {column} is there twice")]
    Twice {
        /// The column.
        column: &'static str,
    },
    /// Not a finite number.
    #[error("row {row}, column {column}: `{text}` is not a finite number")]
    Number {
        /// The row.
        row: usize,
        /// The column.
        column: &'static str,
        /// What stands there.
        text: String,
    },
    /// Outside the body.
    #[error("row {row}, column z: {z:?} is above the surface; z >= 0 points into the body")]
    Outside {
        /// The row.
        row: usize,
        /// What stands there (m).
        z: f64,
    },
    /// No CSV.
    #[error(transparent)]
    Csv(#[from] csv::Error),
}

/// Points `[x, y, z]` (m), `z` into the body, from CSV with these columns in any order; others are
/// passed over, and so are lines that begin with `#`. Columns may be separated by semicolons or tabs, and between
/// semicolons a comma may be the decimal sign.
///
/// ```
/// assert_eq!(creepage_study::read_points("z,x,y\n1e-3,0,0\n")?, [[0.0, 0.0, 1e-3]]);
/// # Ok::<(), creepage_study::PointsError>(())
/// ```
///
/// # Errors
/// [`PointsError`], which names row and column.
pub fn read_points(text: &str) -> Result<Vec<[f64; 3]>, PointsError> {
    let text = text.trim_start_matches('\u{feff}');
    let separator = Separator::of(text);
    let mut reader = separator.reader().from_reader(text.as_bytes());
    let places = places(reader.headers()?)?;
    let point = |(record, row): (csv::Result<_>, usize)| point(&record?, separator, places, row);
    reader.into_records().zip(1..).map(point).collect()
}

fn places(header: &StringRecord) -> Result<[usize; 3], PointsError> {
    let mut places = [0; 3];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        let mut found = (0..header.len()).filter(|i| header.get(*i) == Some(column));
        *place = found.next().ok_or(PointsError::Missing { column })?;
        if found.next().is_some() {
            return Err(PointsError::Twice { column });
        }
    }
    Ok(places)
}

fn point(
    record: &StringRecord,
    separator: Separator,
    places: [usize; 3],
    row: usize,
) -> Result<[f64; 3], PointsError> {
    let mut point = [0.0; 3];
    for ((number, place), column) in point.iter_mut().zip(places).zip(COLUMNS) {
        let text = record.get(place).unwrap_or_default();
        let found = separator.number(text).filter(|value| value.is_finite());
        *number =
            found.ok_or_else(|| PointsError::Number { row, column, text: text.to_string() })?;
    }
    let z = point[2];
    if z < 0.0 { Err(PointsError::Outside { row, z }) } else { Ok(point) }
}
