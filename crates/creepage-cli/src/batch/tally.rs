//! Tally of batch rows by their outcome.

use std::fmt;

use creepage::Status;
use creepage_study::{Caution, Reply};

use super::columns::NoCase;
use crate::outcome::Outcome;

/// Counts of rows by their outcome.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Tally {
    rows: usize,
    solved: usize,
    not_converged: usize,
    invalid: usize,
    no_contact: usize,
    /// Rows of dissimilar bodies, which the theory neglects.
    dissimilar: usize,
    /// Rows with a number that may be in another unit.
    units: usize,
    /// Rows with a field that holds other rows.
    open_quotes: usize,
}

impl Tally {
    pub(super) fn count(&mut self, answer: Result<&Reply, &NoCase>) {
        let Ok(Reply { solution, cautions, .. }) = answer else {
            self.count_status(None);
            return;
        };
        let any = |is: fn(&Caution) -> bool| usize::from(cautions.iter().any(is));
        self.dissimilar += any(|caution| matches!(caution, Caution::Dissimilar { .. }));
        self.units += any(Caution::is_of_units);
        self.count_status(Some(solution.status));
    }

    /// A row with that status; none where the row is no case.
    pub(super) fn count_status(&mut self, status: Option<Status>) {
        self.rows += 1;
        match status {
            None => self.invalid += 1,
            Some(Status::Solved) => self.solved += 1,
            Some(Status::NotConverged) => self.not_converged += 1,
            Some(Status::NoContact) => self.no_contact += 1,
            Some(_) => {}
        }
    }

    /// The same with so many rows that hold other ones.
    pub(super) fn with_open_quotes(self, open_quotes: usize) -> Self {
        Self { open_quotes, ..self }
    }

    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// Words of caution about many rows.
    pub(super) fn cautions(&self) -> Vec<String> {
        let of = |rows: usize, words: &str| {
            let are = if rows == 1 { "row is" } else { "rows are" };
            (rows > 0).then(|| format!("caution: {rows} {are} {words}"))
        };
        let dissimilar = of(
            self.dissimilar,
            "of unlike bodies, which the theory takes for like ones: `message` says how far the \
             force may be off",
        );
        let units = of(self.units, "beyond any real contact: `message` says which unit to check");
        dissimilar.into_iter().chain(units).collect()
    }

    pub(super) fn outcome(&self) -> Outcome {
        let doubtful = self.invalid + self.not_converged + self.open_quotes;
        if doubtful > 0 { Outcome::Doubtful } else { Outcome::Done }
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rows, solved, not_converged, invalid, no_contact, .. } = *self;
        write!(f, "{rows} rows: {solved} solved")?;
        let others = [
            (not_converged, "not converged"),
            (no_contact, "without contact"),
            (rows - solved - not_converged - invalid - no_contact, "beyond the theory's range"),
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
    use creepage::{Force, Solution, Statistics, TheorySpec};

    fn tally(answers: &[Result<Reply, NoCase>]) -> Tally {
        let mut tally = Tally::default();
        for answer in answers {
            tally.count(answer.as_ref());
        }
        tally
    }

    fn with(status: Status) -> Reply {
        let (force, statistics) = (Force::default(), Statistics::default());
        let solution = Solution { force, error: None, status, statistics };
        Reply { solution, power: 0.0, cautions: vec![] }
    }

    #[test]
    fn doubtful_rows_make_the_whole_doubtful() {
        assert_eq!(tally(&[]).outcome(), Outcome::Done);
        assert_eq!(tally(&[Ok(with(Status::SpinTooLarge))]).outcome(), Outcome::Done);
        assert_eq!(tally(&[Ok(with(Status::NotConverged))]).outcome(), Outcome::Doubtful);
        let invalid = Err(NoCase::EmptyField { column: "xi" });
        let tally = tally(&[Ok(with(Status::Solved)), Ok(with(Status::SpinTooLarge)), invalid]);
        assert_eq!(tally.outcome(), Outcome::Doubtful);
        assert_eq!(tally.to_string(), "3 rows: 1 solved, 1 beyond the theory's range, 1 invalid");
        assert!(tally.cautions().is_empty());
    }

    #[test]
    fn what_is_left_out_and_what_looks_wrong_is_counted() {
        let polach = TheorySpec::named("polach").unwrap();
        let cautions = Caution::dissimilar(&polach, 0.3).into_iter().collect();
        let unlike = Reply { cautions, ..with(Status::Solved) };
        let degrees = Caution::LargeCreepage { component: "lateral", value: 2.0 };
        let large = || Reply { cautions: vec![degrees], ..with(Status::Solved) };
        let tally = tally(&[Ok(unlike), Ok(large()), Ok(large())]);
        assert_eq!(tally.outcome(), Outcome::Done);
        let [unlike, large] = &tally.cautions()[..] else { panic!("two") };
        assert!(unlike.starts_with("caution: 1 row is of unlike bodies"));
        assert!(large.starts_with("caution: 2 rows are beyond any real contact"));
    }
}
