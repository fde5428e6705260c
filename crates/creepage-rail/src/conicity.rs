//! Equivalent conicity of EN 15302: from the difference of rolling radii, integrated over a wave of the wheelset.

use crate::search::threshold;
use crate::{GeometryError, WheelsetOnTrack};

/// Points of the integral over half a wave.
const PHASES: usize = 2000;
/// Spacing of the radius difference that is integrated, linear between (m): the standard's own.
/// Next to a jump of contact the conicity depends on it.
const DIFFERENCE_SPACING: f64 = 1e-4;
/// The conicity of a smaller amplitude (m) is that of this one: differences of its potential are rounding errors.
const LEAST_AMPLITUDE: f64 = 0.1 * DIFFERENCE_SPACING;
/// Rounding of the radius difference (m).
const ROUNDING: f64 = 1e-12;

/// The difference of rolling radii over the lateral position, and what follows from it.
///
/// The wheelset without mass runs by `y'' = -difference(y) / (e r_0)`; the equivalent conicity
/// for an amplitude is that of the cones which run with the same wavelength.
#[derive(Debug, Clone, PartialEq)]
pub struct RadiusDifference {
    /// Lateral positions, even (m).
    from: f64,
    values: Vec<f64>,
    /// Integral of the values, from the first (m^2).
    potential: Vec<f64>,
    /// Distance of the tape circles times the mean radius (m^2).
    scale: f64,
    /// Why it ends at either side, where it does not go as far as was asked for.
    ends: [Option<GeometryError>; 2],
}

/// Error of an amplitude that the profiles do not hold.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConicityError {
    /// The profiles do not meet at the track's centre.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// Contact ends before the wheelset has swung that far.
    #[error("amplitude {amplitude} m: contact exists for y from {from:.4} to {to:.4} m only{}", why(*end))]
    TooFar {
        /// The amplitude wanted (m).
        amplitude: f64,
        /// Least lateral position with contact (m).
        from: f64,
        /// Greatest lateral position with contact (m).
        to: f64,
        /// What ends it at the nearer side.
        end: Option<GeometryError>,
    },
    /// The radius difference leads the wheelset back nowhere, so it does not swing.
    #[error("the radius difference never steers the wheelset back to the centre")]
    Unstable,
    /// The amplitude must be positive and finite.
    #[error("amplitude = {amplitude} m: must be positive and finite")]
    Amplitude {
        /// What was given (m).
        amplitude: f64,
    },
}

impl WheelsetOnTrack {
    /// The difference of rolling radii as far as contact exists, at most to `reach` (m) to either
    /// side.
    ///
    /// EN 15302 leaves roll out (`Some(0.0)`); `None` lets the wheelset roll until both touch.
    ///
    /// # Errors
    /// [`GeometryError`] where the profiles do not meet at the centre, and for whatever else but
    /// their ends.
    pub fn radius_differences(
        &self,
        reach: f64,
        roll: Option<f64>,
    ) -> Result<RadiusDifference, GeometryError> {
        let centre = self.radius_difference(0.0, roll)?;
        let [left, right] = [-1.0, 1.0].map(|sense| self.walk(sense, reach, roll));
        let ((mut values, first), (right, last)) = (left?, right?);
        let from = -DIFFERENCE_SPACING * values.len() as f64;
        values.reverse();
        values.push(centre);
        values.extend(right);
        let wheelset = self.wheelset();
        let scale = wheelset.tape_distance() * wheelset.radius();
        Ok(RadiusDifference { ends: [first, last], ..RadiusDifference::new(from, values, scale) })
    }

    /// Radius differences to one side of the centre, until the profiles no longer meet, and why
    /// they do not.
    fn walk(
        &self,
        sense: f64,
        reach: f64,
        roll: Option<f64>,
    ) -> Result<(Vec<f64>, Option<GeometryError>), GeometryError> {
        let count = crate::curve::whole((reach / DIFFERENCE_SPACING).clamp(0.0, 1e4));
        let mut values = Vec::new();
        for i in 1..=count {
            match self.radius_difference(sense * i as f64 * DIFFERENCE_SPACING, roll) {
                Ok(value) => values.push(value),
                Err(end @ (GeometryError::End { .. } | GeometryError::Apart { .. })) => {
                    return Ok((values, Some(end)));
                }
                Err(error) => return Err(error),
            }
        }
        Ok((values, None))
    }
}

fn why(end: Option<GeometryError>) -> String {
    end.map_or_else(String::new, |end| format!(": {end}"))
}

impl RadiusDifference {
    fn new(from: f64, values: Vec<f64>, scale: f64) -> Self {
        let mut sum = 0.0;
        let steps = values.windows(2).map(|pair| {
            sum += 0.5 * DIFFERENCE_SPACING * (pair[0] + pair[1]);
            sum
        });
        let potential = [0.0].into_iter().chain(steps).collect();
        Self { from, values, potential, scale, ends: [None; 2] }
    }

    /// Lateral positions between which contact exists (m).
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.from, self.from + DIFFERENCE_SPACING * (self.values.len().saturating_sub(1)) as f64]
    }

    /// Lateral position and difference (m), right less left, every .1 mm.
    pub fn rows(&self) -> impl Iterator<Item = (f64, f64)> {
        let place = |i: usize| self.from + DIFFERENCE_SPACING * i as f64;
        self.values.iter().enumerate().map(move |(i, &value)| (place(i), value))
    }

    /// The difference (m), right less left, at lateral position `y` (m). `None` out of range.
    #[must_use]
    pub fn at(&self, y: f64) -> Option<f64> {
        let [from, to] = self.range();
        if !(from..=to).contains(&y) {
            return None;
        }
        let (index, part) = self.place(y);
        let value = |i: usize| self.values.get(i).copied();
        Some((1.0 - part) * value(index)? + part * value(index + 1).or_else(|| value(index))?)
    }

    /// Index below `y` and the part of the step above it.
    fn place(&self, y: f64) -> (usize, f64) {
        let steps = ((y - self.from) / DIFFERENCE_SPACING).max(0.0);
        let index = crate::curve::whole(steps).min(self.values.len().saturating_sub(2));
        (index, steps - index as f64)
    }

    /// Integral of the difference from the start, which is linear between the values.
    fn potential_at(&self, y: f64) -> f64 {
        let (index, part) = self.place(y);
        let value = |i: usize| self.values.get(i).copied().unwrap_or(0.0);
        let start = self.potential.get(index).copied().unwrap_or(0.0);
        start
            + DIFFERENCE_SPACING
                * part
                * (value(index) + 0.5 * part * (value(index + 1) - value(index)))
    }

    /// Equivalent conicity for an amplitude (m): half of what the wheelset swings from side to
    /// side.
    ///
    /// # Errors
    /// [`ConicityError`] where contact ends before, or the wheelset does not swing.
    pub fn conicity(&self, amplitude: f64) -> Result<f64, ConicityError> {
        // Between two values the difference is a straight line, of one slope whatever the amplitude.
        let [low, high] = self.turning_points(match amplitude {
            small if small > 0.0 && small < LEAST_AMPLITUDE => LEAST_AMPLITUDE,
            amplitude => amplitude,
        })?;
        let (middle, half) = (low.midpoint(high), 0.5 * (high - low));
        let energy = self.potential_at(low).midpoint(self.potential_at(high));
        // y = middle + half sin t takes the roots out of both ends.
        let step = std::f64::consts::PI / PHASES as f64;
        let sum: f64 = (0..PHASES)
            .map(|i| -std::f64::consts::FRAC_PI_2 + (i as f64 + 0.5) * step)
            .map(|t| {
                let left = energy - self.potential_at(middle + half * t.sin());
                half * t.cos() / (2.0 * left).max(f64::MIN_POSITIVE).sqrt()
            })
            .sum();
        let wavelength = 2.0 * sum * step * self.scale.sqrt();
        let wave_number = std::f64::consts::TAU / wavelength;
        Ok(0.5 * self.scale * wave_number * wave_number)
    }

    /// Two positions `2 amplitude` apart with one potential, and less between.
    fn turning_points(&self, amplitude: f64) -> Result<[f64; 2], ConicityError> {
        if !(amplitude > 0.0 && amplitude.is_finite()) {
            return Err(ConicityError::Amplitude { amplitude });
        }
        let [from, to] = self.range();
        let centre = self.centre().ok_or(ConicityError::Unstable)?;
        // Higher to the right than to the left: too far right.
        let excess = |low: f64| self.potential_at(low + 2.0 * amplitude) - self.potential_at(low);
        let [left, right] =
            [(centre - 2.0 * amplitude).max(from), centre.min(to - 2.0 * amplitude)];
        if !(left <= right && excess(left) <= 0.0 && excess(right) >= 0.0) {
            let end = self.ends[usize::from(to.abs() < from.abs())];
            return Err(ConicityError::TooFar { amplitude, from, to, end });
        }
        let [low, _] = threshold([left, right], |low| excess(low) <= 0.0);
        // Where wheels run on cylinders nothing steers: waves of any length, conicity zero.
        let steered = self.potential_at(low) >= self.potential_at(centre) - ROUNDING * amplitude;
        steered.then_some([low, low + 2.0 * amplitude]).ok_or(ConicityError::Unstable)
    }

    /// The position nearest to the middle at which the difference rises through zero.
    fn centre(&self) -> Option<f64> {
        let crossings = self.values.windows(2).enumerate().filter_map(|(i, pair)| {
            let (a, b) = (pair[0], pair[1]);
            let rises = a <= 0.0 && b >= 0.0 && b > a;
            rises.then(|| self.from + DIFFERENCE_SPACING * (i as f64 - a / (b - a)))
        });
        crossings.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }
}
