//! Theories and case files, prepared.

use std::fs;
use std::path::Path;

use creepage_case::{Case, CaseFile, Solve};
use creepage_theories::{ChoiceError, Entry, PreparedTheory, choose};

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

/// The case of a file, and its theory, or the theory `name` with its usual options.
pub(crate) fn case(path: &Path, name: Option<&str>) -> Result<(Case, Solver), Failure> {
    let text =
        fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    let wrong = |source| Failure::CaseFile { path: path.into(), source };
    let case = CaseFile::read(&text).map_err(wrong)?.case().map_err(wrong)?;
    let own = case.solve.theory.as_deref().unwrap_or("exact");
    let name = name.unwrap_or(own);
    let solve = if name == own { case.solve.clone() } else { Solve::default() };
    let (entry, solve) = chosen(name, &solve)?;
    let theory = entry.for_contact(&case.contact, case.friction, &solve)?;
    Ok((case, Solver { name: entry.name, theory }))
}

/// The theory `name`, and options of its own.
fn chosen(name: &str, solve: &Solve) -> Result<(&'static Entry, Solve), ChoiceError> {
    let solve = Solve { theory: Some(name.into()), ..solve.clone() };
    Ok((choose(&[], &solve)?.theories[0], solve))
}
