//! `[solve]` of a contact of any shape: the theories that take one.

use creepage::TheorySpec;
use creepage::approximate::non_hertzian::Simplified;
use creepage::approximate::{fastrip, fastsim};
use creepage::theory::ExactOptions;

use super::error::GapCaseError;

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

    /// The theory of `[solve]`, if it takes any shape, and its options mean something here.
    ///
    /// # Errors
    /// [`GapCaseError`] for a theory or an option that needs an ellipse.
    pub fn new(spec: &TheorySpec) -> Result<Self, GapCaseError> {
        let name = spec.facts().name;
        let without = |key, why| Err(GapCaseError::Option { name, key, why });
        let usual = fastsim::Settings::default();
        match spec {
            TheorySpec::Exact(options) => Ok(Self::Exact(*options)),
            TheorySpec::Fastsim(settings) if settings.flexibility != usual.flexibility => {
                without("flexibility", "areas of any shape have one flexibility each")
            }
            TheorySpec::Fastsim(settings) if settings.bound != usual.bound => {
                without("bound", "the bound is mu times the true pressure")
            }
            TheorySpec::Fastsim(settings) => {
                Ok(Self::Simplified(Simplified::Fastsim, settings.grid))
            }
            TheorySpec::Fastrip(options) if options.variant != fastrip::Variant::default() => {
                without("variant", "areas of any shape have the consistent one")
            }
            TheorySpec::Fastrip(options) => Ok(Self::Simplified(Simplified::Fastrip, options.grid)),
            TheorySpec::Linear(_) => Ok(Self::Simplified(Simplified::Linear, usual.grid)),
            TheorySpec::Saturated(_) => Ok(Self::Simplified(Simplified::Saturated, usual.grid)),
            TheorySpec::Variational(_) => {
                Err(GapCaseError::Theory { name, why: "its polynomials are those of an ellipse" })
            }
            TheorySpec::Strip(_) => Err(GapCaseError::Theory {
                name,
                why: "it solves all strips of an ellipse in closed form; fastrip has them",
            }),
            _ => Err(GapCaseError::Theory {
                name,
                why: "it is a formula for the forces on an ellipse",
            }),
        }
    }
}
