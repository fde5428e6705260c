//! What is known of a grid while its friction problem is solved.

use super::dense::Dense;
use super::friction::{Sliding, project};
use super::grid::Grid;
use super::sampling::{Fields, Sum};
use super::tractions::Tractions;
use super::unlike::Drive;
use crate::Creepage;

/// Tractions and slip of one grid, and the matrices that improve them.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub traction: Tractions,
    pub slip: [Vec<f64>; 2],
    /// The sliding branch of the elements that slide, as last looked at.
    pub sliding: Vec<Option<Sliding>>,
    /// Newton's matrix of each strip, factored.
    pub factors: Vec<Dense>,
    /// Size of the last step with a strip's factors; infinite when they are of no use any more.
    pub last_step: Vec<f64>,
    /// Room for the change of a strip, `x` before `y`.
    pub step: Vec<f64>,
}

impl State {
    pub(super) fn new(grid: &Grid) -> Self {
        let (n, along, strips) = (grid.elements.len(), grid.elements.along, grid.elements.strips);
        Self {
            traction: Tractions::zeros(grid),
            slip: [vec![0.0; n], vec![0.0; n]],
            sliding: vec![None; n],
            factors: vec![Dense::new(2 * along); strips],
            last_step: vec![f64::INFINITY; strips],
            step: vec![0.0; 2 * along],
        }
    }

    pub(super) fn reset(&mut self) {
        self.traction.clear();
        self.sliding.fill(None);
        self.last_step.fill(f64::INFINITY);
    }

    /// Starts from the tractions of a grid with half the elements along and across.
    pub(super) fn refine(&mut self, grid: &Grid, coarse: &Self) {
        self.reset();
        let along = grid.elements.along;
        for element in 0..grid.elements.len() {
            let parent = element / along / 2 * (along / 2) + element % along / 2;
            self.sliding[element] = coarse.sliding[parent];
            let traction = coarse.traction.at(parent);
            self.step[element % along] = traction[0];
            self.step[along + element % along] = traction[1];
            if element % along + 1 == along {
                self.traction.add(element / along, &self.step);
            }
        }
    }

    pub(super) fn slides(&self, element: usize) -> bool {
        self.sliding[element].is_some()
    }

    pub(super) fn fields<'a>(&'a self, grid: &'a Grid, creepage: Creepage) -> Fields<'a> {
        let Grid { elements, places, .. } = grid;
        Fields { elements, places, traction: &self.traction.own, slip: &self.slip, creepage }
    }

    /// Force and power as last solved.
    pub(super) fn sum(&self, grid: &Grid, drive: Drive) -> Sum {
        let mut sum = Sum::default();
        for element in 0..grid.elements.len() {
            let fields = self.fields(grid, drive.creepage);
            grid.sampling.add(fields, element, self.slides(element), &mut sum);
            let ([x, y], [p, q]) = (self.traction.at(element), grid.pressure_slip[element]);
            sum.by_pressure += drive.side * grid.elements.shares[element] * (x * p + y * q);
        }
        sum
    }

    /// Computes the slip of some elements from the tractions.
    pub(super) fn update_slip(
        &mut self,
        grid: &Grid,
        drive: Drive,
        elements: impl Iterator<Item = usize>,
    ) {
        for element in elements {
            let driven = grid.driven_slip(drive, element);
            let elastic = self.traction.slip(grid, element);
            self.slip[0][element] = driven[0] + elastic[0];
            self.slip[1][element] = driven[1] + elastic[1];
        }
    }

    pub(super) fn slip_of(&self, element: usize) -> [f64; 2] {
        [self.slip[0][element], self.slip[1][element]]
    }

    /// Adhesion or slip for every element of a strip; true when one of them changed.
    pub(super) fn choose_branches(&mut self, grid: &Grid, strip: usize) -> bool {
        let mut switched = false;
        for element in grid.elements.of_strip(strip) {
            let (traction, slip) = (self.traction.at(element), self.slip_of(element));
            let sliding = project(traction, slip, grid.weights[element]);
            switched |= sliding.is_some() != self.slides(element);
            self.sliding[element] = sliding;
        }
        switched
    }

    /// What the equations of an element lack: slip in adhesion, `traction - projection` in slip.
    pub(super) fn residual(&self, element: usize) -> [f64; 2] {
        match self.sliding[element] {
            None => self.slip_of(element).map(|s| -s),
            Some(Sliding { traction: [x, y], .. }) => {
                let own = self.traction.at(element);
                [x - own[0], y - own[1]]
            }
        }
    }

    /// Newton's matrix of a strip: `slip' = 0` in adhesion, `traction - projection = 0` in slip.
    /// False when it is singular.
    pub(super) fn factor(&mut self, grid: &Grid, strip: usize) -> bool {
        let along = grid.elements.along;
        for (i, element) in grid.elements.of_strip(strip).enumerate() {
            let (own, sign) = grid.own_strip(element);
            let (first, second) = self.factors[strip].two_rows(2 * i);
            let Some(Sliding { derivative: [dx, dy], .. }) = self.sliding[element] else {
                combine(first, [1.0, 0.0], own.xx, own.xy, own.yy, sign);
                combine(second, [0.0, 1.0], own.xx, own.xy, own.yy, sign);
                continue;
            };
            let weight = grid.weights[element];
            for (row, d, k) in [(first, dx, 0), (second, dy, 1)] {
                combine(row, d.map(|d| -weight * d), own.xx, own.xy, own.yy, sign);
                row[i] -= d[0];
                row[along + i] -= d[1];
                row[k * along + i] += 1.0;
            }
        }
        self.factors[strip].factor()
    }
}

/// `row = by_x * (slip in x) + by_y * (slip in y)`, by tractions `x` then `y` of the strip.
fn combine(row: &mut [f64], [by_x, by_y]: [f64; 2], xx: &[f64], xy: &[f64], yy: &[f64], sign: f64) {
    let along = xx.len();
    let (left, right) = row.split_at_mut(along);
    for k in 0..along {
        left[k] = by_x * xx[k] + sign * by_y * xy[k];
        right[k] = sign * by_x * xy[k] + by_y * yy[k];
    }
}
