//! Table of agreement: printed values beside computed ones.

use std::fmt::Write;

use crate::comparison::{Comparison, Verdict};
use crate::item::Made;

const HEADER: [&str; 7] = ["item", "quantity", "printed", "ours", "difference", "verdict", "note"];

/// What of the thesis has nothing to be computed.
pub(super) const SKETCHES: &str = "Figs 1 and 6 are sketches of bodies and axes and have no \
    numbers; Fig. 8 of the list of symbols is printed as Figs 3a and 3b.";

/// Ours less the print, to two digits.
pub(super) fn difference(line: &Comparison) -> String {
    line.difference.map_or_else(String::new, |difference| {
        // Smaller than any digit printed: of the rounding of decimal fractions.
        if difference.abs() < 1e-13 { "0".into() } else { format!("{difference:+.1e}") }
    })
}

pub(super) fn csv(made: &[Made]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for made in made {
        for line in &made.reproduction.agreement {
            writer.write_record([
                made.item.name,
                &line.quantity,
                &line.printed,
                &line.ours,
                &difference(line),
                line.verdict.words(),
                &line.note,
            ])?;
        }
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}

pub(super) fn markdown(made: &[Made]) -> String {
    let mut text =
        format!("# Agreement with the print of 1967\n\n{}\n\n{SKETCHES}\n\n", summary(made));
    text.push_str(&row(&HEADER.map(String::from)));
    text.push_str(&row(&HEADER.map(|_| "---".into())));
    for made in made {
        for line in &made.reproduction.agreement {
            let Comparison { quantity, printed, ours, note, .. } = line.clone();
            let (name, verdict) = (made.item.name.into(), line.verdict.words().into());
            text.push_str(&row(&[name, quantity, printed, ours, difference(line), verdict, note]));
        }
    }
    text
}

fn row(cells: &[String]) -> String {
    let cells: Vec<_> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
    format!("| {} |\n", cells.join(" | "))
}

/// How many lines have which verdict.
pub(super) fn summary(made: &[Made]) -> String {
    let lines = || made.iter().flat_map(|made| &made.reproduction.agreement);
    let count = |verdict| lines().filter(|line| line.verdict == verdict).count();
    let [agree, close, misprints] = [Verdict::Agrees, Verdict::Close, Verdict::Misprint].map(count);
    let [not, no_data] = [Verdict::NotReproduced, Verdict::NoData].map(count);
    format!(
        "{} comparisons: {agree} agree, {close} are close, {misprints} are misprints, {not} are \
         not reproduced, {no_data} have no data to be compared with.",
        lines().count()
    )
}

/// What is found for one item, for the terminal.
#[must_use]
pub fn agreement_text(made: &Made) -> String {
    let mut text = made.item.title.to_owned();
    for line in &made.reproduction.agreement {
        // Writing to a String cannot fail.
        let _ = write!(
            text,
            "\n  {}: printed {}, ours {}: {}",
            line.quantity,
            line.printed,
            line.ours,
            line.verdict.words()
        );
        if !line.note.is_empty() {
            let _ = write!(text, " ({})", line.note);
        }
    }
    text
}
