//! The theories that take contact areas of any shape.

use creepage::approximate::non_hertzian::Simplified;
use creepage::theory::ExactOptions;

/// A theory that takes contact areas of any shape, with its options.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GapTheory {
    /// The full theory.
    Exact(ExactOptions),
    /// A simplified one, with cells in each row along rolling and rows in the widest area.
    Simplified(Simplified, [usize; 2]),
}

impl GapTheory {
    /// Names of the theories that take any shape.
    pub(super) const NAMES: [&'static str; 5] =
        ["exact", "fastsim", "fastrip", "linear", "saturated"];

    /// The theory's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Exact(_) => "exact",
            Self::Simplified(Simplified::Fastsim, _) => "fastsim",
            Self::Simplified(Simplified::Fastrip, _) => "fastrip",
            Self::Simplified(Simplified::Linear, _) => "linear",
            Self::Simplified(Simplified::Saturated, _) => "saturated",
        }
    }
}
