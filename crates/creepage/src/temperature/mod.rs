//! Temperature of both surfaces in steady rolling: friction as a moving source of heat.
//!
//! With `beta = sqrt(lambda rho c)` the effusivity of a body, `V` the speed at which its surface passes the
//! contact, and `q(x) = |p_t| s V` what friction turns to heat on an area, both surfaces of a contact have
//! the same temperature, above that before the contact by
//!
//! ```math
//! \Delta T(x) = \frac{1}{B \sqrt{\pi}} \int_x^{\infty} \frac{q(x')}{\sqrt{x' - x}} \, dx',
//! \qquad B = \beta_u \sqrt{V_u} + \beta_l \sqrt{V_l},
//! ```
//!
//! `x` in the rolling direction: what lies ahead of a place has heated it. A body takes the share
//! `beta sqrt(V)/B` of the heat. Bodies of different bulk temperatures have the mean of these, weighted by
//! the same shares, all over the contact while nothing is rubbed.
//!
//! Heat is conducted into the depth only: `V a/(2 kappa)`, the [Peclet number](HeatedPair::peclet), must be
//! large. Against the exact band (Jaeger) an elliptic source is too hot by 0.4 % at 5, by 2.3 % at 2 and by
//! 6.3 % at 1. The rise is that of a smooth surface; the tips of asperities are hotter.
//!
//! Sources: J.C. Jaeger, J. Proc. Roy. Soc. New South Wales 76 (1942) 203-224; H. Blok, Proc. Inst. Mech.
//! Eng. (1937) 222-235; M. Ertz, K. Knothe, Wear 253 (2002) 498-508.

mod rows;

pub use rows::{HeatRow, HeatedElement};

use std::f64::consts::PI;

use crate::check::{self, InvalidValue};

/// Thermal properties of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThermalSolid {
    conductivity: f64,
    capacity: f64,
}

impl ThermalSolid {
    /// Rail steel: 50 W/(m K), 7850 kg/m3, 450 J/(kg K), as Ertz and Knothe (2002) take it.
    pub const STEEL: Self = Self { conductivity: 50.0, capacity: 7850.0 * 450.0 };

    /// From the thermal conductivity (W/(m K)), the density (kg/m3) and the specific heat (J/(kg K)).
    ///
    /// # Errors
    /// [`InvalidValue`] unless all are finite and positive.
    pub fn new(conductivity: f64, density: f64, specific_heat: f64) -> Result<Self, InvalidValue> {
        check::positive("conductivity", conductivity)?;
        check::positive("density", density)?;
        check::positive("specific_heat", specific_heat)?;
        let capacity = check::positive("density times specific_heat", density * specific_heat)?;
        Ok(Self { conductivity, capacity })
    }

    /// Effusivity `sqrt(lambda rho c)` (W s^(1/2)/(m2 K)).
    #[must_use]
    pub fn effusivity(&self) -> f64 {
        (self.conductivity * self.capacity).sqrt()
    }

    /// Diffusivity `lambda/(rho c)` (m2/s).
    #[must_use]
    pub fn diffusivity(&self) -> f64 {
        self.conductivity / self.capacity
    }
}

/// Two bodies that roll on one another: the upper one first in every pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatedPair {
    solids: [ThermalSolid; 2],
    speeds: [f64; 2],
    bulk: [f64; 2],
}

impl HeatedPair {
    /// Two bodies with the speeds (m/s) at which their surfaces pass the contact and their temperatures
    /// before it, in any scale of kelvins.
    ///
    /// ```
    /// use creepage::temperature::{HeatedPair, ThermalSolid};
    /// let pair = HeatedPair::new([ThermalSolid::STEEL; 2], [30.0; 2], [0.0, 150.0])?;
    /// assert_eq!((pair.share(), pair.touching()), (0.5, 75.0));
    /// assert!((pair.peclet(5.878886e-3)[0] - 6230.1).abs() < 0.1);
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidValue`] unless the speeds are finite and positive, that is both surfaces pass the contact
    /// the same way, and the temperatures are finite.
    pub fn new(
        solids: [ThermalSolid; 2],
        speeds: [f64; 2],
        bulk: [f64; 2],
    ) -> Result<Self, InvalidValue> {
        for (name, speed) in
            ["speed of the upper surface", "speed of the lower surface"].into_iter().zip(speeds)
        {
            check::positive(name, speed)?;
        }
        for bulk in bulk {
            check::finite("bulk_temperature", bulk)?;
        }
        Ok(Self { solids, speeds, bulk })
    }

    /// The same at rolling velocity `speed` (m/s), the mean of both surfaces', with a longitudinal creepage:
    /// the upper surface passes the slower the more it is ahead.
    ///
    /// # Errors
    /// As [`HeatedPair::new`]: a creepage of 2 and beyond has one surface stand still or run back.
    pub fn rolling(
        solids: [ThermalSolid; 2],
        speed: f64,
        longitudinal: f64,
        bulk: [f64; 2],
    ) -> Result<Self, InvalidValue> {
        let half = 0.5 * check::finite("longitudinal", longitudinal)?;
        Self::new(solids, [speed * (1.0 - half), speed * (1.0 + half)], bulk)
    }

    /// `beta sqrt(V)` of each body.
    fn weights(&self) -> [f64; 2] {
        [0, 1].map(|k| self.solids[k].effusivity() * self.speeds[k].sqrt())
    }

    /// `B` of the [equations](self) (W/(m^(3/2) K)).
    #[must_use]
    pub fn weight(&self) -> f64 {
        let [upper, lower] = self.weights();
        upper + lower
    }

    /// The upper body's share of the heat of friction.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.weights()[0] / self.weight()
    }

    /// Temperatures before the contact.
    #[must_use]
    pub fn bulk(&self) -> [f64; 2] {
        self.bulk
    }

    /// The temperature of both surfaces where they touch and nothing is rubbed.
    #[must_use]
    pub fn touching(&self) -> f64 {
        let share = self.share();
        // Where both bodies are as hot, so is the contact, to the last bit.
        self.bulk[1] + share * (self.bulk[0] - self.bulk[1])
    }

    /// Peclet numbers `V a/(2 kappa)` of a contact of half-length `a` (m) along the rolling direction.
    #[must_use]
    pub fn peclet(&self, half_length: f64) -> [f64; 2] {
        [0, 1].map(|k| 0.5 * self.speeds[k] * half_length / self.solids[k].diffusivity())
    }

    /// Depth of the layers that are heated while a contact of half-length `a` (m) passes:
    /// `sqrt(2 a kappa/V)` (m).
    #[must_use]
    pub fn depths(&self, half_length: f64) -> [f64; 2] {
        [0, 1].map(|k| (2.0 * half_length * self.solids[k].diffusivity() / self.speeds[k]).sqrt())
    }

    /// The unit of the rise: that of a heat `q` (W/m2) over a half-length `a` (m), `q sqrt(a/pi)/B`.
    #[must_use]
    pub fn unit(&self, heat: f64, half_length: f64) -> f64 {
        heat * (half_length / PI).sqrt() / self.weight()
    }

    /// Heat that flows from the hotter to the colder body, into the upper one, over its length along the
    /// rolling direction and its width (W), where nothing is rubbed.
    #[must_use]
    pub fn conducted(&self, length: f64, width: f64) -> f64 {
        let rise = self.touching() - self.bulk[0];
        2.0 * self.weights()[0] * rise * (length.max(0.0) / PI).sqrt() * width
    }

    /// Temperatures of both surfaces at a distance (m) behind the leading edge of a contact that is
    /// `length` long, where nothing is rubbed: one in the contact, and behind it each goes back to its
    /// own.
    #[must_use]
    pub fn unrubbed(&self, behind: f64, length: f64) -> [f64; 2] {
        let touching = self.touching();
        if behind < 0.0 {
            return self.bulk;
        }
        if behind <= length {
            return [touching; 2];
        }
        let left = 2.0 / PI * (length / behind).sqrt().asin();
        self.bulk.map(|bulk| bulk + left * (touching - bulk))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nonsense_is_an_error_that_names_the_quantity() {
        let quantity =
            |error: Result<_, InvalidValue>| error.map(|_: ThermalSolid| ()).unwrap_err().quantity;
        assert_eq!(quantity(ThermalSolid::new(0.0, 1.0, 1.0)), "conductivity");
        assert_eq!(quantity(ThermalSolid::new(1.0, f64::NAN, 1.0)), "density");
        assert_eq!(quantity(ThermalSolid::new(1.0, 1.0, -1.0)), "specific_heat");
        let steel = [ThermalSolid::STEEL; 2];
        assert!(HeatedPair::rolling(steel, 10.0, 2.0, [0.0; 2]).is_err());
        assert!(HeatedPair::rolling(steel, 10.0, 0.1, [0.0, f64::INFINITY]).is_err());
    }

    /// What one body loses by conduction the other gains.
    #[test]
    fn conduction_is_in_balance() {
        let hard = ThermalSolid::new(20.0, 3000.0, 800.0).unwrap();
        let (there, back) = ([ThermalSolid::STEEL, hard], [hard, ThermalSolid::STEEL]);
        let into_upper = HeatedPair::new(there, [9.0, 11.0], [10.0, 90.0]).unwrap();
        let into_lower = HeatedPair::new(back, [11.0, 9.0], [90.0, 10.0]).unwrap();
        let [one, other] = [into_upper, into_lower].map(|pair| pair.conducted(8e-3, 6e-3));
        assert!(one > 0.0 && (one + other).abs() < 1e-13 * one, "{one} {other}");
        assert!((into_upper.touching() - into_lower.touching()).abs() < 1e-13);
    }

    /// Behind the contact: at its end the common temperature, far behind the bulk's.
    #[test]
    fn unrubbed_surfaces_go_back_to_their_own() {
        let pair = HeatedPair::new([ThermalSolid::STEEL; 2], [30.0; 2], [0.0, 150.0]).unwrap();
        let is = |found: [f64; 2], expected: [f64; 2]| {
            found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12)
        };
        assert!(is(pair.unrubbed(-1e-3, 1e-2), [0.0, 150.0]));
        assert!(is(pair.unrubbed(5e-3, 1e-2), [75.0; 2]));
        let [upper, lower] = pair.unrubbed(1e-2 + 1e-12, 1e-2);
        assert!((upper - 75.0).abs() < 1e-3 && (lower - 75.0).abs() < 1e-3);
        // 2/pi asin(1/sqrt 2) is a half.
        let [upper, lower] = pair.unrubbed(2e-2, 1e-2);
        assert!((upper - 37.5).abs() < 1e-12 && (lower - 112.5).abs() < 1e-12);
    }
}
