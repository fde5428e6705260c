//! Theories and case files, prepared.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use creepage::Hertz;
use creepage::rolling::{Scaling, SiCreepage, SiForce, Solution, Status, Theory};
use creepage_study::{
    Case, CaseFile, ChoiceError, Entry, PreparedTheory, Solve, SolvedCase, choose, kappa_over_mu,
};

use crate::failure::Failure;

/// A theory prepared for one shape of the contact and one Poisson's ratio, and its name.
pub(crate) struct Solver {
    pub(crate) name: &'static str,
    pub(crate) theory: PreparedTheory,
}

impl Solver {
    /// Prepares the theory `name`; `solve` holds options of its own only.
    pub(crate) fn new(
        name: &str,
        a_over_b: f64,
        poisson: f64,
        solve: &Solve,
    ) -> Result<Self, Failure> {
        let (entry, solve) = chosen(name, solve)?;
        Ok(Self { name: entry.name, theory: entry.prepare(a_over_b, poisson, &solve)? })
    }
}

/// What a case file asks for.
pub(crate) struct AnsweredCase {
    /// Given, or found.
    pub(crate) creepage: SiCreepage,
    pub(crate) force: SiForce,
    pub(crate) status: Status,
    /// Whether the theory takes bodies for alike whose difference matters.
    pub(crate) left_out: bool,
}

/// Solves the case of a file by its own theory, or by the theory `name` with its usual options.
pub(crate) fn solve_case(path: &Path, name: Option<&str>) -> Result<AnsweredCase, Failure> {
    let text =
        fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    let wrong = |source| Failure::CaseFile { path: path.into(), source };
    let file = CaseFile::read(&text).map_err(wrong)?;
    if !file.is_inverse() {
        let case = file.case().map_err(wrong)?;
        let (entry, theory) = prepare((&case.contact, case.friction), &case.solve, name)?;
        return answered(&case, entry, theory.solve(case.creepage));
    }
    let case = file.inverse().map_err(wrong)?;
    let (entry, theory) = prepare((&case.contact, case.friction), &case.solve, name)?;
    let solved = SolvedCase::creepage(case, entry.name, Arc::new(theory))
        .map_err(|source| Failure::Find { path: path.into(), source })?;
    answered(&solved.case, entry, solved.found.answered.solution)
}

fn prepare(
    (contact, friction): (&Hertz, f64),
    solve: &Solve,
    name: Option<&str>,
) -> Result<(&'static Entry, PreparedTheory), Failure> {
    let own = solve.theory.as_deref().unwrap_or("exact");
    let name = name.unwrap_or(own);
    let usual = Solve::default();
    let (entry, solve) = chosen(name, if name == own { solve } else { &usual })?;
    Ok((entry, entry.for_contact(contact, friction, &solve)?))
}

fn answered(case: &Case, entry: &Entry, solution: Solution) -> Result<AnsweredCase, Failure> {
    let Case { contact, friction, si_creepage, .. } = case;
    Ok(AnsweredCase {
        creepage: *si_creepage,
        force: Scaling::new(contact, *friction)?.si_force(solution.force),
        status: solution.status,
        left_out: entry.leaves_out(kappa_over_mu(contact, *friction)).is_some(),
    })
}

/// The theory `name`, and options of its own.
fn chosen(name: &str, solve: &Solve) -> Result<(&'static Entry, Solve), ChoiceError> {
    let solve = Solve { theory: Some(name.into()), ..solve.clone() };
    Ok((choose(&[], &solve)?.theories[0], solve))
}
