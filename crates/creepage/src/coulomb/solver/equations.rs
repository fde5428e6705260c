//! Newton's equations of all strips at once, solved by GMRES on sweeps over the strips; and the
//! derivative of the force by creepage and spin, which solves the same equations.

use super::State;
use super::gmres::{Gmres, Part};
use crate::coulomb::friction::Sliding;
use crate::coulomb::grid::Grid;
use crate::coulomb::influence::Tractions;
use crate::coulomb::quadrature::{Fields, Sum};
use crate::{Creepage, Force};

/// Relative accuracy of derivatives.
const ACCURACY: f64 = 1e-11;

/// A change of all tractions, and the room to find it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Equations {
    /// Right-hand side of the two equations of each element, interleaved.
    pub(super) right: Vec<f64>,
    /// The solution, and the change of the slip by it.
    pub(super) change: Tractions,
    pub(super) slip: [Vec<f64>; 2],
    /// Sweeps since this was last set to zero.
    pub(super) sweeps: usize,
    solution: Vec<f64>,
    /// Residual of a strip.
    residual: Vec<f64>,
    gmres: Gmres,
}

impl Equations {
    pub(crate) fn new(grid: &Grid) -> Self {
        let n = grid.mesh.len();
        Self {
            right: vec![0.0; 2 * n],
            change: Tractions::zeros(&grid.influence),
            slip: [vec![0.0; n], vec![0.0; n]],
            sweeps: 0,
            solution: vec![0.0; 2 * n],
            residual: vec![0.0; 2 * n],
            gmres: Gmres::new(2 * n),
        }
    }

    /// Finds the change that a sweep moves by `accuracy` times as much as it moves zero change.
    pub(super) fn solve(&mut self, grid: &Grid, state: &State, accuracy: f64) {
        let Self { right, change, slip, sweeps, solution, residual, gmres } = self;
        solution.fill(0.0);
        gmres.fixed_point(solution, accuracy, |part, from, to| {
            *sweeps += 1;
            change.copy_from(from);
            for strip in 0..grid.mesh.strips.len() {
                let right = if part == Part::Whole { Some(&*right) } else { None };
                let residual = &mut residual[..2 * grid.mesh.elements(strip).len()];
                residual_of(grid, state, change, strip, right, residual);
                state.factors[strip].solve(residual);
                change.add(strip, residual);
            }
            change.copy_to(to);
        });
        change.copy_from(solution);
        let [u, v] = slip;
        for (element, (u, v)) in u.iter_mut().zip(v).enumerate() {
            [*u, *v] = grid.influence.apply(element, change);
        }
    }

    /// Sets the change to zero.
    pub(super) fn clear(&mut self) {
        self.change.clear();
        for slip in &mut self.slip {
            slip.fill(0.0);
        }
    }

    /// Derivatives of `(fx, fy, mz)` of a converged state by `xi`, `eta` and `chi`.
    pub(crate) fn derivative(&mut self, grid: &Grid, state: &State) -> [Force; 3] {
        let zero = Creepage::default();
        let directions = [
            Creepage { xi: 1.0, ..zero },
            Creepage { eta: 1.0, ..zero },
            Creepage { chi: 1.0, ..zero },
        ];
        directions.map(|direction| {
            let rigid = |element: usize| direction.rigid_slip(grid.places[element]);
            for (element, right) in self.right.chunks_exact_mut(2).enumerate() {
                right.copy_from_slice(&by_rigid_slip(grid, state, rigid(element), element));
            }
            self.solve(grid, state, ACCURACY);
            for element in 0..grid.mesh.len() {
                let rigid = rigid(element);
                self.slip[0][element] += rigid[0];
                self.slip[1][element] += rigid[1];
            }
            self.change_of_force(grid, state, direction)
        })
    }

    fn change_of_force(&self, grid: &Grid, state: &State, direction: Creepage) -> Force {
        let fields = state.fields(grid);
        let (traction, slip) = (&self.change.own, &self.slip);
        let change = Fields { traction, slip, spin: direction.chi, ..fields };
        let mut sum = Sum::default();
        for element in 0..grid.mesh.len() {
            let slides = state.slides(element);
            grid.quadrature.add_change([fields, change], element, slides, &mut sum);
        }
        sum.force
    }
}

/// The change of an element's residual with its rigid slip, at constant tractions.
fn by_rigid_slip(grid: &Grid, state: &State, slip: [f64; 2], element: usize) -> [f64; 2] {
    match state.sliding[element] {
        None => slip.map(|s| -s),
        Some(Sliding { derivative, .. }) => {
            derivative.map(|[x, y]| grid.weights[element] * (x * slip[0] + y * slip[1]))
        }
    }
}

/// Fills `residual` with that of a strip's equations.
fn residual_of(
    grid: &Grid,
    state: &State,
    change: &Tractions,
    strip: usize,
    right: Option<&Vec<f64>>,
    residual: &mut [f64],
) {
    for (i, element) in grid.mesh.elements(strip).enumerate() {
        let left = left_side(grid, state, change, element);
        for k in 0..2 {
            residual[2 * i + k] = right.map_or(0.0, |right| right[2 * element + k]) - left[k];
        }
    }
}

/// Left-hand side of the equations of an element: the slip in adhesion, `traction - projection`
/// in slip, as in [`State::residual`].
fn left_side(grid: &Grid, state: &State, change: &Tractions, element: usize) -> [f64; 2] {
    let slip = grid.influence.apply(element, change);
    let Some(Sliding { derivative, .. }) = state.sliding[element] else {
        return slip;
    };
    let (own, weight) = (change.at(element), grid.weights[element]);
    let trial = [own[0] + weight * slip[0], own[1] + weight * slip[1]];
    [0, 1].map(|k| own[k] - derivative[k][0] * trial[0] - derivative[k][1] * trial[1])
}
