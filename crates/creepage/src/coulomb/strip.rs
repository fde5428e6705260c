//! Newton in one strip, with the tractions of the others held.

use super::grid::Grid;
use super::state::State;
use super::unlike::Drive;

const STEPS: usize = 30;
/// Newton steps that are taken in full; later ones by half, for they swing between two states.
const EAGER: usize = 12;
/// Steps below this size leave a strip's factors good enough to use again.
const CHORD: f64 = 0.02;

impl State {
    /// Makes a strip obey friction; returns the largest change of a traction.
    pub(super) fn solve_strip(
        &mut self,
        grid: &Grid,
        drive: Drive,
        strip: usize,
        tolerance: f64,
    ) -> f64 {
        self.update_slip(grid, drive, grid.elements.of_strip(strip));
        let (mut change, mut last) = (0.0_f64, f64::INFINITY);
        for k in 0..STEPS {
            let switched = self.choose_branches(grid, strip);
            if (switched || self.last_step[strip] > CHORD) && !self.factor(grid, strip) {
                return f64::INFINITY;
            }
            let step = self.newton_step(grid, strip, if k < EAGER { 1.0 } else { 0.5 });
            self.last_step[strip] = step;
            change = change.max(step);
            let settled = !switched && step < 0.01 && step < 0.1 * last;
            if step <= tolerance || settled || !step.is_finite() {
                break;
            }
            last = step;
        }
        change
    }

    fn newton_step(&mut self, grid: &Grid, strip: usize, share: f64) -> f64 {
        for (i, element) in grid.elements.of_strip(strip).enumerate() {
            let rest = self.residual(element);
            self.step[2 * i] = share * rest[0];
            self.step[2 * i + 1] = share * rest[1];
        }
        self.factors[strip].solve(&mut self.step);
        self.traction.add(strip, &self.step);
        let (x, y) = self.step.split_at(grid.elements.along);
        for element in grid.elements.of_strip(strip) {
            let (own, sign) = grid.own_strip(element);
            let by = own.apply(sign, x, y);
            self.slip[0][element] += by[0];
            self.slip[1][element] += by[1];
        }
        let largest = self.step.iter().fold(0.0_f64, |largest, s| largest.max(s.abs()));
        if self.step.iter().all(|s| s.is_finite()) { largest } else { f64::INFINITY }
    }
}
