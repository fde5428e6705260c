//! What every theory of rolling contact can be asked.

use super::{Creepage, FieldPoint, Force};

/// Whether a force may be trusted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Status {
    /// The theory's equations are solved, within the range where the theory holds.
    Solved,
    /// The iteration ended before its tolerance was met; the force is that of the last iterate.
    NotConverged,
    /// Solved, but the creepage is too small for the theory's resolution: its slip area is
    /// narrower than the theory can represent, and the force is too small. Use linear theory.
    CreepageTooSmall,
    /// Solved, but the spin is beyond the bound up to which the theory holds.
    SpinTooLarge,
}

impl Status {
    /// One word for tables: `solved`, `not_converged`, `creepage_too_small`, `spin_too_large`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::NotConverged => "not_converged",
            Self::CreepageTooSmall => "creepage_too_small",
            Self::SpinTooLarge => "spin_too_large",
        }
    }
}

/// A theory's force at one creepage, and whether it may be trusted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Force and moment on the lower body.
    pub force: Force,
    /// Outcome of the solution.
    pub status: Status,
}

/// A theory prepared for one ratio of semi-axes and one Poisson's ratio.
///
/// Prepare once, ask many times; a theory is shared freely between threads.
pub trait Theory: Send + Sync {
    /// Force and moment at `creepage`.
    fn solve(&self, creepage: Creepage) -> Solution;

    /// Traction and slip at `positions` `(x, y)` in units of `c`; a position outside the
    /// contact has neither, and is answered with zeros and [`Region::Slip`](super::Region::Slip).
    fn field(&self, creepage: Creepage, positions: &[[f64; 2]]) -> Vec<FieldPoint>;
}
