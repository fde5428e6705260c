//! The derivative of the tractions by creepage and spin, from the equations that they solve.

use super::friction::Sliding;
use super::grid::Grid;
use super::linear::Linear;
use super::sampling::{Fields, Sum};
use super::state::State;
use crate::{Creepage, Force};

const ACCURACY: f64 = 1e-11;

/// Derivatives of `(fx, fy, mz)` by `xi`, `eta`, `chi`.
pub(super) type Columns = [Force; 3];

/// Differentiates a converged state: Newton's equations with the rigid slip's derivative on the
/// right.
pub(super) fn differentiate(
    grid: &Grid,
    state: &State,
    linear: &mut Linear,
    creepage: Creepage,
) -> Columns {
    let still = Creepage::default();
    let directions = [
        Creepage { xi: 1.0, ..still },
        Creepage { eta: 1.0, ..still },
        Creepage { chi: 1.0, ..still },
    ];
    directions.map(|direction| {
        for element in 0..grid.elements.len() {
            let right = right_side(grid, state, direction, element);
            linear.right[2 * element..2 * element + 2].copy_from_slice(&right);
        }
        linear.solve(grid, state, ACCURACY);
        for element in 0..grid.elements.len() {
            let rigid = grid.rigid_slip(direction, element);
            linear.slip[0][element] += rigid[0];
            linear.slip[1][element] += rigid[1];
        }
        change_of_force(grid, state, linear, [creepage, direction])
    })
}

/// The change of what an element's equations lack, by the rigid slip alone.
fn right_side(grid: &Grid, state: &State, direction: Creepage, element: usize) -> [f64; 2] {
    let slip = grid.rigid_slip(direction, element);
    match state.sliding[element] {
        None => slip.map(|s| -s),
        Some(Sliding { derivative, .. }) => {
            derivative.map(|[x, y]| grid.weights[element] * (x * slip[0] + y * slip[1]))
        }
    }
}

fn change_of_force(
    grid: &Grid,
    state: &State,
    linear: &Linear,
    [at, direction]: [Creepage; 2],
) -> Force {
    let fields = state.fields(grid, at);
    let change =
        Fields { traction: &linear.change.own, slip: &linear.slip, creepage: direction, ..fields };
    let mut sum = Sum::default();
    for element in 0..grid.elements.len() {
        grid.sampling.add_change([fields, change], element, state.slides(element), &mut sum);
    }
    sum.force
}
