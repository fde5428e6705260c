//! From any tractions to those that obey friction.
//!
//! Sweeps come near: a sweep solves the friction problem of each strip with the other strips
//! held, for strips act on one another more weakly than elements of a strip do. Newton in all
//! strips at once ends it; where one of its steps must be shortened, a pair of sweeps comes first
//! again, but only in the first rounds: where sweeps swing between states, shortened steps go on.

mod equations;
mod gmres;
mod lu;
mod newton;
mod sweeps;

pub(crate) use equations::Equations;

use super::forcing::SlipForcing;
use super::friction::{Sliding, project};
use super::grid::Grid;
use super::influence::Tractions;
use super::quadrature::{Fields, Sum};
use lu::Lu;

/// Largest residual of friction's equation `p = P(p + r s)` in a solution, over the traction bound,
/// or over the creepage where that is smaller than one: then tractions are as small as the creepage.
const TOLERANCE: f64 = 1e-8;
/// Tractions so many times larger than the slip that drives them are no start: they are dropped.
const LARGEST_START: f64 = 1e6;
/// Slip whose square is lost to rounding counts as zero.
const SMALLEST_SLIP: f64 = 1e-140;
const ROUNDS: usize = 60;
/// Rounds in which Newton is left as soon as one of its steps must be shortened.
const ROUNDS_OF_FULL_STEPS: usize = 3;

/// How an iteration ended.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Outcome {
    pub converged: bool,
    pub sweeps: usize,
    /// Matrices of strips that were factored.
    pub factorizations: usize,
}

/// Tractions and slip of one grid, and the matrices that improve them.
#[derive(Debug, Clone, Default)]
pub(crate) struct State {
    /// What drives the slip, to be set before [`State::solve`].
    pub forcing: SlipForcing,
    pub traction: Tractions,
    slip: [Vec<f64>; 2],
    /// The sliding branch of the elements that slide, as last chosen.
    sliding: Vec<Option<Sliding>>,
    /// Newton's matrix of each strip, factored.
    factors: Vec<Lu>,
    /// Size of the last step with a strip's factors; infinite when they are of no use any more.
    last_step: Vec<f64>,
    /// Room for the change of a strip, `x` before `y`.
    step: Vec<f64>,
    factorizations: usize,
}

impl State {
    pub(crate) fn new(grid: &Grid) -> Self {
        let (n, strips) = (grid.mesh.len(), &grid.mesh.strips);
        let longest = strips.iter().map(super::mesh::Strip::len).max().unwrap_or(0);
        Self {
            forcing: SlipForcing::default(),
            traction: Tractions::zeros(&grid.influence),
            slip: [vec![0.0; n], vec![0.0; n]],
            sliding: vec![None; n],
            factors: strips.iter().map(|strip| Lu::new(2 * strip.len())).collect(),
            last_step: vec![f64::INFINITY; strips.len()],
            step: vec![0.0; 2 * longest],
            factorizations: 0,
        }
    }

    pub(crate) fn reset(&mut self) {
        self.traction.clear();
        self.sliding.fill(None);
        self.last_step.fill(f64::INFINITY);
    }

    /// Starts from the tractions of a grid with half the strips and half the elements in each.
    pub(crate) fn refine(&mut self, grid: &Grid, coarse: &Self, coarse_grid: &Grid) {
        self.reset();
        for strip in 0..grid.mesh.strips.len() {
            let (parents, own) = (coarse_grid.mesh.elements(strip / 2), grid.mesh.elements(strip));
            let n = own.len();
            for (i, element) in own.enumerate() {
                let parent = (parents.start + i / 2).min(parents.end - 1);
                self.sliding[element] = coarse.sliding[parent];
                let traction = coarse.traction.at(parent);
                self.step[i] = traction[0];
                self.step[n + i] = traction[1];
            }
            self.traction.add(strip, &self.step[..2 * n]);
        }
    }

    /// Improves the tractions until they obey friction at the slip that [`State::forcing`] causes.
    pub(crate) fn solve(&mut self, grid: &Grid, equations: &mut Equations) -> Outcome {
        let strips = grid.mesh.strips.len();
        let mut scale = self.forcing.largest();
        if scale < SMALLEST_SLIP {
            self.forcing.clear();
            scale = 0.0;
        }
        if self.traction.largest() > LARGEST_START * scale {
            self.reset();
        }
        let tolerance = TOLERANCE * scale.min(1.0);
        (equations.sweeps, self.factorizations) = (0, 0);
        for round in 1..=ROUNDS {
            for strip in (0..strips).chain((0..strips).rev()) {
                self.solve_strip(grid, strip, tolerance);
            }
            self.update_slip(grid, 0..grid.mesh.len());
            let full_steps_only = round <= ROUNDS_OF_FULL_STEPS;
            if self.newton(grid, equations, tolerance, full_steps_only) {
                return self.outcome(true, 2 * round + equations.sweeps);
            }
        }
        self.outcome(false, 2 * ROUNDS + equations.sweeps)
    }

    fn outcome(&self, converged: bool, sweeps: usize) -> Outcome {
        Outcome { converged, sweeps, factorizations: self.factorizations }
    }

    pub(crate) fn slides(&self, element: usize) -> bool {
        self.sliding[element].is_some()
    }

    pub(crate) fn slip(&self, element: usize) -> [f64; 2] {
        [self.slip[0][element], self.slip[1][element]]
    }

    pub(crate) fn fields<'a>(&'a self, grid: &'a Grid) -> Fields<'a> {
        Fields {
            places: &grid.places,
            traction: &self.traction.own,
            slip: &self.slip,
            spin: self.forcing.spin,
        }
    }

    /// Force and power; `side` is the sign of the pressure's part in the forcing.
    pub(crate) fn sum(&self, grid: &Grid, side: f64) -> Sum {
        let mut sum = Sum::default();
        for element in 0..grid.mesh.len() {
            grid.quadrature.add(self.fields(grid), element, self.slides(element), &mut sum);
            let ([x, y], [p, q]) = (self.traction.at(element), grid.pressure_slip[element]);
            sum.by_pressure += side * grid.pressure.shares[element] * (x * p + y * q);
        }
        sum
    }

    /// Frictional power of one element.
    pub(crate) fn power(&self, grid: &Grid, element: usize) -> f64 {
        let mut sum = Sum::default();
        grid.quadrature.add(self.fields(grid), element, self.slides(element), &mut sum);
        sum.dissipation
    }

    /// Computes the slip of some elements from the tractions.
    fn update_slip(&mut self, grid: &Grid, elements: impl Iterator<Item = usize>) {
        for element in elements {
            let driven = self.forcing.slip[element];
            let elastic = grid.influence.apply(element, &self.traction);
            self.slip[0][element] = driven[0] + elastic[0];
            self.slip[1][element] = driven[1] + elastic[1];
        }
    }

    /// Adhesion or slip for every element of a strip; true when one of them changed.
    fn choose_branches(&mut self, grid: &Grid, strip: usize) -> bool {
        let mut switched = false;
        for element in grid.mesh.elements(strip) {
            let (traction, slip) = (self.traction.at(element), self.slip(element));
            let sliding = project(traction, slip, grid.weights[element]);
            switched |= sliding.is_some() != self.slides(element);
            self.sliding[element] = sliding;
        }
        switched
    }

    /// The residual of an element's equations, right-hand side less left: `0 - slip` in adhesion,
    /// `projection - traction` in slip.
    fn residual(&self, element: usize) -> [f64; 2] {
        match self.sliding[element] {
            None => self.slip(element).map(|s| -s),
            Some(Sliding { traction: [x, y], .. }) => {
                let own = self.traction.at(element);
                [x - own[0], y - own[1]]
            }
        }
    }
}
