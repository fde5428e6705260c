//! `creepage wheelset`: the contacts of a wheelset on its track.

use std::path::Path;

use creepage::InvalidValue;
use creepage_study::{
    ProfileNote, Sources, TableAxis, WheelsetCase, WheelsetFile, WheelsetFileError, WheelsetTable,
    WholeFile,
};
use indicatif::ProgressBar;

use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{bar_style, print, say, say_written, to_json};
use crate::rail_args::WheelsetArgs;

/// The files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &WheelsetArgs) -> Result<Outcome, Failure> {
    let case = read(&args.case)?;
    if let Some(file) = &args.table {
        return table(args, &case, file);
    }
    let wrong = |source| Failure::Wheelset { path: args.case.clone(), source: Box::new(source) };
    let mut solved = case.solve().map_err(wrong)?;
    if args.derivatives {
        solved.solved.derivatives = Some(case.derivatives(&solved).map_err(wrong)?);
    }
    case.notes.iter().for_each(say_found);
    if let Some(directory) = &args.out {
        say_written(&solved.write(&case, directory, &Sources::new([&args.case]))?);
    }
    print(&if args.json { to_json(&solved.report())? } else { solved.text() })?;
    for words in solved.caution_words() {
        say(&format!("caution: {words}"));
    }
    let is_done = solved.status() != creepage::Status::NotConverged;
    Ok(if is_done { Outcome::Done } else { Outcome::Doubtful })
}

/// A table over positions and loads; what could not be solved is NaN in it.
fn table(args: &WheelsetArgs, case: &WheelsetCase, file: &Path) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Wheelset { path: args.case.clone(), source: Box::new(source) };
    let failed = |source| Failure::Write { path: file.into(), source };
    // Yaw and lateral position always, each the file's own where it is not given; the walk goes along the last one.
    let given = [
        ("axle_load", "--axle-load", &args.axle_load, None),
        ("z", "--z", &args.z, None),
        ("roll", "--roll", &args.roll, None),
        ("yaw", "--yaw", &args.yaw, Some(case.stance.yaw)),
        ("y", "--y", &args.y, Some(case.stance.y)),
    ];
    let axes = given.into_iter().filter_map(|(name, flag, values, own)| {
        let values = match (values, own) {
            (Some(values), _) => even(flag, values),
            (None, Some(own)) => Ok(vec![own]),
            (None, None) => return None,
        };
        Some(values.map(|values| TableAxis { name, values }))
    });
    let axes = axes.collect::<Result<Vec<_>, _>>()?;
    Sources::new([&args.case]).ensure_not_overwritten(file)?;
    case.sources().ensure_not_overwritten(file)?;
    let mut whole = WholeFile::create(file).map_err(failed)?;
    let style = bar_style("{wide_bar} {pos}/{len} positions  {per_sec}  {eta} left");
    let bar = ProgressBar::new(axes.iter().map(|axis| axis.values.len() as u64).product())
        .with_style(style);
    let goes_on = || {
        bar.inc(1);
        true
    };
    let table = WheelsetTable::solve(case, &axes, goes_on).map_err(wrong)?;
    bar.finish_and_clear();
    case.notes.iter().for_each(say_found);
    say_left_out(case, "tables");
    whole.fill(|path| table.netcdf(path))?;
    whole.finish().map_err(failed)?;
    say_written(&[file.into()]);
    if let Some((count, first)) = table.cautions() {
        say(&format!("caution: {count} positions have cautions, the first: {}", first.join("; ")));
    }
    match table.lacking() {
        0 => Ok(Outcome::Done),
        lacking => {
            say(&format!("note: {lacking} positions could not be solved: NaN in the table"));
            Ok(Outcome::Doubtful)
        }
    }
}

/// Even values: first, last, count.
fn even(name: &'static str, given: &[f64]) -> Result<Vec<f64>, Failure> {
    const MAX_VALUES: f64 = 1e5;
    let &[from, to, count] = given else { return Ok(Vec::new()) };
    let wrong = |value, valid| InvalidValue { quantity: name, value, valid };
    for value in [from, to] {
        if !value.is_finite() {
            return Err(wrong(value, "finite").into());
        }
    }
    if !((1.0..=MAX_VALUES).contains(&count) && count.fract().abs() < f64::EPSILON) {
        return Err(wrong(count, "a whole COUNT, 1 to 100000").into());
    }
    if count > 1.0 && (to - from).abs() <= f64::EPSILON * from.abs() {
        return Err(wrong(to, "two different ends, or COUNT 1").into());
    }
    let step = if count > 1.0 { (to - from) / (count - 1.0) } else { 0.0 };
    let places = std::iter::successors(Some(0.0), |k| Some(k + 1.0)).take_while(|k| *k < count);
    Ok(places.map(|k| from + k * step).collect())
}

/// The case of a wheelset file, its profile files beside it.
pub(crate) fn read(path: &Path) -> Result<WheelsetCase, Failure> {
    let text = read_text(path)?;
    let directory = path.parent().unwrap_or(Path::new(""));
    WheelsetFile::read(&text)
        .map_err(WheelsetFileError::from)
        .and_then(|file| file.case(directory))
        .map_err(|source| Failure::Wheelset { path: path.into(), source: Box::new(source) })
}

/// Says which sections of a file have no place in many positions at once: rows, tables and maps.
pub(crate) fn say_left_out(case: &WheelsetCase, of: &str) {
    let sections = [("[damage]", case.damage.is_some()), ("[heat]", case.heat.is_some())];
    for (section, _) in sections.iter().filter(|(_, is_there)| *is_there) {
        say(&format!("note: {section} is left out of {of}: solve a position by itself for it"));
    }
}

/// Says what was found in a profile file: nothing is guessed silently.
pub(crate) fn say_found(note: &ProfileNote) {
    for action in &note.actions {
        say(&format!("note: {}: {action}", note.path.display()));
    }
}
