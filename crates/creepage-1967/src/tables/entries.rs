//! A table of the thesis, entry by entry: as text, as CSV, as lines of agreement.

use std::fmt::Write;

use super::printed::{Entry, Judgement};
use crate::prelude::*;

/// Rows with common heads of columns.
pub(crate) struct Block {
    /// What the heads of its columns are, in words.
    pub(crate) argument: &'static str,
    /// Columns side by side in the thesis.
    pub(crate) columns: usize,
    pub(crate) entries: Vec<Entry>,
}

/// A table of the thesis.
pub(crate) struct Table {
    pub(crate) item: Item,
    /// What the heads of its columns are, in the file.
    pub(crate) key: &'static str,
    pub(crate) blocks: Vec<Block>,
}

impl Table {
    /// With the reason why entries that are wrong are known to be misprints.
    pub(crate) fn reproduction(&self, caption: &str, misprint: &str) -> Reproduction {
        Reproduction::table(self.text(), caption, self.data(), self.agreement(misprint))
    }

    fn entries(&self) -> impl Iterator<Item = (&Block, &Entry)> {
        self.blocks.iter().flat_map(|block| block.entries.iter().map(move |entry| (block, entry)))
    }

    fn wrong(&self) -> impl Iterator<Item = (&Block, &Entry)> {
        self.entries().filter(|(_, entry)| entry.verdict != Judgement::Right)
    }

    fn text(&self) -> String {
        let title = self.item.title;
        let mut text = format!("{title}\n\nAs printed in 1967; * marks a wrong entry.\n");
        for block in &self.blocks {
            block.layout(&mut text);
        }
        for block in &self.blocks {
            block.list(&mut text);
        }
        text + "\n" + &self.summary()
    }

    /// How many entries are right, and which are not.
    fn summary(&self) -> String {
        let (all, wrong) = (self.entries().count(), self.wrong().count());
        let right = all - wrong;
        let mut text = format!("{}: {right} of {all} printed entries are right.", self.item.name);
        for block in &self.blocks {
            let wrong: Vec<_> =
                block.entries.iter().filter(|entry| entry.verdict != Judgement::Right).collect();
            for row in wrong.chunk_by(|one, two| one.quantity == two.quantity) {
                let heads: Vec<_> = row.iter().map(|entry| head(entry)).collect();
                // Writing to a String cannot fail.
                let _ = write!(text, "\n  wrong: {} at {}", row[0].quantity, heads.join(", "));
            }
        }
        text
    }

    fn data(&self) -> Data {
        let mut data = Data::new(["quantity", self.key, "printed", "ours", "verdict"]);
        for (_, entry) in self.entries() {
            let verdict = words(entry.verdict);
            data.push([
                (&entry.quantity).into(),
                entry.argument.into(),
                (&entry.printed).into(),
                (&entry.ours).into(),
                (&verdict).into(),
            ]);
        }
        data
    }

    /// All entries in one line, and each that is wrong in one of its own.
    fn agreement(&self, misprint: &str) -> Vec<Comparison> {
        let (all, wrong) = (self.entries().count(), self.wrong().count());
        let ours = format!("{} of {all} entries as printed", all - wrong);
        let all = Comparison::claim("all entries", "to the digits printed", ours, wrong == 0)
            .misprint("the wrong ones follow");
        let one = |(block, entry): (&Block, &Entry)| {
            let quantity = format!("{} at {} = {}", entry.quantity, block.argument, head(entry));
            let ours = entry.ours.parse().unwrap_or(f64::NAN);
            let line = Comparison::number(quantity, &entry.printed, ours);
            // The entry was judged with all its digits.
            Comparison { verdict: Verdict::NotReproduced, ..line }.misprint(misprint)
        };
        [all].into_iter().chain(self.wrong().map(one)).collect()
    }
}

impl Block {
    /// As the thesis has it: a row a quantity, a column an argument.
    fn layout(&self, text: &mut String) {
        let rows: Vec<_> = self.entries.chunk_by(|one, two| one.quantity == two.quantity).collect();
        let columns: Vec<usize> = (0..rows.first().map_or(0, |row| row.len())).collect();
        let name_width = rows.iter().map(|row| row[0].quantity.len() + 2).fold(9, usize::max);
        for part in columns.chunks(self.columns) {
            let _ = writeln!(text);
            for (number, row) in rows.iter().enumerate() {
                let line = |name: &str, cell: fn(&Entry) -> String| {
                    let cells = part.iter().filter_map(|&column| {
                        Some(format!("{:>1$}", cell(row.get(column)?), width(&rows, column)))
                    });
                    let cells = cells.collect::<String>();
                    format!("  {name:<name_width$}{}\n", cells.trim_end())
                };
                if number == 0 {
                    text.push_str(&line(self.argument, |entry| head(entry) + " "));
                }
                text.push_str(&line(&row[0].quantity, marked));
            }
        }
    }

    /// An entry a line.
    fn list(&self, text: &mut String) {
        let width = self.entries.iter().map(|entry| entry.quantity.len()).fold(8, usize::max);
        let _ = writeln!(
            text,
            "\n  {:>9}  {:>width$}  {:>10}  {:>12}  verdict",
            self.argument, "quantity", "printed", "ours"
        );
        for entry in &self.entries {
            let _ = writeln!(
                text,
                "  {:>9}  {:>width$}  {:>10}  {:>12}  {}",
                head(entry),
                entry.quantity,
                entry.printed,
                entry.ours,
                words(entry.verdict)
            );
        }
    }
}

/// The head of an entry's column.
fn head(entry: &Entry) -> String {
    if entry.argument == 0.0 { "->0".into() } else { entry.argument.to_string() }
}

/// The entry as printed, with a mark when it is wrong.
fn marked(entry: &Entry) -> String {
    let mark = if entry.verdict == Judgement::Right { ' ' } else { '*' };
    format!("{}{mark}", entry.printed)
}

/// Width of a column: its longest entry with a mark, and white.
fn width(rows: &[&[Entry]], column: usize) -> usize {
    let lengths = rows.iter().filter_map(|row| Some(row.get(column)?.printed.len() + 2));
    lengths.fold(7, usize::max)
}

fn words(verdict: Judgement) -> String {
    match verdict {
        Judgement::Right => "right".into(),
        Judgement::Off(units) => format!("wrong by {units:+} in the last digit"),
    }
}
