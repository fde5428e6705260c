//! The page of Fig. 12 as printed, and the numbers of a page in the formats of 1967.

use serde::Deserialize;
use std::collections::BTreeMap;

/// The printed numbers, and which of them are known to be wrong.
#[derive(Debug, Deserialize)]
pub(super) struct PrintedPage {
    printed: BTreeMap<String, Vec<Vec<f64>>>,
    slips: Vec<Slip>,
}

#[derive(Debug, Deserialize)]
struct Slip {
    list: String,
    line: usize,
    place: usize,
    right: f64,
}

/// A number of the page.
pub(super) struct Number {
    /// Heading of its list.
    pub(super) list: String,
    /// Counted from 0.
    pub(super) line: usize,
    pub(super) place: usize,
    pub(super) printed: f64,
    pub(super) ours: f64,
    /// What is right where the print is known to be wrong.
    pub(super) right: Option<f64>,
}

impl Number {
    /// Whether ours is the print, to the digits that the machine of 1967 had right.
    pub(super) fn agrees(&self) -> bool {
        (self.ours - self.printed).abs() <= tolerance(&self.list, self.place, self.printed)
    }

    /// Whether ours is what is right where the print is not.
    pub(super) fn is_known_slip(&self) -> bool {
        // Eight digits of a number whose list is good to 1e-6.
        self.right.is_some_and(|right| (self.ours - right).abs() < 2e-6 * right.abs())
    }
}

impl PrintedPage {
    pub(super) fn read() -> Result<Self, serde_json::Error> {
        serde_json::from_str(include_str!("../../data/figure12_page.json"))
    }

    /// Every printed number beside that of the page `text`; one that is missing is no number.
    pub(super) fn beside(&self, text: &str) -> Vec<Number> {
        let mut numbers = Vec::new();
        for (list, lines) in &self.printed {
            let ours = lists(text, list);
            for (line, printed) in lines.iter().enumerate() {
                for (place, printed) in printed.iter().enumerate() {
                    let ours = ours.get(line).and_then(|line| line.get(place));
                    let mut slips = self.slips.iter();
                    let slip =
                        slips.find(|s| s.list == *list && s.line == line && s.place == place);
                    numbers.push(Number {
                        list: list.clone(),
                        line,
                        place,
                        printed: *printed,
                        ours: ours.copied().unwrap_or(f64::NAN),
                        right: slip.map(|slip| slip.right),
                    });
                }
            }
        }
        numbers
    }
}

/// How far a number of the print may be from ours.
fn tolerance(list: &str, place: usize, printed: f64) -> f64 {
    match (list, place) {
        // Twelve digits, of which the machine of 1967 had nine right: 4e-9 in TAU. A change is a
        // difference of coefficients.
        ("TAU" | "UVX", _) | ("TOEG GEV", 1) => 1e-8,
        ("TOEG GEV", 0) => 1e-11,
        ("TOEG GEV", _) => 1e-9 * printed,
        ("T,S,Y,X,F,S,HOEK:", 0 | 1) | ("T,S,INT,X,F,FW,ANF,WS,ARS:", 0..=2) => {
            1e-6 * printed.abs()
        }
        // Fixed numbers have the same decimals here and there.
        _ => 1e-9,
    }
}

/// The numbers of each line after a heading: on its line, or on the lines that follow it.
fn lists(text: &str, heading: &str) -> Vec<Vec<f64>> {
    let of_line = |line: &str| {
        let rest = line.trim_start_matches(heading).replace("GEMAFW:", " ").replace("Y:", " ");
        numbers(&rest)
    };
    let mut found = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if line.starts_with(heading) {
            inside = line == heading;
            if !inside {
                found.push(of_line(line));
            }
        } else if line.starts_with(|c: char| c.is_ascii_alphabetic()) && !line.starts_with("Y:") {
            inside = false;
        } else if inside && !line.is_empty() {
            found.push(of_line(line));
        }
    }
    found
}

/// The numbers of a line in the formats of 1967: `+.310202512545- 2`, `-  0.5241`, `22`.
fn numbers(line: &str) -> Vec<f64> {
    let spaced = line.replace("+.", " +.").replace("-.", " -.");
    let mut found = Vec::new();
    let mut words = spaced.split_whitespace();
    while let Some(word) = words.next() {
        let text = if word.contains("+.") || word.contains("-.") {
            // The exponent's sign ends the word, its digits follow.
            let (mantissa, sign) = word.split_at(word.len() - 1);
            format!("{mantissa}e{sign}{}", words.next().unwrap_or_default())
        } else if let Some(before) = word.strip_suffix('-') {
            // The sign of the next number touches this one.
            found.extend(before.parse::<f64>().ok());
            format!("-{}", words.next().unwrap_or_default())
        } else {
            word.to_owned()
        };
        found.push(text.parse().unwrap_or(f64::NAN));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_1967() {
        assert_eq!(numbers("+.310202512545- 2 +.12+ 1"), [0.003_102_025_125_45, 1.2]);
        assert_eq!(numbers(" 0.9077-  0.5241  22"), [0.9077, -0.5241, 22.0]);
    }

    #[test]
    fn lists_end_where_the_next_begins() {
        let text = "TAU\n+.1+ 0 +.2+ 0\n+.3+ 0\nUVX\n+.4+ 0\nFX:  1.0  2.0\n";
        assert_eq!(lists(text, "TAU"), [vec![0.1, 0.2], vec![0.3]]);
        assert_eq!(lists(text, "FX:"), [[1.0, 2.0]]);
    }
}
