//! `creepage theories`: the theories and their options as a person reads them.

use creepage_study::{ENTRIES, Entry, json_schema};
use serde_json::Value;

const NOTES: &str = "\
COST is that of one force on one core, once the theory is prepared for its contact. ERROR is the
root mean square of the force's error over 132 cases of the full theory, in parts of mu N; linear,
saturated, strip and vermeulen-johnson are meant for few of these. `creepage accuracy` tells more.
Only exact counts how unlike the bodies are; the others say so where that matters.";

/// Longest line.
const WIDTH: usize = 110;

/// The theories, a line each, and the options in `[solve]`.
pub(crate) fn table() -> String {
    let width =
        |text: fn(&Entry) -> &str| ENTRIES.iter().map(|entry| text(entry).len()).max().unwrap_or(0);
    let name = width(|entry| entry.name);
    let assumes = width(|entry| entry.assumes);
    let heads = ["THEORY", "YEAR", "ASSUMES", "COST", "ERROR", "GOOD FOR"];
    let mut table = row(heads.map(str::to_owned), [name, assumes]);
    for entry in ENTRIES {
        let cells = [
            entry.name.into(),
            entry.year.to_string(),
            entry.assumes.into(),
            entry.cost.into(),
            percent(entry.error),
            entry.good_for.into(),
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

/// The options as the schema of case files describes them.
fn options() -> String {
    let schema = json_schema();
    let known = schema["properties"]["solve"]["properties"].as_object();
    let mut text = String::new();
    for (name, option) in known.into_iter().flatten().filter(|(name, _)| *name != "theory") {
        text += &wrapped(&format!("  {name:11}  "), description(option));
        for choice in option["anyOf"][0]["oneOf"].as_array().into_iter().flatten() {
            let value = choice["title"].as_str().map_or(choice["const"].to_string(), str::to_owned);
            text += &wrapped(&format!("{:17}{value}: ", ""), description(choice));
        }
    }
    text
}

fn description(schema: &Value) -> &str {
    schema["description"].as_str().unwrap_or_default()
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
    fn the_schema_names_the_theories_of_each_option() {
        let schema = json_schema();
        let known = schema["properties"]["solve"]["properties"].as_object().unwrap();
        for (name, option) in known.iter().filter(|(name, _)| *name != "theory") {
            let words = option["description"].as_str().unwrap();
            for entry in ENTRIES {
                let told = words.contains(&format!("\"{}\"", entry.name));
                assert_eq!(told, entry.options.contains(&&name[..]), "{name} {}", entry.name);
            }
        }
        let all = ENTRIES.iter().flat_map(|entry| entry.options);
        assert!(all.into_iter().all(|option| known.contains_key(*option)));
    }
}
