//! Many questions at once: grouped by what a theory is prepared for, on all cores.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use creepage::theory::TheoryError;
use creepage::{Contact, Solution, Theory, TheorySpec};
use creepage_study::Caution;
use rayon::prelude::*;

use super::columns::{Question, RowError};

/// What a theory is prepared for: the bits of `a/b`, of Poisson's ratio and of `kappa/mu`.
type Key = [u64; 3];
type Prepared = Arc<dyn Theory>;

/// The force that a row asks for, or why it asks for none.
pub(super) type Answer = Result<Reply, RowError>;

/// A force, and what is to be held against it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reply {
    pub(super) solution: Solution,
    pub(super) cautions: Vec<Caution>,
}

struct Asked {
    key: Key,
    /// Number of the row among those asked together.
    place: usize,
    question: Question,
}

/// One theory, prepared for the last few kinds of contact that were asked about.
pub(super) struct Solver {
    theory: TheorySpec,
    prepared: Mutex<VecDeque<(Key, Prepared)>>,
}

impl Solver {
    /// Prepared theories that are kept: tables mostly run through a few ratios in turn, and a
    /// prepared theory may be some megabytes.
    const KEPT: usize = 64;

    pub(super) fn new(theory: TheorySpec) -> Self {
        Self { theory, prepared: Mutex::default() }
    }

    /// The answers in the order of the questions, the same on any number of cores.
    pub(super) fn solve(&self, questions: Vec<Result<Question, RowError>>) -> Vec<Answer> {
        let mut answers = Vec::with_capacity(questions.len());
        let mut asked = Vec::with_capacity(questions.len());
        for (place, question) in questions.into_iter().enumerate() {
            match question {
                Ok(question) => asked.push(Asked { key: key(&question.contact), place, question }),
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
        let theory = self.prepare(&group[0].question.contact);
        let answer = |asked: &Asked| {
            let reply = |theory: &Prepared| {
                let Question { contact, creepage } = asked.question;
                let solution = theory.solve(creepage);
                Reply { solution, cautions: Caution::all(&self.theory, &contact, &solution) }
            };
            (asked.place, theory.as_ref().map(reply).map_err(|error| error.clone().into()))
        };
        group.par_iter().map(answer).collect()
    }

    fn prepare(&self, contact: &Contact) -> Result<Prepared, TheoryError> {
        let key = key(contact);
        if let Some(theory) = self.recall(key) {
            return Ok(theory);
        }
        let theory = Arc::from(self.theory.prepare(contact)?);
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

fn key(contact: &Contact) -> Key {
    [contact.ellipse().ratio(), contact.poisson(), contact.kappa_over_mu()].map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::{Creepage, Ellipse};

    fn question(a_over_b: f64, xi: f64) -> Question {
        let contact = Contact::new(Ellipse::from_ratio(a_over_b).unwrap(), 0.28).unwrap();
        Question { contact, creepage: Creepage::new(xi, 0.0, 0.5).unwrap() }
    }

    #[test]
    fn prepared_theories_do_not_pile_up() {
        let solver = Solver::new(TheorySpec::named("variational").unwrap());
        let many = (0..3 * Solver::KEPT).map(|i| Ok(question(1.0 + i as f64, 1.0))).collect();
        assert_eq!(solver.solve(many).len(), 3 * Solver::KEPT);
        assert_eq!(solver.prepared.lock().unwrap().len(), Solver::KEPT);
    }

    #[test]
    fn answers_come_in_the_order_of_the_questions() {
        let solver = Solver::new(TheorySpec::named("variational").unwrap());
        let questions: Vec<_> =
            (0..40).map(|i| question([2.0, 0.5, 1.0][i % 3], 0.5 + 0.1 * i as f64)).collect();
        let together = solver.solve(questions.iter().copied().map(Ok).collect());
        for (question, answer) in questions.into_iter().zip(together) {
            assert_eq!(solver.solve(vec![Ok(question)]), vec![answer]);
        }
    }
}
