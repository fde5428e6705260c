//! Prescribed forces in a step: Newton's method in the creepage, by derivatives of the full theory with Broyden's
//! update, by differences for theories that have none.

use std::convert::Infallible;

use nalgebra::{DMatrix, DVector};

use super::history::Creep;
use super::level::TransientLevel;
use super::motion::{Motion, Prescribed};
use crate::coulomb::friction_bound::FrictionBound;
use crate::numerics::{NewtonLimits, broyden_update, largest_magnitude, newton};

/// Largest difference from a prescribed force, in parts of `mu N`.
const TOLERANCE: f64 = 1e-7;
/// Newton steps towards prescribed forces.
const MAX_NEWTON_STEPS: usize = 60;
/// Halvings of one of these steps.
const HALVINGS: usize = 30;
/// Step of the creepage for differences, over one and its size: forces are solved to a millionth of it.
const DIFFERENCE: f64 = 1e-3;
/// A step that leaves less than this part of the residual corrects the slope (Broyden); after any other the slope is
/// computed again.
const NEARER: f64 = 0.3;
/// Creepage, dimensionless, beyond which all slides and no force changes: one that is looked for there is not reached.
const FARTHEST: f64 = 1e6;
/// Newton steps by differences, and halvings of each.
const MAX_DIFFERENCE_STEPS: usize = 40;
const MAX_HALVINGS: usize = 40;

impl TransientLevel {
    /// Solves for a motion, from the creepage of the last solution where it is to be found.
    pub(super) fn solve_prescribed(&mut self, motion: &Motion) -> bool {
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
            return self.solve_one_prescribed(one, prescribed);
        }
        let mut slope = self.known_slope(&unknown);
        for _ in 0..MAX_NEWTON_STEPS {
            let residual = self.residual(&unknown, prescribed);
            if largest_magnitude(residual.as_slice()) <= TOLERANCE {
                if let Some(slope) = &slope {
                    self.keep_slope(&unknown, slope);
                }
                return converged;
            }
            let (is_new, matrix) = (slope.is_none(), slope.take());
            let mut matrix = matrix.unwrap_or_else(|| self.slope(&unknown));
            self.keep_slope(&unknown, &matrix);
            let before = self.creep;
            let step = matrix.clone().lu().solve(&residual);
            let step = step.filter(|step| step.iter().all(|s| s.is_finite()));
            // What earlier steps told of the slope is good for a whole step or for none.
            let halvings = if is_new { HALVINGS } else { 1 };
            let next = step.and_then(|step| {
                self.search(&unknown, prescribed, &step, (residual.norm(), halvings))
            });
            let Some(next) = next else {
                if is_new {
                    return false;
                }
                // What steps told of the slope misled: from there with the slope itself.
                converged = self.solve_at(before);
                continue;
            };
            converged = next;
            if unknown.iter().any(|k| self.creep[*k].abs() > FARTHEST) {
                return false;
            }
            let left = self.residual(&unknown, prescribed);
            if left.norm() < NEARER * residual.norm() {
                let of_unknown = |k: &usize| self.creep[*k] - before[*k];
                let moved = DVector::from_iterator(unknown.len(), unknown.iter().map(of_unknown));
                broyden_update(&mut matrix, &moved, &(residual - left));
                slope = Some(matrix);
            }
        }
        false
    }

    /// A single force rises with its creepage: Newton's steps, bisection where they leave the range in
    /// which the creepage must lie.
    fn solve_one_prescribed(&mut self, unknown: usize, prescribed: [Prescribed; 3]) -> bool {
        let mut range = [f64::NEG_INFINITY, f64::INFINITY];
        // The last creepage and what it left, where it came much nearer than the one before.
        let mut last: Option<[f64; 2]> = None;
        let mut known =
            self.known_slope(&[unknown]).map(|slope| slope[(0, 0)]).filter(|slope| *slope > 0.0);
        for _ in 0..MAX_NEWTON_STEPS {
            let residual = self.residual(&[unknown], prescribed);
            if largest_magnitude(residual.as_slice()) <= TOLERANCE {
                return self.outcome.converged;
            }
            let here = self.creep[unknown];
            if here.abs() > FARTHEST {
                return false;
            }
            range[usize::from(residual[0] < 0.0)] = here;
            let secant = last
                .filter(|[_, left]| residual[0].abs() < NEARER * left.abs())
                .map(|[before, left]| (left - residual[0]) / (here - before))
                .filter(|slope| slope.is_finite());
            let slope = secant.or(known.take()).unwrap_or_else(|| self.slope(&[unknown])[(0, 0)]);
            self.keep_slope(&[unknown], &DMatrix::from_element(1, 1, slope));
            last = Some([here, residual[0]]);
            let newton = Some(here + residual[0] / slope).filter(|next| next.is_finite());
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

    /// The slope as the last step has left it.
    fn known_slope(&self, unknown: &[usize]) -> Option<DMatrix<f64>> {
        let n = unknown.len();
        let slope = self.predictor.slope?;
        Some(DMatrix::from_fn(n, n, |i, k| slope[unknown[i]][unknown[k]]))
    }

    /// Keeps a slope for the next step.
    fn keep_slope(&mut self, unknown: &[usize], matrix: &DMatrix<f64>) {
        let mut slope = [[0.0; 3]; 3];
        for (i, row) in unknown.iter().enumerate() {
            for (k, column) in unknown.iter().enumerate() {
                slope[*row][*column] = matrix[(i, k)];
            }
        }
        self.predictor.slope = Some(slope);
    }

    /// Derivatives of the forces that are prescribed by the creepages that are sought.
    fn slope(&mut self, unknown: &[usize]) -> DMatrix<f64> {
        let yields = self.grid.resistance.as_ref().is_some_and(FrictionBound::yields);
        let columns: Vec<_> = if yields {
            unknown.iter().map(|k| self.difference(*k)).collect()
        } else {
            unknown.iter().map(|k| self.derivative(*k)).collect()
        };
        let n = unknown.len();
        DMatrix::from_fn(n, n, |i, k| columns[k][unknown[i]])
    }

    /// The same by a step of the creepage: what a layer bears changes with the slip, which derivatives within its
    /// limits do not see.
    fn difference(&mut self, component: usize) -> [f64; 3] {
        let (before, force) = (self.creep, self.own_force().components());
        let mut creep = before;
        let step = DIFFERENCE * (1.0 + creep[component].abs());
        creep[component] += step;
        self.solve_at(creep);
        let moved = self.own_force().components();
        self.solve_at(before);
        std::array::from_fn(|k| (moved[k] - force[k]) / step)
    }

    /// Of the force, by a component of the creepage.
    fn derivative(&mut self, component: usize) -> [f64; 3] {
        let Self { elements, grid, system, state, equations, .. } = self;
        let mut unit = [0.0; 3];
        unit[component] = 1.0;
        let slip = |element: usize| system.by_creep(elements, element, unit);
        equations.derivative_of_search(grid, state, slip, unit[2]).components()
    }

    /// The longest of the step's halves that comes nearer; whether the solution there converged.
    fn search(
        &mut self,
        unknown: &[usize],
        prescribed: [Prescribed; 3],
        step: &DVector<f64>,
        (before, halvings): (f64, usize),
    ) -> Option<bool> {
        let from = self.creep;
        let mut length = 1.0;
        for _ in 0..halvings {
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

/// Tolerance of a prescribed force, and the step of the creepage for its derivative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Accuracy {
    pub tolerance: f64,
    pub difference: f64,
}

/// Newton's method with differences and a line search: the last solution and whether it meets the
/// forces. Where that fails, far in full sliding where the force does not change, it starts again without
/// creepage: from below, steps along a force that saturates do not overshoot.
pub(super) fn solve_prescribed<T>(
    prescribed: [Prescribed; 3],
    start: Creep,
    accuracy: Accuracy,
    mut solve: impl FnMut(Creep) -> (T, [f64; 3]),
) -> (Creep, T, bool) {
    let mut from = |start: Creep| newton_by_differences(prescribed, start, accuracy, &mut solve);
    let found = from(start);
    let began_at_rest = start.iter().all(|part| *part == 0.0);
    if found.2 || began_at_rest { found } else { from([0.0; 3]) }
}

fn newton_by_differences<T>(
    prescribed: [Prescribed; 3],
    start: Creep,
    Accuracy { tolerance, difference }: Accuracy,
    mut solve: impl FnMut(Creep) -> (T, [f64; 3]),
) -> (Creep, T, bool) {
    let unknown: Vec<(usize, f64)> =
        (0..3).filter_map(|k| Some((k, prescribed[k].force()?))).collect();
    let creep = |at: &DVector<f64>| {
        let mut creep: Creep = [0, 1, 2].map(|k: usize| prescribed[k].creepage().unwrap_or(0.0));
        unknown.iter().zip(at).for_each(|((k, _), at)| creep[*k] = *at);
        creep
    };
    let over = |at: &DVector<f64>| -> Result<_, Infallible> {
        let (value, force) = solve(creep(at));
        let over = unknown.iter().map(|(k, wanted)| force[*k] - wanted);
        Ok((value, DVector::from_iterator(unknown.len(), over)))
    };
    let first = DVector::from_iterator(unknown.len(), unknown.iter().map(|(k, _)| start[*k]));
    let differences = DVector::from_element(unknown.len(), difference);
    let limits = NewtonLimits {
        tolerance,
        max_steps: MAX_DIFFERENCE_STEPS,
        max_halvings: MAX_HALVINGS,
        least_decrease: 0.0,
    };
    let Ok(found) = newton(first, &differences, limits, over);
    {
        let is_met = found.largest() <= tolerance;
        (creep(&found.at), found.value, is_met)
    }
}
