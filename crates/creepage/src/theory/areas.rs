//! Theories that take contact areas of any shape, as wheelsets and histories prepare them.

use super::spec::{ExactOptions, NamedResolution, ResolutionSpec, TheoryError, TheorySpec};
use crate::InvalidValue;
use crate::approximate::fastsim;
use crate::approximate::non_hertzian::Simplified;
use crate::coulomb::{Automatic, Resolution};

/// A theory that takes contact areas of any shape, with its options.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AreaTheory {
    /// The full theory.
    Exact(ExactOptions),
    /// A simplified one, with cells in each row along rolling and rows in the widest area.
    Simplified(Simplified, [usize; 2]),
}

impl AreaTheory {
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

impl ExactOptions {
    /// The resolutions on areas of any shape, the coarsest first, to be tried until an accuracy is met, and that
    /// accuracy (of a force, in parts of `mu N`).
    ///
    /// # Errors
    /// [`InvalidValue`] for `coupled`, which areas of any shape do not have, and for numbers out of range.
    pub fn resolutions(&self) -> Result<(Vec<Resolution>, f64), InvalidValue> {
        if self.coupled {
            let valid = "left out with [gap], whose bodies are taken for like ones";
            return Err(InvalidValue { quantity: "coupled", value: 1.0, valid });
        }
        let is_auto = self.resolution == ResolutionSpec::Named(NamedResolution::Auto);
        if let Some(value) = self.accuracy.filter(|_| !is_auto) {
            let valid = "left out with a resolution: \"auto\" refines until it is met";
            return Err(InvalidValue { quantity: "accuracy", value, valid });
        }
        let accuracy = self.accuracy.unwrap_or(Automatic::DEFAULT_ACCURACY);
        if !(accuracy.is_finite() && accuracy > 0.0) {
            let valid = "finite and greater than zero";
            return Err(InvalidValue { quantity: "accuracy", value: accuracy, valid });
        }
        let resolutions = match self.resolution {
            ResolutionSpec::Named(NamedResolution::Fast) => vec![Resolution::FAST],
            ResolutionSpec::Named(NamedResolution::Standard) => vec![Resolution::STANDARD],
            ResolutionSpec::Named(NamedResolution::Fine) => vec![Resolution::FINE],
            ResolutionSpec::Named(NamedResolution::Auto) => {
                vec![Resolution::FAST, Resolution::STANDARD, Resolution::FINE]
            }
            ResolutionSpec::Elements([along, across]) => vec![Resolution::new(along, across)?],
        };
        Ok((resolutions, accuracy))
    }
}
