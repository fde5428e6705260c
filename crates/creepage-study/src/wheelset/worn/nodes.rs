//! Worn profile by its points: moved along the normal, and the depth that is taken off.

use creepage_rail::{Profile, ProfileError, Role};
use serde::{Deserialize, Serialize};

/// A kink of the profile (rad), which stays one.
const KINK: f64 = 0.1;
/// Points nearer, and farther apart, than these parts of their spacing are laid anew.
const MIN_SPACING: f64 = 0.5;
const FAR: f64 = 2.0;
/// Rounds in which the volume is made up; each leaves the change of a chord's length over a step.
const ROUNDS: usize = 12;
/// A profile has this many points at most.
pub(super) const MAX_POINTS: f64 = 20_000.0;

/// A profile by its points, and what it has lost.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Nodes {
    /// `(y, z)` (m) along the curve.
    pub(super) points: Vec<[f64; 2]>,
    /// Depth that was taken off at each (m).
    pub(super) depth: Vec<f64>,
    /// Indices of kinks.
    pub(super) corners: Vec<usize>,
    /// Radius of a wheel where `z` is zero (m); infinite for a rail.
    #[serde(with = "infinite_as_none")]
    pub(super) radius: f64,
    /// Area of the section that was taken off (m2), between the polygons through the points.
    pub(super) area: f64,
    /// The same as a volume: of a wheel all around (m3), of a rail per metre (m3/m).
    pub(super) volume: f64,
    /// Volume that the law of wear asked for, as the contacts gave it.
    pub(super) by_law: f64,
}

/// JSON has no infinity.
mod infinite_as_none {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[allow(clippy::trivially_copy_pass_by_ref)] // serde asks for it
    pub(super) fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        value.is_finite().then_some(*value).serialize(to)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        Ok(Option::deserialize(from)?.unwrap_or(f64::INFINITY))
    }
}

impl Nodes {
    /// The points of a new profile, at most `spacing` (m) apart.
    pub(super) fn of(profile: &Profile, radius: f64, spacing: f64) -> Self {
        let curve = profile.curve();
        let kinks: Vec<f64> = curve.kinks(KINK).iter().map(|(s, _)| *s).collect();
        let is_kink = |s: f64| kinks.iter().any(|kink| kink.to_bits() == s.to_bits());
        let mut ends = vec![0.0];
        ends.extend(kinks.iter().copied());
        ends.push(curve.length());
        // Even steps from kink to kink: joints of smooth pieces need no point.
        let mut stations = vec![0.0];
        for run in ends.windows(2) {
            let count = ((run[1] - run[0]) / spacing).ceil().clamp(1.0, MAX_POINTS);
            let step = (run[1] - run[0]) / count;
            let inner = (1..).map(f64::from).take_while(|k| *k < count);
            stations.extend(inner.map(|k: f64| run[0] + k * step));
            stations.push(run[1]);
        }
        stations.dedup_by(|next, last| {
            *next - *last < MIN_SPACING * MIN_SPACING * spacing && !is_kink(*next)
        });
        let corners = (0..stations.len()).filter(|&k| is_kink(stations[k])).collect();
        let points: Vec<[f64; 2]> =
            stations.iter().map(|&s| curve.at(s)).map(|point| [point.y, point.z]).collect();
        let depth = vec![0.0; points.len()];
        Self { points, depth, corners, radius, area: 0.0, volume: 0.0, by_law: 0.0 }
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

    /// Length round the body at a height `z` (m): of a wheel its circumference, of a rail a metre.
    fn round(&self, z: f64) -> f64 {
        if self.radius.is_finite() { std::f64::consts::TAU * (self.radius + z) } else { 1.0 }
    }

    /// Surface that belongs to each point (m2): of a wheel all around, of a rail per metre.
    pub(super) fn surfaces(&self, arcs: &[f64]) -> Vec<f64> {
        let cells = cells(arcs).into_iter();
        cells.zip(&self.points).map(|(cell, [_, z])| cell * self.round(*z)).collect()
    }

    /// The profile after `volumes` (m3, of a rail m3/m) were taken off at its points, along the normal.
    ///
    /// The volume between the polygons before and after is their sum. `None` where points would cross.
    pub(super) fn worn(&self, volumes: &[f64]) -> Option<Self> {
        let (arcs, points) = (self.arcs(), &self.points);
        let surfaces = self.surfaces(&arcs);
        let last = points.len() - 1;
        // Step 1: the distance along the normal at each point, with the curvature and the lesser radius.
        let normals: Vec<[f64; 2]> = (0..=last).map(|k| normal(points, &arcs, k)).collect();
        let mut moves: Vec<f64> = (0..=last)
            .map(|k| {
                let depth = volumes[k] / surfaces[k];
                let by_radius = normals[k][1] / (self.radius + points[k][1]);
                // At kinks curvature is that of the spacing.
                let shrink = (depth * (turn(points, &arcs, k) - by_radius)).clamp(-0.5, 0.5);
                depth / (1.0 - 0.5 * shrink)
            })
            .collect();
        // Step 2: what chords leave is made up all over, so that the whole volume is the one asked for.
        let asked: f64 = volumes.iter().sum();
        let moved = |moves: &[f64]| -> Vec<[f64; 2]> {
            let places = points.iter().zip(&normals).zip(moves);
            places.map(|(([y, z], [ny, nz]), by)| [y + by * ny, z + by * nz]).collect()
        };
        let mut new = moved(&moves);
        let mut swept = self.swept(&new);
        for _ in 0..ROUNDS {
            if !(asked > 0.0 && swept[1] > 0.0) || (swept[1] / asked - 1.0).abs() < 1e-14 {
                break;
            }
            for by in &mut moves {
                *by *= asked / swept[1];
            }
            new = moved(&moves);
            swept = self.swept(&new);
        }
        let ahead = |k: usize| {
            let ([a, b], [c, d]) = ([points[k], points[k + 1]], [new[k], new[k + 1]]);
            (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]) > 0.0
        };
        (0..last).all(ahead).then(|| {
            let depth = self.depth.iter().zip(&moves).map(|(before, by)| before + by).collect();
            let (area, volume) = (self.area + swept[0], self.volume + swept[1]);
            Self { points: new, depth, area, volume, ..self.clone() }
        })
    }

    /// Area (m2) and volume between this polygon and that of the same points moved.
    fn swept(&self, new: &[[f64; 2]]) -> [f64; 2] {
        let mut sums = [0.0; 2];
        let mut triangle = |[a, b, c]: [[f64; 2]; 3]| {
            let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
            sums[0] += area;
            // Guldin: the way of the centroid.
            sums[1] += area * self.round((a[1] + b[1] + c[1]) / 3.0);
        };
        for (old, new) in self.points.windows(2).zip(new.windows(2)) {
            triangle([old[0], old[1], new[1]]);
            triangle([old[0], new[1], new[0]]);
        }
        sums
    }

    /// The same with points laid anew where they have come too near or gone too far.
    pub(super) fn even(self, spacing: f64) -> Self {
        let arcs = self.arcs();
        let steps = || arcs.windows(2).map(|pair| pair[1] - pair[0]);
        let widest = steps().fold(0.0, f64::max);
        let narrowest = steps().fold(f64::INFINITY, f64::min);
        // Short runs between kinks have short steps from the start.
        if widest < FAR * spacing && (narrowest > MIN_SPACING * spacing || !self.corners.is_empty())
        {
            return self;
        }
        let role = if self.radius.is_finite() { Role::Wheel } else { Role::Rail };
        let Ok(profile) = self.profile(role) else {
            return self;
        };
        let mut new = Self::of(&profile, self.radius, spacing);
        let new_arcs = new.arcs();
        let stretch = match (arcs.last(), new_arcs.last()) {
            (Some(old), Some(new)) if *new > 0.0 => old / new,
            _ => return self,
        };
        new.depth = new_arcs.iter().map(|s| between(&arcs, &self.depth, stretch * s)).collect();
        Self { area: self.area, volume: self.volume, by_law: self.by_law, ..new }
    }
}

/// Length of the curve that belongs to each point (m).
pub(super) fn cells(arcs: &[f64]) -> Vec<f64> {
    let last = arcs.len().saturating_sub(1);
    let border = |k: usize, next: usize| arcs[k].midpoint(arcs[next]);
    (0..arcs.len()).map(|k| border(k, (k + 1).min(last)) - border(k.saturating_sub(1), k)).collect()
}

/// The inward normal at a point: it lies on the right hand of the parabola through it and its neighbours.
fn normal(points: &[[f64; 2]], arcs: &[f64], k: usize) -> [f64; 2] {
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
    [-z / length, y / length]
}

/// Curvature at a point (1/m), positive where the body is convex: the turn of the chords over the length that
/// belongs to it; nought at an end.
fn turn(points: &[[f64; 2]], arcs: &[f64], k: usize) -> f64 {
    if k == 0 || k + 1 == points.len() {
        return 0.0;
    }
    let chord = |i: usize| [points[i + 1][0] - points[i][0], points[i + 1][1] - points[i][1]];
    let ([ay, az], [by, bz]) = (chord(k - 1), chord(k));
    (ay * bz - az * by).atan2(ay * by + az * bz) / (0.5 * (arcs[k + 1] - arcs[k - 1]))
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

/// Lays a volume evenly over a width about `s` (m): each point gets what falls on what belongs to it.
pub(super) fn deposit(arcs: &[f64], volumes: &mut [f64], s: f64, width: f64, volume: f64) {
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
            volumes[k] += volume * shared / width;
        }
    }
}

/// Gaussian smoothing of the depth over arc length, by volumes at points with their `surfaces`: each point's
/// volume is spread, and what would fall beyond an end is laid back. The sum stays.
pub(super) fn smoothed(arcs: &[f64], surfaces: &[f64], volumes: &[f64], length: f64) -> Vec<f64> {
    const REACH: f64 = 6.0;
    let (start, end) = (arcs[0], arcs[arcs.len() - 1]);
    let bell = |distance: f64| {
        let t = distance / length;
        if t.abs() < REACH { (-0.5 * t * t).exp() } else { 0.0 }
    };
    let mut smooth = vec![0.0; volumes.len()];
    let mut weights = Vec::new();
    for (k, volume) in volumes.iter().enumerate().filter(|(_, volume)| **volume != 0.0) {
        let s = arcs[k];
        let from = arcs.partition_point(|place| *place < s - REACH * length);
        let to = arcs.partition_point(|place| *place <= s + REACH * length);
        weights.clear();
        weights.extend((from..to).map(|i| {
            let at = arcs[i];
            let direct = bell(at - s);
            surfaces[i] * (direct + bell(2.0 * start - at - s) + bell(2.0 * end - at - s))
        }));
        let whole: f64 = weights.iter().sum();
        for (i, weight) in (from..to).zip(&weights) {
            smooth[i] += volume * weight / whole;
        }
    }
    smooth
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use creepage_rail::Standard;

    use super::*;

    fn s1002() -> Nodes {
        Nodes::of(&Standard::S1002.profile(), 0.46, 2.5e-4)
    }

    #[test]
    fn smoothing_and_deposits_keep_the_volume() {
        let nodes = s1002();
        let arcs = nodes.arcs();
        let mut volumes = vec![0.0; arcs.len()];
        // In the middle, and one against an end, where the bell is folded back.
        for (s, width, volume) in [(0.05, 3.3e-4, 1.0), (0.0503, 3.3e-4, 2.0), (5e-4, 7e-4, 1.0)] {
            deposit(&arcs, &mut volumes, s, width, volume);
        }
        let sum = |volumes: &[f64]| volumes.iter().sum::<f64>();
        // Rounding alone.
        assert!((sum(&volumes) / 4.0 - 1.0).abs() < 1e-12);
        for length in [3e-4, 2e-3, 1e-2] {
            let smooth = smoothed(&arcs, &nodes.surfaces(&arcs), &volumes, length);
            assert!((sum(&smooth) / 4.0 - 1.0).abs() < 1e-12);
            assert!(smooth.iter().all(|volume| *volume >= 0.0));
        }
    }

    /// A level depth stays level on a rail: to what the midpoint rule of a bell over uneven points misses. On a
    /// wheel the volume stays, and the radius falls by up to a metre a metre towards the end of the flange, where
    /// the bell is folded: `sqrt(2/pi) ell/r` of the depth, 3.4e-3.
    #[test]
    fn smoothing_keeps_a_level_depth() {
        for (radius, most) in [(f64::INFINITY, 1e-3), (0.46, 3.4e-3)] {
            let nodes = Nodes { radius, ..s1002() };
            let (arcs, surfaces) = (nodes.arcs(), nodes.surfaces(&nodes.arcs()));
            let smooth = smoothed(&arcs, &surfaces, &surfaces, 2e-3);
            let off = |(volume, surface): (&f64, &f64)| (volume / surface - 1.0).abs();
            let worst = smooth.iter().zip(&surfaces).map(off).fold(0.0, f64::max);
            assert!(worst < most, "{radius} {worst:e}");
        }
    }

    fn round(radius: f64) -> Nodes {
        let points: Vec<[f64; 2]> = (-60..=60)
            .map(|k: i32| f64::from(k) * 2e-3)
            .map(|t: f64| [radius * t.sin(), radius * (1.0 - t.cos())])
            .collect();
        let profile = Profile::through(Role::Rail, &points, &[]).unwrap();
        Nodes::of(&profile, f64::INFINITY, 5e-4)
    }

    /// Depth is taken off along the normal: a round of radius `r` from which an even depth is taken is a round.
    #[test]
    fn a_round_worn_evenly_stays_round() {
        let (radius, depth) = (0.3, 1e-3);
        let nodes = round(radius);
        let length = nodes.arcs().last().copied().unwrap();
        // A ring's part has a chord's length at half its depth.
        let volumes = nodes.surfaces(&nodes.arcs()).iter().map(|s| s * depth).collect::<Vec<_>>();
        let worn = nodes.worn(&volumes).unwrap();
        let taken = radius - (radius * radius - 2.0 * radius * depth).sqrt();
        // Ends have no curvature of their own.
        for ([y, z], by) in worn.points.iter().zip(&worn.depth).skip(1).take(worn.points.len() - 2)
        {
            let off = y.hypot(radius - z) - (radius - taken);
            // Chords of .5 mm: tangents are off by (h/r)^2; the ends' share of the volume is laid over all.
            assert!(off.abs() < 1e-8 && (by - taken).abs() < 1e-8, "{off} {by} {taken}");
        }
        // The sum of the volumes is that between the polygons, to rounding.
        assert!((worn.area / (depth * length) - 1.0).abs() < 1e-12);
        assert!(nodes.worn(&volumes.iter().map(|v| 400.0 * v).collect::<Vec<_>>()).is_none());
    }

    /// Volume between two S1002 wheels by their curves, not by their polygons: what was asked for, on the tread,
    /// in the root of the flange (radius 13 mm) and on its face.
    #[test]
    fn the_curves_enclose_the_volume_that_was_asked_for() {
        let nodes = s1002();
        let (arcs, role) = (nodes.arcs(), Role::Wheel);
        let body = |profile: &Profile| -> f64 {
            // pi r^2 dy by the trapezoid rule over 3 um.
            let curve = profile.curve();
            let points: Vec<_> = curve.stations(3e-6).iter().map(|s| curve.at(*s)).collect();
            let ring = |a: f64, b: f64| (a * a + a * b + b * b) / 3.0;
            let pairs = points.windows(2);
            pairs.map(|p| ring(0.46 + p[0].z, 0.46 + p[1].z) * (p[0].y - p[1].y)).sum::<f64>()
                * std::f64::consts::PI
        };
        let new = body(&nodes.profile(role).unwrap());
        for (y, sd) in [(0.0, 6e-3), (-0.030, 4e-3), (-0.040, 3e-3)] {
            let at = nodes.place(&arcs, role, y).unwrap();
            let surfaces = nodes.surfaces(&arcs);
            let bell = |s: f64| 1e-4 * (-0.5 * ((s - at) / sd) * ((s - at) / sd)).exp();
            let volumes: Vec<f64> =
                arcs.iter().zip(&surfaces).map(|(s, surface)| surface * bell(*s)).collect();
            let asked: f64 = volumes.iter().sum();
            let worn = nodes.worn(&volumes).unwrap();
            assert!((worn.volume / asked - 1.0).abs() < 1e-12);
            let lost = new - body(&worn.profile(role).unwrap());
            // Curve against polygon: sag h^2/8 of the changed curvature.
            assert!((lost / asked - 1.0).abs() < 1e-4, "{y} {lost:e} {asked:e}");
        }
    }
}
