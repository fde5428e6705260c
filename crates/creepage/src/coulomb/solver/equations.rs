//! Newton's equations of all strips at once, solved by GMRES on sweeps over the strips; and the
//! derivative of the force by creepage and spin, which solves the same equations.

use super::State;
use crate::coulomb::friction::{Sliding, by_half_width};
use crate::coulomb::grid::Grid;
use crate::coulomb::influence::{Precision, Tractions};
use crate::coulomb::quadrature::{Fields, Sum};
use crate::numerics::gmres::{Gmres, Part};
use crate::{Creepage, Force};

/// Relative accuracy of a derivative in single precision, and how often it is found: at first, and then
/// for what double precision shows to be left. Together they leave less than 1e-10.
const ACCURACY: f64 = 1e-4;
const REFINEMENTS: usize = 3;
/// Once is enough for a search, whose steps are corrected by what they lead to.
const OF_SEARCH: usize = 1;

/// Newton's linear system: the change of all tractions, and work arrays.
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
    /// What refinements have found before.
    found: Vec<f64>,
    /// Room for the change of a strip, `x` before `y`, and for its unknowns in the order of its factors.
    step: Vec<f64>,
    ordered: Vec<f64>,
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
            found: vec![0.0; 2 * n],
            step: vec![0.0; 2 * n],
            ordered: vec![0.0; 2 * n],
            gmres: Gmres::new(2 * n),
        }
    }

    /// Finds the change that a sweep moves by `accuracy` times as much as it moves zero change.
    pub(super) fn solve(
        &mut self,
        grid: &Grid,
        state: &State,
        accuracy: f64,
        precision: Precision,
    ) {
        let Self { right, change, slip, sweeps, solution, step, ordered, gmres, .. } = self;
        solution.fill(0.0);
        let mut sweep = Sweep { grid, state, right, change, slip, step, ordered, precision };
        gmres.fixed_point(solution, accuracy, |part, from, to| {
            *sweeps += 1;
            sweep.change.copy_from(from);
            sweep.change.fold_all(precision);
            for strip in 0..grid.influence.strips() {
                sweep.solve_both(part, strip);
            }
            sweep.change.copy_to(to);
        });
        change.copy_from(solution);
    }

    /// Solves to the accuracy of derivatives: single precision takes half the time.
    fn solve_by_refinement(&mut self, grid: &Grid, state: &State, refinements: usize) {
        self.found.fill(0.0);
        for refinement in 1..=refinements {
            self.solve(grid, state, ACCURACY, Precision::Single);
            self.found.iter_mut().zip(&self.solution).for_each(|(sum, part)| *sum += part);
            if refinement < refinements {
                self.update_slip(grid, Precision::Double);
                self.leave_residual(grid, state);
            }
        }
        self.change.copy_from(&self.found);
        self.update_slip(grid, Precision::Double);
    }

    /// Takes from the right-hand side what the solution gives.
    fn leave_residual(&mut self, grid: &Grid, state: &State) {
        for (element, right) in self.right.chunks_exact_mut(2).enumerate() {
            let slip = [self.slip[0][element], self.slip[1][element]];
            let left = left_side(grid, state, self.change.at(element), slip, element);
            right.iter_mut().zip(left).for_each(|(right, left)| *right -= left);
        }
    }

    /// Computes the change of the slip by that of the tractions.
    pub(super) fn update_slip(&mut self, grid: &Grid, precision: Precision) {
        self.change.fold_all(precision);
        for strip in 0..grid.influence.strips() {
            grid.influence.slip(precision, strip, &self.change, &mut self.slip);
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
            self.derivative_along(grid, state, rigid, direction.chi, REFINEMENTS)
        })
    }

    /// Derivative of `(fx, fy, mz)` of a converged state by what changes the slip that drives each
    /// element by `slip` and the spin by `spin`, to some 1e-3: for searches.
    pub(crate) fn derivative_of_search(
        &mut self,
        grid: &Grid,
        state: &State,
        slip: impl Fn(usize) -> [f64; 2],
        spin: f64,
    ) -> Force {
        self.derivative_along(grid, state, slip, spin, OF_SEARCH)
    }

    fn derivative_along(
        &mut self,
        grid: &Grid,
        state: &State,
        slip: impl Fn(usize) -> [f64; 2],
        spin: f64,
        refinements: usize,
    ) -> Force {
        for (element, right) in self.right.chunks_exact_mut(2).enumerate() {
            let by_slip = by_rigid_slip(grid, state, slip(element), element);
            let by_spin = by_spin(grid, state, element);
            right.copy_from_slice(&[0, 1].map(|k| by_slip[k] + spin * by_spin[k]));
        }
        self.solve_by_refinement(grid, state, refinements);
        for element in 0..grid.mesh.len() {
            let own = slip(element);
            self.slip[0][element] += own[0];
            self.slip[1][element] += own[1];
        }
        self.change_of_force(grid, state, spin)
    }

    fn change_of_force(&self, grid: &Grid, state: &State, spin: f64) -> Force {
        let fields = state.fields();
        let (traction, slip) = (&self.change.own, &self.slip);
        let change = Fields { traction, slip, spin, ..fields };
        let mut sum = Sum::default();
        for element in 0..grid.mesh.len() {
            let slides = state.slides(element);
            grid.quadrature.add_change([fields, change], element, slides, &mut sum);
        }
        sum.force
    }
}

/// A sweep over the strips for the change of all tractions.
struct Sweep<'a> {
    grid: &'a Grid,
    state: &'a State,
    right: &'a [f64],
    change: &'a mut Tractions,
    slip: &'a mut [Vec<f64>; 2],
    step: &'a mut [f64],
    ordered: &'a mut [f64],
    precision: Precision,
}

impl Sweep<'_> {
    /// Solves the equations of a strip, and then of its mirror image.
    fn solve_both(&mut self, part: Part, strip: usize) {
        let Self { grid, precision, .. } = *self;
        grid.influence.slip(precision, strip, self.change, self.slip);
        self.solve(part, strip);
        if let Some(image) = grid.influence.image(strip) {
            let n = grid.mesh.elements(strip).len();
            let (x, y) = self.step[..2 * n].split_at(n);
            grid.influence.image_block(image).add_slip([x, y], self.slip);
            self.solve(part, image);
        }
        self.change.fold(strip, precision);
    }

    /// Solves the equations of a strip at the slip as it is.
    fn solve(&mut self, part: Part, strip: usize) {
        let Self { grid, state, right, change, slip, step, ordered, .. } = self;
        let elements = grid.mesh.elements(strip);
        let residual = |i: usize| {
            let element = elements.start + i;
            let slip = [slip[0][element], slip[1][element]];
            let left = left_side(grid, state, change.at(element), slip, element);
            match part {
                Part::Whole => [0, 1].map(|k| right[2 * element + k] - left[k]),
                Part::Linear => left.map(|left| -left),
            }
        };
        let step = &mut step[..2 * elements.len()];
        state.factors.0[strip].solve(residual, &mut ordered[..2 * elements.len()], step);
        change.add(strip, step);
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

/// The change of an element's residual with the spin, by which its adhesion gives way and the corner of
/// Coulomb's law is narrower, at constant slip.
fn by_spin(grid: &Grid, state: &State, element: usize) -> [f64; 2] {
    let Some(Sliding { derivative, .. }) = state.sliding[element] else {
        return [0.0; 2];
    };
    let [compliance, slope] = state.forcing.spin_compliance(element);
    let [x, y] = state.trial(grid, element);
    let [part, narrower] = grid.corner(state.forcing.spin);
    let wider = state.corner.half_width() * narrower / part;
    let by_corner = by_half_width(state.limits[element], compliance, [x, y], state.corner);
    [0, 1].map(|k| {
        let [by_x, by_y] = derivative[k];
        wider * by_corner[k] - slope / (1.0 + compliance) * (by_x * x + by_y * y)
    })
}

/// Left-hand side of the equations of an element by the change of its traction and slip: the slip in
/// adhesion, `traction - projection` in slip, as in [`State::residual`].
fn left_side(
    grid: &Grid,
    state: &State,
    own: [f64; 2],
    slip: [f64; 2],
    element: usize,
) -> [f64; 2] {
    let Some(Sliding { derivative, .. }) = state.sliding[element] else {
        return slip;
    };
    let weight = grid.weights[element];
    let trial = [own[0] + weight * slip[0], own[1] + weight * slip[1]];
    [0, 1].map(|k| own[k] - derivative[k][0] * trial[0] - derivative[k][1] * trial[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::mesh::Mesh;
    use crate::ellipse::Ellipse;

    /// Small, for a difference must not reach over the end of a rounded corner.
    const DIFFERENCE_STEP: f64 = 1e-5;

    fn force(grid: &Grid, [xi, eta, chi]: [f64; 3]) -> (State, Equations, Force) {
        let (mut state, mut equations) = (State::new(grid), Equations::new(grid));
        grid.set_forcing(Creepage::new(xi, eta, chi).unwrap(), 1.0, &mut state.forcing);
        assert!(state.solve_to(1e-11, grid, &mut equations).converged);
        let force = state.sum(grid, 1.0).force;
        (state, equations, force)
    }

    /// Central differences of the fourth order, over the largest derivative; 40 cases.
    #[test]
    fn the_derivative_is_that_of_the_force() {
        for (ratio, poisson) in [(0.3, 0.3), (1.0, 0.0), (1.0, 0.28), (4.0, 0.45)] {
            let ellipse = Ellipse::from_ratio(ratio).unwrap();
            let grid = Grid::hertz(ellipse, poisson, 0.0, Mesh::ellipse(ellipse, 10, 8));
            for k in 0..10 {
                let t = f64::from(k);
                let case = [(1.7 * t).sin(), 0.9 * (2.3 * t + 1.0).cos(), 2.5 * (0.9 * t).sin()];
                let (state, mut equations, _) = force(&grid, case);
                let derivative = equations.derivative(&grid, &state).map(|d| d.components());
                let largest = derivative.iter().flatten().fold(0.0, |m: f64, d| m.max(d.abs()));
                for column in 0..3 {
                    let at = |steps: f64| {
                        let mut moved = case;
                        moved[column] += DIFFERENCE_STEP * steps;
                        force(&grid, moved).2.components()
                    };
                    let [near, back, far, far_back] = [at(1.0), at(-1.0), at(2.0), at(-2.0)];
                    for row in 0..3 {
                        let difference = 8.0 * (near[row] - back[row]) - (far[row] - far_back[row]);
                        let apart = difference / (12.0 * DIFFERENCE_STEP) - derivative[column][row];
                        // Tractions solved to 1e-11 leave some 1e-12 in forces.
                        assert!(apart.abs() < 1e-6 * largest, "{case:?} {row} {column}: {apart:e}");
                    }
                }
            }
        }
    }

    /// What single precision leaves is found again: nothing of it is seen in the solution.
    #[test]
    fn refinement_is_as_good_as_double_precision() {
        let ellipse = Ellipse::from_ratio(0.6).unwrap();
        let grid = Grid::hertz(ellipse, 0.28, 0.0, Mesh::ellipse(ellipse, 24, 20));
        for case in [[0.5, 0.3, 0.4], [0.0, 0.8, -1.0], [1.0, -0.4, 3.0], [1e-6, 0.0, 0.0]] {
            let (state, mut equations, _) = force(&grid, case);
            let right: Vec<f64> = (0..grid.mesh.len())
                .flat_map(|element| by_rigid_slip(&grid, &state, grid.places[element], element))
                .collect();
            equations.right.clone_from(&right);
            equations.solve(&grid, &state, 1e-13, Precision::Double);
            equations.update_slip(&grid, Precision::Double);
            let expected = equations.slip.clone();
            equations.right.clone_from(&right);
            equations.solve_by_refinement(&grid, &state, REFINEMENTS);
            let largest = expected.iter().flatten().fold(0.0, |m: f64, s| m.max(s.abs()));
            for (found, expected) in equations.slip.iter().flatten().zip(expected.iter().flatten())
            {
                // Three rounds to 1e-4 each, over a condition number of some tens.
                assert!((found - expected).abs() < 1e-10 * largest, "{case:?}: {found} {expected}");
            }
        }
    }
}
