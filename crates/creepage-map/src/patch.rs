//! Contact patch at one node: where it lies, and the two equivalent ellipses whose forces it has.

use creepage::table::{Shape, Slice, Table};

use crate::scalar::Scalar;

/// A number at a node with its slopes along the map's place and along the logarithm of the load.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sloped {
    /// At the node.
    pub value: f64,
    /// By the place (1/m).
    pub by_place: f64,
    /// By the logarithm of the load.
    pub by_load: f64,
}

impl Sloped {
    /// A number whose slopes are not known yet.
    #[must_use]
    pub fn level(value: f64) -> Self {
        Self { value, ..Self::default() }
    }

    #[inline]
    fn at<S: Scalar>(&self, [place, load]: [S; 2]) -> S {
        place * self.by_place + load * self.by_load + self.value
    }
}

/// An equivalent ellipse: its creep force is a share of that of a contact.
///
/// With creepage `u_x`, `u_y` and spin `phi` at the contact's reference point, its dimensionless creepage
/// is `xi = k_x (u_x - phi s)/mu`, `eta = k_x u_y/mu`, `chi = k_p phi/mu`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ellipse {
    /// Ratio of its semi-axes, along over across the rolling direction.
    pub ratio: f64,
    /// `k_x`.
    pub by_creepage: f64,
    /// `k_p` (m).
    pub by_spin: f64,
    /// `s`: how far from the reference point its centre lies across (m).
    pub offset: f64,
    /// Its share of the force.
    pub weight: f64,
    /// What it adds to the moment over `mu N` (m): by its own moment, by `f_x`, by `f_y`.
    pub moment: [f64; 3],
    /// How it goes on along the map's place (1/m).
    pub by_place: EllipseSlopes,
    /// How it goes on along the logarithm of the load, beyond its growth by the cube root of that.
    pub by_load: EllipseSlopes,
}

/// Slopes of an ellipse's numbers. Its ratio is kept; `k_x` has a slope along and one across.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EllipseSlopes {
    /// Of `ln k_x` in `xi`.
    pub along: f64,
    /// Of `ln k_x` in `eta`.
    pub across: f64,
    /// Of `ln k_p`.
    pub spin: f64,
    /// Of `s` (m).
    pub offset: f64,
    /// Of the share.
    pub weight: f64,
    /// Of what it adds to the moment (m).
    pub moment: [f64; 3],
}

impl Ellipse {
    /// Without slopes.
    pub(crate) fn level(self) -> Self {
        Self { by_place: EllipseSlopes::default(), by_load: EllipseSlopes::default(), ..self }
    }
}

/// One place of contact at one node and load of the map, on the right-hand image of its side.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Patch {
    /// Normal force over the vertical part of all normal forces of the wheel.
    pub share: Sloped,
    /// Rotation about `x` from the track's `z` to the normal into the rail (rad).
    pub angle: Sloped,
    /// The reference point on the rail in track axes (m).
    pub y: Sloped,
    /// See [`Patch::y`].
    pub z: Sloped,
    /// How far the undeformed bodies overlap (m).
    pub approach: f64,
    /// Centre of pressure from the reference point, along and across (m).
    pub centroid: [f64; 2],
    /// Largest pressure (Pa).
    pub peak_pressure: f64,
    /// Area (m^2).
    pub area: f64,
    /// The two ellipses.
    pub ellipses: [Ellipse; 2],
    /// What the fit leaves of the tangential force, root mean square over its samples, in parts of
    /// `mu N`.
    pub residual: f64,
}

/// A patch with its ellipses placed in the table.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Prepared {
    pub(crate) patch: Patch,
    shapes: [Shape; 2],
}

/// Pose and motion of the wheelset, with which all patches of a wheel are asked, on the right-hand image.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WheelsetState<S> {
    /// The wheelset's centre: lateral and vertical place (m).
    pub(crate) centre: [S; 2],
    /// Sine and cosine of roll and yaw.
    pub(crate) roll: (S, S),
    pub(crate) yaw: (S, S),
    pub(crate) tan_yaw: S,
    /// Angular velocity in track axes (rad/s).
    pub(crate) turning: [S; 3],
    /// Velocity of the centre (m/s); `speed` is along the track.
    pub(crate) velocity: [S; 3],
    pub(crate) friction: S,
    /// Where moments are about: lateral and vertical place (m).
    pub(crate) about: [f64; 2],
}

/// Distance of a query from a node: along the place, along the logarithm of the load, and the cube root of the
/// load over the node's.
#[derive(Debug, Clone, Copy)]
pub(crate) struct From<S> {
    pub(crate) place: S,
    pub(crate) load: S,
    pub(crate) growth: S,
}

impl<S: Scalar> From<S> {
    pub(crate) fn new(place: S, load: S) -> Self {
        Self { place, load, growth: (load * (1.0 / 3.0)).exp() }
    }
}

/// Load of a patch on the rail, over the wheel's load: force, moment, and friction's moment about the axle; its
/// numbers for reports.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PatchForces<S> {
    pub(crate) force: [S; 3],
    pub(crate) moment: [S; 3],
    pub(crate) axle: S,
    pub(crate) report: Report,
}

/// Numbers of a patch for reports, over the wheel's load where they are forces.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Report {
    pub(crate) share: f64,
    pub(crate) reference: [f64; 3],
    pub(crate) angle: f64,
    pub(crate) creepage: [f64; 3],
    pub(crate) friction: [f64; 3],
    pub(crate) peak_pressure: f64,
    pub(crate) area: f64,
}

/// Above this part of the bound a force is bent towards it.
const BEND: f64 = 1e-3;

/// A force of length up to a little above one, kept below one: as it is up to [`BEND`] below, then bent
/// with a continuous slope.
fn bounded<S: Scalar>([x, y]: [S; 2]) -> [S; 2] {
    let square = x * x + y * y;
    let knee = 1.0 - BEND;
    if square.value() <= knee * knee {
        return [x, y];
    }
    let length = square.sqrt();
    let beyond = (length - knee) * (1.0 / BEND);
    let kept = -(beyond + 1.0).recip() * BEND + 1.0;
    let scale = kept / length;
    [x * scale, y * scale]
}

impl Prepared {
    pub(crate) fn new(
        patch: &Patch,
        table: &Table,
        poisson: f64,
    ) -> Result<Self, creepage::InvalidValue> {
        let [one, other] = patch.ellipses.map(|ellipse| table.shape(ellipse.ratio, poisson));
        Ok(Self { patch: *patch, shapes: [one?, other?] })
    }

    /// The table at the ratio of an ellipse.
    pub(crate) fn slice<'a>(&self, table: &'a Table, ellipse: usize) -> Slice<'a> {
        table.slice(&self.shapes[ellipse])
    }

    /// Tangential force over `mu N` and moment over `mu N` (m) at creepage, lateral creepage and spin over
    /// `mu`.
    pub(crate) fn friction<S: Scalar>(
        &self,
        table: &Table,
        [along, across, spin]: [S; 3],
        from: &From<S>,
    ) -> [S; 3] {
        let zero = S::constant(0.0);
        let (mut force, mut moment) = ([zero; 2], zero);
        let shrink = from.growth.recip();
        for (ellipse, shape) in self.patch.ellipses.iter().zip(&self.shapes) {
            let (by_place, by_load) = (&ellipse.by_place, &ellipse.by_load);
            let part =
                |of: fn(&EllipseSlopes) -> f64| from.place * of(by_place) + from.load * of(by_load);
            let scale = shrink * ellipse.by_creepage;
            let offset = part(|slopes| slopes.offset) + ellipse.offset;
            let creepage = [
                (along - spin * offset) * scale * (part(|slopes| slopes.along) + 1.0),
                across * scale * (part(|slopes| slopes.across) + 1.0),
                spin * (part(|slopes| slopes.spin) + 1.0) * ellipse.by_spin,
            ];
            let [x, y, m] = S::creep_force(&table.slice(shape), creepage);
            let weight = part(|slopes| slopes.weight) + ellipse.weight;
            let by_m = part(|slopes| slopes.moment[0]) + ellipse.moment[0];
            let by_x = part(|slopes| slopes.moment[1]) + ellipse.moment[1];
            let by_y = part(|slopes| slopes.moment[2]) + ellipse.moment[2];
            force = [force[0] + x * weight, force[1] + y * weight];
            moment = moment + from.growth * m * by_m + x * by_x + y * by_y;
        }
        let [x, y] = bounded(force);
        [x, y, moment]
    }
}

/// Node's contact in a blend of neighbours: its weight, and the distance of the query.
pub(crate) type WeightedPatch<'a, S> = (S, &'a Prepared, From<S>);

/// Where contacts of neighbouring nodes lie, blended.
struct Geometry<S> {
    share: S,
    angle: S,
    place: [S; 2],
    approach: S,
    centroid: [S; 2],
    peak_pressure: f64,
    area: f64,
}

impl<S: Scalar> Geometry<S> {
    fn of(nodes: &[WeightedPatch<'_, S>]) -> Self {
        let zero = S::constant(0.0);
        let (mut all, mut approach, mut centroid) = ([zero; 4], zero, [zero; 2]);
        let (mut peak_pressure, mut area) = (0.0, 0.0);
        for (weight, node, from) in nodes {
            let patch = &node.patch;
            let at = [from.place, from.load];
            for (sum, part) in all.iter_mut().zip([patch.share, patch.angle, patch.y, patch.z]) {
                *sum = *sum + part.at(at) * *weight;
            }
            let square = from.growth * from.growth;
            approach = approach + square * patch.approach * *weight;
            for (sum, part) in centroid.iter_mut().zip(patch.centroid) {
                *sum = *sum + *weight * part;
            }
            peak_pressure += weight.value() * patch.peak_pressure * from.growth.value();
            area += weight.value() * patch.area * square.value();
        }
        let [share, angle, y, z] = all;
        Self { share, angle, place: [y, z], approach, centroid, peak_pressure, area }
    }
}

impl<S: Scalar> PatchForces<S> {
    /// What a contact does in a position and motion, over the wheel's load: it lies where its nodes blended have
    /// it, and the forces of each node there are blended. The weights' sum is one.
    pub(crate) fn of(
        nodes: &[WeightedPatch<'_, S>],
        table: &Table,
        asked: &WheelsetState<S>,
    ) -> Self {
        let geometry = Geometry::of(nodes);
        let (share, angle, [y, z]) = (geometry.share, geometry.angle, geometry.place);
        let (sin, cos) = angle.sin_cos();
        let lever = [y - asked.centre[0], z - asked.centre[1]];
        // The wheel's normal there, by the wheelset's axes, tells where around the axle it touches.
        let (sin_roll, cos_roll) = asked.roll;
        let normal = [-(sin * cos_roll - cos * sin_roll), cos * cos_roll + sin * sin_roll];
        let around = normal[0] / normal[1] * asked.tan_yaw;
        let x = lever[1] * around * asked.yaw.1 - lever[0] * asked.yaw.0;
        let approach = geometry.approach;
        let point = [x, lever[0] - sin * approach, lever[1] + cos * approach];
        let [wx, wy, wz] = asked.turning;
        let [vx, vy, vz] = asked.velocity;
        let slip = [
            vx + wy * point[2] - wz * point[1],
            vy + wz * point[0] - wx * point[2],
            vz + wx * point[1] - wy * point[0],
        ];
        // Rolling speed: the mean of both surfaces' speeds against `x`.
        let per_speed = (vx - slip[0] * 0.5).recip();
        let creepage = [
            slip[0] * per_speed,
            (slip[1] * cos + slip[2] * sin) * per_speed,
            (wz * cos - wy * sin) * per_speed,
        ];
        let per_friction = asked.friction.recip();
        let reduced = creepage.map(|part| part * per_friction);
        let bound = asked.friction * share;
        let mut friction = [S::constant(0.0); 3];
        for (weight, node, from) in nodes {
            let own = node.friction(table, reduced, from);
            friction = [0, 1, 2].map(|k: usize| friction[k] + own[k] * *weight);
        }
        let [fx, fs, mz] = friction.map(|part| part * bound);
        let [cx, cs] = geometry.centroid;
        let force = [fx, fs * cos - share * sin, fs * sin + share * cos];
        let (mx, ms) = (share * cs, -(share * cx));
        let couple = [mx, ms * cos - mz * sin, ms * sin + mz * cos];
        let arm = [x, y - asked.about[0], z - asked.about[1]];
        let levered = cross(arm, force);
        let moment = [0, 1, 2].map(|i: usize| levered[i] + couple[i]);
        // Friction alone: the pressure's normals meet the axle.
        let friction = [fx, fs * cos, fs * sin];
        let turning = cross([x, lever[0], lever[1]], friction);
        let turning = [turning[0], turning[1] - mz * sin, turning[2] + mz * cos];
        let (sin_yaw, cos_yaw) = asked.yaw;
        let axis = [-sin_yaw, cos_yaw * cos_roll, cos_yaw * sin_roll];
        let axle = turning[0] * axis[0] + turning[1] * axis[1] + turning[2] * axis[2];
        let report = Report {
            share: share.value(),
            reference: [x.value(), y.value(), z.value()],
            angle: angle.value(),
            creepage: creepage.map(Scalar::value),
            friction: [fx, fs, mz].map(Scalar::value),
            peak_pressure: geometry.peak_pressure,
            area: geometry.area,
        };
        Self { force, moment, axle, report }
    }
}

pub(crate) fn cross<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Dual;

    /// Where the force meets the bend neither it nor its slope jumps, and it stays below one.
    #[test]
    fn a_force_is_kept_below_its_bound() {
        let length = |at: f64| {
            let x = Dual::<1>::variable(at, 0);
            let [x, y] = bounded([x * 0.6, x * 0.8]);
            (x * x + y * y).sqrt()
        };
        let (before, after) = (length(1.0 - BEND - 1e-9), length(1.0 - BEND + 1e-9));
        assert!((before.v - after.v).abs() < 3e-9 && (before.d[0] - after.d[0]).abs() < 1e-5);
        for at in [0.999_5, 1.0, 1.01, 5.0] {
            assert!(length(at).v < 1.0 && length(at).d[0] > 0.0);
        }
    }
}
