//! Commands on one case file: `solve` and `hertz`.

use std::fs;
use std::path::Path;

use creepage::InvalidValue;
use creepage::rolling::Status;
use creepage_case::{Case, CaseError, CaseFile};
use creepage_report::{Answer, Report, ReportError, hertz_json, hertz_text};
use serde::Serialize;

use crate::Outcome;
use crate::args::{HertzArgs, SolveArgs};
use crate::caution::caution;
use crate::failure::Failure;
use crate::output::{print, say};
use crate::theories::{self, Entry, Examination};

/// `creepage solve`: the files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let case = read(&args.case)?.case().map_err(wrong)?;
    let theory = choose(args.theory.as_slice(), &case, &args.case)?[0];
    let found = examine(&case, theory)
        .map_err(|source| Failure::Options { path: args.case.clone(), source })?;
    let status = found.solution.status;
    let report = report(&case, theory, &found)
        .map_err(|invalid| wrong(CaseError::Invalid { section: "contact", invalid }))?;
    if let Some(directory) = &args.out {
        for path in report.write(directory)? {
            say(&format!("wrote {}", path.display()));
        }
    }
    print(&if args.json { to_json(&report.json())? } else { report.text() })?;
    Ok(judge(status))
}

/// `creepage hertz`.
pub(crate) fn hertz(args: &HertzArgs) -> Result<(), Failure> {
    let contact = read(&args.case)?
        .hertz()
        .map_err(|source| Failure::Case { path: args.case.clone(), source })?;
    print(&if args.json { to_json(&hertz_json(&contact))? } else { hertz_text(&contact) })
}

pub(crate) fn to_json(data: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(data).map_err(|error| ReportError::from(error).into())
}

/// The theories to use for a case, at least one; says which options have no effect.
pub(crate) fn choose(
    names: &[String],
    case: &Case,
    path: &Path,
) -> Result<Vec<&'static Entry>, Failure> {
    let choice = theories::choose(names, &case.solve)
        .map_err(|source| Failure::Choice { path: path.into(), source })?;
    if let Some(note) = choice.note() {
        say(&note);
    }
    Ok(choice.theories)
}

pub(crate) fn read(path: &Path) -> Result<CaseFile, Failure> {
    let text =
        fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    CaseFile::read(&text).map_err(|source| Failure::Case { path: path.into(), source })
}

fn examine(case: &Case, theory: &Entry) -> Result<Examination, theories::TheoryError> {
    let ratio = case.contact.ellipse().ratio();
    theory.examine(ratio, case.contact.pair().poisson(), &case.solve, case.creepage)
}

fn report<'a>(
    case: &'a Case,
    theory: &'a Entry,
    found: &'a Examination,
) -> Result<Report<'a>, InvalidValue> {
    let answer = Answer {
        creepage: case.creepage,
        theory_name: theory.name,
        theory: &*found.theory,
        solution: found.solution,
        points: found.points.clone(),
        details: found.details.clone(),
    };
    Report::new(&case.contact, case.friction, answer)
}

/// Says aloud what the status holds against the solution.
fn judge(status: Status) -> Outcome {
    if let Some(words) = caution(status) {
        say(&format!("caution: {words}"));
    }
    if status == Status::NotConverged { Outcome::Doubtful } else { Outcome::Done }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_solution_that_did_not_converge_is_doubtful() {
        assert_eq!(judge(Status::Solved), Outcome::Done);
        assert_eq!(judge(Status::CreepageTooSmall), Outcome::Done);
        assert_eq!(judge(Status::NotConverged), Outcome::Doubtful);
    }
}
