//! Creepage and spin from the motion of two rigid bodies: 4.1 of the thesis, (4.8) to (4.14).

use crate::check::{self, InvalidValue};
use crate::scaling::SiCreepage;

/// Largest angle between the rolling direction and x (rad): (4.10) takes it as small.
const LARGEST_SKEW: f64 = 0.1;
/// Largest speed at which the surfaces approach or part, over the rolling velocity.
const LARGEST_APPROACH: f64 = 1e-3;

/// How a body moves that is rigid but for its contact; axes as in the contact: x the rolling direction, y to
/// its right, z into the lower body, the origin at the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RigidMotion {
    /// A point of the body, such as one on its axis (m).
    pub point: [f64; 3],
    /// The velocity of that point (m/s).
    pub velocity: [f64; 3],
    /// Angular velocity (rad/s).
    pub angular_velocity: [f64; 3],
}

impl RigidMotion {
    /// Velocity of the undeformed surface at the contact (m/s).
    #[must_use]
    pub fn at_contact(&self) -> [f64; 3] {
        let ([wx, wy, wz], [vx, vy, vz]) = (self.angular_velocity, self.velocity);
        // From the point to the contact.
        let [x, y, z] = self.point.map(|part| -part);
        [vx + wy * z - wz * y, vy + wz * x - wx * z, vz + wx * y - wy * x]
    }

    fn check(&self, names: [&'static str; 3]) -> Result<(), InvalidValue> {
        let parts = [self.point, self.velocity, self.angular_velocity];
        for (name, part) in names.into_iter().zip(parts) {
            part.into_iter().try_for_each(|value| check::finite(name, value).map(drop))?;
        }
        Ok(())
    }
}

/// How two bodies roll on each other.
///
/// ```
/// use creepage::motion::{RigidMotion, RollingMotion};
/// // A wheel of radius .46 m, axle at 20 m/s along x, turns one part in a thousand too fast.
/// let axle = RigidMotion {
///     point: [0.0, 0.0, -0.46],
///     velocity: [20.0, 0.0, 0.0],
///     angular_velocity: [0.0, -20.0 / 0.46 * 1.001, 0.0],
/// };
/// let rolling = RollingMotion::new(&axle, &RigidMotion::default(), [20.0, 0.0, 0.0])?;
/// assert!((rolling.creepage.longitudinal + 1e-3).abs() < 1e-6);
/// assert!((rolling.speed / 20.01 - 1.0).abs() < 1e-6); // the mean of both surfaces
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingMotion {
    /// Creepage and spin of the upper body relative to the lower (4.14).
    pub creepage: SiCreepage,
    /// Rolling velocity V (m/s): that of the contact over the mean of both surfaces (4.9).
    pub speed: f64,
    /// Angle from x to the rolling direction (rad), positive to the right: `delta` of (4.10), at most 0.1.
    pub skew: f64,
}

impl RollingMotion {
    /// From the motion of both bodies, seen from any one frame, in which the contact itself moves with
    /// `contact_velocity` (m/s): zero where the frame goes with it.
    ///
    /// # Errors
    /// [`InvalidValue`] for numbers that are not finite; for a rolling velocity that is none, or more than
    /// 0.1 rad off the axis x; for surfaces that approach or part at a thousandth of it.
    pub fn new(
        upper: &RigidMotion,
        lower: &RigidMotion,
        contact_velocity: [f64; 3],
    ) -> Result<Self, InvalidValue> {
        upper.check(["upper point", "upper velocity", "upper angular_velocity"])?;
        lower.check(["lower point", "lower velocity", "lower angular_velocity"])?;
        contact_velocity
            .into_iter()
            .try_for_each(|value| check::finite("contact_velocity", value).map(drop))?;
        let (above, below) = (upper.at_contact(), lower.at_contact());
        // (4.9): the mean of both, seen from the contact, backwards.
        let rolling = [0, 1].map(|k| contact_velocity[k] - 0.5 * (above[k] + below[k]));
        let speed = rolling[0].hypot(rolling[1]);
        let valid = "greater than zero and finite: the contact must move along the surfaces";
        check::require(speed > 0.0 && speed.is_finite(), "rolling velocity", speed, valid)?;
        let skew = rolling[1].atan2(rolling[0]);
        let valid = "at most 0.1 rad from the axis x: turn the axes";
        check::require(skew.abs() <= LARGEST_SKEW, "rolling direction", skew, valid)?;
        let approach = (above[2] - below[2]) / speed;
        let valid = "at most 0.001: the surfaces must not approach or part";
        let is_small = approach.abs() <= LARGEST_APPROACH;
        check::require(is_small, "normal velocity over rolling velocity", approach, valid)?;
        // (4.11), (4.12).
        let creepage = SiCreepage {
            longitudinal: (above[0] - below[0]) / speed,
            lateral: (above[1] - below[1]) / speed,
            spin: (upper.angular_velocity[2] - lower.angular_velocity[2]) / speed,
        };
        Ok(Self { creepage, speed, skew })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rollers of radii 50 and 80 mm, the upper one yawed and tilted.
    fn rollers() -> [RigidMotion; 2] {
        let (yaw, tilt) = (2e-3_f64, 3e-3_f64);
        let turn = -400.0;
        let axis = [-yaw.sin(), yaw.cos() * tilt.cos(), tilt.sin()];
        let upper = RigidMotion {
            point: [0.0, 0.0, -0.05],
            angular_velocity: axis.map(|part| turn * part),
            ..RigidMotion::default()
        };
        let lower = RigidMotion {
            point: [0.0, 0.0, 0.08],
            angular_velocity: [0.0, 249.0, 0.0],
            ..RigidMotion::default()
        };
        [upper, lower]
    }

    #[test]
    fn rollers_by_hand() {
        let [upper, lower] = rollers();
        let found = RollingMotion::new(&upper, &lower, [0.0; 3]).unwrap();
        // Surfaces at -20 (less a part of the yaw and the tilt) and -19.92 m/s.
        let speed = 0.5 * (20.0 + 19.92);
        assert!((found.speed / speed - 1.0).abs() < 1e-5);
        assert!((found.creepage.longitudinal + 0.08 / speed).abs() < 1e-4);
        assert!((found.creepage.lateral + 20.0 * 2e-3 / speed).abs() < 1e-5, "{found:?}");
        assert!((found.creepage.spin + 400.0 * 3e-3 / speed).abs() < 1e-4);
    }

    #[test]
    fn the_frame_does_not_matter() {
        let bodies = rollers();
        let still = RollingMotion::new(&bodies[0], &bodies[1], [0.0; 3]).unwrap();
        let flight = [3.0, -2.0, 1.0];
        let moved = bodies.map(|body| {
            let velocity = [0, 1, 2].map(|k| body.velocity[k] + flight[k]);
            // Another point of the same body.
            let shifted = RigidMotion { point: [0.1, 0.2, -0.3], ..RigidMotion::default() };
            let from = RigidMotion { velocity, ..body };
            let lever = [0, 1, 2].map(|k| from.point[k] - shifted.point[k]);
            let at = RigidMotion { point: lever, ..from };
            RigidMotion { velocity: at.at_contact(), point: shifted.point, ..body }
        });
        let seen = RollingMotion::new(&moved[0], &moved[1], flight).unwrap();
        // Rounding of velocities of some hundred m/s.
        assert!((seen.creepage.longitudinal - still.creepage.longitudinal).abs() < 1e-12);
        assert!((seen.creepage.lateral - still.creepage.lateral).abs() < 1e-12);
        assert!((seen.speed - still.speed).abs() < 1e-11);
    }

    #[test]
    fn what_does_not_roll_is_refused() {
        let [upper, lower] = rollers();
        let name = |upper: RigidMotion, lower: RigidMotion, velocity| {
            RollingMotion::new(&upper, &lower, velocity).unwrap_err().quantity
        };
        let rest = RigidMotion::default();
        assert_eq!(name(rest, rest, [0.0; 3]), "rolling velocity");
        assert_eq!(name(rest, rest, [-1.0, 0.0, 0.0]), "rolling direction");
        assert_eq!(name(rest, rest, [1.0, 0.2, 0.0]), "rolling direction");
        let falling = RigidMotion { velocity: [0.0, 0.0, 1.0], ..upper };
        assert_eq!(name(falling, lower, [0.0; 3]), "normal velocity over rolling velocity");
        let broken = RigidMotion { velocity: [f64::NAN, 0.0, 0.0], ..upper };
        assert_eq!(name(broken, lower, [0.0; 3]), "upper velocity");
        assert_eq!(name(upper, lower, [f64::INFINITY, 0.0, 0.0]), "contact_velocity");
    }
}
