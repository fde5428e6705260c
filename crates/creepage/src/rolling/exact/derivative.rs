//! The derivative of the tractions by creepage and spin, from the equations that they solve.

use super::grid::Grid;
use super::sampling::{Fields, Sum};
use super::solve::State;
use crate::rolling::{Creepage, Force};

/// Change in the last sweep over the largest change of a traction.
const TOLERANCE: f64 = 1e-11;
const SWEEPS: usize = 200;

/// Derivatives of `(fx, fy, mz)` by `xi`, `eta`, `chi`.
pub(super) type Columns = [Force; 3];

/// Differentiates a converged state: Newton's equations with the rigid slip's derivative on the
/// right, solved by the same sweeps as the state itself.
pub(super) fn differentiate(grid: &Grid, state: &mut State, creepage: Creepage) -> Columns {
    let directions = [
        Creepage { xi: 1.0, ..ZERO },
        Creepage { eta: 1.0, ..ZERO },
        Creepage { chi: 1.0, ..ZERO },
    ];
    for strip in 0..grid.elements.strips {
        state.factor(grid, strip);
    }
    directions.map(|direction| {
        let mut tangent = Tangent::new(grid);
        tangent.solve(grid, state, direction);
        tangent.force(grid, state, [creepage, direction])
    })
}

const ZERO: Creepage = Creepage { xi: 0.0, eta: 0.0, chi: 0.0 };

/// The derivative of the tractions in one direction.
struct Tangent {
    traction: [Vec<f64>; 2],
    slip: [Vec<f64>; 2],
    mirrored: [Vec<f64>; 2],
    rest: Vec<f64>,
}

impl Tangent {
    fn new(grid: &Grid) -> Self {
        let zeros = || [vec![0.0; grid.elements.len()], vec![0.0; grid.elements.len()]];
        Self {
            traction: zeros(),
            slip: zeros(),
            mirrored: zeros(),
            rest: vec![0.0; 2 * grid.elements.along],
        }
    }

    fn solve(&mut self, grid: &Grid, state: &State, direction: Creepage) {
        let strips = grid.elements.strips;
        for sweep in 0..SWEEPS {
            let mut change = 0.0_f64;
            for turn in 0..strips {
                let strip = if sweep % 2 == 0 { turn } else { strips - 1 - turn };
                change = change.max(self.sweep_strip(grid, state, direction, strip));
            }
            let size = self.traction.iter().flatten().fold(0.0_f64, |m, t| m.max(t.abs()));
            if change <= TOLERANCE * size {
                return;
            }
        }
    }

    fn sweep_strip(
        &mut self,
        grid: &Grid,
        state: &State,
        direction: Creepage,
        strip: usize,
    ) -> f64 {
        let along = grid.elements.along;
        let start = strip * along;
        for i in 0..along {
            let rest = self.residual(grid, state, direction, start + i);
            self.rest[2 * i] = rest[0];
            self.rest[2 * i + 1] = rest[1];
        }
        state.solve_linear(strip, &mut self.rest);
        let mirrored = (grid.elements.strips - 1 - strip) * along;
        let mut largest = 0.0_f64;
        for k in 0..2 {
            for i in 0..along {
                let step = self.rest[k * along + i];
                self.traction[k][start + i] += step;
                self.mirrored[k][mirrored + i] = self.traction[k][start + i];
                largest = largest.max(step.abs());
            }
        }
        largest
    }

    fn slip_of(&self, grid: &Grid, direction: Creepage, element: usize) -> [f64; 2] {
        let (row, sign) = grid.row(element);
        let [x, y] = if sign > 0.0 { &self.traction } else { &self.mirrored };
        let rigid = grid.rigid_slip(direction, element);
        let elastic = row.apply(sign, x, y);
        [rigid[0] + elastic[0], rigid[1] + elastic[1]]
    }

    fn force(&mut self, grid: &Grid, state: &State, [at, direction]: [Creepage; 2]) -> Force {
        for element in 0..grid.elements.len() {
            let slip = self.slip_of(grid, direction, element);
            self.slip[0][element] = slip[0];
            self.slip[1][element] = slip[1];
        }
        let change = Fields { traction: &self.traction, slip: &self.slip, creepage: direction };
        let mut sum = Sum::default();
        for element in 0..grid.elements.len() {
            let fields = [state.fields(at), change];
            grid.sampling.add_change(grid, fields, element, state.slides[element], &mut sum);
        }
        sum.force
    }

    fn residual(
        &self,
        grid: &Grid,
        state: &State,
        direction: Creepage,
        element: usize,
    ) -> [f64; 2] {
        let slip = self.slip_of(grid, direction, element);
        let (Some(sliding), weight) = state.friction(grid, element) else {
            return [-slip[0], -slip[1]];
        };
        let own = [self.traction[0][element], self.traction[1][element]];
        let trial = [own[0] + weight * slip[0], own[1] + weight * slip[1]];
        [0, 1].map(|k| {
            let [x, y] = sliding.derivative[k];
            x * trial[0] + y * trial[1] - own[k]
        })
    }
}
