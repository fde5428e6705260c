//! The chains of a sweep, side by side.

use std::io;

use creepage::rolling::Status;
use creepage::rolling::variational::{Chain, Variational};
use creepage_case::Sweep;
use creepage_report::SeriesRow;
use indicatif::ProgressBar;
use rayon::prelude::*;

use super::journal::Journal;
use super::record::Record;

/// Solves all cases that the journal does not have. Each chain is a sequence of its own, so that
/// nothing depends on how many run at a time.
pub(super) fn solve(
    sweep: &Sweep,
    theory: &Variational,
    journal: &Journal,
    bar: &ProgressBar,
) -> io::Result<()> {
    let chains = sweep.cases() / sweep.chain_length();
    (0..chains).into_par_iter().with_max_len(1).try_for_each(|number| {
        let first = number * sweep.chain_length();
        let mut chain = sweep.chain(theory, first);
        for index in first..first + sweep.chain_length() {
            let known = if journal.resumed() { journal.read(index)? } else { None };
            match known {
                Some(record) => go_on(&mut chain, sweep, theory, index, &record),
                None => journal.write(index, &next(&mut chain, sweep, theory, index))?,
            }
            bar.inc(1);
        }
        Ok(())
    })
}

/// Takes the chain past a case that was solved before.
pub(super) fn go_on<'a>(
    chain: &mut Chain<'a>,
    sweep: &Sweep,
    theory: &'a Variational,
    index: usize,
    record: &Record,
) {
    if record.status() != Status::NotConverged {
        let creepage = sweep.case(index).creepage;
        *chain = Chain::from(theory, sweep.procedure, creepage, record.tau.clone());
    }
}

fn next(chain: &mut Chain, sweep: &Sweep, theory: &Variational, index: usize) -> Record {
    let case = sweep.case(index);
    let solved = chain.solve(case.creepage, None);
    let difference = sweep.second_start_difference(theory, case.creepage, &solved.found);
    Record::new(&SeriesRow::new(&case, &solved, difference), solved.found.tau)
}
