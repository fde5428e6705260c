//! Cells of the square grid inside the contact, and their pressure.

use std::ops::Range;

use creepage::Force;

/// Cells `(row, column)`: rows from negative `y`, columns from the trailing edge; those inside the
/// contact are counted row by row.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    /// Half the length and width of the box.
    half: [f64; 2],
    pub n: usize,
    columns: Vec<Range<usize>>,
    starts: Vec<usize>,
    /// `mu Z` at the centre over its largest value.
    pub bounds: Vec<f64>,
}

impl Cells {
    /// `pressure` at a place, over its largest value.
    pub(super) fn new(half: [f64; 2], n: usize, pressure: impl Fn([f64; 2]) -> f64) -> Self {
        let mut cells = Self { half, n, columns: vec![], starts: vec![], bounds: vec![] };
        for j in 0..n {
            let pressures = (0..n).map(|i| pressure(cells.place([j, i], 0.0)));
            let inside: Vec<(usize, f64)> =
                pressures.enumerate().filter(|(_, pressure)| *pressure > 0.0).collect();
            cells.columns.push(inside.first().map_or(0..0, |(i, _)| *i..i + inside.len()));
            cells.starts.push(cells.bounds.len());
            cells.bounds.extend(inside.iter().map(|(_, pressure)| pressure));
        }
        cells
    }

    pub(super) fn len(&self) -> usize {
        self.bounds.len()
    }

    pub(super) fn rows(&self) -> usize {
        self.n
    }

    /// The columns of a row that lie inside.
    pub(super) fn columns(&self, j: usize) -> Range<usize> {
        self.columns[j].clone()
    }

    /// The numbers of a row's cells.
    pub(super) fn numbers(&self, j: usize) -> Range<usize> {
        self.starts[j]..self.starts[j] + self.columns[j].len()
    }

    /// Length and width of a cell.
    pub(super) fn size(&self) -> [f64; 2] {
        self.half.map(|half| 2.0 * half / self.n as f64)
    }

    /// The centre of a cell, moved along by parts of its length.
    fn place(&self, [j, i]: [usize; 2], ahead: f64) -> [f64; 2] {
        let [dx, dy] = self.size();
        let from_rear = i as f64 + 0.5 + ahead;
        [from_rear * dx - self.half[0], (j as f64 + 0.5) * dy - self.half[1]]
    }

    /// Where the rigid slip of a cell is taken: half-way to the middle of its step upstream.
    pub(super) fn slip_place(&self, j: usize, i: usize) -> [f64; 2] {
        self.place([j, i], 0.25)
    }

    /// The tractions' resultant, over that of all bounds.
    pub(super) fn force(&self, tractions: &[Vec<f64>; 2]) -> Force {
        let load: f64 = self.bounds.iter().sum();
        let mut force = Force { fx: 0.0, fy: 0.0, mz: 0.0 };
        for j in 0..self.rows() {
            for (i, k) in self.columns(j).zip(self.numbers(j)) {
                let share = self.bounds[k] / load;
                let [x, y] = [share * tractions[0][k], share * tractions[1][k]];
                let [at, beside] = self.place([j, i], 0.0);
                force.fx += x;
                force.fy += y;
                force.mz += at * y - beside * x;
            }
        }
        force
    }
}
