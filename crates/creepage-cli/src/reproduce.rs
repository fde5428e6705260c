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
    /// What its columns are for: in words, and in the file.
    argument: &'static str,
    key: &'static str,
    /// Columns side by side in the thesis.
    block: usize,
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
    print(&tables.iter().map(Table::text).collect::<Vec<_>>().join("\n\n\n"))
}

/// Each table that is asked for, once, in the order of the thesis.
fn tables(items: &[Item]) -> Result<Vec<Table>, ReproduceError> {
    let asked = |item| items.contains(&item) || items.contains(&Item::All);
    let mut tables = vec![];
    if asked(Item::Table1) {
        tables.push(Table {
            name: "table1",
            title: "Table 1. C and D as functions of g",
            argument: "g",
            key: "g",
            block: 6,
            entries: table1()?,
        });
    }
    if asked(Item::Table2) {
        tables.push(Table {
            name: "table2",
            title: "Table 2. g, |e|, K, E as functions of tau",
            argument: "tau [deg]",
            key: "tau_deg",
            block: 10,
            entries: table2()?,
        });
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
        let rows: Vec<_> = self.entries.chunk_by(|one, two| one.quantity == two.quantity).collect();
        let columns: Vec<usize> = (0..rows.first().map_or(0, |row| row.len())).collect();
        for block in columns.chunks(self.block) {
            let _ = writeln!(text);
            for (number, row) in rows.iter().enumerate() {
                let line = |name: &str, cell: fn(&Entry) -> String| {
                    let cells = block.iter().filter_map(|&column| {
                        Some(format!("{:>1$}", cell(row.get(column)?), width(&rows, column)))
                    });
                    format!("  {name:<9}{}\n", cells.collect::<String>().trim_end())
                };
                if number == 0 {
                    text.push_str(&line(self.argument, |entry| head(entry) + " "));
                }
                text.push_str(&line(&row[0].quantity, marked));
            }
        }
    }

    /// How many entries are right, and which are not.
    fn summary(&self) -> String {
        let wrong: Vec<_> =
            self.entries.iter().filter(|entry| entry.verdict != Verdict::Right).collect();
        let (all, right) = (self.entries.len(), self.entries.len() - wrong.len());
        let mut text = format!("{}: {right} of {all} printed entries are right.", self.name);
        for row in wrong.chunk_by(|one, two| one.quantity == two.quantity) {
            let heads: Vec<_> = row.iter().map(|entry| head(entry)).collect();
            let _ = write!(text, "\n  wrong: {} at {}", row[0].quantity, heads.join(", "));
        }
        text
    }

    fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut writer = csv::Writer::from_writer(vec![]);
        writer.write_record(["quantity", self.key, "printed", "ours", "verdict"])?;
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

/// Width of a column: its longest entry with a mark, and white.
fn width(rows: &[&[Entry]], column: usize) -> usize {
    let lengths = rows.iter().filter_map(|row| Some(row.get(column)?.printed.len() + 2));
    lengths.fold(7, usize::max)
}

fn words(verdict: Verdict) -> String {
    match verdict {
        Verdict::Right => "right".into(),
        Verdict::Off(units) => format!("wrong by {units:+} in the last digit"),
    }
}
