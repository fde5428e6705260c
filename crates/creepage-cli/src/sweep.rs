//! `creepage sweep`: a series of cases of the numerical theory, in chains.

use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use creepage::variational::{Method, Variational};
use creepage_1967::{Page, PageStyle};
use creepage_study::{
    ReportError, SeriesHead, Sources, Sweep, SweepRun, WholeFile, series_csv, series_json,
    series_netcdf,
};
use indicatif::ProgressBar;

use crate::args::{SeriesFormat, SweepArgs};
use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{self, say};

pub(crate) fn run(args: &SweepArgs) -> Result<Outcome, Failure> {
    let path = &args.sweep;
    let text = read_text(path)?;
    let wrong = |source| Failure::Case { path: path.clone(), source };
    let sweep = Sweep::read(&text).map_err(wrong)?;
    let theory = sweep.theory().map_err(wrong)?;
    let format = format(args)?;
    Sources::new([path]).ensure_not_overwritten(&args.out)?;
    let journal = journal_path(&args.out);
    let failed = |source| Failure::Write { path: journal.clone(), source };
    let run = SweepRun::open(&sweep, &theory, &journal)
        .map_err(failed)?
        .ok_or_else(|| Failure::Busy { path: journal.clone() })?;
    let bar = bar(&sweep, &run);
    if theory.keeps_bound() && sweep.procedure.method == Method::Damped {
        say("tractions are kept within their bound, by the least loss of power");
    }
    run.solve(|| bar.inc(1)).map_err(failed)?;
    bar.finish_and_clear();
    write(&run, &sweep, &theory, format, &args.out)?;
    let tally = run.finish().map_err(failed)?;
    say(&tally.to_string());
    Ok(if tally.not_converged > 0 { Outcome::Doubtful } else { Outcome::Done })
}

/// Writes the results, case by case.
fn write(
    run: &SweepRun,
    sweep: &Sweep,
    theory: &Variational,
    format: SeriesFormat,
    path: &Path,
) -> Result<(), Failure> {
    let failed = |source| Failure::Write { path: path.into(), source };
    let report = |error| match error {
        ReportError::Series(source) => failed(source),
        other => Failure::Report(other),
    };
    let mut file = WholeFile::create(path).map_err(failed)?;
    let head = SeriesHead::from(sweep);
    let rows = || run.rows();
    match format {
        SeriesFormat::Csv => series_csv(&head, rows().map_err(failed)?, buffered(&mut file)),
        SeriesFormat::Json => series_json(&head, rows().map_err(failed)?, buffered(&mut file)),
        SeriesFormat::Netcdf => file.fill(|path| series_netcdf(&head, rows, path)),
        SeriesFormat::Page => pages(run, sweep, theory, PageStyle::English, buffered(&mut file)),
        SeriesFormat::Page1967 => pages(run, sweep, theory, PageStyle::Of1967, buffered(&mut file)),
    }
    .map_err(report)?;
    file.finish().map_err(failed)
}

fn buffered(file: &mut WholeFile) -> impl Write {
    BufWriter::with_capacity(1 << 16, file)
}

/// A page a case.
fn pages(
    run: &SweepRun,
    sweep: &Sweep,
    theory: &Variational,
    style: PageStyle,
    mut out: impl Write,
) -> Result<(), ReportError> {
    run.replay(|case, steps, found| {
        let page = Page {
            theory,
            loops: [case.chi, case.upsilon, case.alpha],
            creepage: case.creepage,
            steps,
            found,
            mesh: sweep.settings.mesh,
            lines: &sweep.page_lines,
        };
        writeln!(out, "{}", page.text(style)).map_err(ReportError::from)
    })?;
    Ok(out.flush()?)
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
fn bar(sweep: &Sweep, run: &SweepRun) -> ProgressBar {
    if run.resumed() {
        say("going on with the sweep that was interrupted");
    }
    let style = "{wide_bar} {pos}/{len} cases  {per_sec}  {left}";
    let bar = output::bar(sweep.cases() as u64, style);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
