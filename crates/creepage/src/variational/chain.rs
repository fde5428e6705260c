//! Series of cases, each of which starts from the one before (5.21 h).

use super::{NewtonStep, Procedure, Start, Variational, VariationalSolution};
use crate::{Creepage, Status};

/// A chain of neighbouring cases, each started from the solution of the previous one and the
/// first from full sliding.
///
/// A case that fails is tried again by 2, 4, 8 and 16 smaller steps from the previous one.
///
/// ```
/// use creepage::{Contact, Creepage, Ellipse};
/// use creepage::variational::{Chain, Procedure, Settings, Variational};
/// let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.28)?;
/// let theory = Variational::new(&circle, Settings::default())?;
/// let mut chain = Chain::new(&theory, Procedure::default());
/// for chi in [4.0, 3.0, 2.0] {
///     let case = chain.solve(Creepage::new(0.0, 0.0, chi)?, None);
///     assert!(case.found.solution.force.fy > 0.0);
/// }
/// # Ok::<(), creepage::variational::VariationalError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Chain<'a> {
    theory: &'a Variational,
    procedure: Procedure,
    previous: Option<Previous>,
}

#[derive(Debug, Clone)]
struct Previous {
    creepage: Creepage,
    tau: Vec<f64>,
}

/// One case of a chain.
#[derive(Debug, Clone, PartialEq)]
pub struct ChainCase {
    /// The solution; [`Status::NotConverged`] when the smaller steps have failed as well.
    pub found: VariationalSolution,
    /// Into how many steps the way from the previous case was cut; 1 when the first attempt
    /// succeeded.
    pub steps_from_previous: usize,
}

impl<'a> Chain<'a> {
    /// The most steps into which the way from the previous case is cut.
    pub const MOST_STEPS: usize = 16;

    /// A chain whose first case starts from full sliding.
    #[must_use]
    pub fn new(theory: &'a Variational, procedure: Procedure) -> Self {
        Self { theory, procedure, previous: None }
    }

    /// A chain that goes on from `creepage` and its unknowns `tau`, as in
    /// [`VariationalSolution::tau`]: a case solved before, or starting values (5.21 h).
    #[must_use]
    pub fn from(
        theory: &'a Variational,
        procedure: Procedure,
        creepage: Creepage,
        tau: Vec<f64>,
    ) -> Self {
        Self { theory, procedure, previous: Some(Previous { creepage, tau }) }
    }

    /// Solves the next case of the chain. The steps of the iteration that found it go into
    /// `steps`.
    pub fn solve(
        &mut self,
        creepage: Creepage,
        mut steps: Option<&mut Vec<NewtonStep>>,
    ) -> ChainCase {
        let mut case = self.attempt(creepage, 1, steps.as_deref_mut());
        while case.found.solution.status == Status::NotConverged
            && case.steps_from_previous < Self::MOST_STEPS
        {
            if let Some(steps) = &mut steps {
                steps.clear();
            }
            case = self.attempt(creepage, 2 * case.steps_from_previous, steps.as_deref_mut());
        }
        // A failed case is no start for the next one.
        if case.found.solution.status != Status::NotConverged {
            self.previous = Some(Previous { creepage, tau: case.found.tau.clone() });
        }
        case
    }

    /// Goes to `creepage` in a number of equal steps.
    fn attempt(
        &self,
        creepage: Creepage,
        count: usize,
        steps: Option<&mut Vec<NewtonStep>>,
    ) -> ChainCase {
        let (theory, procedure) = (self.theory, self.procedure);
        let from = self.previous.as_ref().map_or_else(|| far(creepage), |here| here.creepage);
        let mut tau = self.previous.as_ref().map(|previous| previous.tau.clone());
        for step in 1..count {
            let between = between(from, creepage, step as f64 / count as f64);
            let start = tau.as_deref().map_or(Start::FullSliding, Start::From);
            tau = Some(theory.solve_by(procedure, between, &start, None).tau);
        }
        let start = tau.as_deref().map_or(Start::FullSliding, Start::From);
        let found = theory.solve_by(procedure, creepage, &start, steps);
        ChainCase { found, steps_from_previous: count }
    }
}

/// Where full sliding is nearly exact: the first case is approached from there if need be.
fn far(Creepage { xi, eta, chi }: Creepage) -> Creepage {
    Creepage { xi: 5.0 * xi, eta: 5.0 * eta, chi: 5.0 * chi }
}

fn between(from: Creepage, to: Creepage, share: f64) -> Creepage {
    let mix = |from: f64, to: f64| from + share * (to - from);
    Creepage { xi: mix(from.xi, to.xi), eta: mix(from.eta, to.eta), chi: mix(from.chi, to.chi) }
}
