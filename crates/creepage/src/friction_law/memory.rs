//! Friction memory: the coefficient follows the speed of slip with a delay.

use super::FrictionLaw;
use crate::check::{self, InvalidValue};

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
