//! Run of a sweep: its chains side by side, every solved case in a journal; and the tally of what was solved.

use super::SeriesRow;
use super::journal::Journal;
use super::record::Record;
use crate::{Sweep, SweepCase};
use creepage::Status;
use creepage::variational::{Chain, NewtonStep, Variational, VariationalSolution};
use rayon::prelude::*;
use std::fmt;
use std::io;
use std::path::Path;

/// A sweep that is being solved, and what of it is solved.
#[derive(Debug)]
pub struct SweepRun<'a> {
    sweep: &'a Sweep,
    theory: &'a Variational,
    journal: Journal,
}

impl<'a> SweepRun<'a> {
    /// Goes on with an earlier run of the same sweep, whose solved cases are in the file
    /// `journal`, or begins a new one. `None` while another process has the journal.
    ///
    /// # Errors
    /// Those of the system.
    pub fn open(
        sweep: &'a Sweep,
        theory: &'a Variational,
        journal: &Path,
    ) -> io::Result<Option<Self>> {
        let journal = Journal::open(journal, sweep)?;
        Ok(journal.map(|journal| Self { sweep, theory, journal }))
    }

    /// Whether cases of an earlier run may be there.
    #[must_use]
    pub fn resumed(&self) -> bool {
        self.journal.resumed()
    }

    /// Solves all cases that the journal does not have, on all cores; `progress` hears of every
    /// case. Each chain is a sequence of its own, so that nothing depends on how many run at a
    /// time.
    ///
    /// # Errors
    /// Those of the system.
    pub fn solve(&self, progress: impl Fn() + Sync) -> io::Result<()> {
        let length = self.sweep.chain_length();
        let chains = self.sweep.cases() / length;
        self.journal.synced(|| {
            (0..chains)
                .into_par_iter()
                .with_max_len(1)
                .try_for_each(|chain| self.solve_chain(chain * length, &progress))
        })
    }

    fn solve_chain(&self, first: usize, progress: impl Fn()) -> io::Result<()> {
        let mut chain = self.sweep.chain(self.theory, first);
        for index in first..first + self.sweep.chain_length() {
            let known = if self.resumed() { self.journal.read(index)? } else { None };
            match known {
                Some(record) => self.skip_solved(&mut chain, index, &record),
                None => self.journal.write(index, &self.next(&mut chain, index))?,
            }
            progress();
        }
        Ok(())
    }

    /// Takes the chain past a case that was solved before.
    fn skip_solved(&self, chain: &mut Chain<'a>, index: usize, record: &Record) {
        if record.status() != Status::NotConverged {
            let creepage = self.sweep.case(index).creepage;
            *chain = Chain::from(self.theory, self.sweep.procedure, creepage, record.tau.clone());
        }
    }

    fn next(&self, chain: &mut Chain, index: usize) -> Record {
        let case = self.sweep.case(index);
        let solved = chain.solve(case.creepage, None);
        let (creepage, found) = (case.creepage, &solved.found);
        let difference = self.sweep.second_start_difference(self.theory, creepage, found);
        Record::new(&SeriesRow::new(&case, &solved, difference), solved.found.tau)
    }

    /// All cases in order, once they are solved.
    ///
    /// # Errors
    /// Those of the system.
    pub fn rows(&self) -> io::Result<impl Iterator<Item = io::Result<SeriesRow>>> {
        let records = self.journal.records()?.take(self.sweep.cases()).enumerate();
        Ok(records.map(|(index, record)| Ok(record?.row(&self.sweep.case(index)))))
    }

    /// Solves every case once more, for the course of its iteration.
    ///
    /// # Errors
    /// Those of `show`, and of the system.
    pub fn replay<E: From<io::Error>>(
        &self,
        mut show: impl FnMut(SweepCase, &[NewtonStep], &VariationalSolution) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut chain = self.sweep.chain(self.theory, 0);
        let mut steps = Vec::new();
        for (index, record) in self.journal.records()?.take(self.sweep.cases()).enumerate() {
            if index % self.sweep.chain_length() == 0 {
                chain = self.sweep.chain(self.theory, index);
            }
            let case = self.sweep.case(index);
            steps.clear();
            let found = chain.clone().solve(case.creepage, Some(&mut steps)).found;
            show(case, &steps, &found)?;
            self.skip_solved(&mut chain, index, &record?);
        }
        Ok(())
    }

    /// Ends the run when its results are on the disk: the journal goes.
    ///
    /// # Errors
    /// Those of the system.
    pub fn finish(self) -> io::Result<Tally> {
        let tally = Tally::count(self.rows()?)?;
        self.journal.remove()?;
        Ok(tally)
    }
}

/// How many cases were solved, and how; in words by [`Display`](fmt::Display).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// All cases.
    pub cases: usize,
    /// Those that did not converge.
    pub not_converged: usize,
    too_small: usize,
    by_smaller_steps: usize,
    aberrant: usize,
    doubted: usize,
}

/// A second start that changes a force by more than this found another minimum: the same one is
/// found to 1e-9.
const SAME_MINIMUM: f64 = 1e-6;

impl Tally {
    pub(super) fn count(rows: impl Iterator<Item = io::Result<SeriesRow>>) -> io::Result<Self> {
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
