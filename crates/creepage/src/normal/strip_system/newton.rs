//! Newton's method with line search and Broyden updates for the pressures, centres and half lengths of all strips at once.

use std::sync::Arc;

use nalgebra::DVector;

use super::strip::Strip;
use super::system::{Depth, Step, System, points};
use crate::numerics::{largest_magnitude, lu::Lu};

/// Problem of the strip system, in the solver's units.
#[derive(Clone, Copy)]
pub(crate) struct StripProblem<'a> {
    pub(crate) depth: Depth<'a>,
    /// The load, where that is prescribed and not the approach.
    pub(crate) load: Option<f64>,
    /// Largest residual.
    pub(crate) residual_tolerance: f64,
    /// Relative tolerance of the stiffness.
    pub(crate) stiffness_tolerance: f64,
    /// The matrix of like strips close by, to begin with.
    pub(crate) known: Option<&'a Arc<Factors>>,
}

impl StripProblem<'_> {
    /// How far a system is from its answer: the largest residual, and what the load lacks.
    fn size(&self, system: &System, residual: &DVector<f64>) -> f64 {
        let lacking = self.load.map_or(0.0, |load| 1.0 - system.load() / load);
        largest_magnitude(&[largest_magnitude(residual.as_slice()), lacking])
    }
}

/// Solution of the strip system, in the solver's units: strips that touch all along.
#[derive(Debug, Clone)]
pub(crate) struct StripSolution {
    pub(crate) strips: Vec<Strip>,
    /// What was added to the depth for the sake of the load.
    pub(crate) deeper: f64,
    /// How the load follows the depth.
    pub(crate) stiffness: f64,
    pub(crate) factors: Arc<Factors>,
}

/// Failure of the iteration: where it stopped, and by how much it would next have the logarithms of the half
/// lengths fall.
#[derive(Debug, Clone)]
pub(crate) struct StripFailure {
    pub(crate) strips: Vec<Strip>,
    pub(crate) shrinking: Vec<f64>,
    /// Whether these strips touch better than those it began with.
    pub(crate) is_closer: bool,
}

/// Solves from a start close by, with 2, 4 or [`MAX_TERMS`](super::MAX_TERMS) polynomials a strip.
pub(crate) fn solve(
    strips: Vec<Strip>,
    terms: usize,
    problem: StripProblem<'_>,
) -> Result<StripSolution, StripFailure> {
    const MAX_NEWTON_STEPS: usize = 20;
    const CLOSER: f64 = 0.7;
    let mut search = Search::new(strips, terms, problem);
    let (mut end, first) = (Ok(()), search.size());
    for _ in 0..MAX_NEWTON_STEPS {
        let size = search.size();
        if search.is_nearly_there(size)
            && let Some(touching) = search.last_step()
        {
            return Ok(touching);
        }
        end = search.advance(size);
        if end.is_err() {
            break;
        }
    }
    let is_closer = search.size() < CLOSER * first;
    let shrinking = end.err().unwrap_or_default();
    Err(StripFailure { strips: search.system.strips, shrinking, is_closer })
}

/// An iteration. A matrix serves for several steps while each makes the residual much smaller.
struct Search<'a> {
    problem: StripProblem<'a>,
    system: System,
    residual: DVector<f64>,
    factors: Option<Arc<Factors>>,
    /// The whole steps taken with it.
    taken: Vec<DVector<f64>>,
    /// The part of the residual that the last step left.
    left: f64,
    /// Steps of the other kind, steps that hardly helped, and those on which a strip vanishes.
    damped: usize,
    slow: usize,
    vanishing: usize,
}

impl<'a> Search<'a> {
    fn new(strips: Vec<Strip>, terms: usize, problem: StripProblem<'a>) -> Self {
        let system = System { strips, terms, points: points(terms), deeper: 0.0 };
        let known = problem.known.filter(|known| known.fit(&system)).cloned();
        let (residual, factors) = if known.is_some() {
            (system.residual(problem.depth), known)
        } else {
            let (residual, matrix) = system.linearized(problem.depth);
            (residual, Factors::new(&system, &matrix))
        };
        let (taken, left) = (Vec::new(), 1.0);
        Self { problem, system, residual, factors, taken, left, damped: 0, slow: 0, vanishing: 0 }
    }

    fn size(&self) -> f64 {
        self.problem.size(&self.system, &self.residual)
    }

    /// Whether one more step will be enough: it leaves about the same part as the last one.
    fn is_nearly_there(&self, size: f64) -> bool {
        const SAFETY: f64 = 10.0;
        size.min(SAFETY * self.left * size) < self.problem.residual_tolerance
    }

    /// Final quasi-Newton step without a residual check, and the derivative of the load by the depth: both by the
    /// last matrix, if that belongs to a point close enough.
    fn last_step(&mut self) -> Option<StripSolution> {
        let known = self.factors.take();
        let known = known.and_then(|factors| Some((self.stiffness(&factors)?, factors)));
        let (stiffness, factors) = match known {
            Some(known) => known,
            None => self.linearized().map(|factors| (factors.stiffness, factors))?,
        };
        let step = self.step(&factors)?;
        let System { strips, deeper, .. } = self.system.after(&step)?;
        Some(StripSolution { strips, deeper, stiffness, factors })
    }

    /// The derivative of the load by the depth here, by the matrix of a place close by; `None` where that lies too far off.
    ///
    /// One step of iterative refinement: what the matrix gives errs by about the square of what the step changes.
    fn stiffness(&self, factors: &Factors) -> Option<f64> {
        /// Of the change of the depth, over the depth.
        const STEP: f64 = 1e-4;
        let tolerance = self.problem.stiffness_tolerance;
        if factors.distance(&self.system) < tolerance {
            return Some(factors.stiffness);
        }
        let along = Step { unknowns: -STEP * &factors.by_depth, deeper: 0.0 };
        let there = self.system.moved(&along, 1.0).residual(self.problem.depth);
        let mut change = (&self.residual - there) / STEP;
        change.add_scalar_mut(1.0);
        factors.lu.solve(change.as_mut_slice());
        let part = change.norm() / factors.by_depth.norm();
        let by_depth = &factors.by_depth + change;
        (part * part < tolerance).then(|| self.system.load_change(&by_depth))
    }

    /// One step; where there is none, by how much it would have the half lengths shrink.
    fn advance(&mut self, size: f64) -> Result<(), Vec<f64>> {
        const SLOW: f64 = 0.85;
        const SLOW_STEPS: usize = 3;
        // A strip that is to shrink as far as this, again and again, has nothing to touch.
        const FAR: f64 = 0.5;
        const STILL: f64 = 0.4;
        const VANISHING_STEPS: usize = 2;
        let kept = self.factors.take();
        let factors = kept.or_else(|| self.linearized()).ok_or_else(Vec::new)?;
        let step = self.step(&factors).ok_or_else(Vec::new)?;
        let size_of_strip = self.system.size();
        let shrinking = || -> Vec<f64> {
            let lengths = step.unknowns.iter().skip(size_of_strip - 1);
            lengths.step_by(size_of_strip).copied().collect()
        };
        let improved = self.improved(&step, size);
        let Some(Improved { system, residual, size: left, length }) = improved else {
            // An old matrix is given up first.
            let shrinking = shrinking();
            return if factors.distance(&self.system) > 0.0 || self.damp() {
                Ok(())
            } else {
                Err(shrinking)
            };
        };
        if left > SLOW * size && self.slow >= SLOW_STEPS {
            return Err(shrinking());
        }
        self.slow += usize::from(left > SLOW * size);
        self.vanishing +=
            usize::from(left > STILL * size && shrinking().iter().any(|by| *by > FAR));
        (self.system, self.residual, self.left) = (system, residual, left / size);
        if self.vanishing >= VANISHING_STEPS {
            return Err(shrinking());
        }
        if length < 1.0 {
            self.taken.clear();
        } else {
            self.taken.push(step.unknowns);
        }
        self.factors = self.serves_again(size, left).then_some(factors);
        Ok(())
    }

    /// The system after a step, the step halved until the residual falls.
    fn improved(&self, step: &Step, size: f64) -> Option<Improved> {
        const SHORTEST: f64 = 0.03;
        let mut length = self.system.longest(&step.unknowns)?;
        while length > SHORTEST {
            let system = self.system.moved(step, length);
            let residual = system.residual(self.problem.depth);
            let left = self.problem.size(&system, &residual);
            if left < size * (1.0 - 0.1 * length) {
                return Some(Improved { system, residual, size: left, length });
            }
            length *= 0.5;
        }
        None
    }

    /// A matrix of this place.
    fn linearized(&mut self) -> Option<Arc<Factors>> {
        self.taken.clear();
        Factors::new(&self.system, &self.system.linearized(self.problem.depth).1)
    }

    /// A step with a matrix; where the load is not prescribed, as the steps taken with it tell how it errs.
    fn step(&self, factors: &Factors) -> Option<Step> {
        let mut step = factors.step(&self.system, &self.residual, self.problem.load)?;
        if self.problem.load.is_none() {
            improve(&mut step.unknowns, &self.taken);
        }
        Some(step)
    }

    /// Whether steps with an old matrix are cheaper than a new one, which costs about as much as two
    /// of them: after one that left so much.
    fn serves_again(&self, size: f64, left: f64) -> bool {
        const FAST: f64 = 0.15;
        const OLD_STEPS: i32 = 2;
        let part = left / size;
        part < FAST || left * part.powi(OLD_STEPS) < self.problem.residual_tolerance
    }

    /// Levenberg-Marquardt step as a fallback, few times, for it forms the normal equations.
    fn damp(&mut self) -> bool {
        const MAX_DAMPED_STEPS: usize = 2;
        const STRIPS: usize = 40;
        self.damped += 1;
        if self.damped > MAX_DAMPED_STEPS || self.system.strips.len() > STRIPS {
            return false;
        }
        let found = self.system.damped(&self.residual, self.problem.depth);
        let helps = found.is_some();
        if let Some(next) = found {
            (self.system, self.residual) = next;
            self.left = 1.0;
        }
        helps
    }
}

/// A system after a step, its residual, the size of that, and the part of the step that was taken.
struct Improved {
    system: System,
    residual: DVector<f64>,
    size: f64,
    length: f64,
}

/// Improves a step by those taken with the same matrix, as if each had updated that (Broyden 1965).
fn improve(step: &mut DVector<f64>, taken: &[DVector<f64>]) {
    /// A part that may be left of the step along the last one: else the matrix is of no use there.
    const MIN_REMAINDER: f64 = 0.3;
    let part = |along: &DVector<f64>, step: &DVector<f64>| along.dot(step) / along.norm_squared();
    for pair in taken.windows(2) {
        step.axpy(part(&pair[0], step), &pair[1], 1.0);
    }
    if let Some(last) = taken.last() {
        *step /= (1.0 - part(last, step)).max(MIN_REMAINDER);
    }
}

/// LU factors of a strip system's matrix.
#[derive(Debug, PartialEq)]
pub(crate) struct Factors {
    lu: Lu,
    /// Change of the unknowns, and of the load, with the depth.
    by_depth: DVector<f64>,
    stiffness: f64,
    /// Where it is the matrix.
    strips: Vec<Strip>,
    terms: usize,
}

impl Factors {
    fn new(system: &System, matrix: &[f64]) -> Option<Arc<Self>> {
        let total = system.strips.len() * system.size();
        let lu = Lu::of_rows(matrix, total)?;
        let mut by_depth = DVector::from_element(total, 1.0);
        lu.solve(by_depth.as_mut_slice());
        let stiffness = system.load_change(&by_depth);
        let strips = system.strips.clone();
        Some(Arc::new(Self { lu, by_depth, stiffness, strips, terms: system.terms }))
    }

    /// Whether the unknowns of a system are those of the matrix.
    fn fit(&self, system: &System) -> bool {
        let bands = |strips: &[Strip]| strips.iter().map(|strip| strip.band).collect::<Vec<_>>();
        self.terms == system.terms && bands(&self.strips) == bands(&system.strips)
    }

    /// How far a system is from there: the largest part of the largest half length or pressure by which one
    /// differs.
    fn distance(&self, system: &System) -> f64 {
        let most = |of: fn(&Strip) -> f64| system.strips.iter().map(of).fold(0.0, f64::max);
        let (pressure, half) = (most(|strip| strip.pressure[0].abs()), most(|strip| strip.half));
        let pairs = self.strips.iter().zip(&system.strips);
        let apart = pairs.map(|(one, other)| {
            let pressures = one.pressure.iter().zip(&other.pressure).take(self.terms);
            let lengths = [one.centre - other.centre, one.half - other.half];
            let pressures = pressures.map(|(one, other)| (one - other) / pressure);
            let parts = pressures.chain(lengths.map(|length| length / half));
            parts.fold(0.0, |most: f64, part| most.max(part.abs()))
        });
        apart.fold(0.0, f64::max)
    }

    fn step(&self, system: &System, residual: &DVector<f64>, load: Option<f64>) -> Option<Step> {
        let mut unknowns = residual.clone();
        self.lu.solve(unknowns.as_mut_slice());
        let Some(load) = load else { return Some(Step { unknowns, deeper: 0.0 }) };
        let lacking = load - system.load() + system.load_change(&unknowns);
        let deeper = lacking / self.stiffness;
        let unknowns = unknowns - deeper * &self.by_depth;
        deeper.is_finite().then_some(Step { unknowns, deeper })
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    /// A linear system, with the identity in place of its matrix: chords swing for ever, and Broyden's steps
    /// end after twice as many as there are unknowns (Gay 1979).
    #[test]
    fn steps_taken_make_up_for_a_wrong_matrix() {
        let matrix = DMatrix::from_row_slice(2, 2, &[1.0, 0.3, -0.2, 2.0]);
        let right = DVector::from_vec(vec![0.7, -1.1]);
        let (mut at, mut taken) = (DVector::zeros(2), Vec::new());
        for _ in 0..4 {
            let mut step = &matrix * &at - &right;
            improve(&mut step, &taken);
            at -= &step;
            taken.push(step);
        }
        // Rounding.
        assert!((matrix * at - right).amax() < 1e-13);
    }
}
