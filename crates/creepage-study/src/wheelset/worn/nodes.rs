//! A profile that wears: its points, moved along the normal, and the depth that is taken off.

use creepage_rail::{Profile, ProfileError, Role};
use serde::{Deserialize, Serialize};

/// A kink of the profile (rad), which stays one.
const KINK: f64 = 0.1;
/// Points nearer, and farther apart, than these parts of their spacing are laid anew.
const NEAR: f64 = 0.5;
const FAR: f64 = 2.0;
/// A profile has this many points at most.
pub(super) const MOST: f64 = 20_000.0;

/// A profile by its points, and what it has lost.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Nodes {
    /// `(y, z)` (m) along the curve.
    pub(super) points: Vec<[f64; 2]>,
    /// Depth that was taken off at each (m).
    pub(super) depth: Vec<f64>,
    /// Indices of kinks.
    pub(super) corners: Vec<usize>,
    /// Area of the section that was taken off (m2).
    pub(super) area: f64,
    /// Of a wheel, the volume (m3).
    pub(super) volume: f64,
}

impl Nodes {
    /// The points of a new profile, at most `spacing` (m) apart.
    pub(super) fn of(profile: &Profile, spacing: f64) -> Self {
        let curve = profile.curve();
        let kinks: Vec<f64> = curve.kinks(KINK).iter().map(|(s, _)| *s).collect();
        let is_kink = |s: f64| kinks.iter().any(|kink| kink.to_bits() == s.to_bits());
        let mut ends = vec![0.0];
        ends.extend(kinks.iter().copied());
        ends.push(curve.length());
        // Even steps from kink to kink: joints of smooth pieces need no point.
        let mut stations = vec![0.0];
        for run in ends.windows(2) {
            let count = ((run[1] - run[0]) / spacing).ceil().clamp(1.0, MOST);
            let step = (run[1] - run[0]) / count;
            let inner = (1..).map(f64::from).take_while(|k| *k < count);
            stations.extend(inner.map(|k: f64| run[0] + k * step));
            stations.push(run[1]);
        }
        stations.dedup_by(|next, last| *next - *last < NEAR * NEAR * spacing && !is_kink(*next));
        let corners = (0..stations.len()).filter(|&k| is_kink(stations[k])).collect();
        let points: Vec<[f64; 2]> =
            stations.iter().map(|&s| curve.at(s)).map(|point| [point.y, point.z]).collect();
        Self { depth: vec![0.0; points.len()], points, corners, area: 0.0, volume: 0.0 }
    }

    /// The curve through the points.
    pub(super) fn profile(&self, role: Role) -> Result<Profile, ProfileError> {
        Profile::through(role, &self.points, &self.corners)
    }

    /// Arc lengths of the points by their chords (m).
    pub(super) fn arcs(&self) -> Vec<f64> {
        let mut s = 0.0;
        let ends = self.points.windows(2).map(|pair| {
            s += (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
            s
        });
        [0.0].into_iter().chain(ends).collect()
    }

    /// Arc length of the place with this `y` (m): of a rail the highest, of a wheel the first from the
    /// field side.
    pub(super) fn place(&self, arcs: &[f64], role: Role, y: f64) -> Option<f64> {
        let mut found: Option<[f64; 2]> = None;
        for (pair, s) in self.points.windows(2).zip(arcs.windows(2)) {
            let [[from, z], [to, end]] = [pair[0], pair[1]];
            if (from - y) * (to - y) > 0.0 || from.to_bits() == to.to_bits() {
                continue;
            }
            let part = (y - from) / (to - from);
            let here = [z + part * (end - z), s[0] + part * (s[1] - s[0])];
            if found.is_none_or(|found| role == Role::Rail && here[0] < found[0]) {
                found = Some(here);
            }
        }
        found.map(|[_, s]| s)
    }

    /// `z` at an arc length (m), linear between points.
    pub(super) fn height(&self, arcs: &[f64], at: f64) -> f64 {
        let above = arcs.partition_point(|place| *place < at).clamp(1, arcs.len() - 1);
        let [from, to] = [arcs[above - 1], arcs[above]];
        let part = ((at - from) / (to - from)).clamp(0.0, 1.0);
        let [low, high] = [self.points[above - 1][1], self.points[above][1]];
        low + part * (high - low)
    }

    /// The profile after `depth` (m, at each point) was taken off along the normal; `radius` (m) is that
    /// of a wheel.
    ///
    /// `None` where points would cross.
    pub(super) fn worn(&self, depth: &[f64], radius: f64, spacing: f64) -> Option<Self> {
        let (arcs, points) = (self.arcs(), &self.points);
        let cells = cells(&arcs);
        let mut worn = self.clone();
        for (k, taken) in depth.iter().enumerate() {
            // The inward normal lies on the right hand of the curve.
            let [ty, tz] = tangent(points, &arcs, k);
            let [y, z] = points[k];
            worn.points[k] = [y - taken * tz, z + taken * ty];
            worn.depth[k] += taken;
            worn.area += taken * cells[k];
            worn.volume += std::f64::consts::TAU * (radius + z) * taken * cells[k];
        }
        let ahead = |k: usize| {
            let [a, b] = [points[k], points[k + 1]];
            let [c, d] = [worn.points[k], worn.points[k + 1]];
            (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]) > 0.0
        };
        (0..points.len() - 1).all(ahead).then(|| worn.even(spacing))
    }

    /// The same with points laid anew where they have come too near or gone too far.
    fn even(self, spacing: f64) -> Self {
        let arcs = self.arcs();
        let steps = || arcs.windows(2).map(|pair| pair[1] - pair[0]);
        let widest = steps().fold(0.0, f64::max);
        let narrowest = steps().fold(f64::INFINITY, f64::min);
        // Short runs between kinks have short steps from the start.
        if widest < FAR * spacing && (narrowest > NEAR * spacing || !self.corners.is_empty()) {
            return self;
        }
        let Ok(profile) = self.profile(Role::Wheel).or_else(|_| self.profile(Role::Rail)) else {
            return self;
        };
        let mut new = Self::of(&profile, spacing);
        let new_arcs = new.arcs();
        let stretch = match (arcs.last(), new_arcs.last()) {
            (Some(old), Some(new)) if *new > 0.0 => old / new,
            _ => return self,
        };
        new.depth = new_arcs.iter().map(|s| between(&arcs, &self.depth, stretch * s)).collect();
        (new.area, new.volume) = (self.area, self.volume);
        new
    }
}

/// Length of the curve that belongs to each point (m).
pub(super) fn cells(arcs: &[f64]) -> Vec<f64> {
    let last = arcs.len().saturating_sub(1);
    let border = |k: usize, next: usize| arcs[k].midpoint(arcs[next]);
    (0..arcs.len()).map(|k| border(k, (k + 1).min(last)) - border(k.saturating_sub(1), k)).collect()
}

/// The tangent at a point: that of the parabola through it and its neighbours.
fn tangent(points: &[[f64; 2]], arcs: &[f64], k: usize) -> [f64; 2] {
    let last = points.len() - 1;
    let slope =
        |i: usize, axis: usize| (points[i + 1][axis] - points[i][axis]) / (arcs[i + 1] - arcs[i]);
    let [y, z] = [0, 1].map(|axis| {
        if k == 0 || k == last {
            return slope(k.min(last - 1), axis);
        }
        let (before, after) = (arcs[k] - arcs[k - 1], arcs[k + 1] - arcs[k]);
        (slope(k - 1, axis) * after + slope(k, axis) * before) / (before + after)
    });
    let length = y.hypot(z);
    [y / length, z / length]
}

/// Linear between points, that of the end beyond.
fn between(places: &[f64], values: &[f64], at: f64) -> f64 {
    let above = places.partition_point(|place| *place < at).min(places.len() - 1);
    let below = above.saturating_sub(1);
    if above == below || places[above] <= places[below] {
        return values[above];
    }
    let part = ((at - places[below]) / (places[above] - places[below])).clamp(0.0, 1.0);
    values[below] + part * (values[above] - values[below])
}

/// Adds a depth (m) over a width about `s` (m): each point gets the mean over what belongs to it.
pub(super) fn deposit(arcs: &[f64], depths: &mut [f64], s: f64, width: f64, depth: f64) {
    let (from, to) = (s - 0.5 * width, s + 0.5 * width);
    let last = arcs.len() - 1;
    let first = arcs.partition_point(|place| *place < from).saturating_sub(1);
    for k in first..=last {
        let low = arcs[k.saturating_sub(1)].midpoint(arcs[k]);
        let high = arcs[k].midpoint(arcs[(k + 1).min(last)]);
        if low >= to {
            break;
        }
        let shared = high.min(to) - low.max(from);
        if shared > 0.0 {
            depths[k] += depth * shared / (high - low);
        }
    }
}

/// Gaussian smoothing over arc length that keeps the integral: each point's part is spread, and what
/// would fall beyond an end is laid back.
pub(super) fn smoothed(arcs: &[f64], depths: &[f64], length: f64) -> Vec<f64> {
    const REACH: f64 = 6.0;
    let cells = cells(arcs);
    let (start, end) = (arcs[0], arcs[arcs.len() - 1]);
    let bell = |distance: f64| {
        let t = distance / length;
        if t.abs() < REACH { (-0.5 * t * t).exp() } else { 0.0 }
    };
    let mut smooth = vec![0.0; depths.len()];
    let mut weights = Vec::new();
    for (k, depth) in depths.iter().enumerate().filter(|(_, depth)| **depth != 0.0) {
        let s = arcs[k];
        let from = arcs.partition_point(|place| *place < s - REACH * length);
        let to = arcs.partition_point(|place| *place <= s + REACH * length);
        weights.clear();
        weights.extend((from..to).map(|i| {
            let at = arcs[i];
            let direct = bell(at - s);
            cells[i] * (direct + bell(2.0 * start - at - s) + bell(2.0 * end - at - s))
        }));
        let whole: f64 = weights.iter().sum();
        for (i, weight) in (from..to).zip(&weights) {
            smooth[i] += depth * cells[k] * weight / (whole * cells[i]);
        }
    }
    smooth
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use creepage_rail::Standard;

    use super::*;

    fn volume(arcs: &[f64], depths: &[f64]) -> f64 {
        cells(arcs).iter().zip(depths).map(|(cell, depth)| cell * depth).sum()
    }

    #[test]
    fn smoothing_and_deposits_keep_the_volume() {
        let nodes = Nodes::of(&Standard::S1002.profile(), 2.5e-4);
        let arcs = nodes.arcs();
        let mut depths = vec![0.0; arcs.len()];
        // In the middle, and one against an end, where the bell is folded back.
        for (s, width, depth) in [(0.05, 3.3e-4, 1e-5), (0.0503, 3.3e-4, 2e-5), (5e-4, 7e-4, 1e-5)]
        {
            deposit(&arcs, &mut depths, s, width, depth);
        }
        let given = 3.3e-4 * 3e-5 + 7e-4 * 1e-5;
        // Rounding alone.
        assert!((volume(&arcs, &depths) / given - 1.0).abs() < 1e-12);
        for length in [3e-4, 2e-3, 1e-2] {
            let smooth = smoothed(&arcs, &depths, length);
            assert!((volume(&arcs, &smooth) / given - 1.0).abs() < 1e-12);
            assert!(smooth.iter().all(|depth| *depth >= 0.0));
        }
    }

    /// A level depth stays level: to what the midpoint rule of a bell over uneven points misses.
    #[test]
    fn smoothing_keeps_a_level_depth() {
        let arcs = Nodes::of(&Standard::S1002.profile(), 2.5e-4).arcs();
        let smooth = smoothed(&arcs, &vec![1.0; arcs.len()], 2e-3);
        assert!(smooth.iter().all(|depth| (depth - 1.0).abs() < 1e-3), "{smooth:?}");
    }

    /// Depth is taken off along the normal: a round of radius `r` worn evenly is a round of `r - d`.
    #[test]
    fn a_round_worn_evenly_stays_round() {
        let (radius, depth) = (0.3, 1e-3);
        let points: Vec<[f64; 2]> = (-60..=60)
            .map(|k: i32| f64::from(k) * 2e-3)
            .map(|t: f64| [radius * t.sin(), radius * (1.0 - t.cos())])
            .collect();
        let profile = Profile::through(Role::Rail, &points, &[]).unwrap();
        let nodes = Nodes::of(&profile, 5e-4);
        let worn = nodes.worn(&vec![depth; nodes.points.len()], 0.0, 5e-4).unwrap();
        for [y, z] in &worn.points {
            let off = y.hypot(radius - z) - (radius - depth);
            // Chords of .5 mm: tangents are off by (h/r)^2, depths by its square; at the ends by h/2r.
            assert!(off.abs() < 2e-9, "{off}");
        }
        let length = nodes.arcs().last().copied().unwrap();
        assert!((worn.area / (depth * length) - 1.0).abs() < 1e-12);
        assert!(nodes.worn(&vec![0.4; nodes.points.len()], 0.0, 5e-4).is_none());
    }
}
