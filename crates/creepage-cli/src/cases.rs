//! Commands on one case file: `solve` and `hertz`.

use creepage::{SiCreepage, Status};
use creepage_study::{Caution, GapFile, HertzReportJson, hertz_text, solve as solve_case};

use crate::args::{HertzArgs, SolveArgs};
use crate::failure::Failure;
use crate::gap;
use crate::input::{parse_case, read_case, read_text, theories};
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// `creepage solve`: one file after the other.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
    if args.more.is_empty() {
        return solve_one(args);
    }
    let mut outcome = Outcome::Done;
    for case in [&args.case].into_iter().chain(&args.more) {
        let name = case.file_stem().unwrap_or(case.as_os_str());
        let out = args.out.as_ref().map(|directory| directory.join(name));
        let one = SolveArgs { case: case.clone(), more: Vec::new(), out, ..args.clone() };
        if !args.json {
            print(&format!("== {}", case.display()))?;
        }
        outcome = outcome.or(solve_one(&one)?);
    }
    Ok(outcome)
}

/// The files first, then the report, so that a wrong `--out` prints nothing.
fn solve_one(args: &SolveArgs) -> Result<Outcome, Failure> {
    let text = read_text(&args.case)?;
    if GapFile::is_one(&text) {
        return gap::solve(args, &text);
    }
    let case = parse_case(&args.case, &text)?
        .case()
        .map_err(|source| Failure::Case { path: args.case.clone(), source })?;
    let theories = theories(args.theory.as_slice(), &case)?;
    let solved = solve_case(&case, theories.first())
        .map_err(|source| Failure::Solve { path: args.case.clone(), source })?;
    if let Some(directory) = &args.out {
        say_written(&solved.write(directory)?);
    }
    print(&if args.json { to_json(&solved.json())? } else { solved.text() })?;
    for caution in &solved.cautions {
        say(&format!("caution: {caution}"));
    }
    Ok(outcome(solved.solution().status))
}

fn outcome(status: Status) -> Outcome {
    if status == Status::NotConverged { Outcome::Doubtful } else { Outcome::Done }
}

/// `creepage hertz`.
pub(crate) fn hertz(args: &HertzArgs) -> Result<(), Failure> {
    let file = read_case(&args.case)?;
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let contact = file.hertz().map_err(wrong)?;
    let cautions = Caution::units(&contact, file.smallest_radius(), SiCreepage::default());
    let report = HertzReportJson::new(&contact, &cautions);
    print(&if args.json { to_json(&report)? } else { hertz_text(&contact, &cautions) })?;
    for caution in cautions {
        say(&format!("caution: {caution}"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_solution_that_did_not_converge_is_doubtful() {
        assert_eq!(outcome(Status::Solved), Outcome::Done);
        assert_eq!(outcome(Status::CreepageTooSmall), Outcome::Done);
        assert_eq!(outcome(Status::NotConverged), Outcome::Doubtful);
    }
}
