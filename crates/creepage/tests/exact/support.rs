//! What the tests of the full theory share.

use creepage::coulomb::{Exact, Resolution};
use creepage::theory::Solved;
use creepage::{Contact, Force, Status};

use crate::common::{at, contact};

pub(crate) fn components(force: Force) -> [f64; 3] {
    force.components()
}

pub(crate) fn exact(a_over_b: f64, poisson: f64, resolution: Resolution) -> Exact {
    Exact::new(&contact(a_over_b, poisson), resolution).unwrap()
}

pub(crate) fn unlike(a_over_b: f64, poisson: f64, kappa_over_mu: f64) -> Contact {
    contact(a_over_b, poisson).with_kappa_over_mu(kappa_over_mu).unwrap()
}

/// What a solved contact gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) force: Force,
    pub(crate) error: Force,
    pub(crate) status: Status,
    pub(crate) power: f64,
    pub(crate) dissipation: f64,
}

pub(crate) fn solve(theory: &Exact, case: [f64; 3]) -> Found {
    let solved = theory.solve_contact(at(case));
    let solution = solved.solution();
    Found {
        force: solution.force,
        error: solution.error.unwrap(),
        status: solution.status,
        power: solved.power(),
        dissipation: solved.dissipation().unwrap(),
    }
}
