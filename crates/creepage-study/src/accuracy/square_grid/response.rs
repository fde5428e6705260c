//! Influence coefficients of the square grid: slip of a cell by tractions in another, a function of their distance.

use std::f64::consts::PI;

use super::cells::Cells;

/// By unit tractions over their bound `mu Z_max`: `[u by X, u by Y = v by X, v by Y]`.
#[derive(Debug, Clone)]
pub(super) struct Responses {
    n: usize,
    /// By rows apart, then columns apart: `[2 n - 1][2 n - 1]`.
    table: [Vec<f64>; 3],
}

impl Responses {
    /// Slip counts in `unit` times the largest bound over the shear modulus.
    pub(super) fn new(unit: f64, poisson: f64, cells: &Cells) -> Self {
        let n = cells.n;
        let [dx, dy] = cells.size();
        // With 1/pi of (2.11).
        let scale = 1.0 / (PI * unit * dx);
        let apart = |k: usize| k as f64 - (n as f64 - 1.0);
        let mut table: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::new());
        for rows in 0..2 * n - 1 {
            let y = apart(rows) * dy;
            let mut upstream = displacement(poisson, [(apart(0) - 1.0) * dx, y], [dx, dy]);
            for columns in 0..2 * n - 1 {
                let here = displacement(poisson, [apart(columns) * dx, y], [dx, dy]);
                for k in 0..3 {
                    table[k].push(scale * (upstream[k] - here[k]));
                }
                upstream = here;
            }
        }
        Self { n, table }
    }

    /// Where the responses of the cell in row `j`, column `i` to row `by_j` begin, with `first`
    /// the first column of that row.
    fn start(&self, [j, i]: [usize; 2], by_j: usize, first: usize) -> usize {
        (by_j + self.n - 1 - j) * (2 * self.n - 1) + first + self.n - 1 - i
    }

    /// Slip of a cell by all tractions.
    pub(super) fn slip(&self, cells: &Cells, at: [usize; 2], [x, y]: &[Vec<f64>; 2]) -> [f64; 2] {
        let mut slip = [0.0; 2];
        for by_j in 0..cells.rows() {
            let numbers = cells.numbers(by_j);
            let start = self.start(at, by_j, cells.columns(by_j).start);
            let own = |k: usize| &self.table[k][start..start + numbers.len()];
            let loads = x[numbers.clone()].iter().zip(&y[numbers.clone()]);
            let responses = own(0).iter().zip(own(1)).zip(own(2));
            for (((x, y), bound), ((xx, xy), yy)) in
                loads.zip(&cells.bounds[numbers.clone()]).zip(responses)
            {
                slip[0] += bound * (xx * x + xy * y);
                slip[1] += bound * (xy * x + yy * y);
            }
        }
        slip
    }

    /// Slip of a cell by a unit traction in another of the same row.
    pub(super) fn in_row(&self, columns: usize, by: usize) -> [f64; 3] {
        let at = self.start([0, columns], 0, by);
        [0, 1, 2].map(|k| self.table[k][at])
    }
}

/// Displacement difference at the origin by a constant traction on a rectangle, times `pi G`:
/// Boussinesq and Cerruti, integrated over the corners.
fn displacement(poisson: f64, [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (sign, x, y) in [
        (1.0, x + 0.5 * dx, y + 0.5 * dy),
        (-1.0, x - 0.5 * dx, y + 0.5 * dy),
        (-1.0, x + 0.5 * dx, y - 0.5 * dy),
        (1.0, x - 0.5 * dx, y - 0.5 * dy),
    ] {
        let r = x.hypot(y);
        // No corner lies at the field point, the centre of a cell.
        let [ln_x, ln_y] = [y * (x / y.abs()).asinh(), x * (y / x.abs()).asinh()];
        let terms = [ln_x + (1.0 - poisson) * ln_y, -poisson * r, (1.0 - poisson) * ln_x + ln_y];
        for k in 0..3 {
            sum[k] += sign * terms[k];
        }
    }
    sum
}
