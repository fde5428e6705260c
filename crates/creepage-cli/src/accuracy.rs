//! `creepage accuracy`: every theory against the full one.

use creepage::TheorySpec;
use creepage_study::theory_spec;
use creepage_study::{Accuracy, ReferenceCase, Spread, grid, measure, steady_rolling};
use rayon::prelude::*;
use serde::Serialize;

use crate::args::AccuracyArgs;
use crate::failure::Failure;
use crate::output::{print, to_json};

/// A theory with options of its own.
struct Contestant {
    theory: TheorySpec,
    /// What sets it apart from the theory as it is by default.
    manner: &'static str,
}

/// How a theory did.
#[derive(Serialize)]
struct MeasuredAccuracy {
    theory: &'static str,
    options: &'static str,
    #[serde(flatten)]
    accuracy: Accuracy,
}

pub(crate) fn run(args: &AccuracyArgs) -> Result<(), Failure> {
    let named = || args.theory.iter().map(|name| TheorySpec::named(name));
    let theories = if args.theory.is_empty() {
        TheorySpec::all().to_vec()
    } else {
        named().collect::<Result<_, _>>()?
    };
    let mut contestants = Vec::new();
    for theory in theories {
        contestants.extend(contestants_of(theory)?);
    }
    let cases = if args.grid { exact_grid()? } else { steady_rolling()? };
    let results = contestants
        .par_iter()
        .map(|contestant| contestant.measure(&cases))
        .collect::<Result<Vec<_>, Failure>>()?;
    print(&if args.json { to_json(&results)? } else { markdown(&results) })
}

/// The grid of cases as the full theory has them.
fn exact_grid() -> Result<Vec<ReferenceCase>, Failure> {
    let fine = theory_spec("exact", &["resolution=fine"]).map_err(Failure::Option)?;
    let theory = fine.facts().name;
    grid(|contact| fine.prepare(contact)).map_err(|source| Failure::Theory { theory, source })
}

/// The theory by default, and as it is or was in use otherwise.
fn contestants_of(theory: TheorySpec) -> Result<Vec<Contestant>, Failure> {
    let name = theory.facts().name;
    let others: &[(&str, &[&str])] = match theory {
        TheorySpec::Exact(_) => &[("fast", &["resolution=fast"])],
        TheorySpec::Variational(_) => &[("degree 5", &["degree=5"])],
        TheorySpec::Fastrip(_) => {
            &[("modified", &["variant=modified"]), ("original", &["variant=original"])]
        }
        TheorySpec::Fastsim(_) => &[
            ("parabolic", &["bound=parabolic"]),
            ("three flexibilities, parabolic: 1982", &["flexibility=three", "bound=parabolic"]),
            ("one flexibility, parabolic: 1982", &["flexibility=one", "bound=parabolic"]),
            ("grid 10 x 10", &["grid=[10, 10]"]),
        ],
        _ => &[],
    };
    let mut all = vec![Contestant { theory, manner: "" }];
    for (manner, options) in others {
        let theory = theory_spec(name, options).map_err(Failure::Option)?;
        all.push(Contestant { theory, manner });
    }
    Ok(all)
}

impl Contestant {
    fn measure(&self, cases: &[ReferenceCase]) -> Result<MeasuredAccuracy, Failure> {
        let theory = self.theory.facts().name;
        let accuracy = measure(cases, |contact| self.theory.prepare(contact))
            .map_err(|source| Failure::Theory { theory, source })?;
        Ok(MeasuredAccuracy { theory, options: self.manner, accuracy })
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
fn markdown(measured: &[MeasuredAccuracy]) -> String {
    let mut rows = vec![HEADS.map(str::to_owned)];
    rows.extend(measured.iter().map(MeasuredAccuracy::row));
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

impl MeasuredAccuracy {
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
        for theory in TheorySpec::all() {
            let (name, listed) = (theory.facts().name, theory.facts().error_percent);
            let usual = Contestant { theory, manner: "" };
            let rms = 100.0 * usual.measure(&cases).unwrap().accuracy.force.rms;
            // Listed with one digit after the point; from 100 on with none.
            let rounding = if listed < 100.0 { 0.05 } else { 0.5 };
            assert!((rms - listed).abs() <= rounding, "{name}: {rms}");
        }
    }

    #[test]
    fn per_cent_with_a_digit_where_it_matters() {
        let spread = Spread { mean: 0.012_34, rms: 0.0, p95: 0.999_6, worst: 12.3, median: 0.5 };
        assert_eq!(cells(&spread), ["1.2", "0.0", "100", "1230", "50.0"]);
    }
}
