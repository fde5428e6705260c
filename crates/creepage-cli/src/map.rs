//! `creepage map`: the contact map of a wheelset.

use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use creepage::table::{Axis, Intervals, Provenance, Spec, Table, build};
use creepage_map::{ContactMap, Spread};
use creepage_study::{
    MapPlan, MapResolution, MapStage, Sources, WholeFile, build_map, theory_spec,
};

use crate::failure::Failure;
use crate::input::{read_table, read_text};
use crate::outcome::Outcome;
use crate::output::{self, print, say, say_written};
use crate::wheelset::{read, say_found, say_left_out};

#[derive(Debug, clap::Args)]
pub(crate) struct MapArgs {
    /// Wheelset file; its axle load is the one about which the map has its loads.
    #[arg(value_name = "WHEELSET.toml")]
    wheelset: PathBuf,
    /// File for the map; it appears when it is whole.
    #[arg(long, value_name = "FILE.nc")]
    out: PathBuf,
    /// Largest lateral position to either side (m); the map ends before where profiles end. On the flange, with
    /// roll and yaw, loads err by tens of per cent: look at the error that is told.
    #[arg(long, value_name = "M", default_value_t = 0.0062, allow_negative_numbers = true)]
    y: f64,
    /// Largest yaw to either side (rad).
    #[arg(long, value_name = "RAD", default_value_t = 0.01, allow_negative_numbers = true)]
    yaw: f64,
    /// Vertical loads of a wheel at the map's nodes (N), rising, separated by commas; from .12 to 2.4 times
    /// half the axle load if not given.
    #[arg(long, value_name = "N,N,...", value_delimiter = ',', allow_hyphen_values = true)]
    loads: Vec<f64>,
    /// Elements of the full theory.
    #[arg(long, default_value = "standard")]
    resolution: Elements,
    /// Part of mu N by which the middle of a cell may be missed before the cell is halved.
    #[arg(long, value_name = "PART", default_value_t = 0.01, allow_negative_numbers = true)]
    tolerance: f64,
    /// Width of the narrowest cells (m).
    #[arg(long, value_name = "M", default_value_t = 5e-5, allow_negative_numbers = true)]
    narrowest: f64,
    /// States drawn afresh in each cell, by which the map's error is measured.
    #[arg(long, value_name = "N", default_value_t = 2, allow_negative_numbers = true)]
    states: usize,
    /// Table of `exact` over ratios of axes as `creepage table build --a-over-b 0.15,30 --shapes 19` makes it, for
    /// the wheelset's Poisson's ratio; built first if not given, which takes as long as the map.
    #[arg(long, value_name = "TABLE.nc")]
    ellipses: Option<PathBuf>,
}

/// Elements of the full theory, as in case files.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Elements {
    Fast,
    Standard,
    Fine,
}

pub(crate) fn run(args: &MapArgs) -> Result<Outcome, Failure> {
    let case = read(&args.wheelset)?;
    let source = read_text(&args.wheelset)?;
    let of_map = |source| Failure::Map { path: args.wheelset.clone(), source: Box::new(source) };
    let plan = plan(args, &MapPlan::of(&case).map_err(of_map)?);
    plan.check().map_err(|source| Failure::MapPlan { source: Box::new(source) })?;
    plan.check_case(&case).map_err(of_map)?;
    let failed = |source| Failure::Write { path: args.out.clone(), source };
    Sources::new([&args.wheelset]).ensure_not_overwritten(&args.out)?;
    case.sources().ensure_not_overwritten(&args.out)?;
    let mut file = WholeFile::create(&args.out).map_err(failed)?;
    case.notes.iter().for_each(say_found);
    say_left_out(&case, "maps");
    let poisson = case.solids.map_or(f64::NAN, |pair| pair.poisson());
    let table = Arc::new(match &args.ellipses {
        Some(path) => {
            Sources::new([path]).ensure_not_overwritten(&args.out)?;
            read_table(path)?
        }
        None => ellipses(poisson)?,
    });
    let journal = journal_path(&args.out);
    let bar = output::bar(1000, "{msg} {wide_bar} {percent:>3} %  {left}");
    bar.enable_steady_tick(Duration::from_millis(200));
    let progress = |stage| {
        let (words, part) = match stage {
            MapStage::Heights(done, all) => ("heights", done as f64 / all as f64),
            MapStage::Nodes(_, part) => ("nodes", part),
            MapStage::States(done, all) => ("fresh states", done as f64 / all as f64),
        };
        bar.set_message(words);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 0 to 1000
        bar.set_position((1000.0 * part.clamp(0.0, 1.0)) as u64);
        true
    };
    let map = build_map(&case, &plan, table, source, Some(&journal), &progress);
    bar.finish_and_clear();
    let map = map.map_err(of_map)?;
    let bytes = map.to_bytes().map_err(|source| of_map(source.into()))?;
    file.write_all(&bytes).and_then(|()| file.finish()).map_err(failed)?;
    // It holds nothing that the map does not.
    let _ = std::fs::remove_file(journal);
    say_written(std::slice::from_ref(&args.out));
    print(&text(&map, bytes.len()))?;
    Ok(Outcome::Done)
}

fn plan(args: &MapArgs, usual: &MapPlan) -> MapPlan {
    let loads = if args.loads.is_empty() { usual.loads.clone() } else { args.loads.clone() };
    let resolution = match args.resolution {
        Elements::Fast => MapResolution::Fast,
        Elements::Standard => MapResolution::Standard,
        Elements::Fine => MapResolution::Fine,
    };
    let [wide, _] = usual.widths;
    MapPlan {
        y: args.y,
        yaw: args.yaw,
        loads,
        tolerance: args.tolerance,
        widths: [wide, args.narrowest],
        states: args.states,
        resolution,
        ..usual.clone()
    }
}

/// The table of `exact` over ratios of axes that maps need.
fn ellipses(poisson: f64) -> Result<Table, Failure> {
    let options = ["resolution = standard".to_owned()];
    let theory = theory_spec("exact", &options).map_err(Failure::Option)?;
    let spec = Spec {
        a_over_b: Axis { low: 0.15, high: 30.0, nodes: 19 },
        poisson: Axis::fixed(poisson),
        intervals: Intervals::default(),
        places: 300,
        provenance: Provenance {
            theory: "exact".into(),
            options: options.join(", "),
            program: format!("creepage {}", env!("CARGO_PKG_VERSION")),
        },
    };
    say("the table of ellipses is built first: give one by --ellipses to save this");
    let bar = output::bar(spec.steps() as u64, "ellipses {wide_bar} {percent:>3} %  {left}");
    bar.enable_steady_tick(Duration::from_millis(200));
    let table = build(&spec, |contact| theory.prepare(contact), &|| bar.inc(1));
    bar.finish_and_clear();
    table.map_err(|source| Failure::Build { theory: "exact", source })
}

fn journal_path(out: &Path) -> PathBuf {
    let mut name = out.as_os_str().to_owned();
    name.push(".journal");
    name.into()
}

/// The map's range and its error.
fn text(map: &ContactMap, size: usize) -> String {
    let mut text = String::new();
    for (name, side) in [("left", creepage_map::Side::Left), ("right", creepage_map::Side::Right)] {
        let wheel = map.wheel(side);
        let [low, high] = wheel.range().map(|place| 1e3 * place);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{name:5} wheel: places {low:.2} to {high:.2} mm towards its flange, {} nodes",
            wheel.places().len()
        );
    }
    let (yaw, [low, high]) = (1e3 * map.head().yaw, map.head().friction);
    let loads: Vec<String> = map
        .wheel(creepage_map::Side::Right)
        .loads()
        .map(|load| format!("{:.1}", 1e-3 * load))
        .collect();
    let _ = writeln!(
        text,
        "yaw to {yaw} mrad, friction {low} to {high}, loads {} kN, {} kB\n\n\
         error on fresh states against the full theory in per cent\n\
         {:38} {:>6} {:>7} {:>7} {:>7} {:>7}",
        loads.join(", "),
        size / 1000,
        "",
        "states",
        "rms",
        "median",
        "95 %",
        "worst"
    );
    let accuracy = map.accuracy();
    for (name, spreads) in [
        ("tangential force, of mu N", accuracy.tangential),
        ("normal force, of N", accuracy.normal),
        ("whole force, of mu N", accuracy.total),
    ] {
        for (place, spread) in ["", ", areas join"].into_iter().zip(spreads) {
            let Spread { states, rms, median, p95, worst } = spread;
            let [rms, median, p95, worst] = [rms, median, p95, worst].map(|part| 100.0 * part);
            let name = format!("{name}{place}");
            let _ = writeln!(
                text,
                "{name:38} {states:>6} {rms:>7.3} {median:>7.3} {p95:>7.3} {worst:>7.3}"
            );
        }
    }
    text
}
