//! Commands on one case file: `solve` and `hertz`.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use creepage::rolling::Status;
use creepage::rolling::exact::Known;
use creepage::{Hertz, InvalidValue};
use creepage_case::{Case, CaseError, CaseFile, InverseCase, Solve};
use creepage_report::{Answer, Extras, Report, ReportError, hertz_json, hertz_text};
use creepage_theories::{
    Answered, Entry, Examination, LeftOut, PreparedTheory, find_creepage, kappa_over_mu,
    wanted_accuracy,
};
use serde::Serialize;

use crate::Outcome;
use crate::args::{HertzArgs, SolveArgs};
use crate::caution::caution;
use crate::failure::Failure;
use crate::output::{print, say};

/// A case solved, whichever way it was asked.
struct SolvedCase {
    case: Case,
    theory: &'static Entry,
    found: Examination,
    /// What was given, where the creepage was found to wanted forces.
    known: Option<Known>,
}

impl SolvedCase {
    /// What the theory leaves out between unlike bodies.
    fn left_out(&self) -> Option<LeftOut> {
        self.theory.leaves_out(kappa_over_mu(&self.case.contact, self.case.friction))
    }
}

/// `creepage solve`: the files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let file = read(&args.case)?;
    let solved = if file.is_inverse() {
        solve_inverse(file.inverse().map_err(wrong)?, args)?
    } else {
        solve_direct(file.case().map_err(wrong)?, args)?
    };
    let report = report(&solved)
        .map_err(|invalid| wrong(CaseError::Invalid { section: "contact", invalid }))?;
    if let Some(directory) = &args.out {
        for path in report.write(directory)? {
            say(&format!("wrote {}", path.display()));
        }
    }
    print(&if args.json { to_json(&report.json())? } else { report.text() })?;
    if let Some(left_out) = solved.left_out() {
        say(&format!("caution: {left_out}"));
    }
    Ok(judge(&solved.found.answered, &solved.case.solve))
}

fn solve_direct(case: Case, args: &SolveArgs) -> Result<SolvedCase, Failure> {
    let theory = choose(args.theory.as_slice(), &case.solve, &args.case)?[0];
    let prepared = prepare(theory, (&case.contact, case.friction), &case.solve, args)?;
    let found = Examination::new(prepared, case.contact.ellipse(), case.creepage);
    Ok(SolvedCase { case, theory, found, known: None })
}

fn solve_inverse(case: InverseCase, args: &SolveArgs) -> Result<SolvedCase, Failure> {
    let theory = choose(args.theory.as_slice(), &case.solve, &args.case)?[0];
    let prepared = prepare(theory, (&case.contact, case.friction), &case.solve, args)?;
    let found = find_creepage(&case, theory.name, prepared)
        .map_err(|source| Failure::Find { path: args.case.clone(), source })?;
    let (known, case) = (Some(case.known), case.found(found.creepage()));
    Ok(SolvedCase { case, theory, found, known })
}

fn prepare(
    theory: &Entry,
    (contact, friction): (&Hertz, f64),
    solve: &Solve,
    args: &SolveArgs,
) -> Result<Arc<PreparedTheory>, Failure> {
    let failed = |source| Failure::Options { path: args.case.clone(), source };
    theory.for_contact(contact, friction, solve).map(Arc::new).map_err(failed)
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
    let text =
        fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    CaseFile::read(&text).map_err(|source| Failure::Case { path: path.into(), source })
}

fn report(solved: &SolvedCase) -> Result<Report<'_>, InvalidValue> {
    let SolvedCase { case, theory, found, known } = solved;
    let answer = Answer {
        creepage: case.creepage,
        theory_name: theory.name,
        theory: found,
        solution: found.answered.solution,
        points: found.points.clone(),
        details: found.details.clone(),
    };
    let extras = Extras {
        known: *known,
        speed: case.speed,
        power: found.power,
        dissipation: found.dissipation,
        left_out: solved.left_out(),
    };
    Ok(Report::new(&case.contact, case.friction, answer)?.with(extras))
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
