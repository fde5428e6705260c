//! Surface through profiles at places along the track, or at angles around a wheel: slices.
//!
//! Features of the slices cut them into parts; each part is resampled to equal fractions of its arc length, and
//! the places of one fraction make a path from slice to slice. The surface is the tensor product of cubic
//! splines along the profiles and along the paths: linear between slices would put the curvature along rolling
//! into spikes. A part that some slices lack ends there, with an edge.

use std::f64::consts::TAU;

use crate::curve::spline_slopes;
use crate::{Profile, Role};

/// Spacing of the paths along a profile (m).
const PATHS: f64 = 2.5e-4;
/// Patches have their own stretch of the parameter `v` each, this long (m).
const STRETCH: f64 = 10.0;
/// Slices around a wheel that leave no wider gap than this (rad) go all the way round.
const SEAM: f64 = 0.1;
/// Slices that are repeated beyond the seam, for the spline to go on through it.
const REPEATED: usize = 6;

/// One profile of many.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    /// Place along the track (m), or angle around the wheel from straight down towards `+x` at pitch 0 (rad).
    pub u: f64,
    /// The profile there.
    pub profile: Profile,
    /// How far it is shifted there, `y` to the field side and `z` down (m).
    pub shift: [f64; 2],
    /// Arc lengths (m) of its features from the profile's start, a rail's from the track side, a wheel's from
    /// the field side; `None` where the slice lacks one. None at all: the profile is one part.
    pub features: Vec<Option<f64>>,
    /// Whether the surface has a kink along the track here.
    pub kink: bool,
}

/// Error of slices that make no surface.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SliceError {
    /// Fewer than two.
    #[error("{count} slices: a surface needs 2 at least")]
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// Places that do not rise.
    #[error("slice {index} at {u}: places must be finite and rise from slice to slice")]
    Order {
        /// Which slice, from 1.
        index: usize,
        /// Its place (m or rad).
        u: f64,
    },
    /// Another role's profile.
    #[error("slice {index}: a {role} profile is wanted")]
    Role {
        /// Which slice, from 1.
        index: usize,
        /// The role wanted.
        role: Role,
    },
    /// Another number of features.
    #[error(
        "slice {index} has {count} features and the first has {expected}: give every feature of \
        every slice, negative where it is absent, two at least or none"
    )]
    Features {
        /// Which slice, from 1.
        index: usize,
        /// How many it has.
        count: usize,
        /// How many the first has.
        expected: usize,
    },
    /// Features that do not rise.
    #[error("slice {index}: features must rise along the profile, which is {length:.6} m long")]
    FeatureOrder {
        /// Which slice, from 1.
        index: usize,
        /// Length of its profile (m).
        length: f64,
    },
    /// The list of kinks names a feature that lies at an end of the profile, or is not in the list.
    #[error("kinks: there is no feature {index} inside the profile")]
    NoFeature {
        /// Which was named, from 1.
        index: usize,
    },
    /// No part is there on two slices in a row.
    #[error("no part between features is there on two slices in a row")]
    Empty,
    /// Angles of more than a turn.
    #[error("slices span {span} rad: no more than one turn, 2 pi")]
    TooLong {
        /// From the first to the last (rad).
        span: f64,
    },
}

/// A value with its derivatives along the profile, along the path, and mixed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Node {
    value: [f64; 2],
    by_v: [f64; 2],
    by_u: [f64; 2],
    mixed: [f64; 2],
}

/// Parts that begin and end together, without a kink between.
#[derive(Debug, Clone, PartialEq)]
struct SurfacePatch {
    /// Places of its slices; twice where there is a kink.
    u: Vec<f64>,
    /// Parameter of its paths.
    v: Vec<f64>,
    /// Path by path of the first slice, then of the next.
    nodes: Vec<Node>,
    /// Whether it goes on, alike, before its first slice and behind its last.
    goes_on: [bool; 2],
}

/// A point of the surface in the profiles' coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SurfacePoint {
    /// `(y, z)` (m).
    pub(crate) place: [f64; 2],
    /// Derivatives by `v` and by `u`.
    pub(crate) by_v: [f64; 2],
    pub(crate) by_u: [f64; 2],
}

/// A surface through slices.
#[derive(Debug, Clone, PartialEq)]
pub struct SliceSurface {
    patches: Vec<SurfacePatch>,
    /// The profile of the slice nearest to `u = 0`.
    profile: Profile,
    range: [f64; 2],
    /// Whether it closes around the wheel.
    closed: bool,
}

impl SliceSurface {
    /// The surface through slices of rising `u`: of a rail along the track (m), of a wheel around it (rad).
    ///
    /// `kinks` names features, from 1, along which the surface has an edge. Beyond the slices it goes on alike;
    /// around a wheel it closes where the slices leave no gap wider than .1 rad.
    ///
    /// # Errors
    /// [`SliceError`] for slices out of order, profiles of the other role, and features that do not match.
    pub fn new(role: Role, slices: &[Slice], kinks: &[usize]) -> Result<Self, SliceError> {
        check(role, slices, kinks)?;
        let [first, .., last] = slices else {
            return Err(SliceError::TooFew { count: slices.len() });
        };
        let span = last.u - first.u;
        if role == Role::Wheel && span > TAU {
            return Err(SliceError::TooLong { span });
        }
        let closed = role == Role::Wheel && TAU - span < SEAM;
        let range = [first.u, last.u];
        let nearest = slices.iter().min_by(|a, b| a.u.abs().total_cmp(&b.u.abs())).unwrap_or(first);
        let profile = nearest.profile.clone();
        let all = if closed { around(slices) } else { slices.to_vec() };
        let patches = patches(&all, kinks);
        if patches.is_empty() {
            return Err(SliceError::Empty);
        }
        Ok(Self { patches, profile, range, closed })
    }

    /// The profile of the slice nearest to `u = 0`.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// First and last place (m or rad) of a slice.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Whether the surface goes on alike at `u`, beyond its slices.
    pub(crate) fn is_beyond(&self, u: f64) -> bool {
        !self.closed && !(self.range[0]..=self.range[1]).contains(&u)
    }

    /// The parameters of all paths.
    pub(crate) fn stations(&self) -> impl Iterator<Item = f64> {
        self.patches.iter().flat_map(|patch| patch.v.iter().copied())
    }

    /// How many patches there are, and the places of the slices of each.
    pub(crate) fn patch_slices(&self) -> impl Iterator<Item = (&[f64], &[f64])> {
        self.patches.iter().map(|patch| (patch.u.as_slice(), patch.v.as_slice()))
    }

    /// Whether the patch of `v` is there at `u`, and `v` inside.
    pub(crate) fn holds(&self, v: f64, u: f64) -> bool {
        let u = self.turned(u);
        self.patch(v).is_some_and(|patch| patch.holds_v(v) && patch.holds_u(u))
    }

    /// The point at `v` and `u`, by the nearest one where the patch ends.
    pub(crate) fn at(&self, v: f64, u: f64) -> Option<SurfacePoint> {
        Some(self.patch(v)?.at(v, self.turned(u)))
    }

    fn patch(&self, v: f64) -> Option<&SurfacePatch> {
        self.patches.get(patch_of(v))
    }

    /// An angle where the slices are.
    fn turned(&self, u: f64) -> f64 {
        if self.profile.role() == Role::Rail {
            return u;
        }
        let middle = self.range[0].midpoint(self.range[1]);
        u - TAU * ((u - middle) / TAU).round()
    }
}

/// The patch to which a parameter belongs.
pub(crate) fn patch_of(v: f64) -> usize {
    crate::curve::whole((v / STRETCH).max(0.0))
}

impl SurfacePatch {
    fn holds_u(&self, u: f64) -> bool {
        let first = self.u.first().copied().unwrap_or(0.0);
        let last = self.u.last().copied().unwrap_or(0.0);
        (u >= first || self.goes_on[0]) && (u <= last || self.goes_on[1])
    }

    fn holds_v(&self, v: f64) -> bool {
        let ends = self.v.first().zip(self.v.last());
        ends.is_some_and(|(first, last)| (*first..=*last).contains(&v))
    }

    /// Products of Hermite's cubics, whose slopes are those of the splines; beyond the paths along the tangent.
    fn at(&self, v: f64, u: f64) -> SurfacePoint {
        let (i, mut along) = cell(&self.u, u);
        let ends = self.u.first().zip(self.u.last());
        if ends.is_none_or(|(first, last)| u < *first || u > *last) {
            // It goes on alike.
            along[1] = Weights::default();
        }
        let (j, across) = cell(&self.v, v);
        let mut point = SurfacePoint { place: [0.0; 2], by_v: [0.0; 2], by_u: [0.0; 2] };
        for a in 0..2 {
            for b in 0..2 {
                let Some(node) = self.nodes.get((i + a) * self.v.len() + j + b) else { continue };
                for k in 0..2 {
                    let corner = |p: &Weights, q: &Weights| {
                        p.value[a] * (q.value[b] * node.value[k] + q.slope[b] * node.by_v[k])
                            + p.slope[a] * (q.value[b] * node.by_u[k] + q.slope[b] * node.mixed[k])
                    };
                    point.place[k] += corner(&along[0], &across[0]);
                    point.by_v[k] += corner(&along[0], &across[1]);
                    point.by_u[k] += corner(&along[1], &across[0]);
                }
            }
        }
        let (first, last) = (self.v.first().copied(), self.v.last().copied());
        let beyond = v - v.clamp(first.unwrap_or(v), last.unwrap_or(v));
        point.place = [0, 1].map(|k: usize| point.place[k] + beyond * point.by_v[k]);
        point
    }
}

/// Weights of values and slopes at both ends of a cell.
#[derive(Debug, Clone, Copy, Default)]
struct Weights {
    value: [f64; 2],
    slope: [f64; 2],
}

/// The cell that holds a place, and Hermite's weights for the value and for the derivative there; at the ends of
/// the cells beyond them.
fn cell(knots: &[f64], at: f64) -> (usize, [Weights; 2]) {
    let last = knots.len().saturating_sub(2);
    let mut index = knots.partition_point(|knot| *knot <= at).saturating_sub(1).min(last);
    let width =
        |index: usize| knots.get(index + 1).zip(knots.get(index)).map_or(1.0, |(b, a)| b - a);
    // The cell of a kink has no width.
    if width(index) <= 0.0 {
        index = index.saturating_sub(1);
    }
    let h = width(index);
    let start = knots.get(index).copied().unwrap_or(0.0);
    let t = (at - start) / h;
    let t = t.clamp(0.0, 1.0);
    let w = 1.0 - t;
    let value = Weights {
        value: [w * w * (1.0 + 2.0 * t), t * t * (3.0 - 2.0 * t)],
        slope: [h * t * w * w, -h * t * t * w],
    };
    let rate = 6.0 * t * w / h;
    let derivative =
        Weights { value: [-rate, rate], slope: [w * (1.0 - 3.0 * t), t * (3.0 * t - 2.0)] };
    (index, [value, derivative])
}

fn check(role: Role, slices: &[Slice], kinks: &[usize]) -> Result<(), SliceError> {
    let Some(first) = slices.first().filter(|_| slices.len() >= 2) else {
        return Err(SliceError::TooFew { count: slices.len() });
    };
    let expected = first.features.len();
    if let Some(&index) = kinks.iter().find(|index| !(2..expected).contains(*index)) {
        return Err(SliceError::NoFeature { index });
    }
    let mut before = f64::NEG_INFINITY;
    for (i, slice) in slices.iter().enumerate() {
        let index = i + 1;
        if !(slice.u.is_finite() && slice.u > before) {
            return Err(SliceError::Order { index, u: slice.u });
        }
        before = slice.u;
        if slice.profile.role() != role {
            return Err(SliceError::Role { index, role });
        }
        let count = slice.features.len();
        if count != expected || count == 1 {
            return Err(SliceError::Features { index, count, expected });
        }
        let length = slice.profile.curve().length();
        let given: Vec<f64> = slice.features.iter().flatten().copied().collect();
        let rises = given.windows(2).all(|pair| pair[0] < pair[1]);
        let inside = given.iter().all(|s| s.is_finite() && *s >= 0.0)
            && given.iter().rev().nth(1).is_none_or(|s| *s < length);
        if !(rises && inside) {
            return Err(SliceError::FeatureOrder { index, length });
        }
    }
    Ok(())
}

/// Slices all the way round, with some of them repeated beyond either end.
fn around(slices: &[Slice]) -> Vec<Slice> {
    let count = REPEATED.min(slices.len() - 1);
    let shifted = |slice: &Slice, turns: f64| Slice { u: slice.u + turns * TAU, ..slice.clone() };
    let before = slices.iter().rev().take(count).rev().map(|slice| shifted(slice, -1.0));
    let behind = slices.iter().take(count).map(|slice| shifted(slice, 1.0));
    let mut all: Vec<Slice> = before.chain(slices.iter().cloned()).chain(behind).collect();
    // A last slice that is the first again.
    all.dedup_by(|later, earlier| later.u - earlier.u < 1e-9);
    all
}

/// Ends of each part (m) on a slice; `None` where it is absent.
fn parts(slice: &Slice) -> Vec<Option<[f64; 2]>> {
    let length = slice.profile.curve().length();
    if slice.features.is_empty() {
        return vec![Some([0.0, length])];
    }
    let ends = slice.features.windows(2);
    ends.map(|pair| pair[0].zip(pair[1]).map(|(from, to)| [from, to.min(length)])).collect()
}

/// A part over the slices on which it is there in a row.
#[derive(Debug, Clone)]
struct Run {
    part: usize,
    slices: std::ops::Range<usize>,
}

fn patches(slices: &[Slice], kinks: &[usize]) -> Vec<SurfacePatch> {
    let ends: Vec<Vec<Option<[f64; 2]>>> = slices.iter().map(parts).collect();
    let count = ends.first().map_or(0, Vec::len);
    let is_there = |part: usize, slice: usize| {
        ends.get(slice).and_then(|e| e.get(part)).is_some_and(Option::is_some)
    };
    let mut runs: Vec<Vec<Run>> = Vec::new();
    for part in 0..count {
        let mut from = None;
        for slice in 0..=slices.len() {
            match (from, slice < slices.len() && is_there(part, slice)) {
                (None, true) => from = Some(slice),
                (Some(start), false) => {
                    from = None;
                    let run = Run { part, slices: start..slice };
                    // Feature `part + 1`, counted from 1, is where this part begins.
                    let before = runs.iter_mut().find(|runs| {
                        let last = runs.last();
                        last.is_some_and(|last| last.part + 1 == part && last.slices == run.slices)
                    });
                    match before {
                        Some(before) if !kinks.contains(&(part + 1)) => before.push(run),
                        _ => runs.push(vec![run]),
                    }
                }
                _ => {}
            }
        }
    }
    let long = runs.into_iter().filter(|runs| runs.first().is_some_and(|run| run.slices.len() > 1));
    let long = long.enumerate();
    long.filter_map(|(index, runs)| patch(index, slices, &ends, &runs)).collect()
}

/// Consecutive parts as one patch.
fn patch(
    index: usize,
    slices: &[Slice],
    ends: &[Vec<Option<[f64; 2]>>],
    runs: &[Run],
) -> Option<SurfacePatch> {
    let rows = runs.first()?.slices.clone();
    let (mut v, mut fractions) = (Vec::new(), Vec::new());
    let mut start = STRETCH * index as f64 + 0.1;
    for run in runs {
        let lengths = rows.clone().filter_map(|row| ends.get(row)?.get(run.part)?.as_ref());
        let mean = lengths.map(|[from, to]| to - from).sum::<f64>() / rows.len() as f64;
        let steps = crate::curve::whole((mean / PATHS).ceil().clamp(4.0, 4000.0));
        let first = usize::from(!v.is_empty());
        for k in first..=steps {
            let fraction = k as f64 / steps as f64;
            v.push(start + fraction * mean);
            fractions.push((run.part, fraction));
        }
        start += mean;
    }
    let mut u = Vec::new();
    let mut places = Vec::new();
    for row in rows.clone() {
        let slice = slices.get(row)?;
        let curve = slice.profile.curve();
        let line: Option<Vec<[f64; 2]>> = fractions
            .iter()
            .map(|(part, fraction)| {
                let [from, to] = ends.get(row)?.get(*part)?.as_ref().copied()?;
                let point = curve.at(from + fraction * (to - from));
                Some([point.y + slice.shift[0], point.z + slice.shift[1]])
            })
            .collect();
        let line = line?;
        // A kink has its slice twice, for a spline on either side.
        if slice.kink && row != rows.start && row + 1 != rows.end {
            u.push(slice.u);
            places.push(line.clone());
        }
        u.push(slice.u);
        places.push(line);
    }
    let goes_on = [rows.start == 0, rows.end == slices.len()];
    Some(SurfacePatch { nodes: nodes(&u, &v, &places), u, v, goes_on })
}

/// Values with the slopes of the splines in both directions.
fn nodes(u: &[f64], v: &[f64], places: &[Vec<[f64; 2]>]) -> Vec<Node> {
    let columns = v.len();
    let mut nodes: Vec<Node> =
        places.iter().flatten().map(|place| Node { value: *place, ..Node::default() }).collect();
    let segments = segments(u);
    for k in 0..2 {
        for row in nodes.chunks_mut(columns) {
            let values: Vec<f64> = row.iter().map(|node| node.value[k]).collect();
            let slopes = spline_slopes(v, &values);
            row.iter_mut().zip(slopes).for_each(|(node, slope)| node.by_v[k] = slope);
        }
        for column in 0..columns {
            for segment in &segments {
                let knots = u.get(segment.clone()).unwrap_or(&[]);
                let of = |take: fn(&Node, usize) -> f64| -> Vec<f64> {
                    let rows = segment.clone();
                    rows.filter_map(|row| nodes.get(row * columns + column))
                        .map(|node| take(node, k))
                        .collect()
                };
                let by_u = spline_slopes(knots, &of(|node, k| node.value[k]));
                let mixed = spline_slopes(knots, &of(|node, k| node.by_v[k]));
                for ((row, by_u), mixed) in segment.clone().zip(by_u).zip(mixed) {
                    if let Some(node) = nodes.get_mut(row * columns + column) {
                        (node.by_u[k], node.mixed[k]) = (by_u, mixed);
                    }
                }
            }
        }
    }
    nodes
}

/// Stretches of places without a kink between.
fn segments(u: &[f64]) -> Vec<std::ops::Range<usize>> {
    let mut segments = Vec::new();
    let mut start = 0;
    for (index, pair) in u.windows(2).enumerate() {
        if pair[1] <= pair[0] {
            segments.push(start..index + 1);
            start = index + 1;
        }
    }
    segments.push(start..u.len());
    segments
}
