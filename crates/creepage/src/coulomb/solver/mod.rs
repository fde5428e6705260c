//! The tangential solver: block Gauss-Seidel over strips, then semismooth Newton with GMRES.
//!
//! Sweeps come near: a sweep solves the friction problem of each strip with the other strips
//! held, for strips act on one another more weakly than elements of a strip do. Newton in all
//! strips at once ends it; where one of its steps does not make the tractions better, sweeps come first
//! again, more of them each time.

mod equations;
mod newton;
mod strip_factors;

pub(crate) use equations::Equations;

use super::forcing::SlipForcing;
use super::friction::{Regularization, Sliding, project_within};
use super::friction_bound::MIN_BOUND;
use super::grid::Grid;
use super::influence::{Precision, Tractions};
use super::quadrature::{Fields, Sum};
use crate::Force;
use crate::numerics::anderson::AndersonAcceleration;
use strip_factors::Factors;

/// Largest residual of friction's equation `p = P(p + r s)` in a solution, over the traction bound,
/// or over the creepage where that is smaller than one: then tractions are as small as the creepage.
const TOLERANCE: f64 = 1e-6;
/// A warm start whose tractions exceed the rigid slip so many times is discarded.
const LARGEST_START: f64 = 1e6;
/// Slip whose square is lost to rounding counts as zero.
const SMALLEST_SLIP: f64 = 1e-140;
/// Below this slip, single precision loses tractions of its size.
const SMALLEST_SINGLE: f64 = 1e-20;
/// Rounds of sweeps and Newton until the regularization changes: at first, and from a close warm start.
const ROUNDS: [usize; 2] = [5, 3];
/// Width of the narrow monotone regularization, over the full width: its bias is small.
const NARROW: f64 = 0.125;
/// Continuation in the rigid slip: multiples of it whose solutions are warm starts where elements much shorter than
/// their strips are wide make sweeps oscillate (less so the more of the contact slides). Powers of two: no rounding.
const MORE_SLIP: [f64; 2] = [4.0, 2.0];

/// Largest change of a limit, over that at rest, in a solution.
const BOUND_TOLERANCE: f64 = 1e-7;
/// Most steps of the fixed-point iteration for friction bounds that depend on slip.
const MAX_BOUND_ROUNDS: usize = 120;
/// Largest residual of tractions between one set of limits and the next, which amplify it.
const FIXED_POINT_TOLERANCE: f64 = 1e-8;
/// Below this change of the limits steps are mixed; before, each is taken as it is: from friction at
/// rest the limits fall step by step towards the first solution, which mixed steps might pass.
const MIXING_BELOW: f64 = 0.02;
/// Steps after which they are mixed in any case.
const MAX_PLAIN_ROUNDS: usize = 40;

/// Outcome of an iteration.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Outcome {
    pub converged: bool,
    pub sweeps: usize,
    /// Matrices of strips that were factored.
    pub factorizations: usize,
}

/// State of the iteration on one grid: tractions, slip, and the factored matrices.
#[derive(Debug, Clone, Default)]
pub(crate) struct State {
    /// What drives the slip, to be set before [`State::solve`].
    pub forcing: SlipForcing,
    pub traction: Tractions,
    slip: [Vec<f64>; 2],
    /// The largest traction that each element bears, over its bound at rest.
    pub(crate) limits: Vec<f64>,
    /// The sliding branch of the elements that slide, as last chosen.
    sliding: Vec<Option<Sliding>>,
    /// Newton's matrix of each strip, factored.
    factors: Factors,
    /// Size of the last step with a strip's factors; infinite when they are of no use any more.
    last_step: Vec<f64>,
    /// Room for the unknowns of a strip in the order of its factors.
    ordered: Vec<f64>,
    /// Room for the change of a strip, `x` before `y`, and for the sum of its changes.
    step: Vec<f64>,
    change: Vec<f64>,
    factorizations: usize,
    corner: Regularization,
    /// That of sweeps.
    precision: Precision,
    /// Whether the tractions are those of a step before: a first sweep need only wake the strips up.
    is_close: bool,
}

impl State {
    pub(crate) fn new(grid: &Grid) -> Self {
        let (n, strips) = (grid.mesh.len(), &grid.mesh.strips);
        let longest = strips.iter().map(super::mesh::Strip::len).max().unwrap_or(0);
        Self {
            forcing: SlipForcing::default(),
            traction: Tractions::zeros(&grid.influence),
            slip: [vec![0.0; n], vec![0.0; n]],
            limits: vec![1.0; n],
            sliding: vec![None; n],
            factors: Factors::new(&grid.mesh),
            last_step: vec![f64::INFINITY; strips.len()],
            ordered: vec![0.0; 2 * longest],
            step: vec![0.0; 2 * longest],
            change: vec![0.0; 2 * longest],
            factorizations: 0,
            corner: Regularization::default(),
            precision: Precision::Single,
            is_close: false,
        }
    }

    /// Improves the tractions until they obey friction at the slip that [`State::forcing`] causes;
    /// where friction depends on the slip, from the limits as they are.
    pub(crate) fn solve(&mut self, grid: &Grid, equations: &mut Equations) -> Outcome {
        let mut sum = self.solve_to(TOLERANCE, grid, equations);
        let Some(resistance) = &grid.resistance else { return sum };
        let (mut limits, mut mixing) = (self.limits.clone(), AndersonAcceleration::default());
        for round in 0..MAX_BOUND_ROUNDS {
            let slip = |element: usize| {
                let [x, y] = self.traction_and_slip(grid, element).1.unwrap_or_default();
                x.hypot(y)
            };
            resistance.limits(&grid.mesh, &grid.pressure.bounds, slip, &mut limits);
            let changes = limits.iter().zip(&self.limits).map(|(new, old)| (new - old).abs());
            let change = changes.fold(0.0, f64::max);
            if change <= BOUND_TOLERANCE {
                return sum;
            }
            if change < MIXING_BELOW || round >= MAX_PLAIN_ROUNDS || resistance.yields() {
                mixing.improve(&mut self.limits, &limits);
                self.limits.iter_mut().for_each(|limit| *limit = limit.clamp(MIN_BOUND, 1.0));
            } else {
                self.limits.copy_from_slice(&limits);
            }
            let resolved = self.solve_to(FIXED_POINT_TOLERANCE, grid, equations);
            sum.converged = resolved.converged;
            sum.sweeps += resolved.sweeps;
            sum.factorizations += resolved.factorizations;
        }
        Outcome { converged: false, ..sum }
    }

    /// Starts from no traction and the same limit, over that at rest, in every element.
    pub(crate) fn reset_to(&mut self, limit: f64) {
        self.reset();
        self.limits.fill(limit);
    }

    pub(crate) fn reset(&mut self) {
        self.is_close = false;
        self.traction.clear();
        self.limits.fill(1.0);
        self.sliding.fill(None);
        self.last_step.fill(f64::INFINITY);
    }

    /// Keeps the tractions as a start and forgets how they were found, so that what follows depends
    /// on them alone.
    pub(crate) fn keep_tractions_only(&mut self) {
        self.is_close = self.traction.largest() > 0.0;
        self.sliding.fill(None);
        self.last_step.fill(f64::INFINITY);
    }

    /// Starts from some tractions.
    pub(crate) fn start_from(&mut self, tractions: &[[f64; 2]]) {
        self.reset();
        self.traction.set(|element| tractions.get(element).copied().unwrap_or_default());
    }

    /// Starts from the tractions of the coarser grid.
    pub(crate) fn refine(&mut self, grid: &Grid, coarse: &Self) {
        self.reset();
        for (limit, from) in self.limits.iter_mut().zip(&grid.coarser) {
            *limit = from.iter().map(|(from, weight)| weight * coarse.limits[*from]).sum();
        }
        self.traction.set(|element| {
            let mut sum = [0.0; 2];
            for (from, weight) in grid.coarser[element] {
                let [x, y] = coarse.traction.at(from);
                sum = [sum[0] + weight * x, sum[1] + weight * y];
            }
            sum
        });
    }

    /// Improves the tractions until they obey friction within the limits of the elements.
    pub(crate) fn solve_to(
        &mut self,
        tolerance: f64,
        grid: &Grid,
        equations: &mut Equations,
    ) -> Outcome {
        // Where bodies press on one another anew at each step, the contact loses its symmetry and has it again.
        self.traction.match_symmetry(&grid.influence);
        equations.change.match_symmetry(&grid.influence);
        let mut scale = self.forcing.largest();
        if scale < SMALLEST_SLIP {
            self.forcing.clear();
            scale = 0.0;
        }
        if self.traction.largest() > LARGEST_START * scale {
            self.reset();
        }
        let tolerance = tolerance * scale.min(1.0);
        self.precision =
            if scale > SMALLEST_SINGLE { Precision::Single } else { Precision::Double };
        (equations.sweeps, self.factorizations) = (0, 0);
        let converged = self.iterate(tolerance, grid, equations);
        Outcome { converged, sweeps: equations.sweeps, factorizations: self.factorizations }
    }

    /// If Newton's method stagnates, continue in the regularization (unbiased, monotone, narrow), then in the rigid
    /// slip. On a long contact the unbiased one stagnates too often, and the narrow monotone one comes first.
    fn iterate(&mut self, tolerance: f64, grid: &Grid, equations: &mut Equations) -> bool {
        let [many, few] = ROUNDS;
        let [part, _] = grid.corner(self.forcing.spin);
        let rounding = part * grid.rounding;
        let mut run_rounds = |state: &mut Self, corner: Regularization, rounds: usize| {
            state.corner = corner;
            state.run_rounds(rounds, tolerance, grid, equations)
        };
        let unbiased = Regularization::Unbiased(rounding);
        let [wide, narrow] = [1.0, NARROW].map(|part| Regularization::Monotone(part * rounding));
        if (grid.is_long && run_rounds(self, narrow, many))
            || run_rounds(self, unbiased, many)
            || (run_rounds(self, wide, many)
                && (run_rounds(self, unbiased, few) || run_rounds(self, narrow, many)))
        {
            return true;
        }
        for times in MORE_SLIP {
            self.forcing.scale(times);
            run_rounds(self, unbiased, few);
            self.forcing.scale(times.recip());
        }
        run_rounds(self, unbiased, few)
    }

    /// Rounds of sweeps and Newton; whether the residual meets the tolerance then. Round `k` does `2 k + 1` pairs of
    /// sweeps, from tractions of a step before the first a single one: a failed Newton costs as much as ten sweeps.
    fn run_rounds(
        &mut self,
        rounds: usize,
        tolerance: f64,
        grid: &Grid,
        equations: &mut Equations,
    ) -> bool {
        (0..rounds).any(|round| {
            let pairs = 2 * round + 1;
            self.traction.fold_all(self.precision);
            if round == 0 && self.is_close {
                for strip in 0..grid.influence.strips() {
                    self.solve_both(grid, strip, tolerance, round);
                }
                equations.sweeps += 1;
            } else {
                for _ in 0..pairs {
                    self.sweep_both_ways(grid, tolerance, round);
                }
                equations.sweeps += 2 * pairs;
            }
            self.traction.fold_all(Precision::Double);
            for strip in 0..grid.influence.strips() {
                self.update_slip(grid, Precision::Double, strip);
            }
            self.newton(grid, equations, tolerance)
        })
    }

    /// A pair of sweeps in one round of them.
    fn sweep_both_ways(&mut self, grid: &Grid, tolerance: f64, round: usize) {
        let strips = grid.influence.strips();
        for strip in (0..strips).chain((0..strips).rev()) {
            self.solve_both(grid, strip, tolerance, round);
        }
    }

    /// Whether an element's corner of Coulomb's law, rounded as it is, is passed, or its adhesion gives way.
    pub(crate) fn slides(&self, element: usize) -> bool {
        self.sliding[element].is_some()
    }

    /// Whether an element is below the corner.
    fn holds(&self, element: usize) -> bool {
        self.sliding[element].is_none_or(|sliding| sliding.holds)
    }

    /// Coulomb's law of an element with the corner as it is.
    fn project(&self, element: usize, trial: [f64; 2]) -> Option<Sliding> {
        let [compliance, _] = self.forcing.spin_compliance(element);
        project_within(self.limits[element], compliance, trial, self.corner)
    }

    /// Traction and slip of an element by Coulomb's law without its corner rounded: those with the
    /// same sum. `None` for the slip in adhesion.
    pub(crate) fn traction_and_slip(
        &self,
        grid: &Grid,
        element: usize,
    ) -> ([f64; 2], Option<[f64; 2]>) {
        let trial = self.trial(grid, element);
        let Some(Sliding { traction, .. }) =
            project_within(self.limits[element], 0.0, trial, Regularization::Sharp)
        else {
            return (trial, None);
        };
        let weight = grid.weights[element];
        (traction, Some([0, 1].map(|k| (trial[k] - traction[k]) / weight)))
    }

    /// By how much the sum that friction projects is larger than the limit, over it.
    pub(crate) fn excess(&self, grid: &Grid, element: usize) -> f64 {
        let [x, y] = self.trial(grid, element);
        x.hypot(y) / self.limits[element] - 1.0
    }

    /// Size of an element's slip.
    pub(crate) fn speed(&self, element: usize) -> f64 {
        let [x, y] = self.slip(element);
        x.hypot(y)
    }

    /// The sum of an element's traction and weighted slip that friction projects.
    fn trial(&self, grid: &Grid, element: usize) -> [f64; 2] {
        let (traction, slip) = (self.traction.at(element), self.slip(element));
        [0, 1].map(|k| traction[k] + grid.weights[element] * slip[k])
    }

    fn slip(&self, element: usize) -> [f64; 2] {
        [self.slip[0][element], self.slip[1][element]]
    }

    pub(crate) fn fields(&self) -> Fields<'_> {
        Fields {
            traction: &self.traction.own,
            slip: &self.slip,
            limits: &self.limits,
            spin: self.forcing.spin,
        }
    }

    /// Force and power; `side` is the sign of the pressure's part in the forcing.
    pub(crate) fn sum(&self, grid: &Grid, side: f64) -> Sum {
        let mut sum = Sum::default();
        for element in 0..grid.mesh.len() {
            grid.quadrature.add(self.fields(), element, self.slides(element), &mut sum);
            let ([x, y], [p, q]) = (self.traction.at(element), grid.pressure_slip[element]);
            sum.by_pressure += side * grid.pressure.shares[element] * (x * p + y * q);
        }
        sum
    }

    /// Power of the tractions, whose sum is `force`, on slips that are given element by element, or on none: the force on
    /// their mean by pressure, so that an even slip is a creepage to rounding, and element by element what differs from it.
    pub(crate) fn work(&self, grid: &Grid, force: Force, slips: &[[f64; 2]]) -> f64 {
        let shares = &grid.pressure.shares;
        let (mut mean, mut all) = ([0.0; 2], 0.0);
        for (share, [x, y]) in shares.iter().zip(slips) {
            mean = [mean[0] + share * x, mean[1] + share * y];
            all += share;
        }
        if all <= 0.0 {
            return 0.0;
        }
        let mean = mean.map(|sum| sum / all);
        let uneven = slips.iter().zip(shares).enumerate().map(|(element, ([x, y], share))| {
            let [p, q] = self.traction.at(element);
            share * (p * (x - mean[0]) + q * (y - mean[1]))
        });
        force.fx * mean[0] + force.fy * mean[1] + uneven.sum::<f64>()
    }

    /// Frictional power of one element.
    pub(crate) fn power(&self, grid: &Grid, element: usize) -> f64 {
        let mut sum = Sum::default();
        grid.quadrature.add(self.fields(), element, self.slides(element), &mut sum);
        sum.dissipation
    }

    /// Computes the slip of a strip and of its mirror image from the tractions.
    fn update_slip(&mut self, grid: &Grid, precision: Precision, strip: usize) {
        let Self { forcing, traction, slip, .. } = self;
        grid.influence.slip(precision, strip, traction, slip);
        for strip in std::iter::once(strip).chain(grid.influence.image(strip)) {
            let elements = grid.mesh.elements(strip);
            for (k, slip) in slip.iter_mut().enumerate() {
                let slip = slip[elements.clone()].iter_mut();
                slip.zip(&forcing.slip[elements.clone()]).for_each(|(slip, by)| *slip += by[k]);
            }
        }
    }

    /// Adhesion or slip for every element of a strip; true when one of them changed.
    fn choose_branches(&mut self, grid: &Grid, strip: usize) -> bool {
        let mut switched = false;
        for element in grid.mesh.elements(strip) {
            let held = self.holds(element);
            self.sliding[element] = self.project(element, self.trial(grid, element));
            switched |= self.holds(element) != held;
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
