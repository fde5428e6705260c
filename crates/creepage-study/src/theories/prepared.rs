//! A theory prepared for one contact, and what it can be asked.

use creepage::InvalidValue;
use creepage::rolling::exact::{Automatic, Exact, ExactSolution, check_unlikeness};
use creepage::rolling::fastrip::Fastrip;
use creepage::rolling::fastsim::Fastsim;
use creepage::rolling::linear::Linear;
use creepage::rolling::polach::Polach;
use creepage::rolling::saturated::Saturated;
use creepage::rolling::shen_hedrick_elkins::ShenHedrickElkins;
use creepage::rolling::strip::StripTheory;
use creepage::rolling::variational::Variational;
use creepage::rolling::vermeulen_johnson::VermeulenJohnson;
use creepage::rolling::{Creepage, FieldPoint, Force, Solution, Theory};

/// A theory prepared for one ratio `a/b` and one Poisson's ratio: what all can be asked by
/// [`Theory`] and the methods here, and the theory itself for what only it can tell.
#[derive(Debug, Clone)]
#[allow(missing_docs)] // each is documented as the theory that it holds
pub enum PreparedTheory {
    Exact(Box<Exact>),
    Automatic(Box<Automatic>),
    Variational(Box<Variational>),
    Fastrip(Box<Fastrip>),
    Fastsim(Box<Fastsim>),
    Strip(Box<StripTheory>),
    Polach(Polach),
    ShenHedrickElkins(ShenHedrickElkins),
    VermeulenJohnson(VermeulenJohnson),
    Linear(Linear),
    Saturated(Box<Saturated>),
}

/// A force, and how far it may be off where the theory knows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answered {
    /// Force and status.
    pub solution: Solution,
    /// Error bars, in the units of the force.
    pub error: Option<Force>,
}

impl From<Solution> for Answered {
    fn from(solution: Solution) -> Self {
        Self { solution, error: None }
    }
}

impl From<ExactSolution> for Answered {
    fn from(found: ExactSolution) -> Self {
        let solution = Solution { force: found.force, status: found.status };
        Self { solution, error: Some(found.error) }
    }
}

impl PreparedTheory {
    /// The same between unlike bodies, `kappa` of (2.10) over the coefficient of friction. The full
    /// theory adds the slip by the pressure; the others neglect it, which
    /// [`Entry::leaves_out`](crate::Entry::leaves_out) tells.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `kappa_over_mu` lies between -1e6 and 1e6.
    pub fn with_unlikeness(self, kappa_over_mu: f64) -> Result<Self, InvalidValue> {
        Ok(match self {
            Self::Exact(theory) => Self::Exact(Box::new(theory.with_unlikeness(kappa_over_mu)?)),
            Self::Automatic(theory) => {
                Self::Automatic(Box::new(theory.with_unlikeness(kappa_over_mu)?))
            }
            other => {
                check_unlikeness(kappa_over_mu)?;
                other
            }
        })
    }

    /// Force, status and error bars.
    #[must_use]
    pub fn answer(&self, creepage: Creepage) -> Answered {
        match self {
            Self::Exact(theory) => theory.solve_with(creepage, &mut theory.workspace()).into(),
            Self::Automatic(theory) => theory.solve_to_accuracy(creepage).into(),
            other => other.theory().solve(creepage).into(),
        }
    }

    /// Derivative of the force: rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`. One-sided where
    /// the force has a kink; `None` where the theory has none, and where its resolution depends on
    /// the creepage.
    #[must_use]
    pub fn derivative(&self, creepage: Creepage) -> Option<[[f64; 3]; 3]> {
        Some(match self {
            Self::Exact(theory) => {
                let mut workspace = theory.workspace();
                theory.solve_with(creepage, &mut workspace);
                theory.derivative(&mut workspace)
            }
            Self::Automatic(_) | Self::Variational(_) => return None,
            Self::Fastrip(theory) => theory.derivative(creepage),
            Self::Fastsim(theory) => theory.derivative(creepage),
            Self::Strip(theory) => theory.derivative(creepage),
            Self::Polach(theory) => theory.derivative(creepage),
            Self::ShenHedrickElkins(theory) => theory.derivative(creepage),
            Self::VermeulenJohnson(theory) => theory.derivative(creepage),
            Self::Linear(theory) => theory.derivative(creepage),
            Self::Saturated(theory) => theory.derivative(creepage),
        })
    }

    /// What all theories have in common.
    #[must_use]
    pub fn theory(&self) -> &dyn Theory {
        match self {
            Self::Exact(theory) => &**theory,
            Self::Automatic(theory) => &**theory,
            Self::Variational(theory) => &**theory,
            Self::Fastrip(theory) => &**theory,
            Self::Fastsim(theory) => &**theory,
            Self::Strip(theory) => &**theory,
            Self::Polach(theory) => theory,
            Self::ShenHedrickElkins(theory) => theory,
            Self::VermeulenJohnson(theory) => theory,
            Self::Linear(theory) => theory,
            Self::Saturated(theory) => &**theory,
        }
    }
}

impl Theory for PreparedTheory {
    fn solve(&self, creepage: Creepage) -> Solution {
        self.theory().solve(creepage)
    }

    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint> {
        self.theory().field(creepage, positions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ENTRIES, find};
    use crate::{Resolution, Solve};

    const CREEPAGE: Creepage = Creepage { xi: 0.4, eta: -0.3, chi: 0.2 };

    #[test]
    fn every_theory_answers_as_its_trait_does() {
        for entry in ENTRIES {
            let theory = entry.prepare(1.3, 0.28, &Solve::default()).unwrap();
            let answered = theory.answer(CREEPAGE);
            assert_eq!(answered.solution, theory.solve(CREEPAGE), "{}", entry.name);
            assert_eq!(answered.error.is_some(), entry.error_bars, "{}", entry.name);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_force() {
        for name in ["linear", "fastsim", "polach", "vermeulen-johnson"] {
            let theory = find(name).unwrap().prepare(1.3, 0.28, &Solve::default()).unwrap();
            let step = 1e-5;
            let at = |xi| theory.solve(Creepage { xi, ..CREEPAGE }).force.fx;
            let slope = (at(CREEPAGE.xi + step) - at(CREEPAGE.xi - step)) / (2.0 * step);
            let derivative = theory.derivative(CREEPAGE).unwrap()[0][0];
            // The curvature of the force over the step; a cell of the springs may change sides.
            assert!((slope - derivative).abs() < 1e-3, "{name}: {slope} {derivative}");
        }
        let variational = find("variational").unwrap();
        let theory = variational.prepare(1.0, 0.28, &Solve::default()).unwrap();
        assert!(theory.derivative(CREEPAGE).is_none());
    }

    #[test]
    fn a_wanted_accuracy_is_reached() {
        let auto = Some(Resolution::Auto);
        let solve = Solve { resolution: auto, accuracy: Some(0.004), ..Solve::default() };
        let theory = find("exact").unwrap().prepare(1.3, 0.28, &solve).unwrap();
        let error = theory.answer(CREEPAGE).error.unwrap();
        assert!(error.fx.max(error.fy) <= 0.004);
    }
}
