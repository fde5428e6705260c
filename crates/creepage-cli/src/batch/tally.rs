//! How many rows were answered, and how.

use std::fmt;

use creepage::rolling::Status;

use super::solver::Answer;
use crate::outcome::Outcome;

/// Counts of rows by what became of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Tally {
    rows: usize,
    solved: usize,
    not_converged: usize,
    invalid: usize,
}

impl Tally {
    pub(super) fn count(&mut self, answer: &Answer) {
        self.rows += 1;
        match answer.as_ref().map(|answered| answered.solution.status) {
            Ok(Status::Solved) => self.solved += 1,
            Ok(Status::NotConverged) => self.not_converged += 1,
            Ok(_) => {}
            Err(_) => self.invalid += 1,
        }
    }

    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    pub(super) fn outcome(&self) -> Outcome {
        if self.invalid + self.not_converged > 0 { Outcome::Doubtful } else { Outcome::Done }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rows, solved, not_converged, invalid } = *self;
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
    use creepage::rolling::{Force, Solution};
    use creepage_theories::Answered;

    fn tally(answers: &[Answer]) -> Tally {
        let mut tally = Tally::default();
        for answer in answers {
            tally.count(answer);
        }
        tally
    }

    fn with(status: Status) -> Answered {
        Answered { solution: Solution { force: Force::default(), status }, error: None }
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
    }
}
