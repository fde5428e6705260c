//! Inverse problem by Newton's method: any three of the six quantities in, the other three out.

use nalgebra::{DMatrix, DVector};

use super::{Exact, ExactSolved};
use crate::check;
use crate::numerics::largest_magnitude;
use crate::theory::{Constraints, InverseError, Solved};
use crate::{Creepage, Solution};

/// Largest difference from a prescribed force, in parts of `mu N`; the forces themselves are solved
/// to some 5e-8.
const TOLERANCE: f64 = 1e-7;
/// Newton steps towards prescribed forces.
const MAX_NEWTON_STEPS: usize = 60;
/// What may be left where Newton's method stagnates, in parts of the force's error bar.
const SMALL_BESIDE_BAR: f64 = 0.05;
/// Creepage beyond which a force has come as near to saturation as it will, over its scale.
const LARGEST: f64 = 1e3;

/// The contact solved at the creepage that meets the constraints.
#[derive(Debug)]
pub struct InverseSolution<'t> {
    /// Creepage and force, and all that can be asked of a solved contact.
    pub solved: ExactSolved<'t>,
    /// Newton steps.
    pub steps: usize,
}

impl InverseSolution<'_> {
    /// The creepage, prescribed or found.
    #[must_use]
    pub fn creepage(&self) -> Creepage {
        self.solved.creepage()
    }

    /// Its solution.
    #[must_use]
    pub fn solution(&self) -> Solution {
        self.solved.solution()
    }
}

impl Exact {
    /// Finds the creepage at which the constraints hold, by Newton's method from zero.
    ///
    /// ```
    /// use creepage::coulomb::{Constraints, Exact, Resolution};
    /// use creepage::{Contact, Ellipse};
    /// // A ball that rolls freely: spin given, no force across.
    /// let theory = Exact::new(&Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?, Resolution::FAST)?;
    /// let free =
    ///     Constraints { xi: Some(0.0), chi: Some(0.5), fy: Some(0.0), ..Constraints::default() };
    /// let found = theory.find(free)?;
    /// assert!(found.creepage().eta() < 0.0 && found.solution().force.fy.abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InverseError`] unless three quantities are prescribed, all finite, and within reach.
    pub fn find(&self, constraints: Constraints) -> Result<InverseSolution<'_>, InverseError> {
        // Between dissimilar bodies the creepage of free rolling grows with kappa/mu.
        let scale = 1.0 + self.contact.kappa_over_mu().abs();
        let (solved, steps) = search(constraints, scale, |creepage| self.solve_contact(creepage))?;
        Ok(InverseSolution { solved, steps })
    }
}

/// A contact solved at one creepage, and again at others.
pub(crate) trait Resolve: Solved + Sized {
    /// The same contact at another creepage.
    fn resolve(&self, creepage: Creepage) -> Self;
}

impl Resolve for ExactSolved<'_> {
    fn resolve(&self, creepage: Creepage) -> Self {
        self.theory().solve_contact(creepage)
    }
}

/// The contact solved where the constraints hold, and the steps taken; from `solve` at the
/// prescribed creepages, the others zero. `scale` is the size of creepage that makes a difference.
pub(crate) fn search<T: Resolve>(
    constraints: Constraints,
    scale: f64,
    solve: impl Fn(Creepage) -> T,
) -> Result<(T, usize), InverseError> {
    let problem = Problem::new(constraints, scale)?;
    let (mut solved, mut taken) = (solve(problem.start), 0);
    for steps in 0..MAX_NEWTON_STEPS {
        taken = steps;
        if problem.is_solved(&solved) {
            return Ok((solved, steps));
        }
        let Some(next) = problem.step(&mut solved) else {
            break;
        };
        solved = next;
    }
    // Coupled bodies are solved to a coarser tolerance: Newton's method stagnates in their scatter.
    if problem.is_within_bars(&solved) {
        return Ok((solved, taken));
    }
    Err(InverseError::NotReachable { nearest: solved.solution().force, at: solved.creepage() })
}

/// The unknown components of the creepage, and the forces prescribed in exchange.
struct Problem {
    start: Creepage,
    unknown: Vec<usize>,
    prescribed: Vec<(usize, f64)>,
    scale: f64,
}

impl Problem {
    fn new(constraints: Constraints, scale: f64) -> Result<Self, InverseError> {
        let Constraints { xi, eta, chi, fx, fy, mz } = constraints;
        let creepage = [("xi", xi), ("eta", eta), ("chi", chi)];
        let force = [("fx", fx), ("fy", fy), ("mz", mz)];
        let given = creepage.iter().chain(&force).filter(|(_, value)| value.is_some()).count();
        if given != 3 {
            return Err(InverseError::NotThree { given });
        }
        for (name, value) in creepage.iter().chain(&force) {
            check::finite(name, value.unwrap_or(0.0))?;
        }
        let [xi, eta, chi] = creepage.map(|(_, value)| value.unwrap_or(0.0));
        let unknown = (0..3).filter(|k| creepage[*k].1.is_none()).collect();
        let prescribed = (0..3).filter_map(|k| force[k].1.map(|value| (k, value))).collect();
        Ok(Self { start: Creepage::new(xi, eta, chi)?, unknown, prescribed, scale })
    }

    /// Prescribed forces less those of a solution.
    fn residual(&self, solved: &impl Solved) -> DVector<f64> {
        let force = solved.solution().force.components();
        let components = self.prescribed.iter().map(|(k, value)| value - force[*k]);
        DVector::from_iterator(self.prescribed.len(), components)
    }

    /// More than `mu N` is out of reach, whatever the rounding of the force says.
    fn is_solved(&self, solved: &impl Solved) -> bool {
        let tangential = self.prescribed.iter().filter(|(k, _)| *k < 2);
        let size = tangential.fold(0.0, |size: f64, (_, value)| size.hypot(*value));
        size <= 1.0 && largest_magnitude(self.residual(solved).as_slice()) <= TOLERANCE
    }

    /// Whether what is left is small beside the error bars of the forces themselves.
    fn is_within_bars(&self, solved: &impl Solved) -> bool {
        let Some(bars) = solved.solution().error else { return false };
        let (bars, residual) = (bars.components(), self.residual(solved));
        let tangential = self.prescribed.iter().filter(|(k, _)| *k < 2);
        let size = tangential.fold(0.0, |size: f64, (_, value)| size.hypot(*value));
        let mut pairs = self.prescribed.iter().zip(residual.iter());
        size <= 1.0 && pairs.all(|((k, _), left)| left.abs() <= SMALL_BESIDE_BAR * bars[*k])
    }

    /// A Newton step, shortened until it comes nearer; `None` when none does.
    fn step<T: Resolve>(&self, from: &mut T) -> Option<T> {
        let (residual, at) = (self.residual(from), from.creepage().components());
        let jacobian = from.jacobian()?;
        let n = residual.len();
        let entry = |i: usize, k: usize| jacobian[self.prescribed[i].0][self.unknown[k]];
        let step = DMatrix::from_fn(n, n, entry).lu().solve(&residual);
        let step = step.filter(|step| step.iter().all(|s| s.is_finite()))?;
        let size = at.iter().fold(0.0, |size: f64, component| size.max(component.abs()));
        let mut length = (size.max(self.scale) / step.amax()).min(1.0);
        for _ in 0..8 {
            let mut to = at;
            for (k, step) in self.unknown.iter().zip(step.iter()) {
                to[*k] += length * step;
            }
            let [xi, eta, chi] = to;
            let next = from.resolve(Creepage { xi, eta, chi });
            let within = self.unknown.iter().all(|k| to[*k].abs() <= LARGEST * self.scale);
            if within && self.residual(&next).norm() < residual.norm() {
                return Some(next);
            }
            length *= 0.4;
        }
        None
    }
}
