//! Surfaces of wheel and rail over the contact plane, on the right-hand image of their side.

use crate::Across;
use crate::curve::CurvePoint;
use crate::frame::Frame;
use crate::meeting::WheelRailPair;

/// A point of the wheel's surface: arc length of its profile, angle around the axle (rad).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Foot {
    along: f64,
    around: f64,
}

impl Foot {
    /// Arc length of the wheel's profile (m).
    pub(crate) fn along(&self) -> f64 {
        self.along
    }
}

/// A pair seen from its contact plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Surfaces<'a> {
    pub(crate) pair: WheelRailPair<'a>,
    pub(crate) frame: Frame,
    /// Arc length of the wheel's profile near the contact.
    pub(crate) start: f64,
}

impl Surfaces<'_> {
    /// The bodies at lateral place `s`, the gap as it is.
    pub(crate) fn at(&self, s: f64) -> Option<(Foot, Across)> {
        let place = |along: f64| {
            let outline = self.pair.posed.outline(along)?;
            Some(self.frame.lateral_part([outline.y, outline.z]) - s)
        };
        // Secants; along the wheel's profile the place falls at about unit rate.
        let mut excess = place(self.start)?;
        let (mut before, mut here) = (self.start, self.start + excess);
        for _ in 0..30 {
            let found = place(here)?;
            if found.abs() < 1e-13 || (found - excess).abs() < f64::EPSILON * found.abs() {
                break;
            }
            let step = -found * (here - before) / (found - excess);
            (before, excess) = (here, found);
            here += step.clamp(-2e-3, 2e-3);
        }
        self.below(here).filter(|(_, across)| (across.s - s).abs() < 1e-10)
    }

    /// The bodies where the outline's point at arc length `along` of the wheel's profile lies.
    pub(crate) fn below(&self, along: f64) -> Option<(Foot, Across)> {
        let wheel = self.pair.posed.wheel.profile().curve().at(along);
        let outline = self.pair.posed.outline_at(along, wheel)?;
        let place = [outline.y, outline.z];
        let s = self.frame.lateral_part(place);
        let (rail_s, rail) = self.rail(s)?;
        let bend = self.bend(wheel, outline.around) / self.frame.facing(outline.slope);
        let apart = self.frame.normal_part([rail.y, rail.z]) - self.frame.normal_part(place);
        let across = Across {
            s,
            x: outline.x - self.frame.x(),
            gap: apart,
            rolling_radius: 1.0 / bend,
            tilt: self.frame.tilt(rail.tangent),
            y_rail: self.pair.rail.profile().curve().at(rail_s).y,
            y_wheel: wheel.y,
        };
        Some((Foot { along, around: outline.around }, across))
    }

    /// Curvature of the wheel's surface along the track (Euler's formula).
    fn bend(&self, wheel: CurvePoint, around: f64) -> f64 {
        let (sin, cos) = around.sin_cos();
        let along = self.pair.posed.turned([cos, 0.0, -sin])[0];
        let round = wheel.normal()[1] / (self.pair.posed.wheel.radius() + wheel.z);
        round * along * along + wheel.curvature * (1.0 - along * along)
    }

    /// The rail's arc length and point at lateral place `s`, by Newton's method.
    pub(crate) fn rail(&self, s: f64) -> Option<(f64, CurvePoint)> {
        let length = self.pair.rail.profile().curve().length();
        let mut along = self.frame.rail_s() + s;
        for _ in 0..30 {
            let point = self.pair.rail.at(along);
            let excess = self.frame.lateral_part([point.y, point.z]) - s;
            let facing = self.frame.facing_tangent(point.tangent);
            if facing < 0.05 {
                return None;
            }
            if excess.abs() < 1e-14 {
                return (0.0..=length).contains(&along).then_some((along, point));
            }
            along -= excess / facing;
        }
        None
    }

    /// The wheel's point at `(x, s)` by Newton's method from a point nearby.
    pub(crate) fn wheel(&self, from: Foot, x: f64, s: f64) -> Option<(Foot, [f64; 3])> {
        let curve = self.pair.posed.wheel.profile().curve();
        let Foot { mut along, mut around } = from;
        for _ in 0..30 {
            let point = curve.at(along);
            let [px, py, pz] = self.pair.posed.surface(point, around);
            let miss = [px - self.frame.x() - x, self.frame.lateral_part([py, pz]) - s];
            if miss[0].abs().max(miss[1].abs()) < 1e-13 {
                return Some((Foot { along, around }, [px, py, pz]));
            }
            let [by_s, by_angle] = self.pair.posed.tangents(point, around);
            let column = |d: [f64; 3]| [d[0], self.frame.facing_tangent([d[1], d[2]])];
            let (a, b) = (column(by_s), column(by_angle));
            let determinant = a[0] * b[1] - a[1] * b[0];
            along -= (miss[0] * b[1] - miss[1] * b[0]) / determinant;
            around -= (a[0] * miss[1] - a[1] * miss[0]) / determinant;
            if !(along >= 0.0 && along <= curve.length() && around.abs() < 1.5) {
                return None;
            }
        }
        None
    }
}
