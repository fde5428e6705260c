//! `creepage bearing`: a ball bearing.

use creepage_study::{BearingCaseError, BearingFile, BearingReport, Sources};

use crate::args::BearingArgs;
use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// The files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &BearingArgs) -> Result<Outcome, Failure> {
    let text = read_text(&args.case)?;
    let wrong = |source| Failure::Bearing { path: args.case.clone(), source };
    let case = BearingFile::read(&text).and_then(|file| file.case());
    let case = case.map_err(BearingCaseError::from).map_err(wrong)?;
    let report = BearingReport::solve(case).map_err(wrong)?;
    if let Some(directory) = &args.out {
        say_written(&report.write(directory, &Sources::new([&args.case]))?);
    }
    print(&if args.json { to_json(&report.report())? } else { report.text() })?;
    for caution in report.cautions() {
        say(&format!("caution: {caution}"));
    }
    let is_solved = report.solved.status() == creepage::Status::Solved;
    Ok(if is_solved { Outcome::Done } else { Outcome::Doubtful })
}
