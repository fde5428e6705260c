//! A law of friction in a contact that rolls.

use super::{FrictionLaw, FrictionMemory};
use crate::check::{self, InvalidValue};

/// Friction by the speed of slip where bodies roll at a given speed: theories know the slip over the
/// rolling velocity only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingFriction {
    law: FrictionLaw,
    memory: Option<FrictionMemory>,
    speed: f64,
}

impl RollingFriction {
    /// The law at the rolling velocity `speed` (m/s), with its memory if it has one.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `speed` is finite and positive.
    pub fn new(
        law: FrictionLaw,
        memory: Option<FrictionMemory>,
        speed: f64,
    ) -> Result<Self, InvalidValue> {
        check::positive("speed", speed)?;
        Ok(Self { law, memory, speed })
    }

    /// The law.
    #[must_use]
    pub fn law(&self) -> &FrictionLaw {
        &self.law
    }

    /// Its memory.
    #[must_use]
    pub fn memory(&self) -> Option<FrictionMemory> {
        self.memory
    }

    /// The rolling velocity (m/s).
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Whether friction depends on the speed of slip at all.
    #[must_use]
    pub fn falls(&self) -> bool {
        self.lowest() < 1.0
    }

    /// The kinetic value over that at rest.
    pub(crate) fn lowest(&self) -> f64 {
        self.law.kinetic() / self.law.at_rest()
    }

    /// Friction over that at rest where a particle comes to slip by the second of `slips`, over the
    /// rolling velocity, when it has rolled `distance` (m) from a place where it slipped by the first
    /// and had `before`.
    pub(crate) fn after(&self, before: f64, slips: [f64; 2], distance: f64) -> f64 {
        let (rest, speeds) = (self.law.at_rest(), slips.map(|slip| slip * self.speed));
        let friction = match &self.memory {
            None => self.law.at(speeds[1]),
            Some(memory) => memory.step(&self.law, before * rest, speeds, distance / self.speed),
        };
        friction / rest
    }
}
