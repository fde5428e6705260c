//! `creepage accuracy`: every theory against the full one.

use creepage_study::{Bound, ENTRIES, Entry, Flexibility, Resolution, Solve, Variant, find};
use creepage_validation::{Accuracy, ReferenceCase, Spread, grid, measure, steady_rolling};
use rayon::prelude::*;
use serde::Serialize;

use crate::args::AccuracyArgs;
use crate::failure::Failure;
use crate::output::{print, to_json};

/// A theory with options of its own.
struct Contestant {
    theory: &'static Entry,
    /// What sets it apart from the theory as it is by default.
    manner: &'static str,
    solve: Solve,
}

/// How a theory did.
#[derive(Serialize)]
struct Standing {
    theory: &'static str,
    options: &'static str,
    #[serde(flatten)]
    accuracy: Accuracy,
}

pub(crate) fn run(args: &AccuracyArgs) -> Result<(), Failure> {
    let theories: Vec<&Entry> = if args.theory.is_empty() {
        ENTRIES.iter().collect()
    } else {
        args.theory.iter().map(|name| find(name)).collect::<Result<_, _>>()?
    };
    let cases = if args.grid { exact_grid()? } else { steady_rolling()? };
    let contestants: Vec<_> = theories.into_iter().flat_map(contestants).collect();
    let results = contestants
        .par_iter()
        .map(|contestant| contestant.measure(&cases))
        .collect::<Result<Vec<_>, Failure>>()?;
    print(&if args.json { to_json(&results)? } else { markdown(&results) })
}

/// The grid of cases as the full theory has them.
fn exact_grid() -> Result<Vec<ReferenceCase>, Failure> {
    let full = find("exact")?;
    let fine = Solve { resolution: Some(Resolution::Fine), ..Solve::default() };
    let theory = full.name;
    grid(|a_over_b, poisson| full.boxed(a_over_b, poisson, &fine))
        .map_err(|source| Failure::Theory { theory, source })
}

/// The theory by default, and as it is or was in use otherwise.
fn contestants(theory: &'static Entry) -> Vec<Contestant> {
    let usual = Solve::default;
    let of_1982 = |flexibility| Solve {
        flexibility: Some(flexibility),
        bound: Some(Bound::Parabolic),
        ..usual()
    };
    let variant = |variant| Solve { variant: Some(variant), ..usual() };
    let others = match theory.name {
        "exact" => vec![("fast", Solve { resolution: Some(Resolution::Fast), ..usual() })],
        "variational" => vec![("degree 5", Solve { degree: Some(5), ..usual() })],
        "fastrip" => {
            vec![("modified", variant(Variant::Modified)), ("original", variant(Variant::Original))]
        }
        "fastsim" => vec![
            ("parabolic", Solve { bound: Some(Bound::Parabolic), ..usual() }),
            ("three flexibilities, parabolic: 1982", of_1982(Flexibility::Three)),
            ("one flexibility, parabolic: 1982", of_1982(Flexibility::One)),
            ("grid 10 x 10", Solve { grid: Some([10, 10]), ..usual() }),
        ],
        _ => vec![],
    };
    let all = [("", usual())].into_iter().chain(others);
    all.map(|(manner, solve)| Contestant { theory, manner, solve }).collect()
}

impl Contestant {
    fn measure(&self, cases: &[ReferenceCase]) -> Result<Standing, Failure> {
        let prepare = |a_over_b, poisson| self.theory.boxed(a_over_b, poisson, &self.solve);
        let theory = self.theory.name;
        let accuracy =
            measure(cases, prepare).map_err(|source| Failure::Theory { theory, source })?;
        Ok(Standing { theory, options: self.manner, accuracy })
    }
}

const HEADS: [&str; 12] = [
    "theory",
    "force: mean",
    "rms",
    "95 %",
    "worst",
    "median",
    "moment: mean",
    "rms",
    "95 %",
    "worst",
    "median",
    "doubtful",
];

/// A table to be read as it is, or pasted.
fn markdown(standings: &[Standing]) -> String {
    let mut rows = vec![HEADS.map(str::to_owned)];
    rows.extend(standings.iter().map(Standing::row));
    let widths: Vec<usize> =
        (0..HEADS.len()).map(|i| rows.iter().map(|row| row[i].len()).max().unwrap_or(0)).collect();
    // A colon aligns numbers to the right.
    let rule = |i: usize| match i {
        0 => "-".repeat(widths[0]),
        _ => "-".repeat(widths[i] - 1) + ":",
    };
    rows.insert(1, std::array::from_fn(rule));
    let mut table = String::new();
    for row in rows {
        let cell = |(i, text): (usize, &String)| match i {
            0 => format!("| {text:0$} ", widths[0]),
            _ => format!("| {text:>0$} ", widths[i]),
        };
        table += &row.iter().enumerate().map(cell).collect::<String>();
        table += "|\n";
    }
    table
}

impl Standing {
    fn row(&self) -> [String; 12] {
        let Self { theory, options, accuracy } = self;
        let name =
            if options.is_empty() { (*theory).to_owned() } else { format!("{theory}, {options}") };
        let [a, b, c, d, e] = cells(&accuracy.force);
        let [f, g, h, i, j] = cells(&accuracy.moment);
        [name, a, b, c, d, e, f, g, h, i, j, accuracy.doubtful.to_string()]
    }
}

/// In per cent; a digit after the point where it matters.
fn cells(spread: &Spread) -> [String; 5] {
    let Spread { mean, rms, p95, worst, median } = *spread;
    [mean, rms, p95, worst, median].map(|error| {
        let percent = 100.0 * error;
        if percent < 99.95 { format!("{percent:.1}") } else { format!("{percent:.0}") }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_that_each_theory_is_listed_with_is_the_measured_one() {
        let cases = steady_rolling().unwrap();
        for theory in ENTRIES {
            let usual = &contestants(theory)[0];
            let rms = 100.0 * usual.measure(&cases).unwrap().accuracy.force.rms;
            // Listed with one digit after the point; from 100 on with none.
            let rounding = if theory.error < 100.0 { 0.05 } else { 0.5 };
            assert!((rms - theory.error).abs() <= rounding, "{}: {rms}", theory.name);
        }
    }

    #[test]
    fn per_cent_with_a_digit_where_it_matters() {
        let spread = Spread { mean: 0.012_34, rms: 0.0, p95: 0.999_6, worst: 12.3, median: 0.5 };
        assert_eq!(cells(&spread), ["1.2", "0.0", "100", "1230", "50.0"]);
    }
}
