//! `creepage batch`: CSV in, the same rows with forces appended out.

pub(crate) mod columns;
mod gaps;
mod row_query;
mod rows;
mod stream;
mod table;
mod tally;
mod wheelsets;

use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use creepage::{Contact, Ellipse, TheorySpec};
use creepage_study::{
    AnyCaseFile, BulkQuery, CaseFile, Damage, DamageWanted, Solver, Sources, theory_spec,
};
use csv::ByteRecord;
use rayon::prelude::*;

use columns::{CaseColumns, ColumnError, Columns, NoCase};
use row_query::{Ask, RowQuery};
use rows::{Answer, Rows, Sink};
use stream::{Stream, progress_bar};
use table::{Table, goes_on};
use tally::Tally;

use crate::batch_args::BatchArgs;
use crate::failure::Failure;
use crate::input::sources_of;
use crate::input::{is_wheelset, read_any, read_table};
use crate::outcome::Outcome;
use crate::output::say;

pub(crate) fn run(args: &BatchArgs) -> Result<Outcome, Failure> {
    if let Some(path) = args.case.as_deref().filter(|path| is_wheelset(path)) {
        return wheelsets::run(args, path);
    }
    let case = match args.case.as_deref().map(|path| (path, read_any(path))) {
        Some((path, file)) => match file? {
            AnyCaseFile::Gap(file) => return gaps::run(args, path, *file),
            AnyCaseFile::Ellipse(file) => Some(*file),
        },
        None => None,
    };
    let solver = solver(args, case.as_ref())?;
    let table = Table::open(args.input.as_deref())?;
    if case.as_ref().is_some_and(CaseFile::has_damage) {
        let names = Damage::OF_ROWS.join(", ");
        say(&format!("note: of [damage] rows have {names}; solve a case by itself for the others"));
    }
    let ask = ask(&table, args.case.as_deref().zip(case.as_ref()), &solver)?;
    let appended = appended(&table, &ask, solver.error_bars())?;
    let answers = |rows: &[ByteRecord]| Ok(replies(&ask, &solver, rows));
    let tally =
        write_answers(args, table, &appended, ask.damage(), answers, |out, row, answer| {
            out.write(row, answer)
        })?;
    tally.cautions().iter().for_each(|caution| say(caution));
    Ok(tally.outcome())
}

/// The theory with its options, of values that it takes; or the table.
fn solver(args: &BatchArgs, case: Option<&CaseFile>) -> Result<Solver, Failure> {
    if let Some(path) = &args.table {
        let table = read_table(path)?;
        let accuracy = table.accuracy();
        say(&format!(
            "note: {}: largest error {:.2} % of mu N, of the moment {:.2} % of mu N c",
            path.display(),
            100.0 * accuracy.force.worst,
            100.0 * accuracy.moment.worst
        ));
        return Ok(Solver::of_table(Arc::new(table)));
    }
    let of_file = |path, source| Failure::Case { path, source };
    let spec = match (&args.theory, case, &args.case) {
        (None, Some(file), Some(path)) => {
            file.theory().map_err(|error| of_file(path.clone(), error))?
        }
        (name, ..) => {
            let name = TheorySpec::named(name.as_deref().unwrap_or("exact"))?.facts().name;
            theory_spec(name, &args.options).map_err(Failure::Option)?
        }
    };
    if !args.options.is_empty() {
        // No row could be answered if the theory took its options not even for a circle.
        let circle = Contact::new(Ellipse::from_ratio(1.0)?, 0.25)?;
        let failed = |source| Failure::Value { source };
        spec.prepare(&circle).map_err(failed)?;
    }
    Ok(Solver::new(spec))
}

/// How the columns of the table ask.
fn ask(table: &Table, case: Option<(&Path, &CaseFile)>, solver: &Solver) -> Result<Ask, Failure> {
    let of_table = |source| Failure::Columns { input: table.name.clone(), source };
    let Some((path, file)) = case else {
        let found = Columns::find(&table.header, solver.only_contact());
        return found.map(Ask::Dimensionless).map_err(of_table);
    };
    match CaseColumns::find(&table.header, file) {
        Ok(columns) => Ok(Ask::Case(Box::new(columns))),
        Err(ColumnError::Case(source)) => Err(Failure::Case { path: path.into(), source: *source }),
        Err(source) => Err(of_table(source)),
    }
}

/// The columns that are to be appended; none of them may be there already.
fn appended(table: &Table, ask: &Ask, error_bars: bool) -> Result<Vec<&'static str>, Failure> {
    let appended = ask.appended(error_bars);
    free(table, &appended)?;
    Ok(appended)
}

fn free(table: &Table, appended: &[&'static str]) -> Result<(), Failure> {
    let there = |name: &&&str| table.header.iter().any(|own| own.trim_ascii() == name.as_bytes());
    if let Some(taken) = appended.iter().find(there) {
        let source = ColumnError::Taken(taken);
        return Err(Failure::Columns { input: table.name.clone(), source });
    }
    Ok(())
}

/// Writes the table with what `answers` has for each portion of its rows.
fn write_answers<A>(
    args: &BatchArgs,
    table: Table,
    appended: &[&str],
    damage: Option<DamageWanted>,
    answers: impl Fn(&[ByteRecord]) -> Result<Vec<A>, Failure>,
    write: impl Fn(&mut Rows<&mut Sink>, ByteRecord, A) -> io::Result<()>,
) -> Result<Tally, Failure> {
    let failed = |source: io::Error| Failure::writing(args.out.as_deref(), source);
    if let Some(out) = &args.out {
        let read = args.case.as_deref().map(sources_of).unwrap_or_default();
        let rows = args.input.as_deref().filter(|input| *input != Path::new("-"));
        let others = Sources::new(args.table.as_deref().into_iter().chain(rows));
        read.with(&others).ensure_not_overwritten(out)?;
    }
    let mut sink = Sink::open(args.out.as_deref()).map_err(failed)?;
    sink.write_all(&table.comments).map_err(failed)?;
    let rows = Rows::start(&mut sink, &table.header, appended, table.delimiter).map_err(failed)?;
    let tally = fill(rows.with_damage(damage), table, args, answers, write)?;
    sink.finish().map_err(failed)?;
    say(&tally.to_string());
    Ok(tally)
}

/// Answers the table portion by portion, so that memory does not grow with its length.
fn fill<A>(
    mut out: Rows<&mut Sink>,
    table: Table,
    args: &BatchArgs,
    answers: impl Fn(&[ByteRecord]) -> Result<Vec<A>, Failure>,
    write: impl Fn(&mut Rows<&mut Sink>, ByteRecord, A) -> io::Result<()>,
) -> Result<Tally, Failure> {
    let failed = |source: io::Error| Failure::writing(args.out.as_deref(), source);
    let bar = progress_bar(args);
    let (columns, delimiter) = (table.header.len(), table.delimiter);
    let (mut stream, name) = (Stream::start(table.reader), table.name);
    let mut open = 0;
    loop {
        let rows = stream.next().map_err(|source| Failure::Rows { input: name.clone(), source })?;
        if rows.is_empty() {
            bar.finish_and_clear();
            if open > 0 {
                let have = if open == 1 { "row has" } else { "rows have" };
                say(&format!(
                    "caution: {name}: {open} {have} a field that holds other rows: is a quote left open?"
                ));
            }
            return Ok(out.finish().map_err(failed)?.with_open_quotes(open));
        }
        open += rows.iter().filter(|row| holds_others(row, columns, delimiter)).count();
        let answers = answers(&rows)?;
        for (row, answer) in rows.into_iter().zip(answers) {
            write(&mut out, row, answer).map_err(failed)?;
        }
        out.flush().map_err(failed)?;
        bar.set_position(stream.position());
        bar.set_message(format!("{} rows", out.tally().rows()));
    }
}

/// Whether a row has a field that holds lines below it, as after a quote that is left open: what it swallows has as
/// many separators as a row, or what it leaves is no row.
fn holds_others(row: &ByteRecord, columns: usize, delimiter: u8) -> bool {
    let parts = |field: &[u8]| field.split(|byte| *byte == delimiter).count();
    let is_wrong = row.len() != columns;
    row.iter().any(|field| goes_on(field) && (is_wrong || parts(field) >= columns))
}

/// The answers to rows, in their order.
fn replies(ask: &Ask, solver: &Solver, rows: &[ByteRecord]) -> Vec<Answer> {
    let asked: Vec<_> = rows.par_iter().map(|row| ask.of(row)).collect();
    let replies = solver.solve(asked.iter().map(query).collect());
    let together = asked.into_iter().zip(replies);
    together.map(|(asked, reply)| asked.and_then(|asked| Ok((asked, reply?)))).collect()
}

fn query(asked: &Result<RowQuery, NoCase>) -> Result<BulkQuery, NoCase> {
    asked.as_ref().map(RowQuery::query).map_err(Clone::clone)
}
