//! `creepage statics`: a contact without rolling.

use std::fs;

use creepage_case::{StaticsCase, StaticsError, StaticsFile};
use creepage_report::{ReportError, StaticsReport};

use crate::args::StaticsArgs;
use crate::failure::Failure;
use crate::output::{print, say};

/// The files first, then the report, so that a wrong `--out` prints nothing.
pub(crate) fn run(args: &StaticsArgs) -> Result<(), Failure> {
    let text = fs::read_to_string(&args.case)
        .map_err(|source| Failure::Read { path: args.case.clone(), source })?;
    let wrong = |source| Failure::Statics { path: args.case.clone(), source };
    let case = StaticsFile::read(&text)
        .map_err(StaticsError::from)
        .and_then(|file| file.solve())
        .map_err(wrong)?;
    let report = report(&case).map_err(wrong)?;
    if let Some(directory) = &args.out {
        for path in report.write(directory)? {
            say(&format!("wrote {}", path.display()));
        }
    }
    let json = || serde_json::to_string_pretty(&report.json()).map_err(ReportError::from);
    print(&if args.json { json()? } else { report.text() })
}

fn report(case: &StaticsCase) -> Result<StaticsReport<'_>, StaticsError> {
    Ok(match case {
        StaticsCase::Die { solid, base, normal_force, offset, die } => {
            StaticsReport::die(*solid, *base, *normal_force, *offset, die)?
        }
        StaticsCase::Shift { pair, ellipse, force, bonded } => {
            StaticsReport::shift(*pair, *ellipse, *force, bonded)?
        }
        StaticsCase::Twist { pair, ellipse, moment, bonded } => {
            StaticsReport::twist(*pair, *ellipse, *moment, bonded)?
        }
        StaticsCase::PartialSlip { contact, friction, force, partial } => {
            StaticsReport::partial_slip(contact, *friction, *force, partial)?
        }
    })
}
