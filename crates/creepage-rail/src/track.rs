//! Rails in place.
//!
//! A side is held as a right-hand one: `y` to the field side. The left side is its mirror image.

use crate::curve::CurvePoint;
use crate::search::threshold;
use crate::{GeometryError, Profile, Role};

/// Spacing of the stations between which a rail is looked up (m).
const STEP: f64 = 2.5e-4;

/// Where a rail stands across the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// The head's nearest point to the track centre, down to `height` (m) below its highest
    /// point, lies at half of `gauge` (m).
    Gauge {
        /// Distance between the two rails' nearest points (m).
        gauge: f64,
        /// Depth down to which they are looked for (m).
        height: f64,
    },
    /// The profile's origin lies that far from the track centre (m).
    Origin(f64),
}

impl Place {
    /// By the gauge (m) and the depth (m) above which it is measured.
    #[must_use]
    pub fn gauge(gauge: f64, height: f64) -> Self {
        Self::Gauge { gauge, height }
    }
}

/// A rail, canted and set in place, raised until its highest point touches the plane `z = 0`.
#[derive(Debug, Clone, PartialEq)]
pub struct Rail {
    profile: Profile,
    rotation: (f64, f64),
    shift: [f64; 2],
    /// Arc lengths and `y` of the part that a wheel can see from above, `y` rising.
    visible: Vec<(f64, f64)>,
}

impl Rail {
    /// Sets a rail's `profile` in place. A positive `cant` (rad) inclines the head towards the
    /// track centre.
    ///
    /// # Errors
    /// [`GeometryError`] for a wheel's profile, values not finite, and a head too low or too
    /// short for its gauge to be measured.
    pub fn new(profile: &Profile, cant: f64, place: Place) -> Result<Self, GeometryError> {
        if profile.role() != Role::Rail {
            return Err(GeometryError::NotA { role: Role::Rail });
        }
        if cant.is_nan() || cant.abs() >= 1.0 {
            return Err(GeometryError::Value { name: "cant", value: cant, range: "-1 to 1 rad" });
        }
        let (sin, cos) = (-cant).sin_cos();
        let mut rail = Self {
            profile: profile.clone(),
            rotation: (cos, sin),
            shift: [0.0; 2],
            visible: vec![],
        };
        let stations = rail.profile.curve().stations(STEP);
        rail.shift[1] = -rail.highest(&stations).z;
        rail.shift[0] = rail.offset(&stations, place)?;
        rail.visible = rail.seen_from_above(&stations);
        if rail.visible.len() < 2 {
            return Err(GeometryError::Hidden);
        }
        Ok(rail)
    }

    /// The profile as given.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Distance of the profile's origin from the track centre, and its `z` in the track (m).
    #[must_use]
    pub fn origin(&self) -> [f64; 2] {
        self.shift
    }

    /// The point at arc length `s`, in track coordinates of a right-hand rail.
    pub(crate) fn at(&self, s: f64) -> CurvePoint {
        self.profile.curve().at(s).moved(self.rotation, self.shift)
    }

    /// `y` of the visible part (m), from the track side to the field side.
    pub(crate) fn range(&self) -> [f64; 2] {
        let y = |end: Option<&(f64, f64)>| end.map_or(0.0, |&(_, y)| y);
        [y(self.visible.first()), y(self.visible.last())]
    }

    /// The visible point at `y`, to a tolerance: its arc length and itself. `None` beyond the
    /// visible part.
    pub(crate) fn at_y(&self, y: f64, tolerance: f64) -> Option<(f64, CurvePoint)> {
        let after = self.visible.partition_point(|&(_, known)| known <= y);
        let &(mut low, start) = self.visible.get(after.checked_sub(1)?)?;
        let &(mut high, end) = self.visible.get(after).or_else(|| self.visible.last())?;
        if y > end || y < start {
            return None;
        }
        let mut s =
            if end > start { low + (high - low) * (y - start) / (end - start) } else { low };
        let mut point = self.at(s);
        for _ in 0..60 {
            let excess = point.y - y;
            if excess.abs() < tolerance {
                break;
            }
            if excess > 0.0 {
                high = s;
            } else {
                low = s;
            }
            let step = s - excess / point.tangent[0];
            let next = if step > low && step < high { step } else { 0.5 * (low + high) };
            if (next - s).abs() < f64::EPSILON * s.abs() {
                break;
            }
            s = next;
            point = self.at(s);
        }
        Some((s, point))
    }

    /// The highest point: where the tangent is level, else the highest station.
    fn highest(&self, stations: &[f64]) -> CurvePoint {
        let lowest = |a: CurvePoint, b: CurvePoint| if b.z < a.z { b } else { a };
        let level = stations.windows(2).filter_map(|pair| {
            let rises = |s: f64| self.at(s).tangent[1] < 0.0;
            let inside = rises(pair[0]) && !rises(pair[1]);
            inside.then(|| self.at(threshold([pair[0], pair[1]], rises)[1]))
        });
        stations.iter().map(|&s| self.at(s)).chain(level).fold(self.at(0.0), lowest)
    }

    /// How far the origin stands from the track centre.
    fn offset(&self, stations: &[f64], place: Place) -> Result<f64, GeometryError> {
        let (gauge, height) = match place {
            Place::Origin(y) if y.is_finite() => return Ok(y),
            Place::Origin(value) => {
                return Err(GeometryError::Value { name: "rail_position", value, range: "finite" });
            }
            Place::Gauge { gauge, height } => (gauge, height),
        };
        if !(gauge > 0.0 && gauge.is_finite()) {
            return Err(GeometryError::Value { name: "gauge", value: gauge, range: "above 0 m" });
        }
        if !(height > 0.0 && height.is_finite()) {
            let range = "above 0 m";
            return Err(GeometryError::Value { name: "gauge_height", value: height, range });
        }
        let lowest = stations.first().map_or(0.0, |&s| self.at(s).z);
        if lowest < height {
            return Err(GeometryError::HeadTooLow { depth: lowest, height });
        }
        Ok(0.5 * gauge - self.nearest(stations, height))
    }

    /// Least `y` down to the given depth, on the track side of the highest point.
    fn nearest(&self, stations: &[f64], height: f64) -> f64 {
        let deep = |s: f64| self.at(s).z > height;
        let overhangs = |s: f64| self.at(s).tangent[0] < 0.0;
        let mut nearest = f64::INFINITY;
        for pair in stations.windows(2) {
            let ends = [pair[0], pair[1]];
            let mut count = |s: f64| {
                if !deep(s) {
                    nearest = nearest.min(self.at(s).y);
                }
            };
            count(ends[1]);
            if deep(ends[0]) && !deep(ends[1]) {
                count(threshold(ends, deep)[1]);
            }
            if overhangs(ends[0]) && !overhangs(ends[1]) {
                count(threshold(ends, overhangs)[1]);
            }
        }
        nearest
    }

    /// From the highest station outwards, as long as `y` goes on.
    fn seen_from_above(&self, stations: &[f64]) -> Vec<(f64, f64)> {
        let points: Vec<(f64, CurvePoint)> = stations.iter().map(|&s| (s, self.at(s))).collect();
        let higher = |best: usize, i: usize| {
            let z = |i: usize| points.get(i).map_or(f64::INFINITY, |p| p.1.z);
            if z(i) < z(best) { i } else { best }
        };
        let top = (0..points.len()).fold(0, higher);
        let (inner, outer) = points.split_at(top.min(points.len()));
        let mut bound = f64::INFINITY;
        let mut seen: Vec<(f64, f64)> = outer
            .first()
            .into_iter()
            .chain(inner.iter().rev())
            .take_while(|(_, p)| {
                let goes_on = p.y < bound && p.tangent[0] > 0.0;
                bound = p.y;
                goes_on
            })
            .map(|(s, p)| (*s, p.y))
            .collect();
        seen.reverse();
        let mut bound = seen.last().map_or(f64::NEG_INFINITY, |&(_, y)| y);
        seen.extend(
            outer
                .iter()
                .skip(1)
                .take_while(|(_, p)| {
                    let goes_on = p.y > bound && p.tangent[0] > 0.0;
                    bound = p.y;
                    goes_on
                })
                .map(|(s, p)| (*s, p.y)),
        );
        seen
    }
}

/// Two rails.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// The left rail, as its mirror image on the right.
    pub left: Rail,
    /// The right rail.
    pub right: Rail,
}

impl Track {
    /// Two like rails.
    ///
    /// # Errors
    /// [`GeometryError`] as by [`Rail::new`].
    pub fn new(profile: &Profile, cant: f64, place: Place) -> Result<Self, GeometryError> {
        let right = Rail::new(profile, cant, place)?;
        Ok(Self { left: right.clone(), right })
    }
}
