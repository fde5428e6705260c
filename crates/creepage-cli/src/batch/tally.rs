//! How many rows were answered, and how.

use std::fmt;

use creepage::Status;
use creepage_study::Caution;

use super::solver::{Answer, Reply};
use crate::outcome::Outcome;

/// Counts of rows by what became of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Tally {
    rows: usize,
    solved: usize,
    not_converged: usize,
    invalid: usize,
    /// Rows of dissimilar bodies, which the theory neglects.
    dissimilar: usize,
}

impl Tally {
    pub(super) fn count(&mut self, answer: &Answer) {
        self.rows += 1;
        let dissimilar = |caution: &Caution| matches!(caution, Caution::Dissimilar { .. });
        let is_so = |reply: &Reply| reply.cautions.iter().any(dissimilar);
        self.dissimilar += usize::from(answer.as_ref().is_ok_and(is_so));
        match answer.as_ref().map(|reply| reply.solution.status) {
            Ok(Status::Solved) => self.solved += 1,
            Ok(Status::NotConverged) => self.not_converged += 1,
            Ok(_) => {}
            Err(_) => self.invalid += 1,
        }
    }

    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// Words of caution about rows of unlike bodies.
    pub(super) fn caution(&self) -> Option<String> {
        let rows = if self.dissimilar == 1 { "row is" } else { "rows are" };
        (self.dissimilar > 0).then(|| {
            format!(
                "caution: {} {rows} of unlike bodies, which the theory takes for like ones: \
                 `message` says how far the force may be off",
                self.dissimilar
            )
        })
    }

    pub(super) fn outcome(&self) -> Outcome {
        if self.invalid + self.not_converged > 0 { Outcome::Doubtful } else { Outcome::Done }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rows, solved, not_converged, invalid, .. } = *self;
        write!(f, "{rows} rows: {solved} solved")?;
        let others = [
            (not_converged, "not converged"),
            (rows - solved - not_converged - invalid, "beyond the theory's range"),
            (invalid, "invalid"),
        ];
        for (count, name) in others {
            if count > 0 {
                write!(f, ", {count} {name}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::columns::RowError;
    use creepage::{Force, Solution, Statistics, TheorySpec};

    fn tally(answers: &[Answer]) -> Tally {
        let mut tally = Tally::default();
        for answer in answers {
            tally.count(answer);
        }
        tally
    }

    fn with(status: Status) -> Reply {
        let (force, statistics) = (Force::default(), Statistics::default());
        Reply { solution: Solution { force, error: None, status, statistics }, cautions: vec![] }
    }

    #[test]
    fn doubtful_rows_make_the_whole_doubtful() {
        assert_eq!(tally(&[]).outcome(), Outcome::Done);
        assert_eq!(tally(&[Ok(with(Status::SpinTooLarge))]).outcome(), Outcome::Done);
        assert_eq!(tally(&[Ok(with(Status::NotConverged))]).outcome(), Outcome::Doubtful);
        let invalid = Err(RowError::EmptyField { column: "xi" });
        let tally = tally(&[Ok(with(Status::Solved)), Ok(with(Status::SpinTooLarge)), invalid]);
        assert_eq!(tally.outcome(), Outcome::Doubtful);
        assert_eq!(tally.to_string(), "3 rows: 1 solved, 1 beyond the theory's range, 1 invalid");
        assert_eq!(tally.caution(), None);
    }

    #[test]
    fn what_is_left_out_is_counted() {
        let polach = TheorySpec::named("polach").unwrap();
        let cautions = Caution::dissimilar(&polach, 0.3).into_iter().collect();
        let tally = tally(&[Ok(Reply { cautions, ..with(Status::Solved) })]);
        assert_eq!(tally.outcome(), Outcome::Done);
        assert!(tally.caution().unwrap().starts_with("caution: 1 row is of unlike bodies"));
    }
}
