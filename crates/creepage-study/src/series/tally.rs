//! Tally of a series: how many cases were solved, and how.

use std::fmt;
use std::io;

use creepage::Status;

use super::SeriesRow;

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
