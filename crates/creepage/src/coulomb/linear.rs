//! Newton's equations of all strips at once, solved by sweeps over the strips.

use super::friction::Sliding;
use super::gmres::{Gmres, Part};
use super::grid::Grid;
use super::state::State;
use super::tractions::Tractions;

/// A change of all tractions, and the room to find it.
#[derive(Debug, Clone)]
pub(super) struct Linear {
    /// Right-hand side of the two equations of each element, interleaved.
    pub right: Vec<f64>,
    /// The solution, and the change of the slip by it.
    pub change: Tractions,
    pub slip: [Vec<f64>; 2],
    /// Sweeps since this was last set to zero.
    pub sweeps: usize,
    solution: Vec<f64>,
    /// What the equations of a strip lack.
    rest: Vec<f64>,
    gmres: Gmres,
}

impl Linear {
    pub(super) fn new(grid: &Grid) -> Self {
        let n = grid.elements.len();
        Self {
            right: vec![0.0; 2 * n],
            change: Tractions::zeros(grid),
            slip: [vec![0.0; n], vec![0.0; n]],
            sweeps: 0,
            solution: vec![0.0; 2 * n],
            rest: vec![0.0; 2 * grid.elements.along],
            gmres: Gmres::new(2 * n),
        }
    }

    /// Finds the change that a sweep moves by `accuracy` times what it moves no change at all.
    pub(super) fn solve(&mut self, grid: &Grid, state: &State, accuracy: f64) {
        let Self { right, change, slip, sweeps, solution, rest, gmres } = self;
        solution.fill(0.0);
        gmres.fixed_point(solution, accuracy, |part, from, to| {
            *sweeps += 1;
            change.copy_from(from);
            for strip in 0..grid.elements.strips {
                let right = if part == Part::Whole { Some(&*right) } else { None };
                lack(grid, state, change, strip, right, rest);
                state.factors[strip].solve(rest);
                change.add(strip, rest);
            }
            change.copy_to(to);
        });
        change.copy_from(solution);
        let [u, v] = slip;
        for (element, (u, v)) in u.iter_mut().zip(v).enumerate() {
            [*u, *v] = change.slip(grid, element);
        }
    }

    /// No change.
    pub(super) fn clear(&mut self) {
        self.change.clear();
        for slip in &mut self.slip {
            slip.fill(0.0);
        }
    }
}

/// Fills `rest` with what the equations of a strip lack.
fn lack(
    grid: &Grid,
    state: &State,
    change: &Tractions,
    strip: usize,
    right: Option<&Vec<f64>>,
    rest: &mut [f64],
) {
    for (i, element) in grid.elements.of_strip(strip).enumerate() {
        let left = left_side(grid, state, change, element);
        for k in 0..2 {
            rest[2 * i + k] = right.map_or(0.0, |right| right[2 * element + k]) - left[k];
        }
    }
}

/// Left-hand side of the equations of an element: the slip in adhesion, `traction - projection`
/// in slip, as in [`State::residual`].
fn left_side(grid: &Grid, state: &State, change: &Tractions, element: usize) -> [f64; 2] {
    let slip = change.slip(grid, element);
    let Some(Sliding { derivative, .. }) = state.sliding[element] else {
        return slip;
    };
    let (own, weight) = (change.at(element), grid.weights[element]);
    let trial = [own[0] + weight * slip[0], own[1] + weight * slip[1]];
    [0, 1].map(|k| own[k] - derivative[k][0] * trial[0] - derivative[k][1] * trial[1])
}
