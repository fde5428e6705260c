//! User-supplied points drawn over a figure: those of experiments that the thesis has in its pictures only.

use std::io::Read;

use csv::Trim;

/// Points in the axes of an item's panels, in the order of the file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OwnPoints {
    /// Panel, counted from 1 row by row, and the point.
    points: Vec<(usize, [f64; 2])>,
}

/// Error of a table without points for a picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PointsError {
    /// A column that is needed.
    #[error(
        "column {column} is missing: columns x and y are the axes of the picture, panel is its panel"
    )]
    Missing {
        /// `x` or `y`.
        column: &'static str,
    },
    /// A column that means nothing here.
    #[error("unknown column `{name}`: known are x, y and panel")]
    Unknown {
        /// Its name.
        name: String,
    },
    /// A field that is no number.
    #[error("row {row}, column {column}: `{text}` is no number")]
    NotANumber {
        /// Of the table, from 1.
        row: usize,
        /// Its name.
        column: &'static str,
        /// What stands there.
        text: String,
    },
    /// A panel that the picture does not have.
    #[error("row {row}: the picture has no panel {panel}, only 1 to {panels}")]
    NoPanel {
        /// Of the table, from 1.
        row: usize,
        /// What was asked for.
        panel: String,
        /// How many there are.
        panels: usize,
    },
    /// The table has no rows.
    #[error("the table has no rows")]
    Empty,
    /// A table of words, which has no axes.
    #[error("{name} is a table, not a picture: points can be laid over pictures only")]
    NoPicture {
        /// The item.
        name: &'static str,
    },
    /// No CSV.
    #[error(transparent)]
    Csv(#[from] csv::Error),
}

const COLUMNS: [&str; 3] = ["x", "y", "panel"];

impl OwnPoints {
    /// Reads a table in CSV with the columns `x` and `y`, in the numbers of the picture's axes, and
    /// `panel`, counted from 1 row by row; without that column all points are of the first panel.
    ///
    /// ```
    /// let table = "x,y\n0.5,0.21\n1.0,0.38\n";
    /// let points = creepage_1967::OwnPoints::read(table.as_bytes())?;
    /// assert_eq!(points.count(), 2);
    /// # Ok::<(), creepage_1967::PointsError>(())
    /// ```
    ///
    /// # Errors
    /// [`PointsError`] that names the column and the row.
    pub fn read(input: impl Read) -> Result<Self, PointsError> {
        let mut reader =
            csv::ReaderBuilder::new().trim(Trim::All).comment(Some(b'#')).from_reader(input);
        let header = reader.headers()?.clone();
        let names: Vec<&str> =
            header.iter().map(|name| name.trim_start_matches('\u{feff}')).collect();
        if let Some(name) = names.iter().find(|name| !COLUMNS.contains(name)) {
            return Err(PointsError::Unknown { name: (*name).into() });
        }
        let place = |column: &str| names.iter().position(|name| *name == column);
        let needed = |column| place(column).ok_or(PointsError::Missing { column });
        let (columns, panel) = ([needed(COLUMNS[0])?, needed(COLUMNS[1])?], place(COLUMNS[2]));
        let mut points = Vec::new();
        for (index, record) in reader.records().enumerate() {
            let (record, row) = (record?, index + 1);
            let text = |column: usize| record.get(column).unwrap_or_default();
            let number = |k: usize| {
                let found = text(columns[k]).parse::<f64>().ok().filter(|value| value.is_finite());
                found.ok_or_else(|| PointsError::NotANumber {
                    row,
                    column: COLUMNS[k],
                    text: text(columns[k]).into(),
                })
            };
            let panel = match panel.map(text) {
                None => 1,
                Some(text) => text.parse().map_err(|_| PointsError::NotANumber {
                    row,
                    column: COLUMNS[2],
                    text: text.into(),
                })?,
            };
            points.push((panel, [number(0)?, number(1)?]));
        }
        if points.is_empty() { Err(PointsError::Empty) } else { Ok(Self { points }) }
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.points.len()
    }

    /// Panel, counted from 1, and point of each, in the order of the file.
    pub fn iter(&self) -> impl Iterator<Item = (usize, [f64; 2])> + '_ {
        self.points.iter().copied()
    }
}
