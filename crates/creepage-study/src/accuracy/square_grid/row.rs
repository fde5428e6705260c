//! Row solver of the square grid: friction in one row of cells, the others held, by a semismooth Newton method.

use nalgebra::{DMatrix, DVector, Dyn, LU, Matrix2};

use super::cells::Cells;
use super::response::Responses;

/// Semismooth Newton steps in one row of cells.
const MAX_NEWTON_STEPS: usize = 30;
/// Steps below this size leave the factors good enough to use again.
const CHORD: f64 = 0.02;
/// Weight of slip against traction in the projection, over a cell's own response.
const WEIGHT: f64 = 0.3;

/// A row, and the factors of its last Newton step.
#[derive(Debug, Clone)]
pub(super) struct Row {
    first: usize,
    first_column: usize,
    bounds: Vec<f64>,
    slides: Vec<bool>,
    factors: Option<LU<f64, Dyn, Dyn>>,
    last_step: f64,
}

/// A cell's projected traction: its value, and its derivative, `None` in adhesion.
type Projection = Option<([f64; 2], Matrix2<f64>)>;

impl Row {
    pub(super) fn new(cells: &Cells, j: usize) -> Self {
        let numbers = cells.numbers(j);
        Self {
            first: numbers.start,
            first_column: cells.columns(j).start,
            slides: vec![false; numbers.len()],
            bounds: cells.bounds[numbers].to_vec(),
            factors: None,
            last_step: f64::INFINITY,
        }
    }

    /// Improves the row's tractions; the largest change, or `None` when there is no step.
    pub(super) fn solve(
        &mut self,
        responses: &Responses,
        mut slip: Vec<[f64; 2]>,
        tractions: &mut [Vec<f64>; 2],
    ) -> Option<f64> {
        let mut largest = 0.0_f64;
        for _ in 0..MAX_NEWTON_STEPS {
            let projections = self.project(responses, &slip, tractions);
            let slides: Vec<_> = projections.iter().map(Option::is_some).collect();
            let switched = slides != self.slides;
            self.slides = slides;
            if switched || self.last_step > CHORD {
                self.factors = Some(self.matrix(responses, &projections).lu());
            }
            let step =
                self.factors.as_ref()?.solve(&self.residual(&projections, &slip, tractions))?;
            self.move_by(&step, responses, &mut slip, tractions);
            self.last_step = step.amax();
            largest = largest.max(self.last_step);
            if !switched && self.last_step < 0.01 {
                break;
            }
        }
        Some(largest)
    }

    fn response(&self, responses: &Responses, cell: usize, by: usize) -> [f64; 3] {
        let bound = self.bounds[by];
        responses.in_row(self.first_column + cell, self.first_column + by).map(|r| bound * r)
    }

    fn weight(&self, responses: &Responses, cell: usize) -> f64 {
        let own = self.response(responses, cell, cell);
        WEIGHT / own[0].abs().max(own[2].abs())
    }

    fn project(
        &self,
        responses: &Responses,
        slip: &[[f64; 2]],
        tractions: &[Vec<f64>; 2],
    ) -> Vec<Projection> {
        let one = |cell: usize| {
            let weight = self.weight(responses, cell);
            let [p, q] = [0, 1].map(|k| tractions[k][self.first + cell] + weight * slip[cell][k]);
            let size = p.hypot(q);
            let [x, y] = [p / size, q / size];
            let by_trial = Matrix2::new(y * y, -x * y, -x * y, x * x) / size;
            (size > 1.0).then_some(([x, y], by_trial))
        };
        (0..self.bounds.len()).map(one).collect()
    }

    /// `slip' = 0` in adhesion, `traction - projection = 0` in slip; unknowns cell by cell.
    fn matrix(&self, responses: &Responses, projections: &[Projection]) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(2 * projections.len(), 2 * projections.len());
        for (cell, projection) in projections.iter().enumerate() {
            let weight = self.weight(responses, cell);
            for by in 0..projections.len() {
                let [xx, xy, yy] = self.response(responses, cell, by);
                let slip = Matrix2::new(xx, xy, xy, yy);
                let own = Matrix2::identity() * if cell == by { 1.0 } else { 0.0 };
                let block = match projection {
                    None => slip,
                    Some((_, by_trial)) => own - by_trial * (own + weight * slip),
                };
                matrix.fixed_view_mut::<2, 2>(2 * cell, 2 * by).copy_from(&block);
            }
        }
        matrix
    }

    fn residual(
        &self,
        projections: &[Projection],
        slip: &[[f64; 2]],
        tractions: &[Vec<f64>; 2],
    ) -> DVector<f64> {
        DVector::from_fn(2 * projections.len(), |row, _| match projections[row / 2] {
            None => -slip[row / 2][row % 2],
            Some((projected, _)) => projected[row % 2] - tractions[row % 2][self.first + row / 2],
        })
    }

    fn move_by(
        &self,
        step: &DVector<f64>,
        responses: &Responses,
        slip: &mut [[f64; 2]],
        tractions: &mut [Vec<f64>; 2],
    ) {
        for by in 0..slip.len() {
            let [x, y] = [step[2 * by], step[2 * by + 1]];
            tractions[0][self.first + by] += x;
            tractions[1][self.first + by] += y;
            for (cell, slip) in slip.iter_mut().enumerate() {
                let [xx, xy, yy] = self.response(responses, cell, by);
                slip[0] += xx * x + xy * y;
                slip[1] += xy * x + yy * y;
            }
        }
    }
}
