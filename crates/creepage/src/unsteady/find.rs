//! The creepage at which prescribed forces are met.

use nalgebra::{DMatrix, DVector};

use super::level::TransientLevel;
use super::motion::{Motion, Prescribed};

/// Largest difference from a prescribed force, in parts of `mu N`.
const TOLERANCE: f64 = 1e-7;
const STEPS: usize = 60;
const HALVINGS: usize = 30;

impl TransientLevel {
    /// Solves for a motion, from the creepage of the last solution where it is to be found.
    pub(super) fn meet(&mut self, motion: &Motion) -> bool {
        let prescribed = motion.components();
        let mut creep = self.creep;
        for (creep, prescribed) in creep.iter_mut().zip(prescribed) {
            *creep = prescribed.creepage().unwrap_or(*creep);
        }
        let mut converged = self.solve_at(creep);
        let unknown: Vec<_> = (0..3).filter(|k| prescribed[*k].force().is_some()).collect();
        if unknown.is_empty() {
            return converged;
        }
        if let [one] = unknown[..] {
            return self.meet_one(one, prescribed);
        }
        for _ in 0..STEPS {
            let residual = self.residual(&unknown, prescribed);
            if residual.amax() <= TOLERANCE {
                return converged;
            }
            let Some(step) = self.newton_step(&unknown, &residual) else { return false };
            let Some(next) = self.search(&unknown, prescribed, &step, residual.norm()) else {
                return false;
            };
            converged = next;
        }
        false
    }

    /// A single force rises with its creepage: Newton's steps, bisection where they leave the range in
    /// which the creepage must lie.
    fn meet_one(&mut self, unknown: usize, prescribed: [Prescribed; 3]) -> bool {
        let mut range = [f64::NEG_INFINITY, f64::INFINITY];
        for _ in 0..STEPS {
            let residual = self.residual(&[unknown], prescribed);
            if residual.amax() <= TOLERANCE {
                return self.outcome.converged;
            }
            let here = self.creep[unknown];
            range[usize::from(residual[0] < 0.0)] = here;
            let newton = self.newton_step(&[unknown], &residual).map(|step| here + step[0]);
            let [low, high] = range;
            let inside = newton.filter(|next| *next > low && *next < high);
            let mut creep = self.creep;
            creep[unknown] = inside.unwrap_or(match [low.is_finite(), high.is_finite()] {
                [true, true] => 0.5 * (low + high),
                // Sliding all over: further out.
                [true, false] => here + 2.0 * (here.abs() + 1.0),
                _ => here - 2.0 * (here.abs() + 1.0),
            });
            self.solve_at(creep);
        }
        false
    }

    /// Prescribed forces less those of the last solution, over the present `mu N`.
    fn residual(&self, unknown: &[usize], prescribed: [Prescribed; 3]) -> DVector<f64> {
        let (force, scale) = (self.own_force().components(), self.system.scale);
        let unit = [scale.powi(3), scale.powi(3), scale.powi(4)];
        let of = |k: &usize| prescribed[*k].force().unwrap_or(0.0) / unit[*k] - force[*k];
        DVector::from_iterator(unknown.len(), unknown.iter().map(of))
    }

    fn newton_step(&mut self, unknown: &[usize], residual: &DVector<f64>) -> Option<DVector<f64>> {
        let columns: Vec<_> = unknown.iter().map(|k| self.derivative(*k)).collect();
        let n = unknown.len();
        let matrix = DMatrix::from_fn(n, n, |i, k| columns[k][unknown[i]]);
        matrix.lu().solve(residual).filter(|step| step.iter().all(|s| s.is_finite()))
    }

    /// Of the force, by a component of the creepage.
    fn derivative(&mut self, component: usize) -> [f64; 3] {
        let Self { elements, grid, system, state, equations, .. } = self;
        let mut unit = [0.0; 3];
        unit[component] = 1.0;
        let slip = |element: usize| system.by_creep(elements, element, unit);
        equations.derivative_along(grid, state, slip, unit[2]).components()
    }

    /// The longest of the step's halves that comes nearer; whether the solution there converged.
    fn search(
        &mut self,
        unknown: &[usize],
        prescribed: [Prescribed; 3],
        step: &DVector<f64>,
        before: f64,
    ) -> Option<bool> {
        let from = self.creep;
        let mut length = 1.0;
        for _ in 0..HALVINGS {
            let mut creep = from;
            for (k, step) in unknown.iter().zip(step.iter()) {
                creep[*k] += length * step;
            }
            let converged = self.solve_at(creep);
            if self.residual(unknown, prescribed).norm() < before {
                return Some(converged);
            }
            length *= 0.5;
        }
        None
    }
}
