//! Forces that are wanted, and the creepage that gives them.

use std::fmt;
use std::path::Path;

use creepage::rolling::exact::{InverseError, Known};
use creepage::rolling::{SiCreepage, SiForce};
use creepage_case::{Case, InverseCase};

use crate::failure::Failure;
use crate::theories::{Entry, Examination, FindError};

/// Wanted forces that no creepage gives.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unreachable {
    /// Which components are wanted.
    wanted: [bool; 3],
    /// The forces that came nearest.
    force: SiForce,
    /// Their creepage.
    at: SiCreepage,
}

impl std::error::Error for Unreachable {}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { wanted, force, at } = self;
        let forces = [
            format!("longitudinal_force = {:?} N", rounded(force.longitudinal)),
            format!("lateral_force = {:?} N", rounded(force.lateral)),
            format!("moment = {:?} N m", rounded(force.moment)),
        ];
        let reached = forces.into_iter().zip(wanted).filter_map(|(force, on)| on.then_some(force));
        write!(
            f,
            "[wanted] is not reachable: at most {} was reached, at longitudinal = {:?}, \
             lateral = {:?}, spin = {:?} rad/m",
            reached.collect::<Vec<_>>().join(", "),
            rounded(at.longitudinal),
            rounded(at.lateral),
            rounded(at.spin)
        )
    }
}

/// To six digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Finds the creepage, and all about the case that it makes.
pub(crate) fn find(
    case: InverseCase,
    theory: &Entry,
    path: &Path,
) -> Result<(Case, Examination), Failure> {
    let (ratio, poisson) = (case.contact.ellipse().ratio(), case.contact.pair().poisson());
    let prepared = (theory.prepare)(ratio, poisson, &case.solve)
        .map_err(|source| Failure::Options { path: path.into(), source })?;
    let (found, examination) =
        prepared.find(theory.name, case.known).map_err(|error| match error {
            FindError::Inverse(InverseError::NotReachable { nearest, at }) => {
                let Known { fx, fy, mz, .. } = case.known;
                let wanted = [fx, fy, mz].map(|force| force.is_some());
                let (force, at) = (case.scaling.si_force(nearest), case.scaling.si_creepage(at));
                let source = Unreachable { wanted, force, at };
                Failure::Unreachable { path: path.into(), source }
            }
            source => Failure::Find { path: path.into(), source },
        })?;
    Ok((case.found(found.creepage), examination))
}
