//! `creepage table build`: a table of creep force, computed in parallel and written to a file.

use std::io::Write;
use std::path::PathBuf;
use std::time::Duration;

use creepage::TheorySpec;
use creepage::table::{Axis, Intervals, Provenance, Spec, build};
use creepage_study::{WholeFile, theory_spec};
use indicatif::ProgressBar;

use crate::failure::Failure;
use crate::output::{self, say};

#[derive(Debug, clap::Args)]
pub(crate) struct BuildArgs {
    /// Theory; `creepage theories` lists them. It must be linear near zero and bounded.
    #[arg(long, value_name = "NAME", default_value = "exact")]
    theory: String,
    /// Elements of the theory `exact`, by default fine ones: the ripple of coarse elements under
    /// strong spin is most of a table's error.
    #[arg(long)]
    resolution: Option<Elements>,
    /// Option of the theory, as in [solve] of a case file: grid=[20,20]; may be given several times.
    #[arg(long = "option", value_name = "KEY=VALUE")]
    options: Vec<String>,
    /// Ratio of the contact's semi-axes, along over across the rolling direction; or the first
    /// and the last of a range, as 0.2,5.
    #[arg(long, value_name = "RATIO[,RATIO]", default_value = "1", value_parser = numbers,
          allow_hyphen_values = true)]
    a_over_b: Numbers,
    /// Number of ratios in a range, in equal steps of their logarithm.
    #[arg(long, value_name = "N", default_value_t = 9, allow_negative_numbers = true)]
    shapes: usize,
    /// Combined Poisson's ratio; or the first and the last of a range, as 0,0.5.
    #[arg(long, value_name = "RATIO[,RATIO]", default_value = "0.28", value_parser = numbers,
          allow_hyphen_values = true)]
    poisson: Numbers,
    /// Number of Poisson's ratios in a range.
    #[arg(long, value_name = "N", default_value_t = 4, allow_negative_numbers = true)]
    materials: usize,
    /// Intervals along theta (from pure spin to none), phi (from -eta over xi to eta; even) and t
    /// (from no creepage to infinite creepage).
    #[arg(long, value_name = "THETA,PHI,T", default_value = "20,16,48", value_parser = counts)]
    intervals: Intervals,
    /// At how many random places to measure the error, and at about as many where the force bends
    /// most.
    #[arg(long, value_name = "N", default_value_t = 500, allow_negative_numbers = true)]
    places: usize,
    /// File for the table; it appears when it is whole.
    #[arg(long, value_name = "FILE.nc")]
    out: PathBuf,
}

/// Elements of the full theory, as in case files.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Elements {
    Fast,
    Standard,
    Fine,
}

pub(crate) fn run(args: &BuildArgs) -> Result<(), Failure> {
    let options = options(args)?;
    let theory = theory_spec(&args.theory, &options).map_err(Failure::Option)?;
    let name = theory.facts().name;
    let failed = |source| Failure::writing(Some(&args.out), source);
    // A wrong place is reported before the work.
    let mut file = WholeFile::create(&args.out).map_err(failed)?;
    let spec = spec(args, &theory, &options);
    let bar = bar(&spec);
    let table = build(&spec, |contact| theory.prepare(contact), &|| bar.inc(1));
    bar.finish_and_clear();
    let table = table.map_err(|source| Failure::Build { theory: name, source })?;
    let bytes =
        table.to_bytes().map_err(|source| Failure::Table { path: args.out.clone(), source })?;
    file.write_all(&bytes).and_then(|()| file.finish()).map_err(failed)?;
    let [worst, moment] = [table.accuracy().force.worst, table.accuracy().moment.worst];
    let places = table.accuracy().places + table.accuracy().hard_places;
    say(&format!(
        "wrote {}: largest error at {places} places {:.2} % of mu N, of the moment {:.2} % of mu N c",
        args.out.display(),
        100.0 * worst,
        100.0 * moment
    ));
    Ok(())
}

fn spec(args: &BuildArgs, theory: &TheorySpec, options: &[String]) -> Spec {
    Spec {
        a_over_b: axis(args.a_over_b, args.shapes),
        poisson: axis(args.poisson, args.materials),
        intervals: args.intervals,
        places: args.places,
        provenance: Provenance {
            theory: theory.facts().name.into(),
            options: options.join(", "),
            program: format!("creepage {}", env!("CARGO_PKG_VERSION")),
        },
    }
}

/// The first number, and the second where there are two.
type Numbers = (f64, Option<f64>);

fn numbers(text: &str) -> Result<Numbers, String> {
    let number = |text: &str| text.trim().parse().map_err(|_| format!("`{text}` is no number"));
    match text.split_once(',') {
        Some((first, last)) => Ok((number(first)?, Some(number(last)?))),
        None => Ok((number(text)?, None)),
    }
}

fn counts(text: &str) -> Result<Intervals, String> {
    let counts: Vec<_> = text.split(',').filter_map(|count| count.trim().parse().ok()).collect();
    match counts[..] {
        [theta, phi, t] if text.matches(',').count() == 2 => Ok(Intervals { theta, phi, t }),
        _ => Err("three whole numbers are needed".into()),
    }
}

/// One value or a range of them.
fn axis((first, last): Numbers, nodes: usize) -> Axis {
    last.map_or(Axis::fixed(first), |last| Axis { low: first, high: last, nodes })
}

/// The options of the theory that fills the table, each `key = value`.
fn options(args: &BuildArgs) -> Result<Vec<String>, Failure> {
    let spaced = |option: &String| match option.split_once('=') {
        Some((key, value)) => format!("{} = {}", key.trim(), value.trim()),
        None => option.clone(),
    };
    let mut options: Vec<_> = args.options.iter().map(spaced).collect();
    let is_given = options.iter().any(|option| option.starts_with("resolution ="));
    let is_exact = matches!(TheorySpec::named(&args.theory)?, TheorySpec::Exact(_));
    if let Some(elements) = args.resolution {
        options.push(format!("resolution = {elements:?}").to_lowercase());
    } else if is_exact && !is_given {
        options.push("resolution = fine".into());
    }
    Ok(options)
}

/// Lines of nodes done and the time left; on a terminal only.
fn bar(spec: &Spec) -> ProgressBar {
    let bar = output::bar(spec.steps() as u64, "{wide_bar} {percent:>3} %  {left}");
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
