//! Generator of `ROWS.md`, the one list of what a reader of the thesis can do with it, row by row.

/// The table of all rows, in Markdown.
pub const ROWS: &str = include_str!("../ROWS.md");

/// The cells of each row: number, what, where, how, test, state.
pub fn rows() -> impl Iterator<Item = [&'static str; 6]> {
    ROWS.lines().filter_map(|line| {
        let mut cells = line.strip_prefix("| ")?.strip_suffix(" |")?.split(" | ").map(str::trim);
        let row = std::array::from_fn(|_| cells.next().unwrap_or_default());
        row[0].parse::<usize>().is_ok().then_some(row)
    })
}

/// How many rows work, and how many have an answer in place of what cannot be had: measured points that the
/// thesis has in its pictures only, a formula that it does not state, a claim that does not hold.
#[must_use]
pub fn states() -> [usize; 2] {
    ["works", "answered"].map(|state| rows().filter(|row| row[5] == state).count())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::registry;

    #[test]
    fn the_table_is_whole_and_its_counts_are_right() {
        let numbers: Vec<_> = rows().map(|row| row[0].parse::<usize>().unwrap()).collect();
        assert_eq!(numbers, (1..=105).collect::<Vec<_>>());
        let [works, answered] = states();
        assert_eq!(works + answered, 105);
        let words = format!("105 things, of which\n{works} work and {answered} have an answer");
        assert!(ROWS.contains(&words), "the first lines of ROWS.md should say: {words}");
    }

    #[test]
    fn items_and_tests_that_it_names_are_there() {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        for [number, what, _, how, test, state] in rows() {
            assert!(!what.is_empty() && !how.is_empty(), "{number}");
            let path = test.trim_matches('`');
            assert!(crates.join(path).exists(), "row {number}: {path}");
            // Whoever wants to know why has to be told: an answer names its page or its item.
            assert!(!path.is_empty() && ["works", "answered"].contains(&state), "row {number}");
            for command in how.split('`').filter_map(|part| part.strip_prefix("reproduce ")) {
                for name in command.split(' ').filter(|word| !word.starts_with("--")) {
                    assert!(
                        registry().iter().any(|item| item.name == name),
                        "row {number}: {name}"
                    );
                }
            }
        }
    }
}
