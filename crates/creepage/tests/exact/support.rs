//! What the tests of the full theory share.

use creepage::coulomb::{Exact, ExactSolution};
use creepage::{Creepage, Force};

pub(crate) fn components(force: Force) -> [f64; 3] {
    [force.fx, force.fy, force.mz]
}

pub(crate) fn solve(theory: &Exact, [xi, eta, chi]: [f64; 3]) -> ExactSolution {
    theory.solve_with(Creepage::new(xi, eta, chi).unwrap(), &mut theory.workspace())
}
