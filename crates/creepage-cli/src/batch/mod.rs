//! `creepage batch`: CSV in, the same rows with forces appended out.

mod columns;
mod progress;
mod rows;
mod sink;
mod solver;
mod table;
mod tally;

use std::io;

pub(crate) use columns::ColumnError;
use rows::Rows;
use sink::Sink;
use solver::Solver;
use table::Table;
use tally::Tally;

use crate::Outcome;
use crate::args::BatchArgs;
use crate::failure::Failure;
use crate::output::say;
use crate::theories;

/// Rows in memory at a time: enough to keep all cores busy.
const CHUNK: usize = 4096;

pub(crate) fn run(args: &BatchArgs) -> Result<Outcome, Failure> {
    let solver = Solver::new(theories::find(&args.theory)?);
    let table = Table::open(args.input.as_deref())?;
    let failed = |source: io::Error| Failure::writing(args.out.as_deref(), source);
    let mut sink = Sink::open(args.out.as_deref()).map_err(failed)?;
    let tally = fill(&mut sink, table, &solver, args)?;
    sink.finish().map_err(failed)?;
    say(&tally.to_string());
    Ok(tally.outcome())
}

/// Answers the table chunk by chunk, so that memory does not grow with its length.
fn fill(
    sink: &mut Sink,
    mut table: Table,
    solver: &Solver,
    args: &BatchArgs,
) -> Result<Tally, Failure> {
    let failed = |source: io::Error| Failure::writing(args.out.as_deref(), source);
    let bar = progress::bar(args);
    let mut out = Rows::start(sink, table.header()).map_err(failed)?;
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
