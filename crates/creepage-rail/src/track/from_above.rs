//! Visible part of a rail from above: its highest point and outwards, as long as `y` goes on.

use super::Rail;
use crate::GeometryError;
use crate::curve::{CurvePoint, hermite};
use crate::search::threshold;

/// Stretches of a slice on which `y` rises: `y` in the track and the parameter there.
pub(super) type Stretches = Vec<Vec<[f64; 2]>>;

/// A station of a rail in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    s: f64,
    pub(super) y: f64,
    pub(super) z: f64,
    /// `dz/dy`.
    slope: f64,
}

impl Station {
    fn new(s: f64, point: CurvePoint) -> Self {
        Self { s, y: point.y, z: point.z, slope: point.tangent[1] / point.tangent[0] }
    }
}

impl Rail {
    /// Stretches of all slices on which the surface looks upwards.
    pub(super) fn rising_stretches(&self) -> Vec<Vec<Stretches>> {
        let Some(slices) = self.slices() else { return Vec::new() };
        let stretches = |u: f64, v: &[f64]| {
            let mut all: Stretches = Vec::new();
            let mut is_open = false;
            for &v in v {
                let Some(point) = slices.at(v, u) else { continue };
                let [y, _] = self.placed(point.place);
                let [dy, dz] = self.rotated(point.by_v);
                // Steeper than 80 degrees is a wall.
                if dy <= 0.17 * dz.abs() {
                    is_open = false;
                    continue;
                }
                match all.last_mut() {
                    Some(last) if is_open => last.push([y, v]),
                    _ => all.push(vec![[y, v]]),
                }
                is_open = true;
            }
            all
        };
        let patch = |(u, v): (&[f64], &[f64])| u.iter().map(|&u| stretches(u, v)).collect();
        slices.patch_slices().map(patch).collect()
    }

    /// Parameters near those at which slices about `u` reach `y`.
    pub(crate) fn seeds(&self, u: f64, y: f64, mut each: impl FnMut(f64)) {
        /// From slice to slice an end may move by so much (m).
        const AROUND: f64 = 2e-3;
        let Some(slices) = self.slices() else { return };
        for ((places, _), seen) in slices.patch_slices().zip(&self.seen) {
            let after = places.partition_point(|place| *place <= u);
            let about = [after.checked_sub(1), Some(after)];
            for slice in about.into_iter().flatten().filter_map(|index| seen.get(index)) {
                for stretch in slice {
                    let Some([first, last]) =
                        stretch.first().zip(stretch.last()).map(|(a, b)| [a[0], b[0]])
                    else {
                        continue;
                    };
                    if y < first - AROUND || y > last + AROUND {
                        continue;
                    }
                    let at = stretch.partition_point(|[there, _]| *there <= y);
                    let at = at.min(stretch.len() - 1);
                    if let Some([_, v]) = stretch.get(at) {
                        each(*v);
                    }
                }
            }
        }
    }

    /// Finds what a wheel can see from above.
    pub(super) fn look(&mut self) -> Result<(), GeometryError> {
        (self.visible, self.walls) = self.seen_from_above(&self.stations());
        self.seen = self.rising_stretches();
        if self.visible.len() < 2 { Err(GeometryError::Hidden) } else { Ok(()) }
    }

    /// Points of the visible part (m), `y` rising.
    pub(crate) fn outline(&self) -> Vec<[f64; 2]> {
        self.visible.iter().map(|station| [station.y, station.z]).collect()
    }

    /// `y` of the visible part (m), from the track side to the field side.
    pub(crate) fn range(&self) -> [f64; 2] {
        let y = |end: Option<&Station>| end.map_or(0.0, |station| station.y);
        [y(self.visible.first()), y(self.visible.last())]
    }

    /// Whether `y` lies beyond a wall: nothing is met there.
    pub(crate) fn beyond_wall(&self, y: f64) -> bool {
        let [low, high] = self.range();
        (self.walls[0] && y < low) || (self.walls[1] && y > high)
    }

    /// The stations about `y`; none beyond the visible part.
    fn about(&self, y: f64) -> Option<[&Station; 2]> {
        let after = self.visible.partition_point(|station| station.y <= y);
        let low = self.visible.get(after.checked_sub(1)?)?;
        let high = self.visible.get(after).or_else(|| self.visible.last())?;
        (y <= high.y).then_some([low, high])
    }

    /// Height of the visible part at `y`, by cubics between stations: to nanometres but on walls.
    pub(crate) fn height(&self, y: f64) -> Option<f64> {
        let [low, high] = self.about(y)?;
        let width = high.y - low.y;
        let steep = low.slope.abs().max(high.slope.abs()) > 4.0;
        if steep || width <= 0.0 {
            return self.at_y(y).map(|(_, point)| point.z);
        }
        let slopes = [width * low.slope, width * high.slope];
        Some(hermite((y - low.y) / width, [low.z, high.z], slopes))
    }

    /// The visible point at `y`: its arc length and itself. `None` beyond the visible part.
    pub(crate) fn at_y(&self, y: f64) -> Option<(f64, CurvePoint)> {
        let [start, end] = self.about(y)?;
        let (mut low, mut high) = (start.s, end.s);
        let part = if end.y > start.y { (y - start.y) / (end.y - start.y) } else { 0.0 };
        let mut s = low + part * (high - low);
        let mut point = self.at(s);
        for _ in 0..60 {
            let excess = point.y - y;
            if excess.abs() < 1e-14 {
                break;
            }
            if excess > 0.0 {
                high = s;
            } else {
                low = s;
            }
            let step = s - excess / point.tangent[0];
            let next = if step > low && step < high { step } else { low.midpoint(high) };
            if (next - s).abs() < f64::EPSILON * s.abs() {
                break;
            }
            s = next;
            point = self.at(s);
        }
        Some((s, point))
    }

    /// From the highest station outwards, as long as `y` goes on or comes out again below a dent; and on which
    /// ends it stops at a wall before the profile ends.
    fn seen_from_above(&self, stations: &[f64]) -> (Vec<Station>, [bool; 2]) {
        let points: Vec<(f64, CurvePoint)> = stations.iter().map(|&s| (s, self.at(s))).collect();
        let heights = points.iter().map(|(_, point)| point.z).enumerate();
        let top = heights.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(index, _)| index);
        let (inner, outer) = points.split_at(top);
        let (mut seen, inner_wall) =
            self.onwards(outer.first().into_iter().chain(inner.iter().rev()), -1.0);
        let (outwards, outer_wall) = self.onwards(outer.iter(), 1.0);
        seen.reverse();
        seen.extend(outwards.into_iter().skip(1));
        (seen, [inner_wall, outer_wall])
    }

    /// Stations as long as `y` grows in the given sense and the surface looks upwards; at a wall its foot is the
    /// last, unless the surface comes out beyond it further down: the wall of a dent, whose underside alone is
    /// hidden. Stations go on there at the same `y`.
    fn onwards<'p>(
        &self,
        walk: impl Iterator<Item = &'p (f64, CurvePoint)>,
        sense: f64,
    ) -> (Vec<Station>, bool) {
        let mut seen: Vec<Station> = Vec::new();
        let looks_up = |s: f64| self.at(s).tangent[0] > 1e-6;
        // Where it was last, below a wall.
        let mut hidden: Option<f64> = None;
        for &(s, point) in walk {
            let Some(&last) = seen.last() else {
                seen.push(Station::new(s, point));
                continue;
            };
            let goes_on = sense * point.y > sense * last.y && looks_up(s);
            if let Some(before) = hidden {
                if !(goes_on && point.z > last.z) {
                    hidden = Some(s);
                    continue;
                }
                let is_out = |s: f64| sense * self.at(s).y > sense * last.y;
                let [out, _] = threshold([s, before], is_out);
                seen.extend([out, s].map(|s| Station::new(s, self.at(s))));
                hidden = None;
            } else if goes_on {
                seen.push(Station::new(s, point));
            } else {
                let [foot, _] = threshold([last.s, s], looks_up);
                let point = self.at(foot);
                if sense * point.y > sense * last.y {
                    seen.push(Station::new(foot, point));
                }
                hidden = Some(s);
            }
        }
        (seen, hidden.is_some())
    }
}
