//! `creepage reproduce`: the thesis's tables and figures computed again, beside what was printed.

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use creepage_1967::{
    File, Item, Made, OwnPoints, PointsError, ROWS, agreement_text, files, gallery, registry,
    reproduce,
};
use creepage_study::{Sources, write_all};
use indicatif::ProgressBar;

use crate::failure::Failure;
use crate::input::read_text;
use crate::output::{bar_style, print, say, say_written};

const ALL: &str = "all";

#[derive(Debug, clap::Args)]
pub(crate) struct ReproduceArgs {
    /// What to reproduce.
    #[arg(value_name = "NAME", required = true, value_parser = names())]
    items: Vec<String>,
    /// Directory for the files; made if need be.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Points of your own to lay over one picture, as those of an experiment. The CSV file has the
    /// columns x and y, in the numbers of the axes, and panel, counted from 1.
    #[arg(long, value_name = "POINTS.csv", requires = "out")]
    points: Option<PathBuf>,
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
    let own = args.points.as_deref().map(|path| own_points(path, &items)).transpose()?;
    let bar = bar(items.len());
    let made = reproduce(&items, |item| {
        bar.set_message(item.name);
        bar.inc(1);
    });
    bar.finish_and_clear();
    let made = with_points(made?, own)?;
    if let Some(directory) = &args.out {
        let mut written = files(&made)?;
        if all {
            written.extend(gallery(&made)?);
        }
        let pairs: Vec<_> = written.iter().map(File::as_pair).collect();
        say_written(&write_all(directory, &pairs, &Sources::new(&args.points))?);
    }
    let opening = all.then(|| ROWS.to_owned());
    let parts: Vec<_> = opening.into_iter().chain(made.iter().map(text)).collect();
    print(&parts.join("\n\n\n"))
}

/// The points of a file for the one picture that was asked for.
fn own_points<'p>(path: &'p Path, items: &[&Item]) -> Result<(&'p Path, OwnPoints), Failure> {
    if items.len() != 1 {
        return Err(Failure::PointsOfOne);
    }
    let text = read_text(path)?;
    Ok((path, OwnPoints::read(text.as_bytes()).map_err(of(path))?))
}

fn of(path: &Path) -> impl Fn(PointsError) -> Failure {
    move |source| Failure::OwnPoints { path: path.into(), source }
}

/// Lays them over it, and says how many are not seen.
fn with_points(made: Vec<Made>, own: Option<(&Path, OwnPoints)>) -> Result<Vec<Made>, Failure> {
    let Some((path, own)) = own else { return Ok(made) };
    let over = |made: Made| {
        let (reproduction, outside) =
            made.reproduction.with_points(made.item.name, &own).map_err(of(path))?;
        if outside > 0 {
            say(&format!("caution: {outside} of {} points lie outside the frame", own.count()));
        }
        Ok(Made { reproduction, ..made })
    };
    made.into_iter().map(over).collect()
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
