//! Stress tensor, and what engineers read from it.

use nalgebra::Matrix3;

use crate::solid::Solid;

/// A state of stress, positive in tension; or, with the same letters, a state of strain.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stress {
    /// Normal component in the rolling direction.
    pub xx: f64,
    /// Normal component across.
    pub yy: f64,
    /// Normal component into the body.
    pub zz: f64,
    /// Shear component in the plane of the surface.
    pub xy: f64,
    /// Shear component across and into the body.
    pub yz: f64,
    /// Shear component in the rolling direction and into the body.
    pub xz: f64,
}

impl Stress {
    /// From `[xx, yy, zz, xy, yz, xz]`.
    #[must_use]
    pub fn from_components([xx, yy, zz, xy, yz, xz]: [f64; 6]) -> Self {
        Self { xx, yy, zz, xy, yz, xz }
    }

    /// `[xx, yy, zz, xy, yz, xz]`.
    #[must_use]
    pub fn components(&self) -> [f64; 6] {
        [self.xx, self.yy, self.zz, self.xy, self.yz, self.xz]
    }

    /// The sum of the normal components: three times the mean stress.
    #[must_use]
    pub fn trace(&self) -> f64 {
        self.xx + self.yy + self.zz
    }

    /// The part that changes the shape: the stress without its mean.
    #[must_use]
    pub fn deviator(&self) -> Self {
        let mean = self.trace() / 3.0;
        Self { xx: self.xx - mean, yy: self.yy - mean, zz: self.zz - mean, ..*self }
    }

    /// The double product `s_ij t_ij` of two states.
    #[must_use]
    pub fn dot(&self, other: &Self) -> f64 {
        let normal = self.xx * other.xx + self.yy * other.yy + self.zz * other.zz;
        normal + 2.0 * (self.xy * other.xy + self.yz * other.yz + self.xz * other.xz)
    }

    /// `self + factor other`.
    #[must_use]
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        let (one, two) = (self.components(), other.components());
        Self::from_components([0, 1, 2, 3, 4, 5].map(|i| one[i] + factor * two[i]))
    }

    /// Von Mises's equivalent stress, `sqrt(3/2 s_ij s_ij)` of the deviator; `sqrt 3` times the
    /// shear stress that does the same work of distortion.
    #[must_use]
    pub fn von_mises(&self) -> f64 {
        let deviator = self.deviator();
        (1.5 * deviator.dot(&deviator)).sqrt()
    }

    /// The principal stresses, the largest first; NaN for a state that is not finite.
    #[must_use]
    pub fn principal(&self) -> [f64; 3] {
        let size = self.components().iter().fold(0.0_f64, |max, value| max.max(value.abs()));
        if !self.components().iter().all(|value| value.is_finite()) || size == 0.0 {
            return [self.trace(); 3];
        }
        let Self { xx, yy, zz, xy, yz, xz } = *self;
        // Scaled, so that no square overflows.
        let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz) / size;
        let mut values: [f64; 3] = (matrix.symmetric_eigenvalues() * size).into();
        values.sort_by(|one, two| two.total_cmp(one));
        values
    }

    /// Tresca's equivalent stress: the largest principal stress less the smallest, twice the
    /// largest shear stress on any plane.
    #[must_use]
    pub fn tresca(&self) -> f64 {
        let [first, _, third] = self.principal();
        first - third
    }

    /// The strain of `solid` under this stress: Hooke's law,
    /// `2 G e_ij = s_ij - sigma / (1 + sigma) s_kk delta_ij`.
    #[must_use]
    pub fn strain(&self, solid: Solid) -> Self {
        let mean = solid.poisson() / (1.0 + solid.poisson()) * self.trace();
        let double = Self { xx: self.xx - mean, yy: self.yy - mean, zz: self.zz - mean, ..*self };
        Self::default().plus(0.5 / solid.shear_modulus(), &double)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simple_states_have_the_known_measures() {
        let tension = Stress { xx: 3.0, ..Stress::default() };
        assert!((tension.von_mises() - 3.0).abs() < 1e-15);
        assert!((tension.tresca() - 3.0).abs() < 1e-15);
        let shear = Stress { xz: 2.0, ..Stress::default() };
        // Eigenvalues of a 3 x 3 matrix: rounding.
        assert!((shear.tresca() - 4.0).abs() < 1e-14);
        assert!((shear.von_mises() - 2.0 * 3.0_f64.sqrt()).abs() < 1e-14);
        let mean = Stress { xx: 5.0, yy: 5.0, zz: 5.0, ..Stress::default() };
        assert!(mean.von_mises().abs() < 1e-15);
        assert!(mean.principal().iter().all(|value| (value - 5.0).abs() < 1e-15));
    }

    #[test]
    fn what_is_not_finite_stays_so() {
        let broken = Stress { xy: f64::NAN, xx: f64::INFINITY, ..Stress::default() };
        assert!(!broken.tresca().is_finite() && !broken.von_mises().is_finite());
    }
}
