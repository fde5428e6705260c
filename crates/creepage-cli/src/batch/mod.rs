//! `creepage batch`: CSV in, the same rows with forces appended out.

pub(crate) mod columns;
mod progress;
mod rows;
mod solver;
mod table;
mod tally;

use std::io::{self, Stdout, Write};
use std::path::Path;

use creepage::{Contact, Ellipse, TheorySpec};
use creepage_study::{WholeFile, theory_spec};
use rows::{Rows, answer_columns};
use solver::Solver;
use table::Table;
use tally::Tally;

use crate::args::BatchArgs;
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::say;

/// Rows in memory at a time: enough to keep all cores busy.
const CHUNK: usize = 4096;

pub(crate) fn run(args: &BatchArgs) -> Result<Outcome, Failure> {
    let theory = theory(args)?;
    let error_bars = theory.facts().error_bars;
    let table = Table::open(args.input.as_deref(), answer_columns(error_bars))?;
    let failed = |source: io::Error| Failure::writing(args.out.as_deref(), source);
    let mut sink = Sink::open(args.out.as_deref()).map_err(failed)?;
    let rows = Rows::start(&mut sink, table.header(), error_bars).map_err(failed)?;
    let tally = fill(rows, table, &Solver::new(theory), args)?;
    sink.finish().map_err(failed)?;
    say(&tally.to_string());
    if let Some(caution) = tally.caution() {
        say(&caution);
    }
    Ok(tally.outcome())
}

/// The theory with its options, of values that it takes.
fn theory(args: &BatchArgs) -> Result<TheorySpec, Failure> {
    let name = TheorySpec::named(&args.theory)?.facts().name;
    let theory = theory_spec(name, &args.options).map_err(Failure::Option)?;
    if !args.options.is_empty() {
        // No row could be answered if the theory took its options not even for a circle.
        let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.25)?;
        let failed = |source| Failure::Value { source };
        theory.prepare(&circle).map_err(failed)?;
    }
    Ok(theory)
}

/// Where rows go.
enum Sink {
    Stdout(Stdout),
    File(WholeFile),
}

impl Sink {
    fn open(out: Option<&Path>) -> io::Result<Self> {
        out.map_or_else(
            || Ok(Self::Stdout(io::stdout())),
            |path| WholeFile::create(path).map(Self::File),
        )
    }

    fn finish(self) -> io::Result<()> {
        match self {
            Self::Stdout(mut stdout) => stdout.flush(),
            Self::File(file) => file.finish(),
        }
    }

    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Self::Stdout(stdout) => stdout,
            Self::File(file) => file,
        }
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer().flush()
    }
}

/// Answers the table chunk by chunk, so that memory does not grow with its length.
fn fill(
    mut out: Rows<&mut Sink>,
    mut table: Table,
    solver: &Solver,
    args: &BatchArgs,
) -> Result<Tally, Failure> {
    let failed = |source: io::Error| Failure::writing(args.out.as_deref(), source);
    let bar = progress::bar(args);
    loop {
        let rows = table.next_rows(CHUNK)?;
        if rows.is_empty() {
            bar.finish_and_clear();
            return out.finish().map_err(failed);
        }
        let questions = rows.iter().map(|row| table.columns().question(row)).collect();
        for (row, answer) in rows.into_iter().zip(solver.solve(questions)) {
            out.write(row, &answer).map_err(failed)?;
        }
        bar.set_position(table.position());
        bar.set_message(format!("{} rows", out.tally().rows()));
    }
}
