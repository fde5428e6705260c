//! One place of contact: its plane, the undeformed distance over it, its extent.

use crate::curve::CurvePoint;
use crate::frame::Frame;
use crate::meeting::{Meeting, Overlap, Pair};
use crate::search::least;
use crate::{GeometryError, Side};

/// Points at which an overlap is weighed.
const POINTS: usize = 64;

/// A place of contact in the plane through its reference point, tilted by its angle.
///
/// Axes in the plane: `x` forward, `s = (cos angle, sin angle)` in the track's `(y, z)`; the
/// normal `n = (-sin angle, cos angle)` points into the rail. The reference point is the centre
/// of the overlap of the undeformed bodies, weighed by its vertical depth squared, on the rail;
/// the angle is the rail's, weighed alike. Both go smoothly with the position.
#[derive(Debug, Clone, Copy)]
pub struct Contact<'a> {
    /// Side of the track.
    pub side: Side,
    /// The reference point in track axes (m).
    pub reference: [f64; 3],
    /// Rotation about `x` from the track's `z` to the normal into the rail (rad).
    pub angle: f64,
    /// `y` of the reference point in the rail's and of the wheel's point below it in the wheel's
    /// profile (m), to the field side.
    pub y_rail: f64,
    /// See [`Contact::y_rail`].
    pub y_wheel: f64,
    /// Greatest depth (m) of the overlap along the normal.
    pub approach: f64,
    /// Extent of the overlap along `x` and along `s` (m), from the reference point: the area of
    /// contact lies inside.
    pub extent: [[f64; 2]; 2],
    pub(crate) pair: Pair<'a>,
    pub(crate) frame: Frame,
    overlap: Overlap,
}

/// The undeformed bodies at one lateral place of the contact plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Across {
    /// Lateral place in the plane (m).
    pub s: f64,
    /// Where along `x` the gap is least (m).
    pub x: f64,
    /// The gap there, 0 where the overlap is deepest (m).
    pub gap: f64,
    /// `R` (m) of `gap + (x - x_0)^2 / (2 R)`.
    pub rolling_radius: f64,
    /// Angle of the rail's surface against the plane (rad), in the sense of [`Contact::angle`].
    pub tilt: f64,
    /// `y` in the rail's and in the wheel's profile (m), to the field side.
    pub y_rail: f64,
    /// See [`Across::y_rail`].
    pub y_wheel: f64,
}

impl<'a> Contact<'a> {
    /// The contact on an overlap; `None` where the overlap has no depth.
    pub(crate) fn of(
        side: Side,
        pair: Pair<'a>,
        overlap: Overlap,
    ) -> Result<Option<Self>, GeometryError> {
        if let Some(y) = overlap.end {
            return Err(GeometryError::End { side, y: side.sense() * y });
        }
        let Some([x, y, angle]) = centre(&pair, overlap) else { return Ok(None) };
        let Some((rail_s, point)) = pair.rail.at_y(y) else { return Ok(None) };
        let frame = Frame::new(x, point, rail_s, angle);
        let mut contact = Self {
            side,
            reference: [x, side.sense() * y, point.z],
            angle: side.sense() * angle,
            y_rail: pair.rail.profile().curve().at(rail_s).y,
            y_wheel: 0.0,
            approach: 0.0,
            extent: [[0.0; 2]; 2],
            pair,
            frame,
            overlap,
        };
        contact.measure();
        Ok((contact.approach > 0.0).then_some(contact))
    }

    /// Approach, extent and the wheel's place.
    fn measure(&mut self) {
        let places: Vec<Across> = spread(self.overlap, POINTS)
            .filter_map(|wheel_s| self.pair.posed.outline(wheel_s))
            .filter_map(|outline| self.across(outline.s))
            .collect();
        let lowest = places.iter().min_by(|a, b| a.gap.total_cmp(&b.gap)).map_or(0.0, |p| p.s);
        let spacing = (self.overlap.to - self.overlap.from) / POINTS as f64;
        let raw = |s: f64| self.raw(s).map_or(f64::INFINITY, |across| across.gap);
        self.approach = -raw(least(raw, [lowest - 2.0 * spacing, lowest + 2.0 * spacing]));
        self.y_wheel = self.raw(0.0).map_or(f64::NAN, |across| across.y_wheel);
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for place in places.iter().filter(|place| place.gap < 0.0) {
            let half = (-2.0 * place.rolling_radius * place.gap).max(0.0).sqrt();
            extent[0] = [extent[0][0].min(place.x - half), extent[0][1].max(place.x + half)];
            extent[1] = [extent[1][0].min(place.s - spacing), extent[1][1].max(place.s + spacing)];
        }
        self.extent = extent;
        if self.side == Side::Left {
            self.extent[1] = [-extent[1][1], -extent[1][0]];
        }
    }

    /// The undeformed bodies at lateral place `s` (m) of the contact plane.
    ///
    /// `None` beyond the profiles, or where the rail's surface or the wheel's turns away.
    #[must_use]
    pub fn at(&self, s: f64) -> Option<Across> {
        let sense = self.side.sense();
        let raw = self.raw(sense * s)?;
        Some(Across { s, gap: raw.gap + self.approach, tilt: sense * raw.tilt, ..raw })
    }

    /// `count` even places across, over the extent widened by `margin` of itself on both sides.
    #[must_use]
    pub fn section(&self, count: usize, margin: f64) -> Vec<Across> {
        let [from, to] = self.extent[1];
        let wide = margin * (to - from);
        let spacing = (to - from + 2.0 * wide) / count.saturating_sub(1).max(1) as f64;
        (0..count).filter_map(|i| self.at(from - wide + i as f64 * spacing)).collect()
    }

    /// The undeformed distance (m) at `(x, s)` (m) of the contact plane, exactly; 0 where the
    /// overlap is deepest.
    ///
    /// `None` beyond the profiles, or where a surface turns away.
    #[must_use]
    pub fn gap(&self, x: f64, s: f64) -> Option<f64> {
        let local = self.side.sense() * s;
        let (_, rail) = self.rail(local)?;
        let [_, y, z] = self.wheel(x, local)?;
        let apart = self.frame.normal_part([rail.y, rail.z]) - self.frame.normal_part([y, z]);
        Some(apart + self.approach)
    }

    /// The wheel's point at `(x, s)` and the rail's tangent below it, on the right-hand image.
    pub(crate) fn facing_points(&self, x: f64, s: f64) -> Option<[[f64; 3]; 2]> {
        let [ty, tz] = self.rail(s)?.1.tangent;
        Some([self.wheel(x, s)?, [0.0, ty, tz]])
    }

    /// [`Contact::at`] on the right-hand image, without the approach.
    fn raw(&self, s: f64) -> Option<Across> {
        let middle = self.overlap.from.midpoint(self.overlap.to);
        let place = |wheel_s: f64| {
            let outline = self.pair.posed.outline(wheel_s)?;
            Some(self.frame.lateral_part([outline.y, outline.z]))
        };
        // Secants; along the wheel's profile `s` falls at about unit rate.
        let (mut before, mut here) = (middle, middle + place(middle)? - s);
        let mut excess = place(before)? - s;
        for _ in 0..30 {
            let found = place(here)? - s;
            if found.abs() < 1e-13 || (found - excess).abs() < f64::EPSILON * found.abs() {
                break;
            }
            let step = -found * (here - before) / (found - excess);
            (before, excess) = (here, found);
            here += step.clamp(-2e-3, 2e-3);
        }
        self.across(here).filter(|across| (across.s - s).abs() < 1e-10)
    }

    /// The place at which the outline's point at `wheel_s` lies.
    fn across(&self, wheel_s: f64) -> Option<Across> {
        let outline = self.pair.posed.outline(wheel_s)?;
        let s = self.frame.lateral_part([outline.y, outline.z]);
        let (rail_s, rail) = self.rail(s)?;
        let wheel = self.pair.posed.wheel.profile().curve().at(wheel_s);
        let bend = self.bend(wheel, outline.around) / self.frame.facing(outline.slope);
        let apart = self.frame.normal_part([rail.y, rail.z])
            - self.frame.normal_part([outline.y, outline.z]);
        Some(Across {
            s,
            x: outline.x - self.frame.x(),
            gap: apart,
            rolling_radius: 1.0 / bend,
            tilt: self.frame.tilt(rail.tangent),
            y_rail: self.pair.rail.profile().curve().at(rail_s).y,
            y_wheel: wheel.y,
        })
    }

    /// Curvature of the wheel's surface along the track (Euler's formula).
    fn bend(&self, wheel: CurvePoint, around: f64) -> f64 {
        let (sin, cos) = around.sin_cos();
        let along = self.pair.posed.turned([cos, 0.0, -sin])[0];
        let round = wheel.normal()[1] / (self.pair.posed.wheel.radius() + wheel.z);
        round * along * along + wheel.curvature * (1.0 - along * along)
    }

    /// The rail's arc length and point at lateral place `s`, by Newton's method.
    fn rail(&self, s: f64) -> Option<(f64, CurvePoint)> {
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

    /// The wheel's surface at `(x, s)` by Newton's method over its profile and its angle.
    fn wheel(&self, x: f64, s: f64) -> Option<[f64; 3]> {
        let start = self.raw(s)?;
        let curve = self.pair.posed.wheel.profile().curve();
        let mut along = self.overlap.from.midpoint(self.overlap.to);
        along += self.pair.posed.outline(along).map(|o| self.frame.lateral_part([o.y, o.z]))? - s;
        let mut around = self.pair.posed.outline(along)?.around;
        around += (x - start.x) / self.pair.posed.wheel.radius();
        for _ in 0..30 {
            let point = curve.at(along);
            let [px, py, pz] = self.pair.posed.surface(point, around);
            let [by_s, by_angle] = self.pair.posed.tangents(point, around);
            let miss = [px - self.frame.x() - x, self.frame.lateral_part([py, pz]) - s];
            let column = |d: [f64; 3]| [d[0], self.frame.facing_tangent([d[1], d[2]])];
            let (a, b) = (column(by_s), column(by_angle));
            let determinant = a[0] * b[1] - a[1] * b[0];
            along -= (miss[0] * b[1] - miss[1] * b[0]) / determinant;
            around -= (a[0] * miss[1] - a[1] * miss[0]) / determinant;
            if miss[0].abs().max(miss[1].abs()) < 1e-13 {
                return Some([px, py, pz]);
            }
            if !(along >= 0.0 && along <= curve.length() && around.abs() < 1.5) {
                return None;
            }
        }
        None
    }
}

/// Middle points of even parts of an overlap.
fn spread(overlap: Overlap, count: usize) -> impl Iterator<Item = f64> {
    let part = (overlap.to - overlap.from) / count as f64;
    (0..count).map(move |i| overlap.from + (i as f64 + 0.5) * part)
}

/// `x` and `y` of the overlap's centre and the rail's mean angle over it: each place counts by the integral of its depth squared
/// along `x`, which goes as the 5/2th power of the depth on the locus.
fn centre(pair: &Pair, overlap: Overlap) -> Option<[f64; 3]> {
    let part = (overlap.to - overlap.from) / POINTS as f64;
    let places = (0..=POINTS).map(|i| pair.meeting(overlap.from + i as f64 * part));
    let places: Option<Vec<Meeting>> = places.collect();
    let mut sums = [0.0; 4];
    // At both ends the depth is nought.
    for three in places?.windows(3) {
        let [before, Meeting { outline, rail, .. }, after] = three else { continue };
        let depth = (outline.z - rail.z).max(0.0);
        let weight = depth.powf(2.5) * (before.outline.y - after.outline.y).abs();
        let angle = rail.tangent[1].atan2(rail.tangent[0]);
        let parts = [1.0, outline.x, outline.y, angle].map(|part| weight * part);
        sums = [0, 1, 2, 3].map(|i| sums[i] + parts[i]);
    }
    let [total, x, y, angle] = sums;
    (total > 0.0).then(|| [x, y, angle].map(|sum| sum / total))
}
