//! A regular lattice of equal rectangles, and sets of its cells.

use crate::gap::{Gap, Rectangle};

use super::error::NormalError;

/// Equal rectangles in rows of constant y, the first at low x and low y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lattice {
    pub(super) corner: [f64; 2],
    pub(super) step: [f64; 2],
    pub(super) count: [usize; 2],
}

impl Lattice {
    /// Divides a rectangle into the given numbers of cells.
    pub(super) fn dividing(rectangle: &Rectangle, count: [usize; 2]) -> Self {
        let [width, height] = rectangle.size();
        let step = [width / count[0] as f64, height / count[1] as f64];
        Self { corner: [rectangle.x[0], rectangle.y[0]], step, count }
    }

    pub(super) fn cells(&self) -> usize {
        self.count[0] * self.count[1]
    }

    pub(super) fn cell_area(&self) -> f64 {
        self.step[0] * self.step[1]
    }

    /// Centre of a column.
    pub(super) fn x(&self, column: usize) -> f64 {
        self.corner[0] + (column as f64 + 0.5) * self.step[0]
    }

    /// Centre of a row.
    pub(super) fn y(&self, row: usize) -> f64 {
        self.corner[1] + (row as f64 + 0.5) * self.step[1]
    }

    /// Column and row of the cell that holds a place.
    pub(super) fn holding(&self, x: f64, y: f64) -> Option<[usize; 2]> {
        let index = |place: f64, axis: usize| {
            let cell = (place - self.corner[axis]) / self.step[axis];
            (cell >= 0.0 && cell < self.count[axis] as f64).then(|| whole(cell))
        };
        Some([index(x, 0)?, index(y, 1)?])
    }

    /// The rectangle of cells from the first to the last column and row.
    pub(super) fn rectangle(&self, columns: [usize; 2], rows: [usize; 2]) -> Rectangle {
        let ends = |axis: usize, [first, last]: [usize; 2]| {
            let at = |i: usize| self.corner[axis] + i as f64 * self.step[axis];
            [at(first), at(last + 1)]
        };
        Rectangle { x: ends(0, columns), y: ends(1, rows) }
    }

    /// How deep the undeformed bodies would lie in each other, `approach - h`, at all centres.
    pub(super) fn depths(&self, gap: &Gap, approach: f64) -> Result<Vec<f64>, NormalError> {
        let xs: Vec<f64> = (0..self.count[0]).map(|column| self.x(column)).collect();
        let mut depths = vec![0.0; self.cells()];
        for (row, out) in depths.chunks_mut(self.count[0]).enumerate() {
            let y = self.y(row);
            gap.fill_row(y, &xs, out);
            for (depth, &x) in out.iter_mut().zip(&xs) {
                if depth.is_nan() {
                    return Err(NormalError::NotFinite { x, y, value: *depth });
                }
                *depth = approach - *depth;
            }
        }
        Ok(depths)
    }
}

/// The whole part of a number that is not negative and small.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn whole(number: f64) -> usize {
    number as usize
}

/// First and last column and row of the cells in a set.
pub(super) fn bounds(lattice: &Lattice, holds: impl Fn(usize) -> bool) -> Option<[[usize; 2]; 2]> {
    let (mut columns, mut rows) = ([usize::MAX, 0], [usize::MAX, 0]);
    for cell in (0..lattice.cells()).filter(|&cell| holds(cell)) {
        let (column, row) = (cell % lattice.count[0], cell / lattice.count[0]);
        columns = [columns[0].min(column), columns[1].max(column)];
        rows = [rows[0].min(row), rows[1].max(row)];
    }
    (columns[0] <= columns[1]).then_some([columns, rows])
}

/// Mean lengths of the unbroken runs of a set along x and along y (m).
pub(super) fn mean_chords(lattice: &Lattice, holds: impl Fn(usize) -> bool) -> Option<[f64; 2]> {
    let [columns, _] = lattice.count;
    let (mut cells, mut runs) = (0_usize, [0_usize; 2]);
    for cell in (0..lattice.cells()).filter(|&cell| holds(cell)) {
        cells += 1;
        runs[0] += usize::from(cell % columns == 0 || !holds(cell - 1));
        runs[1] += usize::from(cell < columns || !holds(cell - columns));
    }
    let mean = |axis: usize| lattice.step[axis] * cells as f64 / runs[axis] as f64;
    (cells > 0).then(|| [mean(0), mean(1)])
}
