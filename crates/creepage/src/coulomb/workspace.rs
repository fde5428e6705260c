//! Workspace of one case: buffers on two grids, and a pool of them.

use std::sync::{Mutex, PoisonError};

use super::forcing::SlipForcing;
use super::friction_bound::FrictionBound;
use super::grid::Grid;
use super::quadrature::Sum;
use super::solver::{Equations, Outcome, State};
use crate::Force;
use crate::theory::{Solution, Statistics, Status};

/// Two solutions at one creepage are distinct if their forces differ by more than this part of `mu N`.
const DISTINCT_FORCES: f64 = 1e-3;

/// State of one grid.
#[derive(Debug, Clone, Default)]
struct GridState {
    state: State,
    equations: Equations,
    outcome: Outcome,
}

/// The states of the coarser and the finer grid.
#[derive(Debug, Clone, Default)]
pub(super) struct Workspace {
    levels: [GridState; 2],
}

impl Workspace {
    fn new(grids: &[Grid; 2]) -> Self {
        let level = |grid: &Grid| GridState {
            state: State::new(grid),
            equations: Equations::new(grid),
            outcome: Outcome::default(),
        };
        Self { levels: [level(&grids[0]), level(&grids[1])] }
    }

    /// Solves from scratch, or from the tractions of the last case; `force` sets what drives the
    /// slip of the coarser grid, 0, and of the finer, 1.
    pub(super) fn solve(
        &mut self,
        grids: &[Grid; 2],
        warm: bool,
        force: impl Fn(usize, &mut SlipForcing),
    ) {
        for (k, level) in self.levels.iter_mut().enumerate() {
            force(k, &mut level.state.forcing);
        }
        let [coarse, fine] = &mut self.levels;
        if !warm {
            coarse.state.reset();
        }
        coarse.outcome = coarse.state.solve(&grids[0], &mut coarse.equations);
        if !warm {
            fine.state.refine(&grids[1], &coarse.state);
        }
        fine.outcome = fine.state.solve(&grids[1], &mut fine.equations);
    }

    /// Has the next case start from the tractions of a like contact.
    pub(super) fn start_from(&mut self, tractions: &[Vec<[f64; 2]>; 2]) {
        for (level, tractions) in self.levels.iter_mut().zip(tractions) {
            level.state.start_from(tractions);
        }
    }

    /// What the tractions of each grid add up to; `side` is the sign of the pressure's part in what
    /// drives the slip.
    pub(super) fn sums(&self, grids: &[Grid; 2], side: f64) -> [Sum; 2] {
        [0, 1].map(|k| self.levels[k].state.sum(&grids[k], side))
    }

    /// Whether kinetic friction everywhere leads to another solution on the coarser grid; not where
    /// friction does not depend on the slip.
    pub(super) fn has_another(&self, grids: &[Grid; 2], side: f64) -> bool {
        let Some(lowest) = grids[0].resistance.as_ref().and_then(FrictionBound::lowest) else {
            return false;
        };
        let GridState { mut state, mut equations, .. } = self.levels[0].clone();
        state.reset_to(lowest);
        if !state.solve(&grids[0], &mut equations).converged {
            return false;
        }
        let [one, two] = [&self.levels[0].state, &state].map(|s| s.sum(&grids[0], side).force);
        let apart = one.components().into_iter().zip(two.components());
        apart.fold(0.0, |most: f64, (one, two)| most.max((one - two).abs())) > DISTINCT_FORCES
    }

    /// A force and its error bars, with the outcome and the cost of both grids.
    pub(super) fn solution(&self, force: Force, error: Force) -> Solution {
        let count = |of: fn(&Outcome) -> usize| self.levels.iter().map(|l| of(&l.outcome)).sum();
        let converged = self.levels.iter().all(|level| level.outcome.converged);
        Solution {
            force,
            error: Some(error),
            status: if converged { Status::Solved } else { Status::NotConverged },
            statistics: Statistics {
                iterations: count(|outcome| outcome.sweeps),
                factorizations: count(|outcome| outcome.factorizations),
            },
        }
    }

    /// Derivatives of the force of each grid by `xi`, `eta` and `chi`.
    pub(super) fn derivatives(&mut self, grids: &[Grid; 2]) -> [[Force; 3]; 2] {
        let [coarse, fine] = &mut self.levels;
        [
            coarse.equations.derivative(&grids[0], &coarse.state),
            fine.equations.derivative(&grids[1], &fine.state),
        ]
    }

    /// The states of the coarser and the finer grid.
    pub(super) fn states(&self) -> [&State; 2] {
        [&self.levels[0].state, &self.levels[1].state]
    }
}

/// Workspaces that are not in use; a clone has none.
#[derive(Debug, Default)]
pub(super) struct Pool(Mutex<Vec<Workspace>>);

impl Clone for Pool {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Pool {
    pub(super) fn take(&self, grids: &[Grid; 2]) -> Workspace {
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        kept.unwrap_or_else(|| Workspace::new(grids))
    }

    pub(super) fn give_back(&self, workspace: Workspace) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(workspace);
    }
}
