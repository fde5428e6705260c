//! Bulk solver of many queries: grouped by what a theory is prepared for, on all cores.

use std::ops::Deref;
use std::sync::Arc;

use creepage::table::{Table, TableTheory};
use creepage::theory::TheoryError;
use creepage::{Contact, Creepage, Force, InvalidValue, Solution, Status, Theory, TheorySpec};
use rayon::prelude::*;

use crate::recent::Recent;
use crate::{CaseError, Caution};

/// Query of one row: a contact and a creepage.
#[derive(Debug, Clone, PartialEq)]
pub struct BulkQuery {
    /// The contact.
    pub contact: Contact,
    /// How it creeps.
    pub creepage: Creepage,
    /// Whether a load presses the bodies together; else the answer is no force.
    pub touches: bool,
}

/// A force and its cautions.
#[derive(Debug, Clone, PartialEq)]
pub struct Reply {
    /// Force, error bars, status.
    pub solution: Solution,
    /// Frictional power, dimensionless: [`Solved::power`](creepage::Solved::power).
    pub power: f64,
    /// Cautions about it.
    pub cautions: Vec<Caution>,
}

/// Error of a row without an answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RowError {
    /// Its values are no case.
    #[error(transparent)]
    Case(Box<CaseError>),
    /// The contact is out of the theory's range.
    #[error(transparent)]
    Theory(#[from] TheoryError),
    /// A number is out of its range, or out of that of a table.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
}

impl From<CaseError> for RowError {
    fn from(error: CaseError) -> Self {
        Self::Case(Box::new(error))
    }
}

/// What a theory is prepared for: the bits of `a/b`, of Poisson's ratio and of `kappa/mu`.
type Key = [u64; 3];

/// One theory, prepared for the last few kinds of contact that were asked about, or a table.
pub struct Solver(PreparedFor);

enum PreparedFor {
    Theory { spec: TheorySpec, prepared: Recent<Key, Box<dyn Theory>> },
    Table(Arc<Table>),
}

/// A theory for one contact.
enum Ready<'a> {
    Theory(Arc<Box<dyn Theory>>),
    Table(Box<TableTheory<'a>>),
}

impl<'a> Deref for Ready<'a> {
    type Target = dyn Theory + 'a;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Theory(theory) => &***theory,
            Self::Table(table) => &**table,
        }
    }
}

/// A query and its place among those asked together.
struct Placed {
    key: Key,
    place: usize,
    query: BulkQuery,
}

impl Solver {
    /// Prepared theories that are kept: tables mostly run through a few ratios in turn, and a
    /// prepared theory may be some megabytes.
    const KEPT: usize = 64;

    /// By a theory with its options.
    #[must_use]
    pub fn new(spec: TheorySpec) -> Self {
        Self(PreparedFor::Theory { spec, prepared: Recent::new(|| Self::KEPT) })
    }

    /// By a table.
    #[must_use]
    pub fn of_table(table: Arc<Table>) -> Self {
        Self(PreparedFor::Table(table))
    }

    /// Whether its forces come with error bars.
    #[must_use]
    pub fn error_bars(&self) -> bool {
        matches!(&self.0, PreparedFor::Theory { spec, .. } if spec.facts().error_bars)
    }

    /// The ratio `a/b` and Poisson's ratio, where it is a table that has but one of them.
    #[must_use]
    pub fn only_contact(&self) -> [Option<f64>; 2] {
        let PreparedFor::Table(table) = &self.0 else { return [None; 2] };
        [table.a_over_b(), table.poisson()].map(|axis| (axis.nodes == 1).then_some(axis.low))
    }

    /// The answers in the order of the queries, the same on any number of cores. `Err` items pass
    /// through unchanged.
    pub fn solve<E: From<RowError> + Send>(
        &self,
        queries: Vec<Result<BulkQuery, E>>,
    ) -> Vec<Result<Reply, E>> {
        let mut answers = Vec::with_capacity(queries.len());
        let mut asked = Vec::with_capacity(queries.len());
        for (place, query) in queries.into_iter().enumerate() {
            match query {
                Ok(query) => {
                    asked.push(Placed { key: self.key(&query.contact), place, query });
                }
                Err(error) => answers.push((place, Err(error))),
            }
        }
        asked.sort_unstable_by_key(|asked| (asked.key, asked.place));
        let together = |one: &Placed, two: &Placed| {
            one.key == two.key
                && (self.is_shared(&one.query.contact) || one.query.contact == two.query.contact)
        };
        let groups: Vec<_> = asked.chunk_by(together).collect();
        answers.par_extend(groups.into_par_iter().flat_map(|group| self.solve_group(group)));
        answers.sort_unstable_by_key(|(place, _)| *place);
        answers.into_iter().map(|(_, answer)| answer).collect()
    }

    /// The answer to one query.
    ///
    /// # Errors
    /// [`RowError`] for a contact out of the theory's range.
    pub fn solve_one(&self, query: &BulkQuery) -> Result<Reply, RowError> {
        let theory = self.ready(self.key(&query.contact), &query.contact)?;
        Ok(self.reply(&*theory, query))
    }

    /// Answers queries of one key, each with its place.
    fn solve_group<E: From<RowError> + Send>(
        &self,
        group: &[Placed],
    ) -> Vec<(usize, Result<Reply, E>)> {
        let Some(first) = group.first() else { return Vec::new() };
        let theory = self.ready(first.key, &first.query.contact);
        let answer = |asked: &Placed| {
            let reply = |theory: &Ready<'_>| self.reply(&**theory, &asked.query);
            (asked.place, theory.as_ref().map(reply).map_err(|error| E::from(error.clone())))
        };
        group.par_iter().map(answer).collect()
    }

    fn reply(&self, theory: &(dyn Theory + '_), query: &BulkQuery) -> Reply {
        if !query.touches {
            let (mut solution, status) = (Solution::no_contact(), Status::NoContact);
            solution.error = self.error_bars().then(Force::default);
            return Reply { solution, power: 0.0, cautions: vec![Caution::Status(status)] };
        }
        let solved = theory.solved(query.creepage);
        let (solution, power) = (solved.solution(), solved.power());
        let contact = &query.contact;
        let cautions = match &self.0 {
            PreparedFor::Theory { spec, .. } => Caution::all(spec, contact, &solution),
            PreparedFor::Table(_) => Caution::all_of_table(contact),
        };
        Reply { solution, power, cautions }
    }

    fn ready(&self, key: Key, contact: &Contact) -> Result<Ready<'_>, RowError> {
        match &self.0 {
            PreparedFor::Theory { spec, .. } if !self.is_shared(contact) => {
                Ok(Ready::Theory(Arc::new(spec.prepare(contact)?)))
            }
            PreparedFor::Theory { spec, prepared } => {
                let theory = match prepared.find(&key) {
                    Some(theory) => theory,
                    None => prepared.keep(&key, spec.prepare(contact)?),
                };
                Ok(Ready::Theory(theory))
            }
            PreparedFor::Table(table) => Ok(Ready::Table(Box::new(table.prepare(contact)?))),
        }
    }

    /// A theory that neglects how dissimilar the bodies are is one for all of them.
    fn key(&self, contact: &Contact) -> Key {
        let counts =
            matches!(&self.0, PreparedFor::Theory { spec, .. } if spec.facts().dissimilar_bodies);
        let kappa_over_mu = if counts { contact.kappa_over_mu() } else { 0.0 };
        [contact.ellipse().ratio(), contact.poisson(), kappa_over_mu].map(f64::to_bits)
    }

    /// Whether a theory for this contact serves all of its key: a law of friction, a layer and an added slip are in
    /// units of their own contact, and coupled bodies need the coefficient of friction by itself.
    fn is_shared(&self, contact: &Contact) -> bool {
        let coupled = matches!(
            &self.0,
            PreparedFor::Theory { spec: TheorySpec::Exact(options), .. } if options.coupled
        );
        let is_plain = contact.rolling_friction().is_none() && contact.layer().is_none();
        !coupled && is_plain && contact.added_slip().is_none()
    }
}

impl std::fmt::Debug for Solver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.0 {
            PreparedFor::Theory { spec, .. } => f.debug_tuple("Solver").field(spec).finish(),
            PreparedFor::Table(table) => f.debug_tuple("Solver").field(table.provenance()).finish(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::Ellipse;

    fn query(a_over_b: f64, xi: f64) -> BulkQuery {
        let contact = Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), 0.28).unwrap();
        let creepage = Creepage::new(xi, 0.0, 0.5).unwrap();
        BulkQuery { contact, creepage, touches: true }
    }

    fn solve(solver: &Solver, queries: Vec<BulkQuery>) -> Vec<Result<Reply, RowError>> {
        solver.solve(queries.into_iter().map(Ok).collect())
    }

    #[test]
    fn prepared_theories_do_not_pile_up() {
        let solver = Solver::new(TheorySpec::named("polach").unwrap());
        let many = (0..3 * Solver::KEPT).map(|i| query(1.0 + i as f64, 1.0)).collect();
        assert_eq!(solve(&solver, many).len(), 3 * Solver::KEPT);
        let PreparedFor::Theory { prepared, .. } = &solver.0 else { panic!("a theory") };
        assert_eq!(prepared.count(), Solver::KEPT);
    }

    #[test]
    fn answers_come_in_the_order_of_the_queries() {
        let solver = Solver::new(TheorySpec::named("variational").unwrap());
        let queries: Vec<_> =
            (0..40).map(|i| query([2.0, 0.5, 1.0][i % 3], 0.5 + 0.1 * i as f64)).collect();
        let together = solve(&solver, queries.clone());
        for (query, answer) in queries.into_iter().zip(together) {
            assert_eq!(solve(&solver, vec![query.clone()]), vec![answer.clone()]);
            assert_eq!(solver.solve_one(&query), answer);
        }
    }

    #[test]
    fn one_theory_serves_all_dissimilarities_that_it_neglects() {
        let unlike = query(1.0, 0.5).contact.with_kappa_over_mu(0.3).unwrap();
        let unlike = BulkQuery { contact: unlike, ..query(1.0, 0.5) };
        for (name, kinds) in [("polach", 1), ("exact", 2)] {
            let solver = Solver::new(TheorySpec::named(name).unwrap());
            let replies = solve(&solver, vec![query(1.0, 0.5), unlike.clone()]);
            let PreparedFor::Theory { prepared, .. } = &solver.0 else { panic!("a theory") };
            assert_eq!(prepared.count(), kinds, "{name}");
            let forces = replies.iter().map(|reply| reply.as_ref().unwrap().solution.force);
            let forces: Vec<_> = forces.collect();
            assert_eq!(forces[0] == forces[1], kinds == 1);
        }
    }
}
