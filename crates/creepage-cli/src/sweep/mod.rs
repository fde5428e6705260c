//! `creepage sweep`: a series of cases of the numerical theory, in chains.

mod chains;
mod journal;
mod record;
mod result;

use std::path::{Path, PathBuf};
use std::time::Duration;

use creepage::rolling::variational::Method;
use creepage_case::Sweep;
use indicatif::ProgressBar;

use crate::args::{SeriesFormat, SweepArgs};
use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{bar_style, say};
use journal::{Journal, Opened};

pub(crate) fn run(args: &SweepArgs) -> Result<Outcome, Failure> {
    let path = &args.sweep;
    let text = read_text(path)?;
    let wrong = |source| Failure::Case { path: path.clone(), source };
    let sweep = Sweep::read(&text).map_err(wrong)?;
    let theory = sweep.theory().map_err(wrong)?;
    let format = format(args)?;
    let journal_path = journal_path(&args.out);
    let failed = |source| Failure::Write { path: journal_path.clone(), source };
    let journal = match Journal::open(&journal_path, &sweep).map_err(failed)? {
        Opened::Busy => return Err(Failure::Busy { path: journal_path.clone() }),
        Opened::Journal(journal) => journal,
    };
    let bar = bar(&sweep, &journal);
    if theory.keeps_bound() && sweep.procedure.method == Method::Damped {
        say("tractions are kept within their bound, by the least loss of power");
    }
    journal.synced(|| chains::solve(&sweep, &theory, &journal, &bar)).map_err(failed)?;
    bar.finish_and_clear();
    let tally = result::write(&sweep, &theory, &journal, format, &args.out)?;
    journal.remove().map_err(failed)?;
    say(&tally.to_string());
    Ok(tally.outcome())
}

fn format(args: &SweepArgs) -> Result<SeriesFormat, Failure> {
    let by_name = || match args.out.extension()?.to_str()? {
        "csv" => Some(SeriesFormat::Csv),
        "json" => Some(SeriesFormat::Json),
        "nc" => Some(SeriesFormat::Netcdf),
        "txt" => Some(SeriesFormat::Page),
        _ => None,
    };
    args.format.or_else(by_name).ok_or_else(|| Failure::Format { path: args.out.clone() })
}

fn journal_path(out: &Path) -> PathBuf {
    let mut name = out.as_os_str().to_owned();
    name.push(".journal");
    name.into()
}

/// Cases done, their rate and the time left; on a terminal only.
fn bar(sweep: &Sweep, journal: &Journal) -> ProgressBar {
    if journal.resumed() {
        say("going on with the sweep that was interrupted");
    }
    let style = bar_style("{wide_bar} {pos}/{len} cases  {per_sec}  {eta} left");
    let bar = ProgressBar::new(sweep.cases() as u64).with_style(style);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
