//! `creepage roll` with a wheelset file: wheels that roll in steps.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use creepage::Status;
use creepage_study::{
    Sources, WHEEL_STEP_COLUMNS, WheelStepsRun, WheelTable, WheelsetFileError, write_all,
};

use indicatif::{ProgressBar, ProgressDrawTarget};

use crate::args::RollArgs;
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::{bar_style, say, say_written};
use crate::wheelset;

/// The name of the file in `--out`.
const NAME: &str = "history.csv";

pub(crate) fn run(args: &RollArgs, table: &str) -> Result<Outcome, Failure> {
    let wrong = |source: WheelsetFileError| Failure::Wheelset {
        path: args.case.clone(),
        source: Box::new(source),
    };
    let case = wheelset::read(&args.case)?;
    let table = WheelTable::read(table.as_bytes()).map_err(|source| Failure::WheelTable {
        path: args.history.clone(),
        source: Box::new(source),
    })?;
    let sources = Sources::new([&args.case, &args.history]).with(&case.sources());
    if let Some(directory) = &args.out {
        sources.ensure_not_overwritten(&directory.join(NAME))?;
        refuse_earlier(directory)?;
    }
    let mut run = WheelStepsRun::new(&case, &table).map_err(wrong)?;
    let mut rows = vec![WHEEL_STEP_COLUMNS.join(",")];
    let mut out = io::stdout().lock();
    let mut tell = |row: &str| match &args.out {
        None => writeln!(out, "{row}").and_then(|()| out.flush()).map_err(Failure::Stdout),
        Some(_) => Ok(()),
    };
    let bar = ProgressBar::new(table.len() as u64)
        .with_style(bar_style("{wide_bar} {pos}/{len} rows  {eta} left"));
    if args.out.is_none() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    let mut not_converged = 0;
    loop {
        // Of a row that cannot be solved the table and the row are named.
        let row = PathBuf::from(format!("{}: row {}", args.history.display(), rows.len()));
        let failed = |source| Failure::Wheelset { path: row, source: Box::new(source) };
        let Some((distance, stepped)) = run.next_row().map_err(failed)? else { break };
        not_converged += usize::from(stepped.solved.status() == Status::NotConverged);
        // Nothing is said before a row is solved.
        if rows.len() == 1 {
            tell(&rows[0])?;
        }
        let row = WheelStepsRun::record(distance, &stepped).join(",");
        tell(&row)?;
        rows.push(row);
        bar.inc(1);
    }
    bar.finish_and_clear();
    if let Some(directory) = &args.out {
        write(directory, &rows, &run.picture(), &sources)?;
    }
    for words in run.cautions() {
        say(&format!("caution: {words}"));
    }
    if not_converged == 0 {
        return Ok(Outcome::Done);
    }
    say(&format!(
        "caution: {not_converged} rows did not converge: their forces are those of the last iterate"
    ));
    Ok(Outcome::Doubtful)
}

/// What a contact without wheels leaves beside its table, and would stand beside another one.
const OF_CONTACTS: [&str; 4] =
    ["rolling.png", "adhesion.svg", "adhesion.png", "history.csv.partial"];

fn refuse_earlier(directory: &Path) -> Result<(), Failure> {
    let paths = OF_CONTACTS.map(|name| directory.join(name));
    let earlier = paths.into_iter().find(|path| path.exists());
    earlier.map_or(Ok(()), |path| Err(Failure::OfAnotherHistory { path }))
}

fn write(directory: &Path, rows: &[String], svg: &str, sources: &Sources) -> Result<(), Failure> {
    let text = rows.join("\n") + "\n";
    let png = creepage_study::to_png(svg)?;
    let files =
        [(NAME, text.as_bytes()), ("history.svg", svg.as_bytes()), ("history.png", &png[..])];
    say_written(&write_all(directory, &files, sources)?);
    Ok(())
}
