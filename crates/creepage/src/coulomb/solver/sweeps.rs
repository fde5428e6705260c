//! Newton in one strip, with the tractions of the others held.

use super::State;
use crate::coulomb::grid::Grid;

/// Newton steps in a strip in one sweep, two or, on a long contact, one: other strips change what drives it
/// before more are worth the matrices to be factored. After [`QUICK_ROUNDS`] there are as many as it takes.
const FEW_STEPS: [usize; 2] = [2, 1];
const STEPS: usize = 30;
/// Rounds of sweeps with few steps.
const QUICK_ROUNDS: usize = 2;
/// Newton steps that are taken in full; later ones by half, for they swing between two states.
const FULL_STEPS: usize = 12;
/// Steps below this size leave a strip's factors good enough to use again.
const CHORD: f64 = 0.02;

impl State {
    /// Makes a strip and then its mirror image obey friction, in a round of sweeps.
    pub(super) fn solve_both(&mut self, grid: &Grid, strip: usize, tolerance: f64, round: usize) {
        let few = FEW_STEPS[usize::from(grid.is_long)];
        let steps = if round < QUICK_ROUNDS { few } else { STEPS };
        self.update_slip(grid, self.precision, strip);
        self.solve_strip(grid, strip, tolerance, steps);
        if let Some(image) = grid.influence.image(strip) {
            let (x, y) = self.change.split_at(grid.mesh.elements(strip).len());
            grid.influence.image_block(image).add_slip([x, &y[..x.len()]], &mut self.slip);
            self.solve_strip(grid, image, tolerance, steps);
        }
        self.traction.fold(strip, self.precision);
    }

    /// Makes a strip obey friction, as far as `tolerance` or until it is as near as a sweep needs. Its
    /// slip does not follow the last step: other strips will change it.
    fn solve_strip(&mut self, grid: &Grid, strip: usize, tolerance: f64, steps: usize) {
        self.change.fill(0.0);
        let mut last = f64::INFINITY;
        for k in 0..steps {
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
            let (x, y) = self.step.split_at(grid.mesh.elements(strip).len());
            grid.influence.own_block(strip).add_slip([x, &y[..x.len()]], &mut self.slip);
            last = step;
        }
    }

    /// Takes a step, which it leaves in [`State::step`]; the largest change of a traction.
    fn newton_step(&mut self, grid: &Grid, strip: usize, length: f64) -> f64 {
        let elements = grid.mesh.elements(strip);
        let [mut step, mut ordered] = [&mut self.step, &mut self.ordered].map(std::mem::take);
        let residual = |i: usize| self.residual(elements.start + i).map(|r| length * r);
        let own = ..2 * elements.len();
        self.factors.0[strip].solve(residual, &mut ordered[own], &mut step[own]);
        (self.step, self.ordered) = (step, ordered);
        let step = &self.step[own];
        self.traction.add(strip, step);
        self.change.iter_mut().zip(step).for_each(|(sum, step)| *sum += step);
        let largest = step.iter().fold(0.0_f64, |largest, s| largest.max(s.abs()));
        if step.iter().all(|s| s.is_finite()) { largest } else { f64::INFINITY }
    }

    /// Newton's matrix of a strip. False when it is singular.
    pub(super) fn factor(&mut self, grid: &Grid, strip: usize) -> bool {
        self.factorizations += 1;
        self.factors.0[strip].factor(grid, strip, &self.sliding)
    }
}
