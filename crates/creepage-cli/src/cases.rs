//! Commands on one case file: `solve` and `hertz`.

use std::sync::Arc;

use creepage::Hertz;
use creepage::rolling::Status;
use creepage_study::{
    Answered, Case, CaseError, Entry, InverseCase, PreparedTheory, Report, Solve, SolvedCase,
    hertz_json, hertz_text, wanted_accuracy,
};

use crate::args::{HertzArgs, SolveArgs};
use crate::caution::caution;
use crate::failure::Failure;
use crate::input::{choose, read_case};
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// `creepage solve`: the files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let file = read_case(&args.case)?;
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
    if let Some(left_out) = solved.left_out(theory) {
        say(&format!("caution: {left_out}"));
    }
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
    let contact = read_case(&args.case)?
        .hertz()
        .map_err(|source| Failure::Case { path: args.case.clone(), source })?;
    print(&if args.json { to_json(&hertz_json(&contact))? } else { hertz_text(&contact) })
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
