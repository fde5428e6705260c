//! Coefficient of friction that depends on the temperature of the surfaces.

use crate::check::{self, InvalidValue};

/// A coefficient of friction by the temperature of both surfaces in contact: constant up to a reference
/// temperature, then linear over a range, and constant beyond. Temperatures are in the scale of the bulk
/// temperatures.
///
/// ```
/// use creepage::friction_law::FrictionByTemperature;
/// let friction = FrictionByTemperature::new(0.3, -0.18, [100.0, 130.0])?;
/// assert_eq!((friction.at(20.0), friction.largest()), (0.3, 0.3));
/// assert!((friction.at(115.0) - 0.21).abs() < 1e-15 && (friction.at(1e3) - 0.12).abs() < 1e-15);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionByTemperature {
    reference: f64,
    change: f64,
    range: [f64; 2],
}

impl FrictionByTemperature {
    /// `reference` up to the first temperature of `range`, `reference + change` from the second on.
    ///
    /// # Errors
    /// [`InvalidValue`] unless both coefficients are finite, positive, and at most a factor of a million
    /// apart, and the range rises.
    pub fn new(reference: f64, change: f64, range: [f64; 2]) -> Result<Self, InvalidValue> {
        check::positive("reference friction", reference)?;
        check::finite("change of friction", change)?;
        let hot = check::positive("friction of hot surfaces", reference + change)?;
        let near = reference.max(hot) < 1e6 * reference.min(hot);
        check::require(near, "change of friction", change, "such that a part of friction is left")?;
        range.into_iter().try_for_each(|end| check::finite("temperature", end).map(drop))?;
        let rises = range[0] < range[1];
        check::require(rises, "end of the temperature range", range[1], "above its beginning")?;
        Ok(Self { reference, change, range })
    }

    /// The coefficient at a temperature.
    #[must_use]
    pub fn at(&self, temperature: f64) -> f64 {
        let [from, to] = self.range;
        let share = ((temperature - from) / (to - from)).clamp(0.0, 1.0);
        self.reference + share * self.change
    }

    /// Coefficients of cold and of hot surfaces.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [self.reference, self.reference + self.change]
    }

    /// The temperatures between which it changes.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The larger one: the `mu` of all quantities.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.reference.max(self.reference + self.change)
    }

    /// The smaller one.
    #[must_use]
    pub fn least(&self) -> f64 {
        self.reference.min(self.reference + self.change)
    }

    /// The coefficient where the temperature is `before` and rises by `gain`, not negative, times the
    /// coefficient itself. Where friction falls there is one; of several, the coldest.
    #[must_use]
    pub fn heated(&self, before: f64, gain: f64) -> f64 {
        let ([from, to], [cold, hot]) = (self.range, self.ends());
        if before + gain * cold <= from {
            return cold;
        }
        // On the slope: mu = cold + slope (before + gain mu - from).
        let slope = self.change / (to - from);
        let between = (cold + slope * (before - from)) / (1.0 - slope * gain);
        let temperature = before + gain * between;
        if between.is_finite() && (from..=to).contains(&temperature) { between } else { hot }
    }
}

/// The law in a contact of bodies that are heated as they roll.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Thermal {
    pub(crate) law: FrictionByTemperature,
    /// Temperature of unrubbed surfaces in contact.
    pub(crate) touching: f64,
    /// `HeatedPair::weight`.
    pub(crate) weight: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficient found is that at the temperature to which it leads, to rounding.
    #[test]
    fn heated_surfaces_have_the_friction_of_their_temperature() {
        let falling = FrictionByTemperature::new(0.3, -0.18, [100.0, 130.0]).unwrap();
        let rising = FrictionByTemperature::new(0.1, 0.2, [100.0, 130.0]).unwrap();
        for law in [falling, rising] {
            for before in [0.0, 60.0, 90.0, 99.0, 104.0, 115.0, 129.0, 140.0] {
                for gain in [0.0, 1.0, 30.0, 90.0, 400.0, 1e4] {
                    let friction = law.heated(before, gain);
                    let there = law.at(before + gain * friction);
                    assert!(
                        (friction - there).abs() < 1e-12,
                        "{before} {gain}: {friction} {there}"
                    );
                }
            }
        }
    }

    #[test]
    fn nonsense_is_an_error_that_names_the_quantity() {
        let wrong = |mu, change, range| FrictionByTemperature::new(mu, change, range).unwrap_err();
        assert_eq!(wrong(0.0, 0.1, [1.0, 2.0]).quantity, "reference friction");
        assert_eq!(wrong(0.3, -0.3, [1.0, 2.0]).quantity, "friction of hot surfaces");
        assert_eq!(wrong(0.3, -0.1, [2.0, 2.0]).quantity, "end of the temperature range");
        assert_eq!(wrong(0.3, f64::NAN, [1.0, 2.0]).quantity, "change of friction");
    }
}
