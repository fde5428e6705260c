//! Commands on one case file: `solve` and `hertz`.

use std::path::{Path, PathBuf};

use creepage::normal::{self, NormalContact};
use creepage::{Creepage, Status};
use creepage_study::{
    AnyCase, AnyCaseFile, Caution, LineCase, LineFile, LineTheory, Sources, hertz_report,
    hertz_text, long_work, pressed_report, pressed_text,
};

use crate::args::{HertzArgs, SolveArgs};
use crate::failure::Failure;
use crate::input::{any_case, directory, read_any, read_text, sources_of, theories};
use crate::outcome::Outcome;
use crate::output::{print, say, say_written, to_json};

/// A case file that is read and checked.
enum ReadCase {
    Any(Box<AnyCase>),
    Line(Box<LineCase>),
}

/// `creepage solve`: one file after the other, when all of them are read and checked.
pub(crate) fn solve(args: &SolveArgs) -> Result<Outcome, Failure> {
    if args.more.is_empty() {
        return solve_one(args, read_one(args, &args.case)?, &sources_of(&args.case));
    }
    let cases: Vec<_> = [&args.case].into_iter().chain(&args.more).collect();
    if cases.iter().filter(|case| **case == Path::new("-")).count() > 1 {
        return Err(Failure::StdinTwice);
    }
    let mut sources = Sources::default();
    if let Some(out) = &args.out {
        each_its_own(&cases, out)?;
        sources = cases.iter().fold(sources, |all, case| all.with(&sources_of(case)));
    }
    let read = cases.iter().map(|case| read_one(args, case)).collect::<Result<Vec<_>, _>>()?;
    let mut outcome = Outcome::Done;
    for (case, read) in cases.into_iter().zip(read) {
        let name = case.file_stem().unwrap_or(case.as_os_str());
        let out = args.out.as_ref().map(|directory| directory.join(name));
        let one = SolveArgs { case: case.clone(), more: Vec::new(), out, ..args.clone() };
        if !args.json {
            print(&format!("== {}", case.display()))?;
        }
        outcome = outcome.or(solve_one(&one, read, &sources)?);
    }
    Ok(outcome)
}

/// Checks that no two cases have one directory for their results.
fn each_its_own(cases: &[&PathBuf], out: &Path) -> Result<(), Failure> {
    for (place, second) in cases.iter().enumerate() {
        let same = |first: &&&PathBuf| first.file_stem() == second.file_stem();
        if let Some(first) = cases[..place].iter().find(same) {
            let directory = out.join(second.file_stem().unwrap_or(second.as_os_str()));
            let [first, second] = [first, second].map(|path| PathBuf::clone(path));
            return Err(Failure::SameDirectory { first, second, directory });
        }
    }
    Ok(())
}

/// Reads a case file, and checks it and the theory's name.
fn read_one(args: &SolveArgs, path: &Path) -> Result<ReadCase, Failure> {
    let text = read_text(path)?;
    if !LineFile::is_one(&text) {
        let case = any_case(path, &text)?;
        if let Some(name) = &args.theory {
            case.theory_named(name)?;
        }
        return Ok(ReadCase::Any(Box::new(case)));
    }
    let wrong = |source| Failure::Case { path: path.into(), source };
    let mut case = LineFile::read(&text).and_then(|file| file.case()).map_err(wrong)?;
    if let Some(name) = &args.theory {
        let theory = LineTheory::named(name)
            .ok_or_else(|| Failure::LineTheory { path: path.into(), name: name.clone() })?;
        case = case.by(theory).map_err(wrong)?;
    }
    Ok(ReadCase::Line(Box::new(case)))
}

/// The files first, then the report, so that a wrong `--out` prints nothing.
fn solve_one(args: &SolveArgs, read: ReadCase, sources: &Sources) -> Result<Outcome, Failure> {
    let case = match read {
        ReadCase::Line(case) => return solve_line(args, &case, sources),
        ReadCase::Any(case) => *case,
    };
    let theories = theories(args.theory.as_slice(), &case)?;
    if let AnyCase::Ellipse(own) = &case
        && let Some(words) = long_work(theories.first().unwrap_or(&own.theory), &own.contact)
    {
        say(&format!("note: {words}"));
    }
    let solved = case
        .solve(theories.first())
        .map_err(|source| Failure::Gap { path: args.case.clone(), source: Box::new(source) })?;
    if let Some(directory) = &args.out {
        say_written(&solved.write(directory, sources)?);
    }
    print(&if args.json { to_json(&solved.report())? } else { solved.text() })?;
    for caution in &solved.cautions {
        say(&format!("caution: {caution}"));
    }
    let pressed = |areas: &NormalContact| areas.status() == normal::Status::Converged;
    let is_pressed = solved.areas().is_none_or(pressed);
    Ok(if is_pressed { outcome(solved.solution().status) } else { Outcome::Doubtful })
}

/// A line contact.
fn solve_line(args: &SolveArgs, case: &LineCase, sources: &Sources) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let solved = case.solve().map_err(wrong)?;
    if let Some(directory) = &args.out {
        say_written(&solved.write(directory, sources)?);
    }
    print(&if args.json { to_json(&solved.report())? } else { solved.text() })?;
    for caution in &solved.cautions {
        say(&format!("caution: {caution}"));
    }
    Ok(outcome(solved.status))
}

fn outcome(status: Status) -> Outcome {
    if status == Status::NotConverged { Outcome::Doubtful } else { Outcome::Done }
}

/// `creepage hertz`.
pub(crate) fn hertz(args: &HertzArgs) -> Result<(), Failure> {
    let wrong = |source| Failure::Case { path: args.case.clone(), source };
    let cautions = match read_any(&args.case)? {
        AnyCaseFile::Ellipse(file) => {
            let contact = file.hertz().map_err(wrong)?;
            let cautions = Caution::of_hertz(&contact, file.smallest_radius());
            let report = hertz_report(&contact, &cautions);
            print(&if args.json { to_json(&report)? } else { hertz_text(&contact, &cautions) })?;
            cautions
        }
        AnyCaseFile::Gap(file) => {
            let wrong = |source| Failure::Gap { path: args.case.clone(), source: Box::new(source) };
            let case = file.case_at_rest(directory(&args.case)).map_err(wrong)?;
            let case = AnyCase::Gap(case);
            let contact = case.contact().map_err(wrong)?;
            let cautions = case.cautions_of_units(&contact, Creepage::default());
            let Some(areas) = contact.areas() else { return Ok(()) };
            let report = pressed_report(areas, &cautions);
            print(&if args.json { to_json(&report)? } else { pressed_text(areas, &cautions) })?;
            cautions
        }
    };
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
