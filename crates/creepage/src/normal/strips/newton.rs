//! Newton's method for the pressures, centres and half lengths of all strips at once.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector, Dyn, LU};
use pulp::{Arch, Simd, WithSimd};

use super::kernel::{MOST, RULES, Rules, View};
use super::strip::Strip;

/// The depth of undeformed penetration, at x and y in the solver's units.
pub(crate) type Depth<'a> = &'a dyn Fn(f64, f64) -> f64;

/// What is to be solved, in the solver's units.
#[derive(Clone, Copy)]
pub(crate) struct Question<'a> {
    pub(crate) depth: Depth<'a>,
    /// The load, where that is prescribed and not the approach.
    pub(crate) load: Option<f64>,
    /// Largest residual.
    pub(crate) enough: f64,
}

impl Question<'_> {
    /// How far a system is from its answer: the largest residual, and what the load lacks.
    fn size(&self, system: &System, residual: &DVector<f64>) -> f64 {
        let lacking = self.load.map_or(0.0, |load| 1.0 - system.load() / load);
        residual.amax().max(lacking.abs())
    }
}

/// Strips that touch all along, in the solver's units.
#[derive(Debug, Clone)]
pub(crate) struct Touching {
    pub(crate) strips: Vec<Strip>,
    /// What was added to the depth for the sake of the load.
    pub(crate) deeper: f64,
    /// How the load follows the depth.
    pub(crate) stiffness: f64,
}

/// Where the iteration stopped, and by how much it would next have the logarithms of the half
/// lengths fall.
#[derive(Debug, Clone)]
pub(crate) struct Stopped {
    pub(crate) strips: Vec<Strip>,
    pub(crate) shrinking: Vec<f64>,
}

/// Solves from a start close by, with 2, 4 or [`MOST`] polynomials a strip.
pub(crate) fn solve(
    strips: Vec<Strip>,
    terms: usize,
    question: Question<'_>,
) -> Result<Touching, Stopped> {
    const STEPS: usize = 20;
    let mut search = Search::new(strips, terms, question);
    let mut end = Ok(());
    for _ in 0..STEPS {
        let size = search.size();
        if size < question.enough
            && let Some(Factors { stiffness, .. }) = Factors::new(&search.system, question.depth)
        {
            let System { strips, deeper, .. } = search.system;
            return Ok(Touching { strips, deeper, stiffness });
        }
        end = search.advance(size);
        if end.is_err() {
            break;
        }
    }
    Err(Stopped { strips: search.system.strips, shrinking: end.err().unwrap_or_default() })
}

/// An iteration. A matrix serves for several steps while each makes the residual much smaller.
struct Search<'a> {
    question: Question<'a>,
    system: System,
    residual: DVector<f64>,
    factors: Option<Factors>,
    /// Steps of the other kind, and steps that hardly helped.
    damped: usize,
    slow: usize,
}

impl<'a> Search<'a> {
    fn new(strips: Vec<Strip>, terms: usize, question: Question<'a>) -> Self {
        let system = System { strips, terms, points: points(terms), deeper: 0.0 };
        let residual = system.residual(question.depth);
        Self { question, system, residual, factors: None, damped: 0, slow: 0 }
    }

    fn size(&self) -> f64 {
        self.question.size(&self.system, &self.residual)
    }

    /// One step; where there is none, by how much it would have the half lengths shrink.
    fn advance(&mut self, size: f64) -> Result<(), Vec<f64>> {
        const FAST: f64 = 0.15;
        const SLOW: f64 = 0.85;
        const SLOW_STEPS: usize = 3;
        let Question { depth, load, .. } = self.question;
        let kept = self.factors.take();
        let fresh = kept.is_none();
        let factors = kept.or_else(|| Factors::new(&self.system, depth)).ok_or_else(Vec::new)?;
        let step = factors.step(&self.system, &self.residual, load).ok_or_else(Vec::new)?;
        let shrinking = || {
            let size = self.system.size();
            step.unknowns.iter().skip(size - 1).step_by(size).copied().collect()
        };
        let Some((next, after, left)) = self.system.improved(&step, size, self.question) else {
            // An old matrix is given up first.
            let shrinking = shrinking();
            return if !fresh || self.damp() { Ok(()) } else { Err(shrinking) };
        };
        if left > SLOW * size && self.slow >= SLOW_STEPS {
            return Err(shrinking());
        }
        self.slow += usize::from(left > SLOW * size);
        (self.system, self.residual) = (next, after);
        self.factors = (left < FAST * size).then_some(factors);
        Ok(())
    }

    /// A damped step, where that helps; it is dear, so there are few.
    fn damp(&mut self) -> bool {
        const MOST: usize = 2;
        const STRIPS: usize = 40;
        self.damped += 1;
        if self.damped > MOST || self.system.strips.len() > STRIPS {
            return false;
        }
        let found = self.system.damped(&self.residual, self.question.depth);
        let helps = found.is_some();
        if let Some(next) = found {
            (self.system, self.residual) = next;
        }
        helps
    }
}

/// A step: what is subtracted from the unknowns, and what is added to the depth.
struct Step {
    unknowns: DVector<f64>,
    deeper: f64,
}

/// The factored matrix of some system.
struct Factors {
    lu: LU<f64, Dyn, Dyn>,
    /// Change of the unknowns, and of the load, with the depth.
    by_depth: DVector<f64>,
    stiffness: f64,
}

impl Factors {
    fn new(system: &System, depth: Depth<'_>) -> Option<Self> {
        let lu = system.jacobian(depth).lu();
        let ones = DVector::from_element(system.strips.len() * system.size(), 1.0);
        let by_depth = lu.solve(&ones)?;
        let stiffness = system.load_change(&by_depth);
        Some(Self { lu, by_depth, stiffness })
    }

    fn step(&self, system: &System, residual: &DVector<f64>, load: Option<f64>) -> Option<Step> {
        let unknowns = self.lu.solve(residual)?;
        let Some(load) = load else { return Some(Step { unknowns, deeper: 0.0 }) };
        let lacking = load - system.load() + system.load_change(&unknowns);
        let deeper = lacking / self.stiffness;
        let unknowns = unknowns - deeper * &self.by_depth;
        deeper.is_finite().then_some(Step { unknowns, deeper })
    }
}

struct System {
    strips: Vec<Strip>,
    terms: usize,
    points: Vec<f64>,
    /// What is added to the depth.
    deeper: f64,
}

/// Zeros of Chebyshev's polynomial: as many as a strip has unknowns.
fn points(terms: usize) -> Vec<f64> {
    let count = terms + 2;
    (0..count).map(|i| -((2 * i + 1) as f64 * PI / (2 * count) as f64).cos()).collect()
}

/// Displacement less depth at the points of all strips, and with `SLOPES` its derivatives by the
/// unknowns, a row a point.
struct Evaluate<'a, const T: usize, const SLOPES: bool> {
    system: &'a System,
    depth: Depth<'a>,
    residual: &'a mut [f64],
    rows: &'a mut [f64],
}

impl<const T: usize, const SLOPES: bool> WithSimd for Evaluate<'_, T, SLOPES> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { system, depth, residual, rows } = self;
        let (rules, total) = (&*RULES, residual.len());
        for (i, strip) in system.strips.iter().enumerate() {
            for (l, &s) in system.points.iter().enumerate() {
                let at = i * system.size() + l;
                let start = if SLOPES { at * total } else { 0 };
                let row = if SLOPES { &mut rows[start..start + total] } else { &mut [][..] };
                residual[at] = system.row::<T, SLOPES>(rules, [i, l], depth, row)
                    - depth(strip.centre + strip.half * s, strip.y)
                    - system.deeper;
            }
        }
    }
}

impl System {
    /// Unknowns of a strip: its pressures, its centre in half lengths, the logarithm of its half
    /// length.
    fn size(&self) -> usize {
        self.terms + 2
    }

    fn residual(&self, depth: Depth<'_>) -> DVector<f64> {
        let mut residual = DVector::zeros(self.strips.len() * self.size());
        let (system, out) = (self, residual.as_mut_slice());
        let arch = Arch::new();
        let rows = &mut [][..];
        match self.terms {
            2 => arch.dispatch(Evaluate::<2, false> { system, depth, residual: out, rows }),
            4 => arch.dispatch(Evaluate::<4, false> { system, depth, residual: out, rows }),
            _ => arch.dispatch(Evaluate::<MOST, false> { system, depth, residual: out, rows }),
        }
        residual
    }

    fn jacobian(&self, depth: Depth<'_>) -> DMatrix<f64> {
        let total = self.strips.len() * self.size();
        let mut residual = vec![0.0; total];
        // By columns of the transpose: a row of the matrix is one contiguous slice.
        let mut matrix = DMatrix::zeros(total, total);
        let (system, residual, rows) = (self, &mut residual[..], matrix.as_mut_slice());
        let arch = Arch::new();
        match self.terms {
            2 => arch.dispatch(Evaluate::<2, true> { system, depth, residual, rows }),
            4 => arch.dispatch(Evaluate::<4, true> { system, depth, residual, rows }),
            _ => arch.dispatch(Evaluate::<MOST, true> { system, depth, residual, rows }),
        }
        matrix.transpose_mut();
        matrix
    }

    /// Displacement at point `l` of strip `i`; with `SLOPES` derivatives of the residual are added to
    /// `row`.
    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn row<const T: usize, const SLOPES: bool>(
        &self,
        rules: &Rules,
        [i, l]: [usize; 2],
        depth: Depth<'_>,
        row: &mut [f64],
    ) -> f64 {
        let (strip, s) = (&self.strips[i], self.points[l]);
        let x = strip.centre + strip.half * s;
        let (mut displacement, mut slope) = (0.0, 0.0);
        for (j, source) in self.strips.iter().enumerate() {
            let view = view(strip, source, x, s, i == j);
            let integrals = view.integrals::<T, SLOPES>(rules, &source.pressure);
            let scale = source.half / PI;
            let parts = integrals.value.iter().zip(&source.pressure);
            let value: f64 = parts.map(|(value, pressure)| value * pressure).sum();
            displacement += scale * value;
            if SLOPES {
                let own = &mut row[j * (T + 2)..(j + 1) * (T + 2)];
                let by_x = integrals.by_x;
                for (own, value) in own.iter_mut().zip(&integrals.value) {
                    *own += scale * value;
                }
                let distance = (x - source.centre) / source.half;
                slope += by_x / PI;
                own[T] -= scale * by_x;
                own[T + 1] += scale * (value - distance * by_x - integrals.by_e);
            }
        }
        if SLOPES {
            const STEP: f64 = 1e-3;
            let h = STEP * strip.half;
            slope -= (depth(x + h, strip.y) - depth(x - h, strip.y)) / (2.0 * h);
            row[i * (T + 2) + T] += slope * strip.half;
            row[i * (T + 2) + T + 1] += slope * strip.half * s;
        }
        displacement
    }

    /// How far a step may go: no half length changes by more than a third, no centre moves
    /// further. `None` when the step is not a number.
    fn longest(&self, step: &DVector<f64>) -> Option<f64> {
        const MOST: f64 = 0.35;
        let size = self.size();
        let largest = (0..self.strips.len())
            .flat_map(|j| [step[j * size + self.terms], step[j * size + self.terms + 1]])
            .fold(0.0, |largest: f64, change| largest.max(change.abs()));
        step.iter().all(|change| change.is_finite()).then(|| (MOST / largest).min(1.0))
    }

    /// The system after a step, its residual and the size of that, the step halved until it falls.
    fn improved(
        &self,
        step: &Step,
        size: f64,
        question: Question<'_>,
    ) -> Option<(Self, DVector<f64>, f64)> {
        const SHORTEST: f64 = 0.03;
        let mut length = self.longest(&step.unknowns)?;
        while length > SHORTEST {
            let trial = self.moved(step, length);
            let residual = trial.residual(question.depth);
            let left = question.size(&trial, &residual);
            if left < size * (1.0 - 0.1 * length) {
                return Some((trial, residual, left));
            }
            length *= 0.5;
        }
        None
    }

    /// The system after a step that minimizes the square of the residual and, weighted, of the
    /// change of ends (Levenberg and Marquardt), the weight raised until the square falls: for strips
    /// whose ends hardly matter yet, such as those at a tip.
    fn damped(&self, residual: &DVector<f64>, depth: Depth<'_>) -> Option<(Self, DVector<f64>)> {
        const WEIGHTS: [f64; 4] = [1e-4, 1e-3, 1e-2, 1e-1];
        const ENOUGH: f64 = 0.98;
        let jacobian = self.jacobian(depth);
        let (square, right) = (jacobian.tr_mul(&jacobian), jacobian.tr_mul(residual));
        WEIGHTS.into_iter().find_map(|weight| {
            let mut matrix = square.clone();
            for (i, strip) in self.strips.iter().enumerate() {
                let end = (i + 1) * self.size();
                for at in end - 2..end {
                    matrix[(at, at)] += weight * strip.pressure[0].powi(2);
                }
            }
            let unknowns = matrix.cholesky()?.solve(&right);
            let length = self.longest(&unknowns)?;
            let trial = self.moved(&Step { unknowns, deeper: 0.0 }, length);
            let after = trial.residual(depth);
            (after.norm() < ENOUGH * residual.norm()).then_some((trial, after))
        })
    }

    fn moved(&self, Step { unknowns: step, deeper }: &Step, length: f64) -> Self {
        let size = self.size();
        let strips = self.strips.iter().enumerate().map(|(j, strip)| {
            let mut strip = *strip;
            for k in 0..self.terms {
                strip.pressure[k] -= length * step[j * size + k];
            }
            strip.centre -= length * step[j * size + self.terms] * strip.half;
            strip.half *= (-length * step[j * size + self.terms + 1]).exp();
            strip
        });
        let deeper = self.deeper + length * deeper;
        Self { strips: strips.collect(), terms: self.terms, points: self.points.clone(), deeper }
    }

    fn load(&self) -> f64 {
        self.strips.iter().map(Strip::load).sum()
    }

    /// Change of load along a change of all unknowns.
    fn load_change(&self, change: &DVector<f64>) -> f64 {
        let size = self.size();
        let strips = self.strips.iter().enumerate();
        strips
            .map(|(j, strip)| {
                let by_half = strip.pressure[0] * change[j * size + self.terms + 1];
                PI * strip.width * strip.half * (change[j * size] + by_half)
            })
            .sum()
    }
}

fn view(strip: &Strip, source: &Strip, x: f64, s: f64, own: bool) -> View {
    let across = strip.y - source.y;
    View {
        x: if own { s } else { (x - source.centre) / source.half },
        low: (across - source.width) / source.half,
        high: (across + source.width) / source.half,
        own,
    }
}
