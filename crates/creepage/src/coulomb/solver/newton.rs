//! Newton's method: in one strip with the others held, and in all strips at once with a line search.

use super::{Equations, State};
use crate::coulomb::grid::Grid;
use crate::coulomb::influence::Precision;

/// Newton steps in a strip in one sweep, two or, on a long contact and from a step before, one: other strips change what drives it
/// before more are worth the matrices to be factored. After [`QUICK_ROUNDS`] there are as many as it takes.
const FEW_STEPS: [usize; 2] = [2, 1];
const MAX_STRIP_STEPS: usize = 30;
/// Rounds of sweeps with few steps.
const QUICK_ROUNDS: usize = 2;
/// Newton steps that are taken in full; later ones by half, for they swing between two states.
const FULL_STEPS: usize = 12;
/// Steps below this size leave a strip's factors good enough to use again.
const CHORD: f64 = 0.02;

impl State {
    /// Makes a strip and then its mirror image obey friction, in a round of sweeps.
    pub(super) fn solve_both(&mut self, grid: &Grid, strip: usize, tolerance: f64, round: usize) {
        let few = FEW_STEPS[usize::from(grid.is_long || (round == 0 && self.is_close))];
        let steps = if round < QUICK_ROUNDS { few } else { MAX_STRIP_STEPS };
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

const MAX_NEWTON_STEPS: usize = 20;
/// Largest and smallest forcing term of Eisenstat and Walker (1996), the relative accuracy of the
/// linear equations: nearer to the solution it pays to solve them better.
const FORCING_TERMS: [f64; 2] = [0.05, 1e-6];
/// Fraction of the residual allowed at the end that the linear equations may leave.
const FINAL_FRACTION: f64 = 0.3;
/// Floor of the GMRES tolerance in single precision: below it results differ between processors.
const FINEST_OF_SINGLE: f64 = 0.015;
/// A change of tractions up to so many times the residual allowed gives slip, in single precision, that is
/// wrong by a hundredth of that residual.
const SMALL: f64 = 1e5;
/// A strip is factored again if its last step was larger.
const STALE: f64 = 0.1;
/// Halvings of a step until it makes the tractions better.
const HALVINGS: usize = 5;
/// Before sweeps a whole step may make the residual so many times larger: what it spoils, elements on the
/// wrong side of the border of adhesion, sweeps mend, but short steps get nowhere.
const GROWTH: f64 = 10.0;

/// By how much friction is not obeyed, in parts of the bound: `traction - projection`.
#[derive(Debug, Clone, Copy, Default)]
struct Norms {
    /// Root of the sum of squares over all elements.
    total: f64,
    largest: f64,
}

impl State {
    /// Improves tractions that are near the solution, until a whole step does not make them better; the
    /// slip must be theirs. Whether they obey friction then.
    pub(super) fn newton(
        &mut self,
        grid: &Grid,
        equations: &mut Equations,
        tolerance: f64,
    ) -> bool {
        let [largest_term, smallest_term] = FORCING_TERMS;
        equations.clear();
        let mut residual = self.residual_after(grid, equations, 0.0);
        let mut term = largest_term;
        for _ in 0..MAX_NEWTON_STEPS {
            if !self.linearize(grid, equations) {
                break;
            }
            if residual.largest <= tolerance {
                return true;
            }
            let accuracy = term.max(FINAL_FRACTION * tolerance / residual.largest);
            equations.solve(grid, self, accuracy.max(FINEST_OF_SINGLE), self.precision);
            let is_small = equations.change.largest() <= SMALL * tolerance;
            equations.update_slip(grid, if is_small { self.precision } else { Precision::Double });
            let Some((length, next)) = self.search(grid, equations, residual) else { break };
            self.advance(equations, length);
            let fraction = next.total / residual.total;
            if length < 1.0 || fraction >= progress(1.0) {
                return false;
            }
            term = (0.5 * fraction.powi(2)).clamp(smallest_term, largest_term);
            residual = next;
        }
        self.last_step.fill(f64::INFINITY);
        false
    }

    /// Newton's equations at the present tractions; false when a strip's are singular.
    fn linearize(&mut self, grid: &Grid, equations: &mut Equations) -> bool {
        for strip in 0..grid.mesh.strips.len() {
            let switched = self.choose_branches(grid, strip);
            if (switched || self.last_step[strip] > STALE) && !self.factor(grid, strip) {
                return false;
            }
            self.last_step[strip] = 0.0;
        }
        for (element, right) in equations.right.chunks_exact_mut(2).enumerate() {
            right.copy_from_slice(&self.residual(element));
        }
        true
    }

    /// The whole step if it does not make the residual [`GROWTH`] times as large, else the longest of its
    /// halves that makes the tractions better; and the residual then.
    fn search(&self, grid: &Grid, equations: &Equations, residual: Norms) -> Option<(f64, Norms)> {
        let (mut length, mut largest) = (1.0, GROWTH);
        for _ in 0..=HALVINGS {
            let next = self.residual_after(grid, equations, length);
            if next.total < largest * residual.total {
                return Some((length, next));
            }
            length *= 0.5;
            largest = progress(length);
        }
        None
    }

    /// The residual after a step of some length.
    fn residual_after(&self, grid: &Grid, equations: &Equations, length: f64) -> Norms {
        let mut norms = Norms::default();
        for element in 0..grid.mesh.len() {
            let (t, s) = (self.traction.at(element), self.slip(element));
            let (dt, weight) = (equations.change.at(element), grid.weights[element]);
            let traction = [0, 1].map(|k| t[k] + length * dt[k]);
            let slip = [0, 1].map(|k| s[k] + length * equations.slip[k][element]);
            let trial = [0, 1].map(|k| traction[k] + weight * slip[k]);
            let [x, y] = match self.project(element, trial) {
                None => slip.map(|s| weight * s),
                Some(sliding) => [0, 1].map(|k| sliding.traction[k] - traction[k]),
            };
            norms.total += x * x + y * y;
            norms.largest = norms.largest.max(x * x + y * y);
        }
        norms = Norms { total: norms.total.sqrt(), largest: norms.largest.sqrt() };
        norms
    }

    fn advance(&mut self, equations: &Equations, length: f64) {
        self.traction.add_times(length, &equations.change);
        for (slip, change) in self.slip.iter_mut().zip(&equations.slip) {
            slip.iter_mut().zip(change).for_each(|(slip, change)| *slip += length * change);
        }
    }
}

/// The fraction of the residual that a step of some length must come below.
fn progress(length: f64) -> f64 {
    1.0 - 0.1 * length
}
