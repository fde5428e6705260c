//! The inverse problem: any three of the six quantities in, the other three out.

use nalgebra::{DMatrix, DVector};

use super::{Exact, ExactSolution, Workspace};
use crate::check::{self, InvalidValue};
use crate::{Creepage, Force};

/// Largest difference from a wanted force, in parts of `mu N`; the forces themselves are solved
/// to some 1e-8.
const TOLERANCE: f64 = 1e-7;
const STEPS: usize = 60;
/// Creepage beyond which a force has come as near to saturation as it will.
const LARGEST: f64 = 1e3;

/// What is known of creepage and force; exactly three are `Some`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Known {
    /// Longitudinal creepage.
    pub xi: Option<f64>,
    /// Lateral creepage.
    pub eta: Option<f64>,
    /// Spin.
    pub chi: Option<f64>,
    /// Longitudinal force.
    pub fx: Option<f64>,
    /// Lateral force.
    pub fy: Option<f64>,
    /// Moment.
    pub mz: Option<f64>,
}

/// Creepage and force that fit together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// The creepage, known or found.
    pub creepage: Creepage,
    /// Its solution.
    pub solution: ExactSolution,
    /// Newton steps.
    pub steps: usize,
}

/// Why an inverse problem has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InverseError {
    /// Three quantities determine the other three; more contradict, fewer leave them open.
    #[error("{given} of the six quantities are given: exactly three must be")]
    NotThree {
        /// How many are given.
        given: usize,
    },
    /// A given quantity is not a finite number.
    #[error(transparent)]
    InvalidValue(#[from] InvalidValue),
    /// No creepage gives the wanted force.
    #[error(
        "the force is not reachable: at most fx = {}, fy = {}, mz = {} was reached, at xi = {}, \
         eta = {}, chi = {}", .nearest.fx, .nearest.fy, .nearest.mz, .at.xi, .at.eta, .at.chi
    )]
    NotReachable {
        /// The force that came nearest.
        nearest: Force,
        /// Its creepage.
        at: Creepage,
    },
}

impl Exact {
    /// Finds the creepage at which the known quantities hold, by Newton's method from zero.
    ///
    /// ```
    /// use creepage::coulomb::{Exact, Known, Resolution};
    /// use creepage::{Contact, Ellipse};
    /// // A ball that rolls freely: spin given, no force across.
    /// let theory = Exact::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?, Resolution::FAST)?;
    /// let known = Known { xi: Some(0.0), chi: Some(0.5), fy: Some(0.0), ..Known::default() };
    /// let found = theory.find(known, &mut theory.workspace())?;
    /// assert!(found.creepage.eta < 0.0 && found.solution.force.fy.abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InverseError`] unless three quantities are given, all finite, and within reach.
    pub fn find(&self, known: Known, workspace: &mut Workspace) -> Result<Found, InverseError> {
        let problem = Problem::new(known)?;
        let mut best = self.found_at(problem.start, workspace);
        for steps in 0..STEPS {
            if problem.is_solved(&best) {
                return Ok(Found { steps, ..best });
            }
            let Some(next) = problem.step(self, &best, workspace) else {
                break;
            };
            best = next;
        }
        Err(InverseError::NotReachable { nearest: best.solution.force, at: best.creepage })
    }

    fn found_at(&self, creepage: Creepage, workspace: &mut Workspace) -> Found {
        Found { creepage, solution: self.solve_with(creepage, workspace), steps: 0 }
    }
}

/// The unknown components of the creepage, and the forces wanted in exchange.
struct Problem {
    start: Creepage,
    unknown: Vec<usize>,
    wanted: Vec<(usize, f64)>,
}

impl Problem {
    fn new(known: Known) -> Result<Self, InverseError> {
        let creepage = [("xi", known.xi), ("eta", known.eta), ("chi", known.chi)];
        let force = [("fx", known.fx), ("fy", known.fy), ("mz", known.mz)];
        let given = creepage.iter().chain(&force).filter(|(_, value)| value.is_some()).count();
        if given != 3 {
            return Err(InverseError::NotThree { given });
        }
        for (name, value) in creepage.iter().chain(&force) {
            check::finite(name, value.unwrap_or(0.0))?;
        }
        let [xi, eta, chi] = creepage.map(|(_, value)| value.unwrap_or(0.0));
        let unknown = (0..3).filter(|k| creepage[*k].1.is_none()).collect();
        let wanted = (0..3).filter_map(|k| force[k].1.map(|value| (k, value))).collect();
        Ok(Self { start: Creepage { xi, eta, chi }, unknown, wanted })
    }

    fn rest(&self, found: &Found) -> DVector<f64> {
        let Force { fx, fy, mz } = found.solution.force;
        DVector::from_iterator(
            self.wanted.len(),
            self.wanted.iter().map(|(k, value)| value - [fx, fy, mz][*k]),
        )
    }

    /// More than `mu N` is out of reach, whatever the rounding of the force says.
    fn is_solved(&self, found: &Found) -> bool {
        let size = self.wanted.iter().filter(|(k, _)| *k < 2).fold(0.0, |s: f64, w| s.hypot(w.1));
        size <= 1.0 && self.rest(found).amax() <= TOLERANCE
    }

    /// A Newton step, shortened until it comes nearer; `None` when none does.
    fn step(&self, theory: &Exact, from: &Found, workspace: &mut Workspace) -> Option<Found> {
        let rest = self.rest(from);
        let derivative = theory.derivative(workspace);
        let n = rest.len();
        let matrix = DMatrix::from_fn(n, n, |i, k| derivative[self.wanted[i].0][self.unknown[k]]);
        let step = matrix.lu().solve(&rest).filter(|step| step.iter().all(|s| s.is_finite()))?;
        let Creepage { xi, eta, chi } = from.creepage;
        let size = xi.abs().max(eta.abs()).max(chi.abs());
        let mut length = (size.max(1.0) / step.amax()).min(1.0);
        for _ in 0..8 {
            let mut to = [xi, eta, chi];
            for (k, step) in self.unknown.iter().zip(step.iter()) {
                to[*k] += length * step;
            }
            let next = theory.found_at(Creepage { xi: to[0], eta: to[1], chi: to[2] }, workspace);
            let within = self.unknown.iter().all(|k| to[*k].abs() <= LARGEST);
            if within && self.rest(&next).norm() < rest.norm() {
                return Some(next);
            }
            length *= 0.4;
        }
        None
    }
}
