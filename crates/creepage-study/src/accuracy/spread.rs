//! Distribution of a theory's error over a set of cases.

use creepage::{Contact, Status, Theory};
use serde::Serialize;

use super::ReferenceCase;

/// Distribution of an error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spread {
    /// Half of the cases err by less.
    pub median: f64,
    /// Arithmetic mean.
    pub mean: f64,
    /// Root of the mean square.
    pub rms: f64,
    /// 95 of 100 cases err by less.
    pub p95: f64,
    /// Largest.
    pub worst: f64,
}

impl Spread {
    /// The distribution of `errors`; zeros when there are none.
    fn new(mut errors: Vec<f64>) -> Self {
        errors.sort_unstable_by(f64::total_cmp);
        let count = errors.len();
        let mean = |power: fn(f64) -> f64| {
            errors.iter().copied().map(power).sum::<f64>() / count.max(1) as f64
        };
        let at = |hundredths: usize| errors.get(count * hundredths / 100).copied().unwrap_or(0.0);
        Self {
            median: at(50),
            mean: mean(|error| error),
            rms: mean(|error| error * error).sqrt(),
            p95: at(95),
            worst: errors.last().copied().unwrap_or(0.0),
        }
    }
}

/// The error of a theory's force, in parts of `mu N`, and of its moment, in parts of `mu N c`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Accuracy {
    /// Number of cases.
    pub cases: usize,
    /// Those that the theory says itself it does not answer well: all but [`Status::Solved`].
    /// They count like the others.
    pub doubtful: usize,
    /// Length of the difference of `(f_x, f_y)`.
    pub force: Spread,
    /// Size of the difference of `m_z`.
    pub moment: Spread,
}

/// Measures a theory over `cases`; `prepare` gives it for a contact.
///
/// # Errors
/// What `prepare` returns, should a case be out of the theory's range.
pub fn measure<E>(
    cases: &[ReferenceCase],
    prepare: impl Fn(&Contact) -> Result<Box<dyn Theory>, E>,
) -> Result<Accuracy, E> {
    let (mut force, mut moment, mut doubtful) = (Vec::new(), Vec::new(), 0);
    for alike in cases.chunk_by(|one, two| one.contact == two.contact) {
        let theory = prepare(&alike[0].contact)?;
        for case in alike {
            let solution = theory.solve(case.creepage);
            let found = solution.force;
            doubtful += usize::from(solution.status != Status::Solved);
            force.push((found.fx - case.force.fx).hypot(found.fy - case.force.fy));
            moment.push((found.mz - case.force.mz).abs());
        }
    }
    let (force, moment) = (Spread::new(force), Spread::new(moment));
    Ok(Accuracy { cases: cases.len(), doubtful, force, moment })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_of_a_known_set() {
        let spread = Spread::new((1..=100).rev().map(f64::from).collect());
        assert!((spread.median - 51.0).abs() < f64::EPSILON);
        assert!((spread.mean - 50.5).abs() < f64::EPSILON);
        assert!((spread.rms - 3383.5_f64.sqrt()).abs() < 1e-12);
        assert!((spread.p95 - 96.0).abs() < f64::EPSILON);
        assert!((spread.worst - 100.0).abs() < f64::EPSILON);
    }

    #[test]
    fn nothing_has_no_error() {
        assert!(Spread::new(vec![]).worst.abs() < f64::EPSILON);
    }
}
