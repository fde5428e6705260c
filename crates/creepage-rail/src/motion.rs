//! Creepage of a contact from the wheelset's motion.

use crate::rolling::{RollingCreepage, SurfaceMotion};
use crate::{Contact, Side};

/// Motion of a wheelset along a track at rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Speed of its centre along the track (m/s).
    pub speed: f64,
    /// Angular velocity about its axle (rad/s), positive when it rolls forward.
    pub pitch_rate: f64,
    /// Velocity of its centre to the right (m/s).
    pub lateral_velocity: f64,
    /// Velocity of its centre downwards (m/s).
    pub vertical_velocity: f64,
    /// Angular velocity about the track's `x` (rad/s), positive where the right wheel goes down.
    pub roll_rate: f64,
    /// Angular velocity about the track's `z` (rad/s).
    pub yaw_rate: f64,
}

impl Motion {
    /// Rolls straight on.
    #[must_use]
    pub fn straight(speed: f64, pitch_rate: f64) -> Self {
        Self { speed, pitch_rate, ..Self::default() }
    }

    fn on(self, side: Side) -> Self {
        let sense = side.sense();
        Self {
            lateral_velocity: sense * self.lateral_velocity,
            roll_rate: sense * self.roll_rate,
            yaw_rate: sense * self.yaw_rate,
            ..self
        }
    }
}

impl Contact<'_> {
    /// Creepage and spin at the reference point, in the contact's axes `x`, `s`, `n`.
    ///
    /// The wheel's velocity is that of its own undeformed surface, which lies the approach below
    /// the rail's. `None` unless wheel and rail roll forward.
    #[must_use]
    pub fn creepage(&self, motion: &Motion) -> Option<RollingCreepage> {
        let [x, _, z] = self.reference;
        let y = self.side.sense() * self.reference[1];
        let [ny, nz] = self.surfaces.frame.normal();
        let point = [x, y + self.approach * ny, z + self.approach * nz];
        let motion = motion.on(self.side);
        let [vx, vy, vz] = self.velocity(motion, point);
        let spin = self.turning(motion);
        let sense = self.side.sense();
        let upper = SurfaceMotion {
            velocity: [vx - motion.speed, sense * self.surfaces.frame.facing_tangent([vy, vz])],
            turn: sense * (ny * spin[1] + nz * spin[2]),
        };
        let lower = SurfaceMotion { velocity: [-motion.speed, 0.0], turn: 0.0 };
        RollingCreepage::between(upper, lower)
    }

    /// Rigid slip at `(x, s)` (m) of the contact plane, over the rolling speed: along `x` and
    /// along the rail's surface there. On a flat contact it is
    /// `(longitudinal - spin s, lateral + spin x)`; on a curved one spin varies.
    ///
    /// `None` as by [`Contact::gap`] and [`Contact::creepage`].
    #[must_use]
    pub fn rigid_slip(&self, motion: &Motion, x: f64, s: f64) -> Option<[f64; 2]> {
        let speed = self.creepage(motion)?.speed;
        let sense = self.side.sense();
        let [point, tangent] = self.facing_points(x, sense * s)?;
        let [vx, vy, vz] = self.velocity(motion.on(self.side), point);
        let lateral = tangent[1] * vy + tangent[2] * vz;
        Some([vx / speed, sense * lateral / speed])
    }

    /// Angular velocity of the wheelset, on the right-hand image.
    fn turning(&self, motion: Motion) -> [f64; 3] {
        let [x, y, z] = self.surfaces.pair.posed.turned([0.0, -motion.pitch_rate, 0.0]);
        [x + motion.roll_rate, y, z + motion.yaw_rate]
    }

    /// Velocity of the wheel's material at a place of the right-hand image.
    fn velocity(&self, motion: Motion, point: [f64; 3]) -> [f64; 3] {
        let [wx, wy, wz] = self.turning(motion);
        let [x, y, z] = [0, 1, 2].map(|i| point[i] - self.surfaces.pair.posed.centre[i]);
        [
            motion.speed + wy * z - wz * y,
            motion.lateral_velocity + wz * x - wx * z,
            motion.vertical_velocity + wx * y - wy * x,
        ]
    }
}
