//! Room to solve one case on two grids, and a pool of such rooms.

use std::sync::{Mutex, PoisonError};

use super::extrapolation::{error_bar, extrapolate, extrapolate_force};
use super::grid::Grid;
use super::solver::{Equations, Outcome, State};
use crate::{Creepage, Force, Status};

/// The reflections that make `xi` and `chi` (or `eta`, without spin) positive: the contact has
/// the symmetries (4.22)-(4.28), and with these they hold to the last bit. The one that changes the
/// sign of `xi` turns all vectors about and leaves the pressure, and so exchanges unlike bodies.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Mirror {
    x: f64,
    y: f64,
}

impl Mirror {
    fn of(creepage: Creepage) -> Self {
        let negative = creepage.chi < 0.0 || (creepage.chi == 0.0 && creepage.eta < 0.0);
        let sign = |negative| if negative { -1.0 } else { 1.0 };
        Self { x: sign(creepage.xi < 0.0), y: sign(negative) }
    }

    fn creepage(self, creepage: Creepage) -> Creepage {
        Creepage {
            xi: self.x * creepage.xi,
            eta: self.y * creepage.eta,
            chi: self.y * creepage.chi,
        }
    }

    fn force(self, force: Force) -> Force {
        Force { fx: self.x * force.fx, fy: self.y * force.fy, mz: self.y * force.mz }
    }

    pub(super) fn vector(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.x * x, self.y * y]
    }

    pub(super) fn position(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x, self.x * self.y * y]
    }

    /// Whether positions change the sign of `y`.
    pub(super) fn flips(self) -> bool {
        self.x * self.y < 0.0
    }
}

/// What two grids give together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Totals {
    pub force: Force,
    pub error: Force,
    pub power: f64,
    pub dissipation: f64,
    pub status: Status,
    pub outcomes: [Outcome; 2],
}

/// The state of one grid.
#[derive(Debug, Clone, Default)]
struct Level {
    state: State,
    equations: Equations,
    outcome: Outcome,
}

/// The states of the coarser and the finer grid, in the mirror.
#[derive(Debug, Clone, Default)]
pub(super) struct Workspace {
    levels: [Level; 2],
    pub mirror: Mirror,
}

impl Workspace {
    fn new(grids: &[Grid; 2]) -> Self {
        let level = |grid: &Grid| Level {
            state: State::new(grid),
            equations: Equations::new(grid),
            outcome: Outcome::default(),
        };
        Self { levels: [level(&grids[0]), level(&grids[1])], mirror: Mirror::default() }
    }

    /// Solves from scratch, or from the tractions of the last case.
    pub(super) fn solve(&mut self, grids: &[Grid; 2], creepage: Creepage, warm: bool) {
        self.mirror = Mirror::of(creepage);
        let mirrored = self.mirror.creepage(creepage);
        for (level, grid) in self.levels.iter_mut().zip(grids) {
            grid.force(mirrored, self.mirror.x, &mut level.state.forcing);
        }
        let [coarse, fine] = &mut self.levels;
        if !warm {
            coarse.state.reset();
        }
        coarse.outcome = coarse.state.solve(&grids[0], &mut coarse.equations);
        if !warm {
            fine.state.refine(&grids[1], &coarse.state, &grids[0]);
        }
        fine.outcome = fine.state.solve(&grids[1], &mut fine.equations);
    }

    /// What the solved grids add up to.
    pub(super) fn totals(&self, grids: &[Grid; 2], creepage: Creepage) -> Totals {
        let sum = |k: usize| self.levels[k].state.sum(&grids[k], self.mirror.x);
        let (coarse, fine) = (sum(0), sum(1));
        let force = self.mirror.force(extrapolate_force(coarse.force, fine.force));
        let outcomes = [self.levels[0].outcome, self.levels[1].outcome];
        let converged = outcomes.iter().all(|outcome| outcome.converged);
        Totals {
            force,
            error: error_bar(coarse.force, fine.force, grids[1].mesh.len()),
            power: force.fx * creepage.xi
                + force.fy * creepage.eta
                + force.mz * creepage.chi
                + extrapolate(coarse.by_pressure, fine.by_pressure),
            dissipation: extrapolate(coarse.dissipation, fine.dissipation).max(0.0),
            status: if converged { Status::Solved } else { Status::NotConverged },
            outcomes,
        }
    }

    /// The derivative of the extrapolated force.
    pub(super) fn jacobian(&mut self, grids: &[Grid; 2]) -> [[f64; 3]; 3] {
        let [coarse, fine] = &mut self.levels;
        let coarse = coarse.equations.derivative(&grids[0], &coarse.state);
        let fine = fine.equations.derivative(&grids[1], &fine.state);
        let signs = [self.mirror.x, self.mirror.y, self.mirror.y];
        let mut matrix = [[0.0; 3]; 3];
        for k in 0..3 {
            let Force { fx, fy, mz } = extrapolate_force(coarse[k], fine[k]);
            for (i, value) in [fx, fy, mz].into_iter().enumerate() {
                matrix[i][k] = signs[i] * signs[k] * value;
            }
        }
        matrix
    }

    /// The state of the finer grid.
    pub(super) fn fine(&self) -> &State {
        &self.levels[1].state
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
