//! A rail as the rim of a roller: of a roller rig, a disc machine, a ring.

use crate::GeometryError;

/// A roller under a wheel, whose axle lies along the track's `y`.
///
/// Its rim has the rail's profile: the radius `radius` where that lies in the track plane `z = 0`, less by what it
/// lies below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roller {
    /// Radius in the track plane (m); below zero for a ring that runs around the wheel.
    radius: f64,
    /// `z` of its axle (m).
    axle: f64,
}

impl Roller {
    /// A roller of that radius (m) in the track plane; below zero it is a ring around the wheel.
    ///
    /// # Errors
    /// [`GeometryError::Value`] for a radius that is zero or not finite.
    pub fn new(radius: f64) -> Result<Self, GeometryError> {
        if radius.is_finite() && radius.abs() >= 1e-4 {
            return Ok(Self { radius, axle: radius });
        }
        let range = "0.1 mm at least, below zero for a ring around the wheel";
        Err(GeometryError::Value { name: "roller_radius", value: radius, range })
    }

    /// Radius in the track plane (m).
    #[must_use]
    pub fn radius(self) -> f64 {
        self.radius
    }

    /// `z` of its axle in the track (m).
    pub(crate) fn axle(self) -> f64 {
        self.axle
    }

    /// The same, further down by `z` (m).
    pub(crate) fn lowered(self, z: f64) -> Self {
        Self { axle: self.axle + z, ..self }
    }

    /// Height of the rim (m, down) at `x` (m) from the top where it is `z` there, and its derivatives by `x` and by
    /// `z`; `None` beside the roller.
    pub(crate) fn at(self, x: f64, z: f64) -> Option<[f64; 3]> {
        let local = self.axle - z;
        let root = ((local - x) * (local + x)).sqrt() * local.signum();
        (root.is_finite() && root.abs() > 0.0).then(|| [self.axle - root, x / root, local / root])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rim_is_a_circle_about_the_axle() {
        for radius in [0.5, -0.5] {
            let roller = Roller::new(radius).unwrap().lowered(0.003);
            let [z, by_x, by_z] = roller.at(0.03, 0.002).unwrap();
            let local = radius + 0.001;
            let off = (0.03f64).hypot(z - radius - 0.003) - local.abs();
            assert!(off.abs() < 1e-15, "{off}");
            let step = 1e-6;
            let at = |x: f64, z: f64| roller.at(x, z).unwrap()[0];
            let differences = [
                (at(0.03 + step, 0.002) - at(0.03 - step, 0.002)) / (2.0 * step),
                (at(0.03, 0.002 + step) - at(0.03, 0.002 - step)) / (2.0 * step),
            ];
            assert!((by_x - differences[0]).abs() < 1e-8 && (by_z - differences[1]).abs() < 1e-8);
            // A ring bends up beside its lowest place.
            assert!((at(0.03, 0.002) > 0.002) == (radius > 0.0));
        }
        assert!(Roller::new(0.0).is_err() && Roller::new(f64::NAN).is_err());
        assert!(Roller::new(0.5).unwrap().at(0.6, 0.0).is_none());
    }
}
