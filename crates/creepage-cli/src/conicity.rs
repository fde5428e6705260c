//! `creepage conicity`: equivalent conicity of a wheelset on its track.

use std::path::Path;

use creepage_study::{
    ProfileNote, WheelsetCase, WheelsetError, WheelsetFile, conicity, radius_difference_csv,
};

use crate::args::ConicityArgs;
use crate::failure::Failure;
use crate::input::read_text;
use crate::outcome::Outcome;
use crate::output::{print, say};

pub(crate) fn run(args: &ConicityArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Wheelset { path: args.case.clone(), source: Box::new(source) };
    let case = read(&args.case)?;
    let difference = case.radius_difference(args.roll).map_err(wrong)?;
    case.notes.iter().for_each(say_found);
    if args.radius_difference {
        print(&radius_difference_csv(&difference))?;
        return Ok(Outcome::Done);
    }
    let table = conicity(&difference);
    print(&table.csv)?;
    let Some((amplitude, why)) = table.lacking else { return Ok(Outcome::Done) };
    say(&format!("note: no conicity from amplitude {amplitude:.4} m on: {why}"));
    Ok(Outcome::Doubtful)
}

/// The case of a wheelset file, its profile files beside it.
fn read(path: &Path) -> Result<WheelsetCase, Failure> {
    let text = read_text(path)?;
    let directory = path.parent().unwrap_or(Path::new(""));
    WheelsetFile::read(&text)
        .map_err(WheelsetError::from)
        .and_then(|file| file.case(directory))
        .map_err(|source| Failure::Wheelset { path: path.into(), source: Box::new(source) })
}

/// Says what was found in a profile file: nothing is guessed silently.
fn say_found(note: &ProfileNote) {
    for action in &note.actions {
        say(&format!("note: {}: {action}", note.path.display()));
    }
}
