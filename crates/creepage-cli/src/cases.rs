//! Commands on one case file: `solve` and `hertz`.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use creepage::rolling::Status;
use creepage::Hertz;
use creepage_case::{Case, CaseError, CaseFile, InverseCase, Solve};
use creepage_report::{Report, ReportError, hertz_json, hertz_text};
use creepage_theories::{Answered, Entry, PreparedTheory, SolvedCase, wanted_accuracy};
use serde::Serialize;

use crate::Outcome;
use crate::args::{HertzArgs, SolveArgs};
use crate::caution::caution;
use crate::failure::Failure;
use crate::output::{print, say, say_written};

/// `creepage solve`: the files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let file = read(&args.case)?;
    let (theory, solved) = if file.is_inverse() {
        find_creepage(file.inverse().map_err(wrong)?, args)?
    } else {
        solve_case(file.case().map_err(wrong)?, args)?
    };
    let report = Report::of_case(&solved, theory.name)
        .map_err(|invalid| wrong(CaseError::Invalid { section: "contact", invalid }))?;
    if let Some(directory) = &args.out {
        say_written(&report.write(directory)?);
    }
    print(&if args.json { to_json(&report.json())? } else { report.text() })?;
    Ok(judge(&solved.found.answered, &solved.case.solve))
}

/// A case solved, and the theory that solved it.
type Solved = (&'static Entry, SolvedCase);

fn solve_case(case: Case, args: &SolveArgs) -> Result<Solved, Failure> {
    let (theory, prepared) = prepare((&case.contact, case.friction), &case.solve, args)?;
    Ok((theory, SolvedCase::forces(case, prepared)))
}

fn find_creepage(case: InverseCase, args: &SolveArgs) -> Result<Solved, Failure> {
    let (theory, prepared) = prepare((&case.contact, case.friction), &case.solve, args)?;
    let solved = SolvedCase::creepage(case, theory.name, prepared)
        .map_err(|source| Failure::Find { path: args.case.clone(), source })?;
    Ok((theory, solved))
}

/// The theory of the command line or of the case, prepared for its contact.
fn prepare(
    (contact, friction): (&Hertz, f64),
    solve: &Solve,
    args: &SolveArgs,
) -> Result<(&'static Entry, Arc<PreparedTheory>), Failure> {
    let theory = choose(args.theory.as_slice(), solve, &args.case)?[0];
    let failed = |source| Failure::Options { path: args.case.clone(), source };
    Ok((theory, theory.for_contact(contact, friction, solve).map(Arc::new).map_err(failed)?))
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
    solve: &Solve,
    path: &Path,
) -> Result<Vec<&'static Entry>, Failure> {
    let choice = creepage_theories::choose(names, solve)
        .map_err(|source| Failure::Choice { path: path.into(), source })?;
    if let Some(note) = choice.note() {
        say(&note);
    }
    Ok(choice.theories)
}

pub(crate) fn read(path: &Path) -> Result<CaseFile, Failure> {
    let text = read_text(path)?;
    CaseFile::read(&text).map_err(|source| Failure::Case { path: path.into(), source })
}

/// The text of a file of any kind.
pub(crate) fn read_text(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })
}

/// Says aloud what is to be held against the solution.
fn judge(answered: &Answered, solve: &Solve) -> Outcome {
    let status = answered.solution.status;
    if let Some(words) = caution(status) {
        say(&format!("caution: {words}"));
    }
    if let (Some(accuracy), Some(error)) = (wanted_accuracy(solve), answered.error)
        && error.fx.max(error.fy) > accuracy
    {
        say("caution: at the finest resolution the error bars are above the wanted accuracy");
    }
    if status == Status::NotConverged { Outcome::Doubtful } else { Outcome::Done }
}

#[cfg(test)]
mod tests {
    use creepage::rolling::{Force, Solution};

    use super::*;

    #[test]
    fn only_a_solution_that_did_not_converge_is_doubtful() {
        let judge = |status| {
            let solution = Solution { force: Force::default(), status };
            judge(&Answered { solution, error: None }, &Solve::default())
        };
        assert_eq!(judge(Status::Solved), Outcome::Done);
        assert_eq!(judge(Status::CreepageTooSmall), Outcome::Done);
        assert_eq!(judge(Status::NotConverged), Outcome::Doubtful);
    }
}
