//! A law of friction in a contact that rolls.

use super::{FrictionAcross, FrictionLaw, FrictionMemory};
use crate::check::{self, InvalidValue};

/// Friction that is not the same everywhere: by the speed of slip where bodies roll at a given speed
/// (theories know the slip over the rolling velocity only), or by the place across the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingFriction {
    law: FrictionLaw,
    memory: Option<FrictionMemory>,
    speed: f64,
    across: Option<FrictionAcross>,
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
        Ok(Self { law, memory, speed, across: None })
    }

    /// Friction that differs across the contact, at any speed.
    ///
    /// # Errors
    /// None that [`FrictionAcross::new`] lets pass.
    pub fn across(across: FrictionAcross) -> Result<Self, InvalidValue> {
        let law = FrictionLaw::constant(across.largest())?;
        Ok(Self { across: Some(across), ..Self::new(law, None, 1.0)? })
    }

    /// How friction differs across the contact, where it does.
    #[must_use]
    pub fn by_place(&self) -> Option<FrictionAcross> {
        self.across
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

    /// Whether friction depends on anything: on the speed of slip or on the place.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.falls() || self.across.is_some()
    }

    /// Friction at `y` (m) over the largest, where friction differs across the contact.
    pub(crate) fn share(&self, y: f64) -> f64 {
        self.across.map_or(1.0, |across| across.at(y) / across.largest())
    }

    /// The same seen from an origin at `y` (m).
    pub(crate) fn seen_from(self, y: f64) -> Self {
        Self { across: self.across.map(|across| across.seen_from(y)), ..self }
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
