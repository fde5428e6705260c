//! `creepage statics`: a contact without rolling.

use creepage_study::{Sources, StaticsError, StaticsFile, StaticsReport};

use crate::args::StaticsArgs;
use crate::failure::Failure;
use crate::input::read_text;
use crate::output::{print, say, say_written, to_json};

/// The files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &StaticsArgs) -> Result<(), Failure> {
    let text = read_text(&args.case)?;
    let wrong = |source| Failure::Statics { path: args.case.clone(), source };
    let case = StaticsFile::read(&text)
        .map_err(StaticsError::from)
        .and_then(|file| file.solve())
        .map_err(wrong)?;
    let report = StaticsReport::new(&case).map_err(wrong)?;
    if let Some(directory) = &args.out {
        say_written(&report.write(directory, &Sources::new([&args.case]))?);
    }
    print(&if args.json { to_json(&report.json())? } else { report.text() })?;
    for caution in &case.cautions {
        say(&format!("caution: {caution}"));
    }
    Ok(())
}
