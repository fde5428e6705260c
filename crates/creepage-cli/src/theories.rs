//! `creepage theories`: the theories and their options as a person reads them.

use creepage::TheorySpec;
use creepage::theory::TheoryFacts;
use creepage_study::json_schema;
use serde_json::Value;

use crate::args::TheoriesArgs;
use crate::failure::Failure;
use crate::output::{print, to_json};

const NOTES: &str = "\
COST is that of one force on one core, once the theory is prepared for its contact. ERROR is the
root mean square of the force's error over 132 cases of the full theory, in parts of mu N; linear,
saturated, strip and vermeulen-johnson are meant for few of these. `creepage accuracy` says more.
Only exact counts how unlike the bodies are; the others say so where that matters.";

/// Longest line.
const WIDTH: usize = 110;

pub(crate) fn run(args: &TheoriesArgs) -> Result<(), Failure> {
    print(&if args.json { to_json(&facts())? } else { table() })
}

/// All theories, the general ones first.
fn facts() -> [&'static TheoryFacts; 10] {
    TheorySpec::all().map(|theory| theory.facts())
}

/// The theories, a line each, and the options in `[solve]`.
fn table() -> String {
    let width = |text: fn(&TheoryFacts) -> &str| {
        facts().into_iter().map(|facts| text(facts).len()).max().unwrap_or(0)
    };
    let name = width(|facts| facts.name);
    let assumes = width(|facts| facts.assumes);
    let heads = ["THEORY", "YEAR", "ASSUMES", "COST", "ERROR", "GOOD FOR"];
    let mut table = row(heads.map(str::to_owned), [name, assumes]);
    for facts in facts() {
        let cells = [
            facts.name.into(),
            facts.year.to_string(),
            facts.assumes.into(),
            facts.cost.into(),
            percent(facts.error_percent),
            facts.good_for.into(),
        ];
        table += &row(cells, [name, assumes]);
    }
    format!("{table}\n{NOTES}\n\nOPTIONS in [solve] of a case file\n{}", options())
}

fn row(cells: [String; 6], [name, assumes]: [usize; 2]) -> String {
    let [theory, year, premise, cost, error, good_for] = cells;
    format!("{theory:name$}  {year:4}  {premise:assumes$}  {cost:>6}  {error:>6}  {good_for}\n")
}

/// With a decimal where it matters.
fn percent(error: f64) -> String {
    if error < 100.0 { format!("{error:.1} %") } else { format!("{error:.0} %") }
}

/// The options of each theory as the schema of case files describes them.
fn options() -> String {
    let schema = json_schema();
    let theories = schema["properties"]["solve"]["oneOf"].as_array();
    let mut text = String::new();
    for theory in theories.into_iter().flatten() {
        let name = theory["properties"]["theory"]["const"].as_str().unwrap_or_default();
        let options = theory["properties"].as_object().into_iter().flatten();
        for (option, form) in options.filter(|(option, _)| *option != "theory") {
            let head = format!("  {name:11}  {option:11}  ");
            let mut words = form["description"].as_str().unwrap_or_default().to_owned();
            let choices = choices(form);
            if !choices.is_empty() {
                words = format!("{words} Words: {}.", choices.join(", "));
            }
            text += &wrapped(&head, &words);
        }
    }
    text
}

/// The words that an option takes.
fn choices(form: &Value) -> Vec<&str> {
    let own = form["const"].as_str();
    let listed = form["enum"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let nested = ["anyOf", "oneOf"].into_iter().filter_map(|key| form[key].as_array()).flatten();
    own.into_iter().chain(listed).chain(nested.flat_map(choices)).collect()
}

/// `words` after `head`, in lines that fit a terminal; the head's width is the indent.
fn wrapped(head: &str, words: &str) -> String {
    let mut text = String::new();
    let mut line = head.to_owned();
    for word in words.split_whitespace() {
        if line.len() + word.len() > WIDTH && line.len() > head.len() {
            text += line.trim_end();
            line = format!("\n{:1$}", "", head.len());
        }
        line += word;
        line.push(' ');
    }
    text + line.trim_end() + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_fits_a_terminal() {
        for line in table().lines() {
            assert!(line.chars().count() <= WIDTH, "{line}");
        }
    }

    #[test]
    fn every_option_of_every_theory_is_described() {
        let options = options();
        for facts in facts() {
            for option in facts.options {
                assert!(options.contains(&format!("  {:11}  {option:11}  ", facts.name)));
            }
        }
    }
}
