//! Contact of a wheel and a rail: its plane, the undeformed distance over it, its extent.

use crate::frame::Frame;
use crate::meeting::{Meeting, Overlap, WheelRailPair};
use crate::search::least;
use crate::surfaces::{Foot, Surfaces};
use crate::varying_contact::VaryingSurfaces;
use crate::{GeometryError, Profile, Role, Side, Waves};

/// Points at which an overlap is weighed.
const OVERLAP_POINTS: usize = 64;
/// Overlaps less deep (m) may come to nothing.
const MIN_DEPTH: f64 = 1e-9;

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
    /// Turn about `s`, after that about `x`, which lowers the plane ahead (rad): 0 unless surfaces vary along
    /// rolling. `x` of the plane points ahead along it, and the normal `n` is turned with it.
    pub slope: f64,
    /// Whether a part of a rail begins or ends within the overlap: the area of contact is cut there.
    pub is_cut: bool,
    /// Whether it lies beyond the rail's slices, where the surface is taken to go on alike.
    pub is_beyond: bool,
    /// Whether it lies on the guard rail: then the rail is that one, here and in [`Contact::y_rail`].
    pub is_on_guard: bool,
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
    pub(crate) surfaces: Surfaces<'a>,
    /// Both surfaces where they vary along rolling.
    pub(crate) varying: Option<VaryingSurfaces>,
}

/// Undeformed bodies at one lateral place of the contact plane.
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
    /// The contact on an overlap; `None` where the bodies hardly touch.
    pub(crate) fn of(
        side: Side,
        pair: WheelRailPair<'a>,
        overlap: Overlap,
    ) -> Result<Option<Self>, GeometryError> {
        let end = |y: f64| GeometryError::End { side, y: side.sense() * y };
        if let Some(y) = overlap.end {
            return Err(end(y));
        }
        let Some(Centre { x, y, angle, depth }) = Centre::of(&pair, overlap) else {
            return Ok(None);
        };
        let (rail_s, point) = pair.rail.at_y(y).ok_or(end(y))?;
        let frame = Frame::new(x, point, rail_s, angle);
        let start = overlap.from.midpoint(overlap.to);
        let mut contact = Self {
            side,
            reference: [x, side.sense() * y, point.z],
            angle: side.sense() * angle,
            slope: 0.0,
            is_cut: false,
            is_beyond: false,
            is_on_guard: pair.is_guard,
            y_rail: pair.rail.profile().curve().at(rail_s).y,
            y_wheel: 0.0,
            approach: 0.0,
            extent: [[0.0; 2]; 2],
            surfaces: Surfaces { pair, frame, start },
            varying: None,
        };
        contact.measure(overlap).ok_or(end(y))?;
        let touches = contact.approach > 0.0;
        (touches || depth < MIN_DEPTH).then_some(touches.then_some(contact)).ok_or(end(y))
    }

    /// Approach, extent and the wheel's place; `None` where the surfaces turn away.
    fn measure(&mut self, overlap: Overlap) -> Option<()> {
        let across = |along: f64| Some(self.surfaces.below(along)?.1);
        let places: Vec<(f64, Across)> = spread(overlap, OVERLAP_POINTS)
            .filter_map(|along| Some((along, across(along)?)))
            .collect();
        let lowest = places.iter().min_by(|a, b| a.1.gap.total_cmp(&b.1.gap))?.0;
        let spacing = (overlap.to - overlap.from) / OVERLAP_POINTS as f64;
        let gap = |along: f64| across(along).map_or(f64::INFINITY, |across| across.gap);
        self.approach = -gap(least(gap, [lowest - 2.0 * spacing, lowest + 2.0 * spacing]));
        self.y_wheel = self.surfaces.at(0.0)?.1.y_wheel;
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for (_, place) in places.iter().filter(|(_, place)| place.gap < 0.0) {
            let half = (-2.0 * place.rolling_radius * place.gap).max(0.0).sqrt();
            extent[0] = [extent[0][0].min(place.x - half), extent[0][1].max(place.x + half)];
            extent[1] = [extent[1][0].min(place.s - spacing), extent[1][1].max(place.s + spacing)];
        }
        self.extent = extent;
        if self.side == Side::Left {
            self.extent[1] = [-extent[1][1], -extent[1][0]];
        }
        Some(())
    }

    /// The undeformed bodies at lateral place `s` (m) of the contact plane.
    ///
    /// `None` beyond the profiles, or where the rail's surface or the wheel's turns away.
    #[must_use]
    pub fn at(&self, s: f64) -> Option<Across> {
        if let Some(over) = &self.varying {
            return self.varying_at(over, s);
        }
        let (_, raw) = self.surfaces.at(self.side.sense() * s)?;
        Some(Across { s, ..self.sided(raw) })
    }

    /// What surfaces of the right-hand image tell, of this side.
    fn sided(&self, raw: Across) -> Across {
        let sense = self.side.sense();
        Across { s: sense * raw.s, gap: raw.gap + self.approach, tilt: sense * raw.tilt, ..raw }
    }

    /// `count` places across, from low to high `s` and even along the wheel's profile, over the extent
    /// widened by `margin` of itself on both sides; those beyond a profile's end are left out.
    #[must_use]
    pub fn section(&self, count: usize, margin: f64) -> Vec<Across> {
        let [from, to] = self.extent[1];
        let wide = margin * (to - from);
        let ends = [from - wide, to + wide];
        let parts = (0..count).map(|i| i as f64 / count.saturating_sub(1).max(1) as f64);
        if self.varies() {
            return parts
                .filter_map(|part| self.at(ends[0] + part * (ends[1] - ends[0])))
                .collect();
        }
        let foot = |s: f64| Some(self.surfaces.at(self.side.sense() * s)?.0.along());
        let [Some(first), Some(last)] = ends.map(foot) else {
            return parts
                .filter_map(|part| self.at(ends[0] + part * (ends[1] - ends[0])))
                .collect();
        };
        parts
            .filter_map(|part| self.surfaces.below(first + part * (last - first)))
            .map(|(_, raw)| self.sided(raw))
            .collect()
    }

    /// Waves of the wheel's or the rail's profile from `s` to `s` (m) of the contact plane, nearly,
    /// that turn it by more than `least` (rad) to and fro; `None` without a whole one.
    #[must_use]
    pub fn waves(&self, role: Role, stretch: [f64; 2], least: f64) -> Option<Waves> {
        let (profile, stretch) = self.profile_along(role, stretch)?;
        Waves::of(profile.curve(), stretch, least)
    }

    /// [`Profile::unmeasured`] of the wheel or the rail from `s` to `s` (m) of the contact plane, nearly.
    #[must_use]
    pub fn unmeasured(&self, role: Role, stretch: [f64; 2]) -> Option<f64> {
        let (profile, stretch) = self.profile_along(role, stretch)?;
        profile.unmeasured(stretch)
    }

    /// The profile, and where on it (arc lengths, m) a stretch of the contact plane lies. Of slices there is no one
    /// profile.
    fn profile_along(&self, role: Role, stretch: [f64; 2]) -> Option<(&Profile, [f64; 2])> {
        let WheelRailPair { posed, rail, .. } = &self.surfaces.pair;
        if posed.wheel.slices().or(rail.slices()).is_some() {
            return None;
        }
        let [one, other] = stretch.map(|s| self.side.sense() * s);
        let (low, high) = (one.min(other), one.max(other));
        match role {
            Role::Rail => {
                let at = self.surfaces.frame.rail_s();
                Some((rail.profile(), [at + low, at + high]))
            }
            Role::Wheel => {
                let at = match &self.varying {
                    Some(over) => over.wheel_parameter(),
                    None => self.surfaces.at(0.0)?.0.along(),
                };
                // Its arc length falls as `s` grows.
                Some((posed.wheel.profile(), [at - high, at - low]))
            }
        }
    }

    /// The undeformed distance (m) at `(x, s)` (m) of the contact plane, exactly; 0 where the
    /// overlap is deepest.
    ///
    /// `None` beyond the profiles, or where a surface turns away.
    #[must_use]
    pub fn gap(&self, x: f64, s: f64) -> Option<f64> {
        self.row(s, &[x])?.first().copied()
    }

    /// [`Contact::gap`] at several `x` and one `s`: quick where neighbours lie close.
    #[must_use]
    pub fn row(&self, s: f64, x: &[f64]) -> Option<Vec<f64>> {
        if let Some(over) = &self.varying {
            return self.varying_row(over, s, x);
        }
        let local = self.side.sense() * s;
        let (mut foot, _) = self.surfaces.at(local)?;
        let (_, rail) = self.surfaces.rail(local)?;
        let frame = &self.surfaces.frame;
        let under = frame.normal_part([rail.y, rail.z]) + self.approach;
        let gaps = x.iter().map(|&x| {
            let (reached, [_, y, z]) = self.surfaces.wheel(foot, x, local)?;
            foot = reached;
            Some(under - frame.normal_part([y, z]))
        });
        gaps.collect()
    }

    /// What the undeformed distance at `(x_0(s) + d, s)` has beyond `gap + d^2 / (2 R)` of [`Across`] (m), in
    /// rows of one `s`: the profile of a yawed wheel passes under a line along `x`, so that on a flange the
    /// section along it is no parabola. `d` increases and has a place on either side of 0.
    ///
    /// Where a surface turns away, or the profile ends, the last value goes on. `None` where a place `s` has no
    /// contact of its own.
    #[must_use]
    pub fn beyond_parabola(&self, s: &[f64], d: &[f64]) -> Option<Vec<f64>> {
        let ahead = d.partition_point(|d| *d < 0.0);
        let mut excess = vec![0.0; s.len() * d.len()];
        for (row, &s) in excess.chunks_mut(d.len().max(1)).zip(s) {
            let local = self.side.sense() * s;
            let (foot, raw) = self.surfaces.at(local)?;
            let (_, rail) = self.surfaces.rail(local)?;
            let under = self.surfaces.frame.normal_part([rail.y, rail.z]);
            let (mut reached, mut last) = (foot, 0.0);
            let at = |reached: &mut Foot, last: &mut f64, d: f64| {
                if let Some((foot, [_, y, z])) = self.surfaces.wheel(*reached, raw.x + d, local) {
                    let gap = under - self.surfaces.frame.normal_part([y, z]);
                    *last = gap - raw.gap - d * d / (2.0 * raw.rolling_radius);
                    *reached = foot;
                }
                *last
            };
            for i in (0..ahead).rev() {
                row[i] = at(&mut reached, &mut last, d[i]);
            }
            (reached, last) = (foot, 0.0);
            for i in ahead..d.len() {
                row[i] = at(&mut reached, &mut last, d[i]);
            }
        }
        Some(excess)
    }

    /// Turn of its rail's profile against its own axes (rad), on a right-hand rail: [`Rail::inclination`](crate::Rail::inclination).
    #[must_use]
    pub fn rail_inclination(&self) -> f64 {
        self.surfaces.pair.rail.inclination()
    }

    /// The wheel's point at `(x, s)` and the rail's tangents below it, along and across, on the right-hand image.
    pub(crate) fn facing_points(&self, x: f64, s: f64) -> Option<[[f64; 3]; 3]> {
        if let Some(over) = &self.varying {
            return self.varying_points(over, x, s);
        }
        let [ty, tz] = self.surfaces.rail(s)?.1.tangent;
        let (foot, _) = self.surfaces.at(s)?;
        Some([self.surfaces.wheel(foot, x, s)?.1, [1.0, 0.0, 0.0], [0.0, ty, tz]])
    }
}

/// Middle points of even parts of an overlap.
fn spread(overlap: Overlap, count: usize) -> impl Iterator<Item = f64> {
    let part = (overlap.to - overlap.from) / count as f64;
    (0..count).map(move |i| overlap.from + (i as f64 + 0.5) * part)
}

/// The middle of an overlap, on the right-hand image.
struct Centre {
    x: f64,
    y: f64,
    /// The rail's mean angle.
    angle: f64,
    /// The greatest vertical depth.
    depth: f64,
}

impl Centre {
    /// Each place counts by the integral of its depth squared along `x`, which goes as the 5/2th
    /// power of the depth on the locus.
    fn of(pair: &WheelRailPair, overlap: Overlap) -> Option<Self> {
        let part = (overlap.to - overlap.from) / OVERLAP_POINTS as f64;
        let places =
            (0..=OVERLAP_POINTS).filter_map(|i| pair.meeting(overlap.from + i as f64 * part));
        let places: Vec<Meeting> = places.collect();
        let (mut sums, mut deepest) = ([0.0; 4], 0.0f64);
        // At both ends the depth is nought.
        for three in places.windows(3) {
            let [before, Meeting { outline, rail, .. }, after] = three else { continue };
            let depth = (outline.z - rail.z).max(0.0);
            deepest = deepest.max(depth);
            let weight = depth.powf(2.5) * (before.outline.y - after.outline.y).abs();
            let angle = rail.tangent[1].atan2(rail.tangent[0]);
            let parts = [1.0, outline.x, outline.y, angle].map(|part| weight * part);
            sums = [0, 1, 2, 3].map(|i| sums[i] + parts[i]);
        }
        let [total, x, y, angle] = sums;
        let [x, y, angle] = [x, y, angle].map(|sum| sum / total);
        (total > 0.0).then_some(Self { x, y, angle, depth: deepest })
    }
}
