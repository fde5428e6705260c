//! `creepage wear`: a wheelset's profiles over distance.

use std::path::PathBuf;
use std::time::Duration;

use creepage_study::{Sources, Wear, WearError, WearStop, WheelsetFile, WheelsetFileError, wear};

use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{self, print, say, say_written, to_json};
use crate::wheelset::say_found;

#[derive(Debug, clap::Args)]
pub(crate) struct WearArgs {
    /// Wheelset file with [wear].
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// Directory for tables, profiles, the report and pictures; made if need be.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Print the report as JSON.
    #[arg(long)]
    json: bool,
}

pub(crate) fn run(args: &WearArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Wear { path: args.case.clone(), source: Box::new(source) };
    let text = read_text(&args.case)?;
    let directory = args.case.parent().unwrap_or(std::path::Path::new(""));
    let file = WheelsetFile::read(&text)
        .map_err(|error| wrong(WearError::Wheelset(WheelsetFileError::from(error))))?;
    let case = file.case(directory).map_err(|error| wrong(error.into()))?;
    let plan = file.wear(&case, directory).map_err(wrong)?;
    let sources = plan.sources(&case).with(&Sources::new([&args.case]));
    let state = args.out.join(Wear::STATE);
    plan.ensure_not_overwritten(&args.out, &sources)?;
    let made = |source| Failure::Write { path: args.out.clone(), source };
    let is_new = !args.out.exists();
    std::fs::create_dir_all(&args.out).map_err(made)?;
    case.notes.iter().for_each(say_found);
    if case.heat.is_some() {
        say("note: [heat] is left out of wear: solve a position by itself for it");
    }
    let bar = output::bar(1000, "{msg} {wide_bar} {percent:>3} %  {left}");
    bar.enable_steady_tick(Duration::from_millis(200));
    let mut noted = 0;
    let mut failed = None;
    let mut progress = |part: f64, stops: &[WearStop]| {
        // Profiles as they come: a long run shows what it has.
        let begun = if part > 0.0 { stops } else { &[] };
        for (number, stop) in begun.iter().enumerate().skip(noted) {
            if let Err(error) = stop.write(number, &args.out, &sources) {
                failed = Some(error);
                return false;
            }
        }
        noted = begun.len();
        bar.set_message(format!("stop {} of {}", noted.saturating_sub(1), plan.stops));
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0 to 1000
        bar.set_position((1000.0 * part.clamp(0.0, 1.0)) as u64);
        true
    };
    let worn = wear(&case, &plan, Some(&state), &mut progress);
    bar.finish_and_clear();
    if let Some(error) = failed {
        return Err(wrong(error));
    }
    let worn = worn.map_err(|error| {
        if is_new {
            // Only where nothing is in it: a run that failed at once.
            let _ = std::fs::remove_dir(&args.out);
        }
        wrong(error)
    })?;
    say_written(&worn.write(&case, &plan, &args.out, &sources).map_err(wrong)?);
    // It holds nothing that the results do not.
    let _ = std::fs::remove_file(state);
    print(&if args.json { to_json(&worn.json())? } else { worn.text() })?;
    for words in &worn.cautions {
        say(&format!("caution: {words}"));
    }
    Ok(if worn.is_solved { Outcome::Done } else { Outcome::Doubtful })
}
