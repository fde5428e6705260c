//! Elastic solids, and the equivalent solid of a pair (2.10).

use crate::check::{self, InvalidValue};

/// A homogeneous, isotropic, linearly elastic solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    shear_modulus: f64,
    poisson: f64,
}

impl Solid {
    /// A solid from its shear modulus `G` (Pa) and Poisson's ratio `sigma`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `shear_modulus > 0` and finite, `0 <= poisson <= 0.5`.
    pub fn new(shear_modulus: f64, poisson: f64) -> Result<Self, InvalidValue> {
        Ok(Self {
            shear_modulus: check::positive("shear_modulus", shear_modulus)?,
            poisson: check::poisson(poisson)?,
        })
    }

    /// A solid from its Young's modulus `E = 2 G (1 + sigma)` (Pa) and Poisson's ratio.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `young_modulus > 0` and finite, `0 <= poisson <= 0.5`.
    pub fn from_young_modulus(young_modulus: f64, poisson: f64) -> Result<Self, InvalidValue> {
        check::positive("young_modulus", young_modulus)?;
        check::poisson(poisson)?;
        Self::new(young_modulus / (2.0 * (1.0 + poisson)), poisson)
    }

    /// Shear modulus `G` (Pa).
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Poisson's ratio `sigma`.
    #[must_use]
    pub fn poisson(&self) -> f64 {
        self.poisson
    }
}

/// The equivalent solid of a pair (2.10): the displacement *difference* of the two bodies
/// depends on these three numbers only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidPair {
    shear_modulus: f64,
    poisson: f64,
    kappa: f64,
}

impl SolidPair {
    /// Combines the upper body (`-` in the thesis) with the lower (`+`).
    ///
    /// `1/G = (1/G+ + 1/G-)/2`, `sigma/G = (sigma+/G+ + sigma-/G-)/2`,
    /// `kappa = (G/4) ((1 - 2 sigma+)/G+ - (1 - 2 sigma-)/G-)`.
    ///
    /// ```
    /// use creepage::{Solid, SolidPair};
    /// let steel = Solid::new(82e9, 0.28)?;
    /// let pair = SolidPair::new(steel, steel);
    /// assert_eq!(pair.kappa(), 0.0); // like bodies: pressure and traction do not couple
    /// # Ok::<(), creepage::InvalidValue>(())
    /// ```
    #[must_use]
    pub fn new(upper: Solid, lower: Solid) -> Self {
        let (upper_weight, lower_weight) = (0.5 / upper.shear_modulus, 0.5 / lower.shear_modulus);
        let compliance = upper_weight + lower_weight;
        let share = lower_weight / compliance;
        Self {
            shear_modulus: 1.0 / compliance,
            poisson: share * lower.poisson + (1.0 - share) * upper.poisson,
            kappa: 0.5
                * (share * (1.0 - 2.0 * lower.poisson)
                    - (1.0 - share) * (1.0 - 2.0 * upper.poisson)),
        }
    }

    /// Combined shear modulus `G` (Pa).
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Combined Poisson's ratio `sigma`.
    #[must_use]
    pub fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Measure of how unlike the bodies are; zero when pressure and traction do not couple.
    #[must_use]
    pub fn kappa(&self) -> f64 {
        self.kappa
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn follows_the_definitions_of_2_10() {
        let (upper, lower) = (Solid::new(3.0, 0.1).unwrap(), Solid::new(7.0, 0.45).unwrap());
        let pair = SolidPair::new(upper, lower);
        let g = 2.0 / (1.0 / 3.0 + 1.0 / 7.0);
        assert!((pair.shear_modulus() - g).abs() < 1e-15 * g);
        assert!((pair.poisson() - g * (0.45 / 7.0 + 0.1 / 3.0) / 2.0).abs() < 1e-15);
        assert!((pair.kappa() - g / 4.0 * (0.1 / 7.0 - 0.8 / 3.0)).abs() < 1e-15);
    }

    #[test]
    fn exchange_of_the_bodies_changes_only_the_sign_of_kappa() {
        let (one, two) = (Solid::new(2.0, 0.5).unwrap(), Solid::new(5.0, 0.2).unwrap());
        let (there, back) = (SolidPair::new(one, two), SolidPair::new(two, one));
        assert!((there.kappa() + back.kappa()).abs() < 1e-16);
        assert!((there.poisson() - back.poisson()).abs() < 1e-16);
    }

    #[test]
    fn nonsense_is_an_error_that_names_the_quantity() {
        assert_eq!(Solid::new(1.0, 0.6).unwrap_err().quantity, "poisson");
        assert_eq!(Solid::new(f64::NAN, 0.3).unwrap_err().quantity, "shear_modulus");
        assert_eq!(Solid::from_young_modulus(-1.0, 0.3).unwrap_err().quantity, "young_modulus");
    }
}
