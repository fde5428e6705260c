//! Methods of minimization, and the limits of each.

use super::functional::Form;
use super::newton::{self, Minimum, Step};
use super::{Limits, NewtonStep, Start, Variational, VariationalSolution, newton_1967, power};
use crate::Creepage;

/// Formulation that is solved, and its solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Method {
    /// (5.9), or the least loss of power where the [bound](super::TractionBound) is kept, by
    /// Newton's method with Marquardt's damping: from every start, every case.
    #[default]
    Damped,
    /// (5.9) by Newton's method as printed (5.12): the historical reference, which fails in one
    /// to four cases of a hundred from a cold start, and seldom in a chain.
    Newton,
    /// The least-squares form with explicit areas of adhesion and slip (5.15), by the damped
    /// method. A point belongs to the area where its term, `W2 T` or `W3 S`, is the smaller one:
    /// [`Settings::weight`](super::Settings::weight) and
    /// [`Settings::adhesion_weight`](super::Settings::adhesion_weight). It has several minima: the one
    /// that is found lies next to the solution of (5.9), which is sought first from the given start.
    Areas,
}

/// A method and its limits.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Procedure {
    /// The way to the minimum.
    pub method: Method,
    /// When the iteration ends.
    pub limits: Limits,
}

impl Procedure {
    /// That of the thesis: Newton's method as printed, `delta = 0.001`, 12 iterations.
    pub const OF_1967: Self = Self { method: Method::Newton, limits: Limits::OF_1967 };
}

impl Variational {
    /// Solves by the given method from `start`; into `steps` goes the course of the iteration,
    /// a line of the printed page each.
    #[must_use]
    pub fn solve_by(
        &self,
        procedure: Procedure,
        creepage: Creepage,
        start: &Start,
        mut steps: Option<&mut Vec<NewtonStep>>,
    ) -> VariationalSolution {
        let minimum = self.minimum(procedure, creepage, start, |step| {
            if let Some(steps) = &mut steps {
                steps.push(step());
            }
        });
        VariationalSolution::new(self, creepage, &minimum)
    }

    fn minimum(
        &self,
        Procedure { method, limits }: Procedure,
        creepage: Creepage,
        start: &Start,
        mut observe: impl FnMut(&dyn Fn() -> NewtonStep),
    ) -> Minimum {
        let tau = start.tau(&self.mesh, &self.weights, creepage);
        let functional = self.functional_of(creepage, self.form());
        let mut see = |step: Step| observe(&|| NewtonStep::new(self, limits.delta, &step));
        match method {
            Method::Damped if self.keeps_bound => {
                let is_near = matches!(start, Start::From(_));
                power::minimize(self, creepage, tau, is_near, limits, see)
            }
            Method::Damped => newton::minimize(&functional, tau, limits, see),
            Method::Areas => {
                let first = newton::minimize(&functional, tau, limits, &mut see);
                let areas = self.functional_of(creepage, Form::Areas(&self.area_weights));
                let second = newton::minimize(&areas, first.tau, limits, see);
                Minimum { iterations: first.iterations + second.iterations, ..second }
            }
            Method::Newton => newton_1967::iterate(self, &functional, tau, limits, |step| {
                observe(&|| step);
            }),
        }
    }

    pub(super) fn form(&self) -> Form<'_> {
        self.own_integrand.as_ref().map_or(Form::Product, Form::Own)
    }
}
