//! Contact between surfaces that vary along rolling: its plane, which may slope along the track too, and the undeformed
//! distance over it along its normal.

use std::cell::Cell;

use crate::frame::Frame;
use crate::meeting::WheelRailPair;
use crate::pair_surfaces::{PatchPoint, Plane, dot};
use crate::running::{ONE_CONTACT_WITHIN, TURN};
use crate::search::least;
use crate::surfaces::Surfaces;
use crate::varying_search::{OverlapCell, OverlapRegion};
use crate::{Across, Contact, GeometryError, Side};

/// Lows that may lie above the least of all and still overlap: those that the load presses together (m).
const DEEP: f64 = 5e-3;
/// Overlaps less deep (m) may come to nothing.
const MIN_DEPTH: f64 = 1e-9;
/// Without a surface the gap is so many times the approach, and so much more (m).
const AWAY: [f64; 2] = [2.0, 2e-5];

/// Both surfaces over a contact plane, on the right-hand image of their side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VaryingSurfaces {
    pub(crate) plane: Plane,
    /// Parameters of the wheel (`v`, angle) and of the rail (`v`, `x`) at the plane's origin.
    wheel: [f64; 2],
    rail: [f64; 2],
}

impl VaryingSurfaces {
    fn wheel_at(
        &self,
        pair: &WheelRailPair<'_>,
        place: [f64; 2],
        from: [f64; 2],
    ) -> Option<([f64; 2], PatchPoint)> {
        self.plane.foot(place, from, |[v, b]| pair.posed.varying(v, b))
    }

    fn rail_at(
        &self,
        pair: &WheelRailPair<'_>,
        place: [f64; 2],
        from: [f64; 2],
    ) -> Option<([f64; 2], PatchPoint)> {
        let found = self.plane.foot(place, from, |[v, x]| {
            let mut point = pair.rail.varying(v, pair.s + x)?;
            point.place[0] = x;
            Some(point)
        });
        let is_there = |[v, x]: [f64; 2]| match pair.rail.slices() {
            Some(slices) => slices.holds(v, pair.s + x),
            None => (0.0..=pair.rail.profile().curve().length()).contains(&v),
        };
        found.filter(|(at, _)| is_there(*at))
    }

    /// Distance along the normal from the rail to the wheel at a place of the plane, from feet nearby.
    fn apart(
        &self,
        pair: &WheelRailPair<'_>,
        place: [f64; 2],
        feet: &mut [[f64; 2]; 2],
    ) -> Option<f64> {
        let (wheel, on_wheel) = self.wheel_at(pair, place, feet[0])?;
        let (rail, on_rail) = self.rail_at(pair, place, feet[1])?;
        *feet = [wheel, rail];
        Some(self.plane.of(on_rail.place)[2] - self.plane.of(on_wheel.place)[2])
    }

    /// The wheel's parameter at the plane's origin.
    pub(crate) fn wheel_parameter(&self) -> f64 {
        self.wheel[0]
    }

    fn feet(&self) -> [[f64; 2]; 2] {
        [self.wheel, self.rail]
    }

    fn gap(&self, pair: &WheelRailPair<'_>, place: [f64; 2]) -> Option<f64> {
        self.apart(pair, place, &mut self.feet())
    }
}

/// All contacts of a pair that varies.
pub(crate) fn contacts(
    side: Side,
    pair: WheelRailPair<'_>,
) -> Result<Vec<Contact<'_>>, GeometryError> {
    let mut regions: Vec<OverlapRegion> = Vec::new();
    for low in pair.lows(DEEP).iter().filter(|low| low.gap < 0.0) {
        let holds = |region: &OverlapRegion| {
            let [dv, db] = region.steps;
            let is_at = |cell: &OverlapCell| {
                (cell.at[0] - low.v).abs() <= dv && (cell.at[1] - low.b).abs() <= db
            };
            region.cells.iter().any(is_at)
        };
        if !regions.iter().any(holds) {
            regions.extend(pair.region(low));
        }
    }
    let mut contacts = Vec::new();
    for region in merged(regions) {
        contacts.extend(Contact::of_region(side, pair, &region)?);
    }
    // From the field side, and from behind.
    contacts.sort_by(|a: &Contact<'_>, b| {
        let key = |one: &Contact<'_>| [-side.sense() * one.reference[1], one.reference[0]];
        key(a).partial_cmp(&key(b)).unwrap_or(std::cmp::Ordering::Equal)
    });
    Ok(contacts)
}

/// Regions that lie close together in nearly one plane, as one.
fn merged(regions: Vec<OverlapRegion>) -> Vec<OverlapRegion> {
    let mut merged: Vec<OverlapRegion> = Vec::new();
    for mut region in regions {
        // Whatever it is near to becomes one with it.
        while let Some(index) = merged.iter().position(|other| are_together(other, &region)) {
            let other = merged.swap_remove(index);
            region.cells.extend(other.cells);
            region.is_cut |= other.is_cut;
            region.end = region.end.or(other.end);
        }
        merged.push(region);
    }
    merged
}

fn are_together(one: &OverlapRegion, other: &OverlapRegion) -> bool {
    let extent = |region: &OverlapRegion, axis: usize| {
        let along = region.cells.iter().map(|cell| cell.place[axis]);
        along
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
    };
    let apart = |axis: usize| {
        let ([a, b], [c, d]) = (extent(one, axis), extent(other, axis));
        (c - b).max(a - d).max(0.0)
    };
    let turn = |axis: usize| {
        let mean = |region: &OverlapRegion| {
            let slopes = region.cells.iter().map(|cell| cell.rail.slope[axis].atan());
            slopes.sum::<f64>() / region.cells.len() as f64
        };
        (mean(one) - mean(other)).abs()
    };
    apart(0).hypot(apart(1)) < ONE_CONTACT_WITHIN && turn(0).max(turn(1)) < TURN
}

/// Means over an overlap, each place weighed by its depth squared.
struct Centre {
    x: f64,
    y: f64,
    angle: f64,
    slope: f64,
    deepest: OverlapCell,
}

impl Centre {
    fn of(cells: &[OverlapCell]) -> Option<Self> {
        let deepest = *cells.iter().max_by(|a, b| a.depth.total_cmp(&b.depth))?;
        let mut sums = [0.0; 5];
        for cell in cells {
            let weight = cell.area * cell.depth * cell.depth;
            let angle = cell.rail.slope[1].atan();
            // Of the plane along rolling against the one across.
            let slope = (cell.rail.slope[0] * angle.cos()).atan();
            let parts = [1.0, cell.place[0], cell.place[1], angle, slope];
            sums = std::array::from_fn(|i| sums[i] + weight * parts[i]);
        }
        let [total, x, y, angle, slope] = sums;
        let [x, y, angle, slope] = [x, y, angle, slope].map(|sum| sum / total);
        (total > 0.0).then_some(Self { x, y, angle, slope, deepest })
    }
}

impl<'a> Contact<'a> {
    /// The contact on a region; `None` where the bodies hardly touch.
    fn of_region(
        side: Side,
        pair: WheelRailPair<'a>,
        region: &OverlapRegion,
    ) -> Result<Option<Self>, GeometryError> {
        let end = |y: f64| GeometryError::End { side, y: side.sense() * y };
        if let Some(y) = region.end {
            return Err(end(y));
        }
        let Some(centre) = Centre::of(&region.cells) else { return Ok(None) };
        let Centre { mut x, mut y, angle, slope, deepest } = centre;
        // Between two areas there may be no rail.
        let below = match pair.rail.below(pair.s + x, y) {
            Some(below) if (below.z - deepest.place[2]).abs() < 1e-2 => below,
            _ => {
                [x, y] = [deepest.place[0], deepest.place[1]];
                deepest.rail
            }
        };
        let plane = Plane::new([x, y, below.z], angle, slope);
        let mut over = VaryingSurfaces { plane, wheel: deepest.at, rail: [below.v, x] };
        let Some((wheel, _)) = over.wheel_at(&pair, [0.0; 2], over.wheel) else {
            return Err(end(y));
        };
        over.wheel = wheel;
        let on_wheel = pair.posed.varying(wheel[0], wheel[1]).ok_or(end(y))?;
        let on_rail = pair.rail.varying(below.v, pair.s + x).ok_or(end(y))?;
        // What is asked of one profile is asked of that of the rail here.
        let point = crate::CurvePoint { y, z: below.z, tangent: [1.0, 0.0], curvature: 0.0 };
        let frame = Frame::new(x, point, below.v, angle);
        let mut contact = Self {
            side,
            reference: [x, side.sense() * y, below.z],
            angle: side.sense() * angle,
            slope,
            is_cut: region.is_cut,
            is_beyond: pair.rail.slices().is_some_and(|slices| slices.is_beyond(pair.s + x)),
            is_on_guard: pair.is_guard,
            y_rail: on_rail.y,
            y_wheel: on_wheel.y,
            approach: 0.0,
            extent: [[0.0; 2]; 2],
            surfaces: Surfaces { pair, frame, start: wheel[0] },
            varying: Some(over),
        };
        let is_measured = contact.measure_region(&over, region);
        let touches = is_measured && contact.approach > 0.0;
        (touches || deepest.depth < MIN_DEPTH).then_some(touches.then_some(contact)).ok_or(end(y))
    }

    /// Approach and extent of a region.
    fn measure_region(&mut self, over: &VaryingSurfaces, region: &OverlapRegion) -> bool {
        let pair = &self.surfaces.pair;
        let places: Vec<([f64; 3], f64)> =
            region.cells.iter().map(|cell| (over.plane.of(cell.place), cell.depth)).collect();
        let Some((deepest, _)) = places.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else {
            return false;
        };
        let radius = pair.posed.wheel.radius();
        let [ds, dx] = [region.steps[0], region.steps[1] * radius];
        // The least gap along the normal, in steps of the lattice about the deepest place.
        // Where the surface is cut it lies at an edge, beyond which there is none.
        let lowest = Cell::new(f64::INFINITY);
        let gap = |x: f64, s: f64| {
            let found = over.gap(pair, [x, s]).unwrap_or(f64::INFINITY);
            lowest.set(lowest.get().min(found));
            found
        };
        let along = |s: f64| {
            let x = least(|x| gap(x, s), [deepest[0] - 2.0 * dx, deepest[0] + 2.0 * dx]);
            gap(x, s)
        };
        let s = least(along, [deepest[1] - 2.0 * ds, deepest[1] + 2.0 * ds]);
        along(s);
        self.approach = -lowest.get();
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for ([x, s, _], _) in &places {
            for (axis, (at, step)) in [(x, dx), (s, ds)].into_iter().enumerate() {
                extent[axis] = [extent[axis][0].min(at - step), extent[axis][1].max(at + step)];
            }
        }
        self.extent = extent;
        if self.side == Side::Left {
            self.extent[1] = [-extent[1][1], -extent[1][0]];
        }
        self.approach.is_finite()
    }

    /// Whether its surfaces vary along rolling: then the undeformed distance is that of
    /// [`Contact::lattice`], and no parabola along `x`.
    #[must_use]
    pub fn varies(&self) -> bool {
        self.varying.is_some()
    }

    /// Whether it is the wheel, or the wheel too, that varies.
    #[must_use]
    pub fn wheel_varies(&self) -> bool {
        self.surfaces.pair.posed.wheel.varies()
    }

    /// The undeformed distance (m) on a lattice of so many places along `x` and across, over the extent widened by
    /// `margin` of itself on all sides: `[x, s, gap]`, 0 where the overlap is deepest. Where a surface ends the
    /// bodies are apart. For surfaces that vary along rolling.
    #[must_use]
    pub fn lattice(&self, counts: [usize; 2], margin: f64) -> Vec<[f64; 3]> {
        let Some(over) = &self.varying else { return Vec::new() };
        let [along, across] = [0, 1].map(|axis: usize| {
            let [from, to] = self.extent[axis];
            let wide = margin * (to - from);
            let last = counts[axis].max(2) - 1;
            let step = (to - from + 2.0 * wide) / last as f64;
            (0..=last).map(|i| from - wide + i as f64 * step).collect::<Vec<f64>>()
        });
        let away = AWAY[0] * self.approach + AWAY[1];
        let pair = &self.surfaces.pair;
        let mut points = Vec::with_capacity(along.len() * across.len());
        let mut start = over.feet();
        for &s in &across {
            let local = self.side.sense() * s;
            let mut feet = start;
            for (i, &x) in along.iter().enumerate() {
                let place = [x, local];
                let near = over.apart(pair, place, &mut feet);
                let found = near.or_else(|| over.apart(pair, place, &mut over.feet()));
                if i == 0 && found.is_some() {
                    start = feet;
                }
                points.push([x, s, found.map_or(away, |apart| apart + self.approach)]);
            }
        }
        points
    }

    /// The bodies at lateral place `s`, surfaces that vary along rolling.
    pub(crate) fn varying_at(&self, over: &VaryingSurfaces, s: f64) -> Option<Across> {
        let pair = &self.surfaces.pair;
        let local = self.side.sense() * s;
        let [low, high] = self.extent[0];
        let gap = |x: f64| over.gap(pair, [x, local]).unwrap_or(f64::INFINITY);
        let x = least(gap, [low, high]);
        let at = over.gap(pair, [x, local])?;
        let step = 0.1 * (high - low);
        let bend = (gap(x - step) - 2.0 * at + gap(x + step)) / (step * step);
        let (_, wheel) = over.wheel_at(pair, [x, local], over.wheel)?;
        let (_, rail) = over.rail_at(pair, [x, local], over.rail)?;
        let [_, ty, tz] = rail.by[0];
        let tilt = self.side.sense() * self.surfaces.frame.tilt([ty, tz]);
        Some(Across {
            s,
            x,
            gap: at + self.approach,
            rolling_radius: 1.0 / bend,
            tilt,
            y_rail: rail.y,
            y_wheel: wheel.y,
        })
    }

    /// The gap at places of one row.
    pub(crate) fn varying_row(
        &self,
        over: &VaryingSurfaces,
        s: f64,
        x: &[f64],
    ) -> Option<Vec<f64>> {
        let local = self.side.sense() * s;
        let pair = &self.surfaces.pair;
        let gaps = x.iter().map(|&x| Some(over.gap(pair, [x, local])? + self.approach));
        gaps.collect()
    }

    /// The wheel's point at `(x, s)` and unit tangents of the rail below it, along rolling and across, on the
    /// right-hand image.
    pub(crate) fn varying_points(
        &self,
        over: &VaryingSurfaces,
        x: f64,
        s: f64,
    ) -> Option<[[f64; 3]; 3]> {
        let pair = &self.surfaces.pair;
        let (_, wheel) = over.wheel_at(pair, [x, s], over.wheel)?;
        let (_, rail) = over.rail_at(pair, [x, s], over.rail)?;
        let unit = |a: [f64; 3]| {
            let length = dot(a, a).sqrt();
            a.map(|part| part / length)
        };
        let across = unit(rail.by[0]);
        let along = rail.by[1];
        let part = dot(along, across);
        let along = unit([0, 1, 2].map(|i: usize| along[i] - part * across[i]));
        Some([wheel.place, along, across])
    }
}
