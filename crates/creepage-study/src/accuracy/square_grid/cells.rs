//! Which cells of the box lie in the contact, and what they bear.

use std::ops::Range;

use creepage::Ellipse;
use creepage::Force;

/// Cells `(row, column)`: rows from negative `y`, columns from the trailing edge; those inside the
/// contact are counted row by row.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    ellipse: Ellipse,
    pub n: usize,
    columns: Vec<Range<usize>>,
    starts: Vec<usize>,
    /// `mu Z` at the centre over its largest value.
    pub bounds: Vec<f64>,
}

impl Cells {
    pub(super) fn new(ellipse: Ellipse, n: usize) -> Self {
        let mut cells = Self { ellipse, n, columns: vec![], starts: vec![], bounds: vec![] };
        for j in 0..n {
            let inside: Vec<_> = (0..n).filter(|i| cells.pressure(j, *i) > 0.0).collect();
            let range = inside.first().map_or(0..0, |first| *first..first + inside.len());
            cells.starts.push(cells.bounds.len());
            let pressures: Vec<_> = range.clone().map(|i| cells.pressure(j, i)).collect();
            cells.bounds.extend(pressures);
            cells.columns.push(range);
        }
        cells
    }

    fn pressure(&self, j: usize, i: usize) -> f64 {
        let [x, y] = [i, j].map(|k| (2 * k + 1) as f64 / self.n as f64 - 1.0);
        (1.0 - x * x - y * y).max(0.0).sqrt()
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
        [self.ellipse.a(), self.ellipse.b()].map(|semi_axis| 2.0 * semi_axis / self.n as f64)
    }

    /// The centre of a cell, moved along by parts of its length.
    fn place(&self, [j, i]: [usize; 2], ahead: f64) -> [f64; 2] {
        let [dx, dy] = self.size();
        let from_rear = i as f64 + 0.5 + ahead;
        [from_rear * dx - self.ellipse.a(), (j as f64 + 0.5) * dy - self.ellipse.b()]
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
