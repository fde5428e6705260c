//! Run of a sweep: its chains side by side, every solved case in a journal.

use std::io;
use std::path::Path;

use creepage::Status;
use creepage::variational::{Chain, NewtonStep, Variational, VariationalSolution};
use rayon::prelude::*;

use super::journal::Journal;
use super::record::Record;
use super::{SeriesRow, Tally};
use crate::{Sweep, SweepCase};

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
