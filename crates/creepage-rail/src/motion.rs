//! Creepage of a contact from the wheelset's motion.

use crate::pair_surfaces::{Plane, contact_axes, dot};
use crate::rolling::{RollingCreepage, SurfaceMotion};
use crate::{Contact, Side};

/// Velocity of a rail.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RailMotion {
    /// Velocity of the profile's origin to the right (m/s).
    pub lateral_velocity: f64,
    /// Velocity of the profile's origin downwards (m/s).
    pub vertical_velocity: f64,
    /// Angular velocity about the track's `x` (rad/s), by the right-hand rule.
    pub roll_rate: f64,
}

/// Motion of a wheelset along its track, in the track's axes, which go along with it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Speed of its centre along the track (m/s).
    pub speed: f64,
    /// Angular velocity about its axle (rad/s), positive when it rolls forward.
    pub pitch_rate: f64,
    /// Velocity of its centre to the right (m/s).
    pub lateral_velocity: f64,
    /// Velocity of its centre downwards (m/s), beside that of following surfaces that vary along rolling.
    pub vertical_velocity: f64,
    /// Angular velocity about the track's `x` (rad/s), positive where the right wheel goes down.
    pub roll_rate: f64,
    /// Angular velocity about the track's `z`, against the track's axes (rad/s).
    pub yaw_rate: f64,
    /// Curvature of the track (1/m), positive in a right-hand curve. The rails go back under the
    /// wheelset by their own lengths.
    pub curvature: f64,
    /// How the left and the right rail move.
    pub rails: [RailMotion; 2],
}

impl Motion {
    /// Rolls straight on.
    #[must_use]
    pub fn straight(speed: f64, pitch_rate: f64) -> Self {
        Self { speed, pitch_rate, ..Self::default() }
    }

    /// On the right-hand image of a side, with the motion of its rail.
    fn on(self, side: Side) -> (Self, RailMotion) {
        let sense = side.sense();
        let motion = Self {
            lateral_velocity: sense * self.lateral_velocity,
            roll_rate: sense * self.roll_rate,
            yaw_rate: sense * self.yaw_rate,
            curvature: sense * self.curvature,
            ..self
        };
        let rail = self.rails[usize::from(side == Side::Right)];
        let rail = RailMotion {
            lateral_velocity: sense * rail.lateral_velocity,
            roll_rate: sense * rail.roll_rate,
            ..rail
        };
        (motion, rail)
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
        let (motion, rail) = motion.on(self.side);
        let motion = self.following(motion);
        let sense = self.side.sense();
        // On surfaces that vary the plane slopes along the track, and the place goes along it.
        let Plane { axes: [along, across, normal], .. } =
            Plane::new(self.reference, sense * self.angle, self.slope);
        let point = [x, y, z];
        let point = [0, 1, 2].map(|i: usize| point[i] + self.approach * normal[i]);
        let surface = |[vx, vy, vz]: [f64; 3], turn: [f64; 3]| SurfaceMotion {
            velocity: [dot(along, [vx - motion.speed, vy, vz]), sense * dot(across, [vx, vy, vz])],
            turn: sense * dot(normal, turn),
        };
        let upper = surface(self.velocity(motion, point), self.turning(motion));
        let on_rail = [x, y, z];
        let lower =
            surface(self.rail_velocity(motion, rail, on_rail), self.rail_turning(motion, rail));
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
        let [point, ahead, tangent] = self.facing_points(x, sense * s)?;
        let (motion, rail) = motion.on(self.side);
        let motion = self.following(motion);
        let (wheel, rail) = (self.velocity(motion, point), self.rail_velocity(motion, rail, point));
        let [vx, vy, vz] = [0, 1, 2].map(|i: usize| wheel[i] - rail[i]);
        let lateral = tangent[1] * vy + tangent[2] * vz;
        let along = dot(ahead, [vx, vy, vz]);
        Some([along / speed, sense * lateral / speed])
    }

    /// The motion (on the right-hand image) of a wheelset whose wheel stays on its rail: where surfaces vary along
    /// rolling, forward speed and turning alone would take it into the rail or out, and its vertical velocity counts
    /// from that which makes up for it. A round wheel on a prism needs none.
    fn following(&self, motion: Motion) -> Motion {
        if !self.varies() {
            return motion;
        }
        let [_, _, normal] = contact_axes(self.side.sense() * self.angle, self.slope);
        let [x, y, z] = self.reference;
        let place = [x, self.side.sense() * y, z];
        let point = [0, 1, 2].map(|i: usize| place[i] + self.approach * normal[i]);
        let rolls = Motion::straight(motion.speed, motion.pitch_rate);
        let wheel = self.velocity(rolls, point);
        let rail = self.rail_velocity(rolls, RailMotion::default(), point);
        let away = dot(normal, [0, 1, 2].map(|i: usize| wheel[i] - rail[i])) / normal[2];
        Motion { vertical_velocity: motion.vertical_velocity - away, ..motion }
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

    /// Velocity of the rail's material there: at rest but for the curve, which takes the rails round
    /// the wheelset, and the rail's own motion. A roller's turns, its rim as fast as the rail would go back.
    fn rail_velocity(&self, motion: Motion, rail: RailMotion, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [origin_y, origin_z] = self.surfaces.pair.rail.origin();
        let round = motion.speed * motion.curvature;
        // Less the speed with which the wheelset would pass it.
        let [back, lift] = self.surfaces.pair.rail.roller().map_or([0.0; 2], |roller| {
            let rate = motion.speed / roller.radius();
            [motion.speed + rate * (z - roller.axle()), -rate * x]
        });
        [
            back + round * y,
            rail.lateral_velocity - round * x - rail.roll_rate * (z - origin_z),
            lift + rail.vertical_velocity + rail.roll_rate * (y - origin_y),
        ]
    }

    /// Angular velocity of the rail under the wheelset.
    fn rail_turning(&self, motion: Motion, rail: RailMotion) -> [f64; 3] {
        let roller = self.surfaces.pair.rail.roller();
        let rate = roller.map_or(0.0, |roller| motion.speed / roller.radius());
        [rail.roll_rate, rate, -motion.speed * motion.curvature]
    }
}
