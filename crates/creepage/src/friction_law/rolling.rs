//! Friction law of a rolling contact: by slip at a given speed and with a memory, by place, or by temperature.

use super::{FrictionAcross, FrictionByTemperature, FrictionLaw, Thermal};
use crate::check::{self, InvalidValue};
use crate::temperature::HeatedPair;

/// Friction that is not the same everywhere: by the speed of slip where bodies roll at a given speed
/// (theories know the slip over the rolling velocity only), by the place across the contact, or by the
/// temperature to which friction itself heats the surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingFriction {
    law: FrictionLaw,
    memory: Option<FrictionMemory>,
    speed: f64,
    by: Dependence,
}

/// Further variable on which friction depends.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Dependence {
    Nothing,
    Place(FrictionAcross),
    Temperature(Thermal),
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
        Ok(Self { law, memory, speed, by: Dependence::Nothing })
    }

    /// Friction that differs across the contact, at any speed.
    ///
    /// # Errors
    /// None that [`FrictionAcross::new`] lets pass.
    pub fn across(across: FrictionAcross) -> Result<Self, InvalidValue> {
        let law = FrictionLaw::constant(across.largest())?;
        Ok(Self { by: Dependence::Place(across), ..Self::new(law, None, 1.0)? })
    }

    /// Friction that depends on the temperature of bodies that rub: `pair` with the speeds of their
    /// surfaces, `speed` the rolling velocity (m/s). `exact`, and `fastsim` on ellipses, follow it; `fastsim`
    /// heats by the rigid slip.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `speed` is finite and positive.
    pub fn by_temperature(
        friction: FrictionByTemperature,
        pair: HeatedPair,
        speed: f64,
    ) -> Result<Self, InvalidValue> {
        let law = FrictionLaw::constant(friction.largest())?;
        let (touching, weight) = (pair.touching(), pair.weight());
        let by = Dependence::Temperature(Thermal { law: friction, touching, weight });
        Ok(Self { by, ..Self::new(law, None, speed)? })
    }

    /// How friction depends on the temperature, where it does.
    #[must_use]
    pub fn of_temperature(&self) -> Option<FrictionByTemperature> {
        self.thermal().map(|thermal| thermal.law)
    }

    /// The same with the bodies that are heated.
    pub(crate) fn thermal(&self) -> Option<&Thermal> {
        match &self.by {
            Dependence::Temperature(thermal) => Some(thermal),
            _ => None,
        }
    }

    /// How friction differs across the contact, where it does.
    #[must_use]
    pub fn by_place(&self) -> Option<FrictionAcross> {
        match self.by {
            Dependence::Place(across) => Some(across),
            _ => None,
        }
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

    /// Whether friction depends on the slip at all, by its speed or by its heat.
    #[must_use]
    pub fn falls(&self) -> bool {
        self.lowest() < 1.0
    }

    /// Whether friction depends on anything: on the speed of slip or on the place.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.falls() || self.by_place().is_some()
    }

    /// Friction at `y` (m) over the largest, where friction differs across the contact.
    pub(crate) fn share(&self, y: f64) -> f64 {
        self.by_place().map_or(1.0, |across| across.at(y) / across.largest())
    }

    /// The same seen from an origin at `y` (m).
    pub(crate) fn seen_from(self, y: f64) -> Self {
        match self.by {
            Dependence::Place(across) => {
                Self { by: Dependence::Place(across.seen_from(y)), ..self }
            }
            _ => self,
        }
    }

    /// The least value over the largest.
    pub(crate) fn lowest(&self) -> f64 {
        if let Some(Thermal { law, .. }) = self.thermal() {
            return law.least() / law.largest();
        }
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

/// Friction does not follow the speed of slip at once, but over a distance of slip:
/// `d mu/dt = (mu_law(s) - mu) max(s, s_0)/d`. Without it, friction that falls with the speed makes
/// the traction jump.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionMemory {
    distance: f64,
    speed: f64,
}

impl FrictionMemory {
    /// Memory over the distance of slip `distance` `d` (m), slip counting as `speed` `s_0` (m/s) at
    /// least.
    ///
    /// # Errors
    /// [`InvalidValue`] unless both are finite and positive.
    pub fn new(distance: f64, speed: f64) -> Result<Self, InvalidValue> {
        check::positive("memory_distance", distance)?;
        check::positive("memory_speed", speed)?;
        Ok(Self { distance, speed })
    }

    /// The distance of slip `d` (m).
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// The least speed that slip counts as, `s_0` (m/s).
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// The friction after `time` (s), in which the speed of slip goes from the first to the second of
    /// `speeds` (m/s), from `before`. Exact at constant speed, of second order in `time` otherwise.
    #[must_use]
    pub fn step(&self, law: &FrictionLaw, before: f64, speeds: [f64; 2], time: f64) -> f64 {
        let rate = speeds.map(|speed| speed.max(self.speed) / self.distance);
        let left = (-0.5 * time.max(0.0) * (rate[0] + rate[1])).exp();
        let target = 0.5 * (law.at(speeds[0]) + law.at(speeds[1]));
        left * before + (1.0 - left) * target
    }
}
