//! Forces that are wanted, and the creepage that gives them.

use std::error::Error;
use std::fmt;
use std::sync::Arc;

use crate::InverseCase;
use creepage::rolling::exact::{InverseError, Known};
use creepage::rolling::{Creepage, Force, Scaling};

use crate::theories::examination::Examination;
use crate::theories::prepared::PreparedTheory;

/// Why no creepage was found for wanted forces.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FindError {
    /// The theory cannot be asked.
    #[error("[wanted] needs the theory exact: {name} does not find creepages")]
    Theory {
        /// Its name.
        name: &'static str,
    },
    /// No creepage gives the forces.
    #[error(transparent)]
    Unreachable(#[from] Unreachable),
    /// The question is none.
    #[error(transparent)]
    Inverse(#[from] InverseError),
}

/// Wanted forces that no creepage gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Unreachable {
    /// Which of `fx`, `fy`, `mz` are wanted.
    pub wanted: [bool; 3],
    /// The force that came nearest.
    pub nearest: Force,
    /// Its creepage.
    pub at: Creepage,
    /// The units of both; the message is in SI units.
    pub scaling: Scaling,
}

impl Error for Unreachable {}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (force, at) = (self.scaling.si_force(self.nearest), self.scaling.si_creepage(self.at));
        let forces = [
            format!("longitudinal_force = {:?} N", rounded(force.longitudinal)),
            format!("lateral_force = {:?} N", rounded(force.lateral)),
            format!("moment = {:?} N m", rounded(force.moment)),
        ];
        let wanted = forces.into_iter().zip(self.wanted);
        let reached: Vec<_> = wanted.filter_map(|(force, on)| on.then_some(force)).collect();
        write!(
            f,
            "[wanted] is not reachable: at most {} was reached, at longitudinal = {:?}, \
             lateral = {:?}, spin = {:?} rad/m",
            reached.join(", "),
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

/// The case at the creepage at which its known quantities hold, by the theory of that name.
pub(crate) fn find_creepage(
    case: &InverseCase,
    name: &'static str,
    theory: Arc<PreparedTheory>,
) -> Result<Examination, FindError> {
    let found = match &*theory {
        PreparedTheory::Exact(exact) => exact
            .find(case.known, &mut exact.workspace())
            .map(|found| ((**exact).clone(), found.creepage)),
        PreparedTheory::Automatic(automatic) => {
            automatic.find(case.known).map(|(level, found)| (level.clone(), found.creepage))
        }
        _ => return Err(FindError::Theory { name }),
    };
    let (exact, creepage) = found.map_err(|error| in_si_units(error, case))?;
    Ok(Examination::of_exact(theory, exact, creepage))
}

fn in_si_units(error: InverseError, case: &InverseCase) -> FindError {
    match error {
        InverseError::NotReachable { nearest, at } => {
            let Known { fx, fy, mz, .. } = case.known;
            let wanted = [fx, fy, mz].map(|force| force.is_some());
            Unreachable { wanted, nearest, at, scaling: case.scaling }.into()
        }
        other => other.into(),
    }
}
