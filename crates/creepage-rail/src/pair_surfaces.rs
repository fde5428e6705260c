//! Points of a wheel and a rail that vary along rolling, on the right-hand image of their side.

use crate::meeting::WheelRailPair;
use crate::track::Rail;
use crate::wheel::Posed;

/// Steps of Newton's method.
const MAX_NEWTON_STEPS: usize = 30;

/// A point of a surface with its derivatives by two parameters.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PatchPoint {
    pub(crate) place: [f64; 3],
    pub(crate) by: [[f64; 3]; 2],
    /// The profile's `y` (m).
    pub(crate) y: f64,
}

/// The rail below a place: its parameter, height, and slopes along and across the track.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RailBelow {
    pub(crate) v: f64,
    pub(crate) z: f64,
    pub(crate) slope: [f64; 2],
}

impl Posed<'_> {
    /// The wheel's point at its parameter `v` and the angle `b` from straight down towards `+x`; derivatives by
    /// both.
    pub(crate) fn varying(&self, v: f64, b: f64) -> Option<PatchPoint> {
        let th = b + self.pitch;
        let wheel = self.wheel;
        let (y, z, by_v, mut by_th) = if let Some(slices) = wheel.slices() {
            let point = slices.at(v, th)?;
            (point.place[0], point.place[1], point.by_v, point.by_u)
        } else {
            let point = wheel.profile().curve().at(v);
            (point.y, point.z, point.tangent, [0.0; 2])
        };
        let [dr, dr_th] = wheel.radial(th);
        by_th[1] += dr_th;
        let radius = wheel.radius() + z + dr;
        let (sin, cos) = b.sin_cos();
        let turned = self.turned([radius * sin, self.arm() + y, radius * cos]);
        let by = [
            self.turned([by_v[1] * sin, by_v[0], by_v[1] * cos]),
            self.turned([radius * cos + by_th[1] * sin, by_th[0], by_th[1] * cos - radius * sin]),
        ];
        let place = [0, 1, 2].map(|i: usize| turned[i] + self.centre[i]);
        Some(PatchPoint { place, by, y })
    }

    /// Distance of a place from the axle (m).
    pub(crate) fn distance_from_axle(&self, place: [f64; 3]) -> f64 {
        let from = [0, 1, 2].map(|i: usize| place[i] - self.centre[i]);
        let along = dot(from, self.turned([0.0, 1.0, 0.0]));
        (dot(from, from) - along * along).max(0.0).sqrt()
    }
}

impl Rail {
    /// The rail's point at its parameter `v` and the place `u` along the track, its `x` taken for 0; derivatives
    /// by both.
    pub(crate) fn varying(&self, v: f64, u: f64) -> Option<PatchPoint> {
        let [dz, dz_u] = self.down(u);
        let (place, by_v, mut by_u, y) = if let Some(slices) = self.slices() {
            let point = slices.at(v, u)?;
            let place = self.placed(point.place);
            (place, self.rotated(point.by_v), self.rotated(point.by_u), point.place[0])
        } else {
            let own = self.profile().curve().at(v);
            let point = self.at(v);
            ([point.y, point.z], point.tangent, [0.0; 2], own.y)
        };
        by_u[1] += dz_u;
        if let Some(roller) = self.roller() {
            let [z, by_x, by_z] = roller.at(u, place[1])?;
            let by = [[0.0, by_v[0], by_z * by_v[1]], [1.0, 0.0, by_x]];
            return Some(PatchPoint { place: [0.0, place[0], z], by, y });
        }
        let by = [[0.0, by_v[0], by_v[1]], [1.0, by_u[0], by_u[1]]];
        Some(PatchPoint { place: [0.0, place[0], place[1] + dz], by, y })
    }

    /// The highest place of the rail at `u` along the track and `y` across; `None` beyond its profile.
    pub(crate) fn below(&self, u: f64, y: f64) -> Option<RailBelow> {
        let Some(slices) = self.slices() else {
            let [dz, dz_u] = self.down(u);
            let (v, point) = self.at_y(y)?;
            let across = point.tangent[1] / point.tangent[0];
            if let Some(roller) = self.roller() {
                let [z, along, by_z] = roller.at(u, point.z)?;
                return Some(RailBelow { v, z, slope: [along, by_z * across] });
            }
            return Some(RailBelow { v, z: point.z + dz, slope: [dz_u, across] });
        };
        let mut best: Option<RailBelow> = None;
        self.seeds(u, y, |seed| {
            let known = best.is_some_and(|best| (best.v - seed).abs() < 1e-4);
            if known {
                return;
            }
            let mut v = seed;
            for _ in 0..MAX_NEWTON_STEPS {
                let Some(point) = self.varying(v, u) else { return };
                let [_, y_v, z_v] = point.by[0];
                let excess = point.place[1] - y;
                if y_v < 1e-3 {
                    return;
                }
                if excess.abs() < 1e-13 {
                    let is_there = slices.holds(v, u);
                    let z = point.place[2];
                    if is_there && best.is_none_or(|best| z < best.z) {
                        let [_, y_u, z_u] = point.by[1];
                        let across = z_v / y_v;
                        best = Some(RailBelow { v, z, slope: [z_u - across * y_u, across] });
                    }
                    return;
                }
                v -= (excess / y_v).clamp(-5e-3, 5e-3);
            }
        });
        best
    }
}

impl WheelRailPair<'_> {
    /// Whether wheel or rail vary along rolling.
    pub(crate) fn varies(&self) -> bool {
        self.posed.wheel.varies() || self.rail.varies()
    }

    /// The vertical gap below the wheel's point (m), with its derivatives by both parameters of the wheel.
    pub(crate) fn vertical_gap(
        &self,
        v: f64,
        b: f64,
    ) -> Option<(f64, [f64; 2], PatchPoint, RailBelow)> {
        let wheel = self.posed.varying(v, b)?;
        let [x, y, z] = wheel.place;
        let rail = self.rail.below(self.s + x, y)?;
        let by = wheel.by.map(|d| rail.slope[0] * d[0] + rail.slope[1] * d[1] - d[2]);
        Some((rail.z - z, by, wheel, rail))
    }
}

/// A plane with axes along and across rolling and its normal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    pub(crate) origin: [f64; 3],
    pub(crate) axes: [[f64; 3]; 3],
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Plane {
    /// Through `origin`, turned by `angle` about `x` and then by `slope` about its own `s`, which lowers what lies
    /// ahead.
    pub(crate) fn new(origin: [f64; 3], angle: f64, slope: f64) -> Self {
        let ((sin, cos), (dip, level)) = (angle.sin_cos(), slope.sin_cos());
        let axes =
            [[level, -sin * dip, cos * dip], [0.0, cos, sin], [-dip, -sin * level, cos * level]];
        Self { origin, axes }
    }

    /// Coordinates of a place in the plane's axes.
    pub(crate) fn of(&self, place: [f64; 3]) -> [f64; 3] {
        let from = [0, 1, 2].map(|i: usize| place[i] - self.origin[i]);
        self.axes.map(|axis| dot(axis, from))
    }

    /// The parameters at which a surface lies over `(x, s)` of the plane, from nearby ones, and the point there.
    pub(crate) fn foot(
        &self,
        [x, s]: [f64; 2],
        from: [f64; 2],
        surface: impl Fn([f64; 2]) -> Option<PatchPoint>,
    ) -> Option<([f64; 2], PatchPoint)> {
        let mut at = from;
        for _ in 0..MAX_NEWTON_STEPS {
            let point = surface(at)?;
            let [px, ps, _] = self.of(point.place);
            let miss = [px - x, ps - s];
            if miss[0].abs().max(miss[1].abs()) < 1e-12 {
                return Some((at, point));
            }
            let [a, b] = point.by.map(|d| [dot(self.axes[0], d), dot(self.axes[1], d)]);
            let determinant = a[0] * b[1] - a[1] * b[0];
            at[0] -= ((miss[0] * b[1] - miss[1] * b[0]) / determinant).clamp(-5e-3, 5e-3);
            at[1] -= (a[0] * miss[1] - a[1] * miss[0]) / determinant;
            if !(at[0].is_finite() && at[1].is_finite()) {
                return None;
            }
        }
        None
    }
}

/// Directions in track axes of a contact plane's `x` and `s` and of its normal into the rail, for
/// [`Contact::angle`](crate::Contact::angle) and [`Contact::slope`](crate::Contact::slope) (rad).
///
/// ```
/// // On a ramp that rises by 1:10 the normal leans forward: pressure pushes the rail ahead.
/// let [along, _, normal] = creepage_rail::contact_axes(0.0, -0.1f64.atan());
/// assert!((normal[0] / normal[2] - 0.1).abs() < 1e-12 && along[2] < 0.0);
/// ```
#[must_use]
pub fn contact_axes(angle: f64, slope: f64) -> [[f64; 3]; 3] {
    Plane::new([0.0; 3], angle, slope).axes
}
