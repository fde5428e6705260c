//! Transient solver of a history: the full theory, FASTSIM or chapter 5.

use creepage::coulomb::ElementField;
use creepage::unsteady::{
    Motion, Rolled, Rolling, RollingFastsim, RollingVariational, Saved, SavedError,
};
use creepage::{Force, InvalidValue};

/// Motion of the bodies up to some distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryMotion {
    /// Dimensionless in the units of the nominal load.
    pub motion: Motion,
    /// Normal force over the nominal one.
    pub load: f64,
}

/// Transient solver of one of the theories.
#[allow(clippy::large_enum_variant)] // one a history
#[derive(Debug, Clone)]
pub(super) enum TransientSolver {
    Exact(Rolling),
    Fastsim(RollingFastsim),
    /// Under a constant load.
    Variational(RollingVariational),
}

impl TransientSolver {
    /// Starts from steady rolling.
    pub(super) fn start_steady(&mut self, first: &HistoryMotion) -> Result<Force, InvalidValue> {
        let rolled = match self {
            Self::Exact(rolling) => {
                rolling.start_with_load(first.load)?;
                rolling.start_steady(&first.motion)?
            }
            Self::Fastsim(rolling) => {
                rolling.start_with_load(first.load)?;
                rolling.start_steady(&first.motion)?
            }
            Self::Variational(rolling) => rolling.start_steady(&first.motion)?,
        };
        Ok(rolled.solution.force)
    }

    /// Starts without traction.
    pub(super) fn start_with_load(&mut self, load: f64) -> Result<(), InvalidValue> {
        match self {
            Self::Exact(rolling) => rolling.start_with_load(load),
            Self::Fastsim(rolling) => rolling.start_with_load(load),
            Self::Variational(rolling) => {
                rolling.start();
                Ok(())
            }
        }
    }

    /// Starts from a shift by a force, which FASTSIM does not know.
    pub(super) fn shift(&mut self, [fx, fy]: [f64; 2]) -> Result<Force, InvalidValue> {
        match self {
            Self::Exact(rolling) => rolling.shift(fx, fy).map(|rolled| rolled.solution.force),
            Self::Variational(rolling) => rolling.shift(fx, fy).map(|rolled| rolled.solution.force),
            Self::Fastsim(_) => Ok(Force::default()),
        }
    }

    /// Rolls on.
    pub(super) fn step(
        &mut self,
        length: f64,
        motion: &HistoryMotion,
    ) -> Result<Rolled, InvalidValue> {
        match self {
            Self::Exact(rolling) => {
                rolling.press(motion.load)?;
                rolling.step(length, &motion.motion)
            }
            Self::Fastsim(rolling) => {
                rolling.press(motion.load)?;
                rolling.step(length, &motion.motion)
            }
            Self::Variational(rolling) => rolling.step(length, &motion.motion),
        }
    }

    /// Distance rolled, dimensionless.
    pub(super) fn distance(&self) -> f64 {
        match self {
            Self::Exact(rolling) => rolling.distance(),
            Self::Fastsim(rolling) => rolling.distance(),
            Self::Variational(rolling) => rolling.distance(),
        }
    }

    pub(super) fn save(&self) -> Vec<u8> {
        match self {
            Self::Exact(rolling) => rolling.save().to_bytes(),
            Self::Fastsim(rolling) => rolling.save(),
            Self::Variational(rolling) => rolling.save(),
        }
    }

    pub(super) fn restore(&mut self, bytes: &[u8]) -> Result<(), SavedError> {
        match self {
            Self::Exact(rolling) => rolling.restore(&Saved::from_bytes(bytes, rolling)?),
            Self::Fastsim(rolling) => rolling.restore(bytes),
            Self::Variational(rolling) => rolling.restore(bytes),
        }
    }

    /// Elements for a picture, if there are any.
    pub(super) fn elements(&self) -> Option<Vec<ElementField>> {
        match self {
            Self::Exact(rolling) => Some(rolling.elements()),
            Self::Fastsim(_) | Self::Variational(_) => None,
        }
    }
}
