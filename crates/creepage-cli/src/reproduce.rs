//! `creepage reproduce`: the thesis's tables and figures computed again, beside what was printed.

use std::io::{self, IsTerminal};
use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use creepage_1967::{File, Item, Made, ROWS, agreement_text, files, gallery, registry, reproduce};
use creepage_study::{Sources, write_all};
use indicatif::ProgressBar;

use crate::failure::Failure;
use crate::output::{bar_style, print, say_written};

const ALL: &str = "all";

#[derive(Debug, clap::Args)]
pub(crate) struct ReproduceArgs {
    /// What to reproduce.
    #[arg(value_name = "NAME", required = true, value_parser = names())]
    items: Vec<String>,
    /// Directory for the files; made if need be.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What can be asked for.
fn names() -> PossibleValuesParser {
    let items = registry().iter().map(|item| PossibleValue::new(item.name).help(item.title));
    let all = PossibleValue::new(ALL).help("All of these, a gallery page and a table of agreement");
    items.chain([all]).into()
}

/// The files first, then the tables, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &ReproduceArgs) -> Result<(), Failure> {
    let all = args.items.iter().any(|name| name == ALL);
    let asked = |item: &&Item| all || args.items.iter().any(|name| name == item.name);
    let items: Vec<&'static Item> = registry().iter().filter(asked).collect();
    let bar = bar(items.len());
    let made = reproduce(&items, |item| {
        bar.set_message(item.name);
        bar.inc(1);
    });
    bar.finish_and_clear();
    let made = made?;
    if let Some(directory) = &args.out {
        let mut written = files(&made)?;
        if all {
            written.extend(gallery(&made)?);
        }
        let pairs: Vec<_> = written.iter().map(File::as_pair).collect();
        say_written(&write_all(directory, &pairs, &Sources::default())?);
    }
    let opening = all.then(|| ROWS.to_owned());
    let parts: Vec<_> = opening.into_iter().chain(made.iter().map(text)).collect();
    print(&parts.join("\n\n\n"))
}

fn text(made: &Made) -> String {
    let agreement = agreement_text(made);
    match &made.reproduction.text {
        Some(table) => format!("{table}\n\n{agreement}"),
        None => agreement,
    }
}

/// How many items are done, shown on a terminal only.
fn bar(count: usize) -> ProgressBar {
    if count < 2 || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    ProgressBar::new(count as u64).with_style(bar_style("{wide_bar} {pos} of {len}  {msg:8}"))
}
