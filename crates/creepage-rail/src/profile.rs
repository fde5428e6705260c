//! A profile: a curve that is a wheel's or a rail's.

use std::fmt;

use crate::Waves;
use crate::curve::{self, Curve, CurvePoint, Smoothing, SplineError};
use crate::search::threshold;

/// Role of a profile: wheel or rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A wheel: the curve runs from the field side to the flange.
    Wheel,
    /// A rail: the curve runs from the track side to the field side.
    Rail,
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Wheel { "wheel" } else { "rail" })
    }
}

/// A wheel's or rail's profile in its own coordinates (m): `y` to the field side, `z` down.
///
/// A wheel's `y = z = 0` is the nominal tape circle, where the radius is the nominal one. The
/// material lies on the right hand of the curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    role: Role,
    curve: Curve,
    /// Stretches without points (arc lengths, m), of a profile through points.
    unmeasured: Vec<[f64; 2]>,
}

/// Error of curves that are no profile.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// No curve goes through the points.
    #[error(transparent)]
    Spline(#[from] SplineError),
    /// A rail must run towards the field side (`y` rising), a wheel towards the flange.
    #[error("the {role:?}'s curve runs from y = {from} to {to} m: material on its left hand")]
    WrongSense {
        /// What the curve is for.
        role: Role,
        /// `y` of its start (m).
        from: f64,
        /// `y` of its end (m).
        to: f64,
    },
    /// The smoothing wavelength must be positive and at most 0.1 m, its weight positive and finite.
    #[error(
        "smoothing {} = {value} {}: must be {}",
        if *is_weight { "weight" } else { "wavelength" },
        if *is_weight { "m3" } else { "m" },
        if *is_weight { "positive and finite" } else { "positive, at most 0.1 m" }
    )]
    Smoothing {
        /// What was given (m, of a weight m3).
        value: f64,
        /// Whether that is a weight.
        is_weight: bool,
    },
    /// The arcs of a rail head do not fit together.
    #[error("arc {index} of the head, radius {radius} m, cannot end at half width {half_width} m")]
    Head {
        /// Index from the crown, from 0.
        index: usize,
        /// Its radius (m).
        radius: f64,
        /// Half width at which it should end (m).
        half_width: f64,
    },
}

/// Heights that differ by less are level (m).
const LEVEL: f64 = 1e-4;

/// Spacing of points (m) beyond which a stretch is not measured: 5 mm, and eight times the median.
pub(crate) fn longest_spacing(spacings: &[f64]) -> f64 {
    const LONG: f64 = 5e-3;
    const TIMES: f64 = 8.0;
    let mut sorted = spacings.to_vec();
    sorted.sort_by(f64::total_cmp);
    let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    LONG.max(TIMES * median)
}

impl Profile {
    /// A profile from its curve.
    ///
    /// # Errors
    /// [`ProfileError::WrongSense`] where the curve's ends lie the wrong way round.
    pub fn new(role: Role, curve: Curve) -> Result<Self, ProfileError> {
        let (from, to) = (curve.at(0.0).y, curve.before(curve.length()).y);
        let forward = if role == Role::Rail { to - from } else { from - to };
        if forward > 0.0 {
            Ok(Self::known(role, curve))
        } else {
            Err(ProfileError::WrongSense { role, from, to })
        }
    }

    /// A profile known to run the right way.
    pub(crate) fn known(role: Role, curve: Curve) -> Self {
        Self { role, curve, unmeasured: Vec::new() }
    }

    /// A profile through points `(y, z)` (m), with continuous slope and curvature but at the
    /// `corners` (indices).
    ///
    /// # Errors
    /// [`ProfileError`] for points that make no curve or run the wrong way.
    pub fn through(
        role: Role,
        points: &[[f64; 2]],
        corners: &[usize],
    ) -> Result<Self, ProfileError> {
        Ok(Self::new(role, curve::interpolate(points, corners)?)?.between_points())
    }

    /// The same, smoothed.
    ///
    /// # Errors
    /// [`ProfileError`] as by [`Profile::through`], and for a wavelength or a weight that is not positive.
    pub fn smoothed(
        role: Role,
        points: &[[f64; 2]],
        corners: &[usize],
        smoothing: Smoothing,
    ) -> Result<Self, ProfileError> {
        let (value, is_weight) = match smoothing {
            Smoothing::Wavelength(wavelength) => (wavelength, false),
            Smoothing::Weight(weight) => (weight, true),
        };
        // A longer wave is that of no profile.
        if !(value > 0.0 && value.is_finite() && (is_weight || value <= 0.1)) {
            return Err(ProfileError::Smoothing { value, is_weight });
        }
        Ok(Self::new(role, curve::smooth(points, corners, smoothing)?)?.between_points())
    }

    /// Notes the stretches without points: there is one piece between two points.
    fn between_points(mut self) -> Self {
        let lengths: Vec<f64> = self.curve.pieces().map(|(_, piece)| piece.length()).collect();
        let longest = longest_spacing(&lengths);
        let ends = self.curve.pieces().map(|(start, piece)| [start, start + piece.length()]);
        self.unmeasured = ends.filter(|[from, to]| to - from > longest).collect();
        self
    }

    /// Length (m) of the longest stretch without points that a range of arc length (m) reaches into: much longer than
    /// the usual spacing, 5 mm at least. `None` where there are points all along, and of profiles by arcs and lines.
    #[must_use]
    pub fn unmeasured(&self, [low, high]: [f64; 2]) -> Option<f64> {
        let reached = self.unmeasured.iter().filter(|[from, to]| *from < high && *to > low);
        reached.map(|[from, to]| to - from).max_by(f64::total_cmp)
    }

    /// Wheel or rail.
    #[must_use]
    pub fn role(&self) -> Role {
        self.role
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The first point along the curve at which `y` has the given value (m).
    #[must_use]
    pub fn at_y(&self, y: f64) -> Option<CurvePoint> {
        self.crossing(|point| point.y - y)
    }

    /// The first point along the curve at which `z` has the given value (m).
    #[must_use]
    pub fn at_z(&self, z: f64) -> Option<CurvePoint> {
        self.crossing(|point| point.z - z)
    }

    /// Waves within `reach` (m) along the curve of the first point with that `y` (m), that turn it
    /// by more than `least` (rad) to and fro; `None` without a whole one.
    #[must_use]
    pub fn waves(&self, y: f64, reach: f64, least: f64) -> Option<Waves> {
        let s = self.crossing_at(|point| point.y - y)?;
        Waves::of(&self.curve, [s - reach, s + reach], least)
    }

    /// [`Profile::unmeasured`] at the first point with that `y` (m).
    #[must_use]
    pub fn unmeasured_at(&self, y: f64) -> Option<f64> {
        let s = self.crossing_at(|point| point.y - y)?;
        self.unmeasured([s, s])
    }

    /// Arc length (m) of the floor of a rail's groove: the place that lies lowest below the heads on both of its
    /// sides, 5 mm at least. `None` where there is no groove.
    #[must_use]
    pub fn groove(&self) -> Option<f64> {
        /// Less deep is no groove (m).
        const DEEP: f64 = 5e-3;
        let stations = self.curve.stations(5e-4);
        let z: Vec<f64> = stations.iter().map(|&s| self.curve.at(s).z).collect();
        let highest = |high: &mut f64, z: &f64| {
            *high = high.min(*z);
            Some(*high)
        };
        let before: Vec<f64> = z.iter().scan(f64::INFINITY, highest).collect();
        let mut after: Vec<f64> = z.iter().rev().scan(f64::INFINITY, highest).collect();
        after.reverse();
        let depths = z.iter().zip(before.iter().zip(&after)).map(|(z, (a, b))| z - a.max(*b));
        let (floor, depth) = stations.iter().zip(depths).max_by(|a, b| a.1.total_cmp(&b.1))?;
        (self.role == Role::Rail && depth > DEEP).then_some(*floor)
    }

    /// Distance along `y` (m) between the highest places on both sides of a rail's groove: a wheel that is narrower
    /// runs in it. `None` where there is no groove.
    #[must_use]
    pub fn groove_opening(&self) -> Option<f64> {
        let floor = self.groove()?;
        let stations = self.curve.stations(5e-4);
        let places = stations.iter().map(|&s| (s, self.curve.at(s)));
        let (before, after): (Vec<_>, Vec<_>) = places.partition(|(s, _)| *s < floor);
        let shoulder = |side: &[(f64, CurvePoint)]| {
            let (_, highest) = side.iter().min_by(|a, b| a.1.z.total_cmp(&b.1.z))?;
            // Of a flat shoulder the place next to the groove.
            let near = |(_, point): &&(f64, CurvePoint)| point.z < highest.z + LEVEL;
            let distance = |(s, _): &&(f64, CurvePoint)| (s - floor).abs();
            let near = side.iter().filter(near);
            near.min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|(_, point)| point.y)
        };
        Some((shoulder(&after)? - shoulder(&before)?).abs())
    }

    /// Distance along `y` between its ends (m).
    #[must_use]
    pub fn width(&self) -> f64 {
        let ys = self.curve.stations(5e-4).into_iter().map(|s| self.curve.at(s).y);
        let range =
            ys.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| [low.min(y), high.max(y)]);
        (range[1] - range[0]).max(0.0)
    }

    fn crossing(&self, excess: impl Fn(CurvePoint) -> f64) -> Option<CurvePoint> {
        self.crossing_at(excess).map(|s| self.curve.at(s))
    }

    fn crossing_at(&self, excess: impl Fn(CurvePoint) -> f64) -> Option<f64> {
        let stations = self.curve.stations(5e-4);
        let bracket = stations.windows(2).find(|pair| {
            let [a, b] = [pair[0], pair[1]].map(|s| excess(self.curve.at(s)));
            a == 0.0 || b == 0.0 || (a < 0.0) != (b < 0.0)
        })?;
        let rising = excess(self.curve.at(bracket[0])) < excess(self.curve.at(bracket[1]));
        let before = |s: f64| (excess(self.curve.at(s)) < 0.0) == rising;
        Some(threshold([bracket[0], bracket[1]], before)[1])
    }
}
