//! The theories that take contact areas of any shape, as wheelsets and histories prepare them.

use creepage::TheorySpec;
use creepage::approximate::fastsim;
use creepage::approximate::non_hertzian::Simplified;
use creepage::theory::{ExactOptions, TheoryError};

/// A theory that takes contact areas of any shape, with its options.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GapTheory {
    /// The full theory.
    Exact(ExactOptions),
    /// A simplified one, with cells in each row along rolling and rows in the widest area.
    Simplified(Simplified, [usize; 2]),
}

impl GapTheory {
    /// The theory of a specification.
    ///
    /// # Errors
    /// [`TheoryError`] for a theory or an option that needs an ellipse.
    pub fn new(spec: &TheorySpec) -> Result<Self, TheoryError> {
        spec.check_on_areas()?;
        let usual = fastsim::Settings::default().grid;
        Ok(match spec {
            TheorySpec::Exact(options) => Self::Exact(*options),
            TheorySpec::Fastsim(settings) => Self::Simplified(Simplified::Fastsim, settings.grid),
            TheorySpec::Fastrip(options) => Self::Simplified(Simplified::Fastrip, options.grid),
            TheorySpec::Linear(_) => Self::Simplified(Simplified::Linear, usual),
            _ => Self::Simplified(Simplified::Saturated, usual),
        })
    }

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
