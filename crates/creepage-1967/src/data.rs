//! Data table behind a figure or a table, written as CSV.

/// A table of numbers and words, to be written as CSV.
#[derive(Debug, Clone, PartialEq)]
pub struct Data {
    columns: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

/// A cell of a row.
#[derive(Debug, Clone)]
pub(crate) enum Cell<'a> {
    Number(f64),
    Word(&'a str),
}

impl From<f64> for Cell<'_> {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl<'a> From<&'a str> for Cell<'a> {
    fn from(word: &'a str) -> Self {
        Self::Word(word)
    }
}

impl<'a> From<&'a String> for Cell<'a> {
    fn from(word: &'a String) -> Self {
        Self::Word(word)
    }
}

impl Data {
    pub(crate) fn new(columns: impl Into<Vec<&'static str>>) -> Self {
        Self { columns: columns.into(), rows: Vec::new() }
    }

    /// Adds a row: `["M = 3".into(), 0.5.into()]`.
    pub(crate) fn push<'a>(&mut self, cells: impl IntoIterator<Item = Cell<'a>>) {
        let text = |cell| match cell {
            Cell::Number(number) => written(number),
            Cell::Word(word) => word.to_owned(),
        };
        self.rows.push(cells.into_iter().map(text).collect());
    }

    /// Adds a row for each point of a curve.
    pub(crate) fn curve(&mut self, name: &str, points: &[[f64; 2]]) {
        self.points(name, &[], points);
    }

    /// Adds a row for each point of a curve: its name, what all its points share, the point.
    pub(crate) fn points<'p>(
        &mut self,
        name: &str,
        shared: &[f64],
        points: impl IntoIterator<Item = &'p [f64; 2]>,
    ) {
        for point in points {
            let numbers = shared.iter().chain(point).map(|number| Cell::Number(*number));
            self.push([Cell::Word(name)].into_iter().chain(numbers));
        }
    }

    /// Rows, without the heads of the columns.
    #[must_use]
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }

    /// As CSV with the heads of the columns.
    ///
    /// # Errors
    /// [`csv::Error`] when a row has too few or too many cells.
    pub fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.columns)?;
        for row in &self.rows {
            writer.write_record(row)?;
        }
        writer.into_inner().map_err(|error| error.into_error().into())
    }
}

/// Eight significant digits: more than any curve is good for, and no rounding of the machine.
fn written(number: f64) -> String {
    // What is nothing beside the quantities of a picture, all of order one, is rounding.
    if number.abs() < 1e-12 {
        return "0".into();
    }
    let rounded: f64 = format!("{number:.7e}").parse().unwrap_or(number);
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_a_point() {
        let mut data = Data::new(["curve", "x", "y"]);
        data.curve("a, b", &[[0.1, 1.0 / 3.0], [-1e-17, 2e9]]);
        let csv = String::from_utf8(data.csv().unwrap()).unwrap();
        assert_eq!(csv, "curve,x,y\n\"a, b\",0.1,0.33333333\n\"a, b\",0,2000000000\n");
    }
}
