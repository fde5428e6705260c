//! The file of a finished sweep, and what to say of it.

use std::fmt;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use creepage::rolling::Status;
use creepage::rolling::variational::Variational;
use creepage_1967::{Page, PageStyle};
use creepage_case::Sweep;
use creepage_report::{ReportError, SeriesHead, SeriesRow, series_csv, series_json, series_netcdf};

use super::chains;
use super::journal::Journal;
use crate::args::SeriesFormat;
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::partial_file::PartialFile;

/// Writes the results, case by case from the journal.
pub(super) fn write(
    sweep: &Sweep,
    theory: &Variational,
    journal: &Journal,
    format: SeriesFormat,
    path: &Path,
) -> Result<Tally, Failure> {
    let failed = |source| Failure::Write { path: path.into(), source };
    let report = |error| match error {
        ReportError::Series(source) => failed(source),
        other => Failure::Report(other),
    };
    let mut file = PartialFile::create(path).map_err(failed)?;
    let rows = || -> io::Result<_> {
        let records = journal.records()?.take(sweep.cases()).enumerate();
        Ok(records.map(|(index, record)| Ok(record?.row(&sweep.case(index)))))
    };
    let head = SeriesHead::from(sweep);
    let partial = file.path().to_owned();
    match format {
        SeriesFormat::Csv => series_csv(&head, rows().map_err(failed)?, buffered(&mut file)),
        SeriesFormat::Json => series_json(&head, rows().map_err(failed)?, buffered(&mut file)),
        SeriesFormat::Netcdf => series_netcdf(&head, rows, &partial),
        SeriesFormat::Page => pages(sweep, theory, journal, PageStyle::English, &mut file),
        SeriesFormat::Page1967 => pages(sweep, theory, journal, PageStyle::Of1967, &mut file),
    }
    .map_err(report)?;
    file.finish().map_err(failed)?;
    Tally::count(rows().map_err(failed)?).map_err(failed)
}

fn buffered(file: &mut PartialFile) -> impl Write {
    BufWriter::with_capacity(1 << 16, file.file())
}

/// A page a case. Each case is solved once more, for the course of its iteration.
fn pages(
    sweep: &Sweep,
    theory: &Variational,
    journal: &Journal,
    style: PageStyle,
    file: &mut PartialFile,
) -> Result<(), ReportError> {
    let mut out = buffered(file);
    let mut chain = sweep.chain(theory, 0);
    let mut steps = Vec::new();
    for (index, record) in journal.records()?.take(sweep.cases()).enumerate() {
        if index % sweep.chain_length() == 0 {
            chain = sweep.chain(theory, index);
        }
        let case = sweep.case(index);
        steps.clear();
        let found = chain.clone().solve(case.creepage, Some(&mut steps)).found;
        let page = Page {
            theory,
            loops: [case.chi, case.upsilon, case.alpha],
            creepage: case.creepage,
            steps: &steps,
            found: &found,
            mesh: sweep.settings.mesh,
            lines: &sweep.page_lines,
        };
        writeln!(out, "{}", page.text(style))?;
        chains::go_on(&mut chain, sweep, theory, index, &record?);
    }
    Ok(out.flush()?)
}

/// How many cases were solved, and how.
#[derive(Debug, Default)]
pub(super) struct Tally {
    cases: usize,
    not_converged: usize,
    too_small: usize,
    by_smaller_steps: usize,
    aberrant: usize,
    doubted: usize,
}

/// A second start that changes a force by more than this found another minimum: the same one is
/// found to 1e-9.
const SAME_MINIMUM: f64 = 1e-6;

impl Tally {
    fn count(rows: impl Iterator<Item = io::Result<SeriesRow>>) -> io::Result<Self> {
        let mut tally = Self::default();
        for row in rows {
            let row = row?;
            tally.cases += 1;
            tally.not_converged += usize::from(row.status == Status::NotConverged);
            tally.too_small += usize::from(row.status == Status::CreepageTooSmall);
            tally.by_smaller_steps += usize::from(row.steps_from_previous > 1);
            tally.aberrant += usize::from(row.aberrations > 0);
            tally.doubted += usize::from(row.second_start_difference > SAME_MINIMUM);
        }
        Ok(tally)
    }

    pub(super) fn outcome(&self) -> Outcome {
        if self.not_converged > 0 { Outcome::Doubtful } else { Outcome::Done }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} cases: {} converged", self.cases, self.cases - self.not_converged)?;
        for (count, words) in [
            (self.not_converged, "not converged"),
            (self.too_small, "with creepage too small for the degree"),
            (self.by_smaller_steps, "tried again by smaller steps"),
            (self.aberrant, "with aberrations"),
            (self.doubted, "with another result from the second start"),
        ] {
            if count > 0 {
                write!(f, ", {count} {words}")?;
            }
        }
        Ok(())
    }
}
