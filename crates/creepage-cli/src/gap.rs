//! `creepage solve` of a case file with `[gap]`.

use std::path::Path;

use creepage::Status;
use creepage::normal;
use creepage_study::{GapFile, solve_gap};

use crate::args::SolveArgs;
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// The files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn solve(args: &SolveArgs, text: &str) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Gap { path: args.case.clone(), source: Box::new(source) };
    let directory = args.case.parent().unwrap_or(Path::new(""));
    let case = GapFile::read(text).and_then(|file| file.case(directory)).map_err(wrong)?;
    let case = match &args.theory {
        Some(name) => case.by_theory(name).map_err(wrong)?,
        None => case,
    };
    let solved = solve_gap(&case).map_err(wrong)?;
    if let Some(directory) = &args.out {
        say_written(&solved.write(directory)?);
    }
    print(&if args.json { to_json(&solved.json())? } else { solved.text() })?;
    for caution in &solved.cautions {
        say(&format!("caution: {caution}"));
    }
    let is_done = solved.solution().status != Status::NotConverged
        && solved.contact.status() == normal::Status::Converged;
    Ok(if is_done { Outcome::Done } else { Outcome::Doubtful })
}
