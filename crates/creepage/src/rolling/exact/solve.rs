//! Strip by strip, by Newton, until nothing moves.
//!
//! A sweep solves the friction problem of each strip with the other strips held; strips act on
//! one another more weakly than elements of a strip do, and the sweeps converge from any start.

use super::acceleration::Acceleration;
use super::dense::Dense;
use super::friction::{Sliding, project};
use super::grid::Grid;
use super::sampling::{Fields, Sum};
use super::unlike::Drive;
use crate::rolling::Creepage;

/// Largest change of a traction in the last sweep, over its bound, or over the creepage where
/// that is smaller than one: then tractions are as small as the creepage.
const TOLERANCE: f64 = 1e-8;
/// A round is a sweep up and a sweep down.
const ROUNDS: usize = 150;
/// Acceleration waits until changes are below this, and most elements know their branch.
const CALM: f64 = 0.1;
const STEPS: usize = 30;
/// Newton steps that are taken in full; later ones by half, for they swing between two states.
const EAGER: usize = 12;
/// Sweeps that were not calm for so many rounds take half of every change, after as many again a
/// quarter, then an eighth, then all, and keep to it: on contacts long in the rolling direction
/// full changes may swing between states, even from near the solution.
const PATIENCE: usize = 12;
/// Steps below this size leave a strip's factors good enough to use again.
const CHORD: f64 = 0.02;
/// Weight of slip against traction in the projection, over the element's own response. Any
/// weight has the same solution; with this the iteration neither cycles nor crawls.
const WEIGHT: f64 = 0.3;

/// The tractions of one grid and the room to improve them.
#[derive(Debug, Clone)]
pub(super) struct State {
    /// Traction of each element over its bound, `x` then `y`.
    pub traction: [Vec<f64>; 2],
    /// The same with the strips in opposite order.
    mirrored: [Vec<f64>; 2],
    /// Slip of each element at the last visit of its strip.
    pub slip: [Vec<f64>; 2],
    /// Which elements slide.
    pub slides: Vec<bool>,
    /// Newton's matrix of each strip, factored, and the size of the last step with it.
    factors: Vec<Dense>,
    last_step: Vec<f64>,
    step: Vec<f64>,
    /// Tractions of a strip before its turn, and the share of the turn's change that is taken.
    before: Vec<f64>,
    share: f64,
    acceleration: Acceleration,
}

/// How an iteration ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outcome {
    pub converged: bool,
    pub sweeps: usize,
}

impl State {
    pub(super) fn new(grid: &Grid) -> Self {
        let (n, along) = (grid.elements.len(), grid.elements.along);
        let zeros = || [vec![0.0; n], vec![0.0; n]];
        Self {
            traction: zeros(),
            mirrored: zeros(),
            slip: zeros(),
            slides: vec![false; n],
            factors: vec![Dense::new(2 * along); grid.elements.strips],
            last_step: vec![f64::INFINITY; grid.elements.strips],
            step: vec![0.0; 2 * along],
            before: vec![0.0; 2 * along],
            share: 1.0,
            acceleration: Acceleration::new(2 * n),
        }
    }

    pub(super) fn reset(&mut self) {
        for k in 0..2 {
            self.traction[k].fill(0.0);
            self.mirrored[k].fill(0.0);
        }
        self.slides.fill(false);
        self.last_step.fill(f64::INFINITY);
    }

    /// Starts from the tractions of a grid with half the elements along and across.
    pub(super) fn refine(&mut self, grid: &Grid, coarse: &Self) {
        let (along, strips) = (grid.elements.along, grid.elements.strips);
        for element in 0..along * strips {
            let (strip, i) = (element / along, element % along);
            let parent = strip / 2 * (along / 2) + i / 2;
            let mirrored = (strips - 1 - strip) * along + i;
            for k in 0..2 {
                self.traction[k][element] = coarse.traction[k][parent];
                self.mirrored[k][mirrored] = coarse.traction[k][parent];
            }
            self.slides[element] = coarse.slides[parent];
        }
        self.last_step.fill(f64::INFINITY);
    }

    /// Improves the tractions until they obey friction at the slip that `drive` causes.
    pub(super) fn solve(&mut self, grid: &Grid, drive: Drive) -> Outcome {
        let strips = grid.elements.strips;
        let tolerance = TOLERANCE * scale(grid, drive).min(1.0);
        self.acceleration.restart();
        let (mut last, mut restless) = (f64::INFINITY, 0);
        for round in 1..=ROUNDS {
            self.acceleration.begin(&self.traction);
            let mut change = 0.0_f64;
            restless += usize::from(last > CALM);
            self.share = share(restless);
            for strip in (0..strips).chain((0..strips).rev()) {
                change = change.max(self.solve_strip(grid, drive, strip, tolerance));
            }
            if change <= tolerance {
                self.update_slip(grid, drive);
                return Outcome { converged: true, sweeps: 2 * round };
            }
            self.accelerate(grid, change > CALM || change > 2.0 * last);
            last = change;
        }
        self.update_slip(grid, drive);
        Outcome { converged: false, sweeps: 2 * ROUNDS }
    }

    pub(super) fn fields(&self, creepage: Creepage) -> Fields<'_> {
        Fields { traction: &self.traction, slip: &self.slip, creepage }
    }

    /// Force and power as last solved.
    pub(super) fn sum(&self, grid: &Grid, drive: Drive) -> Sum {
        let mut sum = Sum::default();
        for element in 0..grid.elements.len() {
            let fields = self.fields(drive.creepage);
            grid.sampling.add(grid, fields, element, self.slides[element], &mut sum);
            let [x, y] = grid.pressure_slip[element];
            let along = self.traction[0][element] * x + self.traction[1][element] * y;
            sum.by_pressure += drive.side * grid.elements.shares[element] * along;
        }
        sum
    }

    fn accelerate(&mut self, grid: &Grid, restart: bool) {
        if restart {
            return self.acceleration.restart();
        }
        self.acceleration.finish(&mut self.traction);
        let along = grid.elements.along;
        for (mirrored, traction) in self.mirrored.iter_mut().zip(&self.traction) {
            let strips = mirrored.chunks_exact_mut(along).rev();
            strips
                .zip(traction.chunks_exact(along))
                .for_each(|(to, from)| to.copy_from_slice(from));
        }
    }

    fn update_slip(&mut self, grid: &Grid, drive: Drive) {
        for element in 0..grid.elements.len() {
            let slip = self.slip_of(grid, drive, element);
            self.set_slip(element, slip);
        }
    }

    fn slip_of(&self, grid: &Grid, drive: Drive, element: usize) -> [f64; 2] {
        let (row, sign) = grid.row(element);
        let [x, y] = if sign > 0.0 { &self.traction } else { &self.mirrored };
        let driven = grid.driven_slip(drive, element);
        let elastic = row.apply(sign, x, y);
        [driven[0] + elastic[0], driven[1] + elastic[1]]
    }

    fn set_slip(&mut self, element: usize, slip: [f64; 2]) {
        self.slip[0][element] = slip[0];
        self.slip[1][element] = slip[1];
    }

    pub(super) fn friction(&self, grid: &Grid, element: usize) -> (Option<Sliding>, f64) {
        let weight = WEIGHT / grid.compliance[element];
        let at = |pair: &[Vec<f64>; 2]| [pair[0][element], pair[1][element]];
        (project(at(&self.traction), at(&self.slip), weight), weight)
    }

    /// Newton in one strip; the largest change of a traction.
    fn solve_strip(&mut self, grid: &Grid, drive: Drive, strip: usize, tolerance: f64) -> f64 {
        let along = grid.elements.along;
        for element in strip * along..(strip + 1) * along {
            let slip = self.slip_of(grid, drive, element);
            self.set_slip(element, slip);
        }
        self.before.clear();
        for traction in &self.traction {
            self.before.extend(&traction[strip * along..(strip + 1) * along]);
        }
        let (mut change, mut last) = (0.0_f64, f64::INFINITY);
        for k in 0..STEPS {
            let switched = self.choose_branches(grid, strip);
            if (switched || self.last_step[strip] > CHORD) && !self.factor(grid, strip) {
                return f64::INFINITY;
            }
            let step = self.newton_step(grid, strip, if k < EAGER { 1.0 } else { 0.5 });
            self.last_step[strip] = step;
            change = change.max(step);
            let settled = !switched && step < 0.01 && step < 0.1 * last;
            if step <= tolerance || settled || !step.is_finite() {
                break;
            }
            last = step;
        }
        if self.share < 1.0 {
            self.step_back(grid, strip);
        }
        change
    }

    /// Undoes a part of a strip's turn.
    fn step_back(&mut self, grid: &Grid, strip: usize) {
        let along = grid.elements.along;
        let (start, mirrored) = (strip * along, (grid.elements.strips - 1 - strip) * along);
        for k in 0..2 {
            for i in 0..along {
                let before = self.before[k * along + i];
                let traction = &mut self.traction[k][start + i];
                *traction = before + self.share * (*traction - before);
                self.mirrored[k][mirrored + i] = *traction;
            }
        }
    }

    /// Adhesion or slip for every element of a strip; true when one of them changed.
    fn choose_branches(&mut self, grid: &Grid, strip: usize) -> bool {
        let along = grid.elements.along;
        let mut switched = false;
        for element in strip * along..(strip + 1) * along {
            let slides = self.friction(grid, element).0.is_some();
            switched |= slides != self.slides[element];
            self.slides[element] = slides;
        }
        switched
    }

    /// Newton's matrix of a strip: `slip' = 0` in adhesion, `traction - projection = 0` in slip.
    pub(super) fn factor(&mut self, grid: &Grid, strip: usize) -> bool {
        let along = grid.elements.along;
        for i in 0..along {
            let element = strip * along + i;
            let (own, sign) = grid.own_strip(element);
            let (sliding, weight) = self.friction(grid, element);
            let (first, second) = self.factors[strip].two_rows(2 * i);
            let Some(Sliding { derivative: [dx, dy], .. }) = sliding else {
                combine(first, [1.0, 0.0], own.xx, own.xy, own.yy, sign);
                combine(second, [0.0, 1.0], own.xx, own.xy, own.yy, sign);
                continue;
            };
            for (row, d, k) in [(first, dx, 0), (second, dy, 1)] {
                combine(row, d.map(|d| -weight * d), own.xx, own.xy, own.yy, sign);
                row[i] -= d[0];
                row[along + i] -= d[1];
                row[k * along + i] += 1.0;
            }
        }
        self.factors[strip].factor()
    }

    fn newton_step(&mut self, grid: &Grid, strip: usize, share: f64) -> f64 {
        let along = grid.elements.along;
        let start = strip * along;
        for i in 0..along {
            let rest = self.residual(grid, start + i);
            self.step[2 * i] = rest[0];
            self.step[2 * i + 1] = rest[1];
        }
        let Self { factors, step, .. } = self;
        factors[strip].solve(step);
        for s in step.iter_mut() {
            *s *= share;
        }
        let mirrored = (grid.elements.strips - 1 - strip) * along;
        let mut largest = 0.0_f64;
        for k in 0..2 {
            for i in 0..along {
                let step = self.step[k * along + i];
                self.traction[k][start + i] += step;
                self.mirrored[k][mirrored + i] = self.traction[k][start + i];
                largest = largest.max(step.abs());
            }
        }
        let (x, y) = self.step.split_at(along);
        for element in start..start + along {
            let (own, sign) = grid.own_strip(element);
            let by = own.apply(sign, x, y);
            self.slip[0][element] += by[0];
            self.slip[1][element] += by[1];
        }
        if self.step.iter().all(|s| s.is_finite()) { largest } else { f64::INFINITY }
    }

    /// What the equations of an element lack.
    fn residual(&self, grid: &Grid, element: usize) -> [f64; 2] {
        match self.friction(grid, element).0 {
            None => [-self.slip[0][element], -self.slip[1][element]],
            Some(sliding) => [
                sliding.traction[0] - self.traction[0][element],
                sliding.traction[1] - self.traction[1][element],
            ],
        }
    }

    /// Applies a strip's factors to the right-hand side `x`, interleaved by element.
    pub(super) fn solve_linear(&self, strip: usize, x: &mut [f64]) {
        self.factors[strip].solve(x);
    }
}

/// Share of a change that is taken.
fn share(restless: usize) -> f64 {
    (-((restless / PATIENCE % 4) as f64)).exp2()
}

/// Largest slip in the contact before any traction, in the unit in which tractions at their bound
/// give slip.
fn scale(grid: &Grid, drive: Drive) -> f64 {
    (0..grid.elements.len())
        .map(|element| {
            let slip = grid.driven_slip(drive, element);
            slip[0].hypot(slip[1])
        })
        .fold(0.0, f64::max)
}

/// `row = by_x * (slip in x) + by_y * (slip in y)`, by tractions `x` then `y` of the strip.
fn combine(row: &mut [f64], [by_x, by_y]: [f64; 2], xx: &[f64], xy: &[f64], yy: &[f64], sign: f64) {
    let along = xx.len();
    let (left, right) = row.split_at_mut(along);
    for k in 0..along {
        left[k] = by_x * xx[k] + sign * by_y * xy[k];
        right[k] = sign * by_x * xy[k] + by_y * yy[k];
    }
}
