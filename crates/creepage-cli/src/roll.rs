//! `creepage roll`: a contact that rolls as a table says.

use std::io::{self, Write};
use std::path::Path;
use std::time::Duration;

use creepage::Status;
use creepage_study::{
    HISTORY_COLUMNS, History, HistoryError, HistoryRun, HistoryWriter, RollFile, Sources,
    WheelsetFile, history_animation, history_picture, write_all,
};
use indicatif::ProgressBar;

use crate::args::RollArgs;
use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{bar_style, say, say_written};
use crate::roll_wheels;

pub(crate) fn run(args: &RollArgs) -> Result<Outcome, Failure> {
    let wrong = |path: &Path| {
        let path = path.to_owned();
        move |source: HistoryError| Failure::History { path, source: Box::new(source) }
    };
    let texts = [read_text(&args.case)?, read_text(&args.history)?];
    if WheelsetFile::is_one(&texts[0]) {
        return roll_wheels::run(args, &texts[1]);
    }
    let directory = args.case.parent().unwrap_or(Path::new(""));
    let file = RollFile::read(&texts[0]).map_err(wrong(&args.case))?;
    let case = file.case(directory).map_err(wrong(&args.case))?;
    let sources = Sources::new([&args.case, &args.history]).with(&file.sources(directory));
    let history = History::read(texts[1].as_bytes(), &case).map_err(wrong(&args.history))?;
    let mut run = HistoryRun::new(&case, &history).map_err(wrong(&args.case))?;
    for note in file.notes() {
        say(&format!("note: {note}"));
    }
    for caution in &case.cautions {
        say(&format!("caution: {caution}"));
    }
    if let Some((row, caution)) = history.caution(&case) {
        say(&format!("caution: row {row}: {caution}"));
    }
    let not_converged = match &args.out {
        None => to_stdout(&mut run).map_err(|error| error.placed(&args.history))?,
        Some(directory) => {
            sources.ensure_not_overwritten(&directory.join(HistoryWriter::NAME))?;
            // The case's own files count too: their numbers are in it.
            let words = format!("{}\0{case:?}", texts[0]);
            let texts = [&words[..], &texts[1][..]];
            let writer =
                HistoryWriter::open(directory, texts, &mut run)?.map_err(wrong(directory))?;
            let bar = bar(history.rows.len(), &run);
            to_file(&mut run, writer, &bar).map_err(|error| error.placed(&args.history))?
        }
    };
    if let Some(directory) = &args.out {
        write_pictures(&run, directory, &sources)?;
    }
    if not_converged == 0 {
        return Ok(Outcome::Done);
    }
    say(&format!(
        "caution: {not_converged} rows did not converge: their forces are those of the last iterate"
    ));
    Ok(Outcome::Doubtful)
}

/// What may go wrong on the way.
enum Stop {
    History(Box<HistoryError>),
    Other(Box<Failure>),
}

impl Stop {
    fn placed(self, path: &Path) -> Failure {
        match self {
            Self::History(source) => Failure::History { path: path.to_owned(), source },
            Self::Other(failure) => *failure,
        }
    }
}

/// The number of rows that did not converge.
fn to_stdout(run: &mut HistoryRun) -> Result<usize, Stop> {
    let mut out = io::stdout().lock();
    let failed = |source| Stop::Other(Box::new(Failure::Stdout(source)));
    writeln!(out, "{}", HISTORY_COLUMNS.join(",")).map_err(failed)?;
    let mut not_converged = 0;
    while let Some((distance, rolled)) =
        run.next_row().map_err(|error| Stop::History(Box::new(error)))?
    {
        not_converged += usize::from(rolled.solution.status == Status::NotConverged);
        let row = run.record(distance, &rolled).join(",");
        writeln!(out, "{row}").and_then(|()| out.flush()).map_err(failed)?;
    }
    Ok(not_converged)
}

fn to_file(
    run: &mut HistoryRun,
    mut writer: HistoryWriter,
    bar: &ProgressBar,
) -> Result<usize, Stop> {
    let failed = |error: creepage_study::ReportError| Stop::Other(Box::new(error.into()));
    let mut not_converged = 0;
    while let Some((distance, rolled)) =
        run.next_row().map_err(|error| Stop::History(Box::new(error)))?
    {
        not_converged += usize::from(rolled.solution.status == Status::NotConverged);
        writer.write(&run.record(distance, &rolled), run).map_err(failed)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    say_written(&[writer.finish().map_err(failed)?]);
    Ok(not_converged)
}

fn write_pictures(run: &HistoryRun, directory: &Path, sources: &Sources) -> Result<(), Failure> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    for (name, svg) in history_picture(run) {
        let png = creepage_study::to_png(&svg)?;
        files.push((format!("{name}.png"), png));
        files.push((format!("{name}.svg"), svg.into_bytes()));
    }
    if let Some(bytes) = history_animation(run)? {
        files.push(("rolling.png".into(), bytes));
    }
    let files: Vec<_> = files.iter().map(|(name, bytes)| (&name[..], &bytes[..])).collect();
    say_written(&write_all(directory, &files, sources)?);
    Ok(())
}

/// Rows done and the time left; on a terminal only.
fn bar(rows: usize, run: &HistoryRun) -> ProgressBar {
    if run.done() > 0 {
        say("going on with the history that was interrupted");
    }
    let style = bar_style("{wide_bar} {pos}/{len} rows  {eta} left");
    let bar = ProgressBar::new(rows as u64).with_style(style);
    bar.set_position(run.done() as u64);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
