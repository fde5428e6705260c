//! `creepage fit`: friction from measured forces.

use std::time::Duration;

use creepage_study::{Fit, FitError, FitOptions, MeasuredPoints, Sources};
use indicatif::ProgressBar;

use crate::args::FitArgs;
use crate::failure::Failure;
use crate::input::{directory, read_any, read_text, sources_of, theories};
use crate::outcome::Outcome;
use crate::output::{bar_style, is_quiet, print, say, say_written, to_json};

/// The files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &FitArgs) -> Result<Outcome, Failure> {
    let measured = MeasuredPoints::read(&read_text(&args.points)?)
        .map_err(|source| Failure::Measured { path: args.points.clone(), source })?;
    let place = directory(&args.case);
    let file = read_any(&args.case)?;
    let case = file
        .case(place)
        .map_err(|source| Failure::Gap { path: args.case.clone(), source: Box::new(source) })?;
    let theories = theories(args.theory.as_slice(), &case)?;
    let spec = theories.first().unwrap_or(case.theory());
    let bar = spinner();
    let mut proceeds = || {
        bar.inc(1);
        true
    };
    let options = FitOptions { slope: args.slope };
    let fit = Fit::new(&file, place, spec, &measured, options, &mut proceeds);
    bar.finish_and_clear();
    let fit = fit.map_err(|source| failed(args, source))?;
    if let Some(directory) = &args.out {
        let sources = sources_of(&args.case).with(&Sources::new([&args.points]));
        say_written(&fit.write(directory, &sources)?);
    }
    print(&if args.json { to_json(&fit.json())? } else { fit.text() })?;
    for words in measured.left_out() {
        say(&format!("caution: {words}"));
    }
    Ok(if measured.unread.is_empty() { Outcome::Done } else { Outcome::Doubtful })
}

/// What is wrong with the case names its file, all else the points'.
fn failed(args: &FitArgs, source: FitError) -> Failure {
    let path = match &source {
        FitError::Case(_) | FitError::FrictionLaw => &args.case,
        _ => &args.points,
    };
    Failure::Fit { path: path.clone(), source }
}

/// Evaluations of all points, whose number is not known beforehand; on a terminal only.
fn spinner() -> ProgressBar {
    if is_quiet() {
        return ProgressBar::hidden();
    }
    let style = bar_style("{spinner} curve number {pos} through the points  {per_sec}");
    let bar = ProgressBar::new_spinner().with_style(style);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
