//! Newton in one strip, with the tractions of the others held.

use super::State;
use crate::coulomb::friction::Sliding;
use crate::coulomb::grid::Grid;
use crate::coulomb::product::Row;

const STEPS: usize = 30;
/// Newton steps that are taken in full; later ones by half, for they swing between two states.
const FULL_STEPS: usize = 12;
/// Steps below this size leave a strip's factors good enough to use again.
const CHORD: f64 = 0.02;

impl State {
    /// Makes a strip and then its mirror image obey friction.
    pub(super) fn solve_both(&mut self, grid: &Grid, strip: usize, tolerance: f64) {
        self.update_slip(grid, self.precision, strip);
        self.solve_strip(grid, strip, tolerance);
        let Some(image) = grid.influence.image(strip) else { return };
        let (x, y) = self.change.split_at(grid.mesh.elements(strip).len());
        for element in grid.mesh.elements(image) {
            let (by_strip, sign) = grid.influence.image_block(image, element);
            let by = by_strip.apply(sign, x, &y[..x.len()]);
            self.slip[0][element] += by[0];
            self.slip[1][element] += by[1];
        }
        self.solve_strip(grid, image, tolerance);
    }

    /// Makes a strip obey friction, as far as `tolerance` or until it is as near as a sweep needs.
    fn solve_strip(&mut self, grid: &Grid, strip: usize, tolerance: f64) {
        self.change.fill(0.0);
        let mut last = f64::INFINITY;
        for k in 0..STEPS {
            let switched = self.choose_branches(grid, strip);
            if (switched || self.last_step[strip] > CHORD) && !self.factor(grid, strip) {
                return;
            }
            let step = self.newton_step(grid, strip, if k < FULL_STEPS { 1.0 } else { 0.5 });
            self.last_step[strip] = step;
            let settled = !switched && step < 0.01 && step < 0.1 * last;
            if step <= tolerance || settled || !step.is_finite() {
                return;
            }
            last = step;
        }
    }

    /// Takes a step; its largest change of a traction.
    fn newton_step(&mut self, grid: &Grid, strip: usize, length: f64) -> f64 {
        let elements = grid.mesh.elements(strip);
        let n = elements.len();
        for (i, element) in elements.clone().enumerate() {
            let residual = self.residual(element);
            self.step[2 * i] = length * residual[0];
            self.step[2 * i + 1] = length * residual[1];
        }
        let step = &mut self.step[..2 * n];
        self.factors[strip].solve(step);
        self.traction.add(strip, step);
        self.change.iter_mut().zip(&*step).for_each(|(sum, step)| *sum += step);
        let (x, y) = step.split_at(n);
        for element in elements {
            let (own, sign) = grid.influence.strip_block(element);
            let by = own.apply(sign, x, y);
            self.slip[0][element] += by[0];
            self.slip[1][element] += by[1];
        }
        let largest = step.iter().fold(0.0_f64, |largest, s| largest.max(s.abs()));
        if step.iter().all(|s| s.is_finite()) { largest } else { f64::INFINITY }
    }

    /// Newton's matrix of a strip: `slip' = 0` in adhesion, `traction - projection = 0` in slip.
    /// False when it is singular.
    pub(super) fn factor(&mut self, grid: &Grid, strip: usize) -> bool {
        self.factorizations += 1;
        let elements = grid.mesh.elements(strip);
        let n = elements.len();
        for (i, element) in elements.enumerate() {
            let (own, sign) = grid.influence.strip_block(element);
            let (first, second) = self.factors[strip].two_rows(2 * i);
            let Some(Sliding { derivative: [dx, dy], .. }) = self.sliding[element] else {
                combine(first, [1.0, 0.0], own, sign);
                combine(second, [0.0, 1.0], own, sign);
                continue;
            };
            let weight = grid.weights[element];
            for (row, d, k) in [(first, dx, 0), (second, dy, 1)] {
                combine(row, d.map(|d| -weight * d), own, sign);
                row[i] -= d[0];
                row[n + i] -= d[1];
                row[k * n + i] += 1.0;
            }
        }
        self.factors[strip].factor()
    }
}

/// `row = by_x * (slip in x) + by_y * (slip in y)`, by tractions `x` then `y` of the strip.
fn combine(row: &mut [f64], [by_x, by_y]: [f64; 2], own: Row, sign: f64) {
    let n = own.xx.len();
    let (left, right) = row.split_at_mut(n);
    for k in 0..n {
        left[k] = by_x * own.xx[k] + sign * by_y * own.xy[k];
        right[k] = sign * by_x * own.xy[k] + by_y * own.yy[k];
    }
}
