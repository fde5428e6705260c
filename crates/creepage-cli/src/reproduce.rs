//! `creepage reproduce`: the thesis's tables computed again, beside what was printed.

use std::fmt::Write;

use clap::ValueEnum;
use creepage_report::{ReportError, write_all};
use creepage_validation::{Entry, Table2Error, TableError, Verdict, table1, table2};

use crate::args::ReproduceArgs;
use crate::failure::Failure;
use crate::output::{print, say};

/// What can be reproduced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Item {
    /// The elliptic integrals C and D.
    Table1,
    /// The shape of the contact ellipse, with K and E.
    Table2,
    /// All of these.
    All,
}

/// A damaged table in the program itself.
#[derive(Debug, thiserror::Error)]
pub(crate) enum ReproduceError {
    #[error(transparent)]
    Table(#[from] TableError),
    #[error(transparent)]
    Table2(#[from] Table2Error),
}

/// A table of the thesis.
struct Table {
    /// Its name on the command line, and that of its file.
    name: &'static str,
    title: &'static str,
    /// What its columns are for.
    argument: &'static str,
    entries: Vec<Entry>,
}

/// The files first, then the tables, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &ReproduceArgs) -> Result<(), Failure> {
    let tables = tables(&args.items)?;
    if let Some(directory) = &args.out {
        let csv = tables.iter().map(Table::csv).collect::<Result<Vec<_>, _>>();
        let csv = csv.map_err(ReportError::from)?;
        let names: Vec<_> = tables.iter().map(|table| format!("{}.csv", table.name)).collect();
        let files: Vec<_> =
            names.iter().zip(&csv).map(|(name, csv)| (&name[..], &csv[..])).collect();
        for path in write_all(directory, &files)? {
            say(&format!("wrote {}", path.display()));
        }
    }
    print(&tables.iter().map(Table::text).collect::<Vec<_>>().join("\n\n"))
}

/// Each table that is asked for, once, in the order of the thesis.
fn tables(items: &[Item]) -> Result<Vec<Table>, ReproduceError> {
    let asked = |item| items.contains(&item) || items.contains(&Item::All);
    let mut tables = vec![];
    if asked(Item::Table1) {
        let (title, argument) = ("Table 1. C and D as functions of g", "g");
        tables.push(Table { name: "table1", title, argument, entries: table1()? });
    }
    if asked(Item::Table2) {
        let (title, argument) = ("Table 2. g, |e|, K, E as functions of tau", "tau [deg]");
        tables.push(Table { name: "table2", title, argument, entries: table2()? });
    }
    Ok(tables)
}

impl Table {
    fn text(&self) -> String {
        let mut text = format!("{}\n\nAs printed in 1967; * marks a wrong entry.\n", self.title);
        self.layout(&mut text);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "\n  {:>9}  {:>8}  {:>10}  {:>12}  verdict",
            self.argument, "quantity", "printed", "ours"
        );
        for entry in &self.entries {
            let _ = writeln!(
                text,
                "  {:>9}  {:>8}  {:>10}  {:>12}  {}",
                head(entry),
                entry.quantity,
                entry.printed,
                entry.ours,
                words(entry.verdict)
            );
        }
        let _ = write!(text, "\n{}", self.summary());
        text
    }

    /// The table as the thesis has it: a row a quantity, a column an argument.
    fn layout(&self, text: &mut String) {
        for (number, row) in self.rows().enumerate() {
            let mut line = |name: &str, cells: Vec<String>| {
                let cells: String =
                    cells.iter().zip(row).map(|(cell, e)| pad(cell, column(e))).collect();
                let _ = writeln!(text, "  {name:<9}{}", cells.trim_end());
            };
            if number == 0 {
                line(self.argument, row.iter().map(|entry| head(entry) + " ").collect());
            }
            line(&row[0].quantity, row.iter().map(marked).collect());
        }
    }

    fn rows(&self) -> impl Iterator<Item = &[Entry]> {
        self.entries.chunk_by(|one, two| one.quantity == two.quantity)
    }

    fn summary(&self) -> String {
        let wrong: Vec<_> =
            self.entries.iter().filter(|entry| entry.verdict != Verdict::Right).collect();
        let (all, right) = (self.entries.len(), self.entries.len() - wrong.len());
        let mut text = format!("{}: {right} of {all} printed entries are right", self.name);
        for (k, entry) in wrong.iter().enumerate() {
            let join = if k == 0 { "; wrong are" } else { "," };
            let _ = write!(text, "{join} {}({})", entry.quantity, head(entry));
        }
        text + ".\n"
    }

    fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut writer = csv::Writer::from_writer(vec![]);
        writer.write_record(["quantity", self.argument, "printed", "ours", "verdict"])?;
        for entry in &self.entries {
            let (argument, verdict) = (entry.argument.to_string(), words(entry.verdict));
            let row = [&entry.quantity, &argument, &entry.printed, &entry.ours, &verdict];
            writer.write_record(row)?;
        }
        writer.into_inner().map_err(|error| error.into_error().into())
    }
}

/// The head of an entry's column.
fn head(entry: &Entry) -> String {
    if entry.argument == 0.0 { "->0".into() } else { entry.argument.to_string() }
}

/// The entry as printed, with a mark when it is wrong.
fn marked(entry: &Entry) -> String {
    let mark = if entry.verdict == Verdict::Right { ' ' } else { '*' };
    format!("{}{mark}", entry.printed)
}

/// Width of an entry's column: those of limits are wide.
fn column(entry: &Entry) -> usize {
    if entry.printed.len() > 7 { 11 } else { 7 }
}

fn pad(cell: &str, width: usize) -> String {
    format!("{cell:>width$}")
}

fn words(verdict: Verdict) -> String {
    match verdict {
        Verdict::Right => "right".into(),
        Verdict::Off(units) => format!("wrong by {units:+} in the last digit"),
    }
}
