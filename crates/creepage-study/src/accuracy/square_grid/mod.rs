//! Square-grid solver of the full theory: equal cells over the contact, the usual method, to measure `exact` by.

mod cells;
mod response;
mod row;

use creepage::{Contact, Creepage, Force};

use cells::Cells;
use response::Responses;
use row::Row;

/// Largest change of a traction over its bound in the last sweep: that of `exact`.
const TOLERANCE: f64 = 1e-8;
const ROUNDS: usize = 300;

/// Steady rolling on `n x n` equal cells over the box around the contact, of which those
/// count whose centres lie inside. The slip is the step of the displacement to the centre of the
/// cell upstream, over rigid slip taken between the two places where it belongs (the step's middle,
/// and the centre, where friction is): over the reference cases 40 x 40 cells then err by 0.35 %
/// (median) to 1.05 % of `mu N`. Rows of cells are solved by Newton in sweeps up and down, as in
/// [`Exact`](creepage::coulomb::Exact).
///
/// ```
/// use creepage::{Contact, Creepage, Ellipse};
/// use creepage_study::SquareGrid;
/// let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let grid = SquareGrid::new(&circle, 16);
/// let force = grid.force(Creepage::new(0.9, 0.0, 0.0)?).unwrap();
/// // On 16 x 16 cells the border of the ellipse is a staircase, and the force off by some per cent.
/// assert!((force.fx - 0.733).abs() < 0.05);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct SquareGrid {
    cells: Cells,
    responses: Responses,
}

impl SquareGrid {
    /// Prepares `n` by `n` cells, two at least, for a contact.
    #[must_use]
    pub fn new(contact: &Contact, n: usize) -> Self {
        let (ellipse, poisson) = (contact.ellipse(), contact.poisson());
        let [a, b] = [ellipse.a(), ellipse.b()];
        let hertz = |[x, y]: [f64; 2]| (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0).sqrt();
        // Slip in units of mu c / rho (4.20): 2 sqrt(g) / ((1 - sigma) E).
        let unit = (1.0 - poisson) * ellipse.integrals().e / (2.0 * ellipse.g().sqrt());
        let cells = Cells::new([a, b], n.max(2), hertz);
        Self { responses: Responses::new(unit, poisson, &cells), cells }
    }

    /// Prepares cells in a box of half length and width `half` about the origin of one area of any shape
    /// that is convex along rolling. `pressure` is over its largest value `p` there; creepage counts in
    /// `mu p / G`, spin in that over the unit of length.
    #[must_use]
    pub fn under_pressure(
        half: [f64; 2],
        poisson: f64,
        n: usize,
        pressure: impl Fn([f64; 2]) -> f64,
    ) -> Self {
        let cells = Cells::new(half, n.max(2), pressure);
        Self { responses: Responses::new(1.0, poisson, &cells), cells }
    }

    /// Cells inside the contact.
    #[must_use]
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// No cell has its centre inside the contact.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Force and moment on the lower body; `None` when the sweeps do not converge.
    #[must_use]
    pub fn force(&self, creepage: Creepage) -> Option<Force> {
        let mut tractions = [vec![0.0; self.len()], vec![0.0; self.len()]];
        let count = self.cells.rows();
        let is_full = |j: &usize| !self.cells.columns(*j).is_empty();
        let mut rows: Vec<_> = (0..count).map(|j| Row::new(&self.cells, j)).collect();
        for _ in 0..ROUNDS {
            let mut change = 0.0_f64;
            for j in (0..count).chain((0..count).rev()).filter(is_full) {
                let slip = self.slip(creepage, j, &tractions);
                change = change.max(rows[j].solve(&self.responses, slip, &mut tractions)?);
            }
            if change <= TOLERANCE {
                return Some(self.cells.force(&tractions));
            }
        }
        None
    }

    /// Slip of each cell of a row.
    fn slip(&self, creepage: Creepage, j: usize, tractions: &[Vec<f64>; 2]) -> Vec<[f64; 2]> {
        let at = |i| {
            let rigid = creepage.rigid_slip(self.cells.slip_place(j, i));
            let elastic = self.responses.slip(&self.cells, [j, i], tractions);
            [rigid[0] + elastic[0], rigid[1] + elastic[1]]
        };
        self.cells.columns(j).map(at).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::steady_rolling;
    use creepage::coulomb::{Exact, Resolution};
    use creepage::{Ellipse, Theory};

    /// A staircase of cells errs by parts of a cell's width: at 20 x 20 by a per cent or two, and
    /// the mean error falls with the cells' width. Every fourth of the reference cases.
    #[test]
    fn the_plain_grid_converges_to_the_reference() {
        let cases = steady_rolling().unwrap();
        let error = |n: usize| {
            let mut sum = 0.0;
            for case in cases.iter().step_by(4) {
                let grid = SquareGrid::new(&case.contact, n);
                let force = grid.force(case.creepage).unwrap();
                sum += (force.fx - case.force.fx).hypot(force.fy - case.force.fy);
            }
            sum / cases.iter().step_by(4).count() as f64
        };
        let [coarse, fine] = [10, 20].map(error);
        assert!(fine < 0.015, "{fine}");
        assert!(fine < 0.7 * coarse, "{coarse} {fine}");
    }

    /// Two programs that share nothing but the physics.
    #[test]
    fn it_agrees_with_the_fitted_elements() {
        let creepage = Creepage::new(0.7, -0.5, 1.0).unwrap();
        let contact = Contact::new(Ellipse::from_ratio(0.5).unwrap(), 0.3).unwrap();
        let exact = Exact::new(&contact, Resolution::STANDARD).unwrap().solve(creepage).force;
        let plain = SquareGrid::new(&contact, 30).force(creepage).unwrap();
        // The staircase at 30 x 30; see above.
        assert!((plain.fx - exact.fx).hypot(plain.fy - exact.fy) < 0.01, "{plain:?} {exact:?}");
    }
}
