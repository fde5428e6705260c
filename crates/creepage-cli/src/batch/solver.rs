//! Many questions at once: grouped by what a theory is prepared for, on all cores.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use creepage_study::{Answered, Entry, LeftOut, PreparedTheory, Solve, TheoryError};
use rayon::prelude::*;

use super::columns::{Question, RowError};

/// What a theory is prepared for: the bits of `a/b`, of Poisson's ratio and of `kappa/mu`.
type Key = [u64; 3];
type Prepared = Arc<PreparedTheory>;

/// The force that a row asks for, or why it asks for none.
pub(super) type Answer = Result<Reply, RowError>;

/// A force, and what the theory leaves out of the row's question.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reply {
    pub(super) answered: Answered,
    pub(super) left_out: Option<LeftOut>,
}

struct Asked {
    key: Key,
    /// Number of the row among those asked together.
    place: usize,
    question: Question,
}

/// One theory, prepared for the last few kinds of contact that were asked about.
pub(super) struct Solver {
    theory: &'static Entry,
    options: Solve,
    prepared: Mutex<VecDeque<(Key, Prepared)>>,
}

impl Solver {
    /// Prepared theories that are kept: tables mostly run through a few ratios in turn, and a
    /// prepared theory may be some megabytes.
    const KEPT: usize = 64;

    pub(super) fn new(theory: &'static Entry, options: Solve) -> Self {
        Self { theory, options, prepared: Mutex::default() }
    }

    /// The answers in the order of the questions, the same on any number of cores.
    pub(super) fn solve(&self, questions: Vec<Result<Question, RowError>>) -> Vec<Answer> {
        let mut answers = Vec::with_capacity(questions.len());
        let mut asked = Vec::with_capacity(questions.len());
        for (place, question) in questions.into_iter().enumerate() {
            match question {
                Ok(question) => asked.push(Asked { key: key(&question), place, question }),
                Err(error) => answers.push((place, Err(error))),
            }
        }
        asked.sort_unstable_by_key(|asked| (asked.key, asked.place));
        let groups: Vec<_> = asked.chunk_by(|one, two| one.key == two.key).collect();
        answers.par_extend(groups.into_par_iter().flat_map(|group| self.solve_group(group)));
        answers.sort_unstable_by_key(|(place, _)| *place);
        answers.into_iter().map(|(_, answer)| answer).collect()
    }

    /// Answers questions of one key, each with its place.
    fn solve_group(&self, group: &[Asked]) -> Vec<(usize, Answer)> {
        let theory = self.prepare(&group[0].question);
        let answer = |asked: &Asked| {
            let reply = |theory: &Prepared| Reply {
                answered: theory.answer(asked.question.creepage),
                left_out: self.theory.leaves_out(asked.question.kappa_over_mu),
            };
            (asked.place, theory.as_ref().map(reply).map_err(|error| error.clone().into()))
        };
        group.par_iter().map(answer).collect()
    }

    fn prepare(&self, question: &Question) -> Result<Prepared, TheoryError> {
        let key = key(question);
        if let Some(theory) = self.recall(key) {
            return Ok(theory);
        }
        let Question { a_over_b, poisson, kappa_over_mu, .. } = *question;
        let like = self.theory.prepare(a_over_b, poisson, &self.options)?;
        let theory = Arc::new(like.with_unlikeness(kappa_over_mu)?);
        self.keep(key, &theory);
        Ok(theory)
    }

    /// A theory that was kept; it is then the last to be dropped.
    fn recall(&self, key: Key) -> Option<Prepared> {
        let mut prepared = self.prepared.lock().unwrap_or_else(PoisonError::into_inner);
        let place = prepared.iter().position(|(known, _)| *known == key)?;
        let entry = prepared.remove(place)?;
        let theory = Arc::clone(&entry.1);
        prepared.push_back(entry);
        Some(theory)
    }

    fn keep(&self, key: Key, theory: &Prepared) {
        let mut prepared = self.prepared.lock().unwrap_or_else(PoisonError::into_inner);
        if prepared.len() == Self::KEPT {
            prepared.pop_front();
        }
        prepared.push_back((key, Arc::clone(theory)));
    }
}

fn key(question: &Question) -> Key {
    [question.a_over_b, question.poisson, question.kappa_over_mu].map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::rolling::Creepage;
    use creepage_study::find;

    fn question(a_over_b: f64, xi: f64) -> Question {
        let creepage = Creepage { xi, eta: 0.0, chi: 0.5 };
        Question { a_over_b, poisson: 0.28, kappa_over_mu: 0.0, creepage }
    }

    #[test]
    fn prepared_theories_do_not_pile_up() {
        let solver = Solver::new(find("variational").unwrap(), Solve::default());
        let many = (0..3 * Solver::KEPT).map(|i| Ok(question(1.0 + i as f64, 1.0))).collect();
        assert_eq!(solver.solve(many).len(), 3 * Solver::KEPT);
        assert_eq!(solver.prepared.lock().unwrap().len(), Solver::KEPT);
    }

    #[test]
    fn answers_come_in_the_order_of_the_questions() {
        let solver = Solver::new(find("variational").unwrap(), Solve::default());
        let questions: Vec<_> =
            (0..40).map(|i| question([2.0, 0.5, 1.0][i % 3], 0.5 + 0.1 * i as f64)).collect();
        let together = solver.solve(questions.iter().copied().map(Ok).collect());
        for (question, answer) in questions.into_iter().zip(together) {
            assert_eq!(solver.solve(vec![Ok(question)]), vec![answer]);
        }
    }
}
