//! `creepage conicity`: equivalent conicity of a wheelset on its track.

use creepage_study::{Sources, conicity, radius_difference_csv, write_all};

use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::output::{print, say, say_written};
use crate::rail_args::ConicityArgs;
use crate::wheelset::{read, say_found};

/// The files first, then the table, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &ConicityArgs) -> Result<Outcome, Failure> {
    let wrong = |source| Failure::Wheelset { path: args.case.clone(), source: Box::new(source) };
    let case = read(&args.case)?;
    let difference = case.radius_difference(args.roll).map_err(wrong)?;
    case.notes.iter().for_each(say_found);
    for words in case.conicity_caution_words(&difference, args.roll, 0.0) {
        say(&format!("caution: {words}"));
    }
    let radii = radius_difference_csv(&difference);
    if args.radius_difference && args.out.is_none() {
        print(&radii)?;
        return Ok(Outcome::Done);
    }
    let table = conicity(&difference);
    if let Some(directory) = &args.out {
        let [svg, png] = case.geometry_pictures(&difference, args.roll)?;
        let files: [(&str, &[u8]); 4] = [
            ("conicity.csv", table.csv.as_bytes()),
            ("radius_difference.csv", radii.as_bytes()),
            ("geometry.svg", &svg),
            ("geometry.png", &png),
        ];
        say_written(&write_all(
            directory,
            &files,
            &case.sources().with(&Sources::new([&args.case])),
        )?);
    }
    if args.radius_difference {
        print(&radii)?;
        return Ok(Outcome::Done);
    }
    print(&table.csv)?;
    let Some((amplitude, why)) = table.lacking else { return Ok(Outcome::Done) };
    say(&format!("note: no conicity from amplitude {amplitude:.4} m on: {why}"));
    Ok(Outcome::Doubtful)
}
