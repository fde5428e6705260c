//! Commands on one case file: `solve` and `hertz`.

use creepage::Status;
use creepage_study::{GapFile, hertz_json, hertz_text, solve as solve_case};

use crate::args::{HertzArgs, SolveArgs};
use crate::failure::Failure;
use crate::gap;
use crate::input::{parse_case, read_case, read_text, theories};
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// `creepage solve`: the files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
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
    let contact = read_case(&args.case)?
        .hertz()
        .map_err(|source| Failure::Case { path: args.case.clone(), source })?;
    print(&if args.json { to_json(&hertz_json(&contact))? } else { hertz_text(&contact) })
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
