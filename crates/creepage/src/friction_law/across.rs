//! Coefficient of friction that varies across the contact.

use crate::check::{self, InvalidValue};

/// A coefficient of friction by the lateral place `y` (m) in the contact: linear between given
/// places, constant beyond the first and the last. Greased gauge corners, wet running bands.
///
/// ```
/// use creepage::friction_law::FrictionAcross;
/// let friction = FrictionAcross::new(&[[-2e-3, 0.1], [2e-3, 0.4]])?;
/// assert_eq!((friction.largest(), friction.at(-1.0)), (0.4, 0.1));
/// assert!((friction.at(0.0) - 0.25).abs() < 1e-15);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionAcross {
    /// Those beyond `count` repeat the last.
    points: [[f64; 2]; FrictionAcross::MAX_PLACES],
    count: usize,
}

impl FrictionAcross {
    /// Most places.
    pub const MAX_PLACES: usize = 7;

    /// From pairs of `y` (m), rising, and the coefficient there.
    ///
    /// # Errors
    /// [`InvalidValue`] unless there are two to [`FrictionAcross::MAX_PLACES`] places that rise,
    /// coefficients that are not negative, and one that is positive; all finite.
    pub fn new(points: &[[f64; 2]]) -> Result<Self, InvalidValue> {
        let count = points.len();
        let enough = (2..=Self::MAX_PLACES).contains(&count);
        check::require(enough, "across", count as f64, "two to seven pairs of y and friction")?;
        for [y, friction] in points {
            check::finite("y of friction across", *y)?;
            let valid = friction.is_finite() && *friction >= 0.0;
            check::require(valid, "friction across", *friction, "finite and not negative")?;
        }
        for pair in points.windows(2) {
            let y = pair[1][0];
            check::require(pair[0][0] < y, "y of friction across", y, "above the one before")?;
        }
        let mut all = [points[count - 1]; Self::MAX_PLACES];
        all[..count].copy_from_slice(points);
        let friction = Self { points: all, count };
        check::positive("largest friction across", friction.largest())?;
        Ok(friction)
    }

    /// The pairs of `y` (m) and friction.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points[..self.count]
    }

    /// The largest coefficient: the `mu` of `xi`, `eta`, `chi` and of the forces.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.points.iter().fold(0.0, |largest, [_, friction]| friction.max(largest))
    }

    /// The coefficient at `y` (m).
    #[must_use]
    pub fn at(&self, y: f64) -> f64 {
        let points = self.points();
        let right = points.partition_point(|[place, _]| *place <= y);
        let [from, before] = points[right.max(1) - 1];
        let [to, after] = points[right.min(self.count - 1)];
        let share = if to > from { (y - from) / (to - from) } else { 0.0 };
        before + share * (after - before)
    }

    /// The same law seen from an origin at `y` (m).
    pub(crate) fn seen_from(mut self, y: f64) -> Self {
        self.points.iter_mut().for_each(|point| point[0] -= y);
        self
    }
}
