//! Variation of wheels and rails along rolling: flats, polygons, corrugation, slices.
//!
//! Angles around a wheel are those of its material: `th` counts from straight down towards `+x` at pitch 0.
//! A wheel that has rolled forward by the pitch `p` shows `th = b + p` at the angle `b` from straight down.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use crate::GeometryError;
use crate::slices::SliceSurface;

/// Shape of a flat along the wheel's circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlatShape {
    /// Freshly ground by sliding: a chord with two edges, `r = R cos a/cos th` for `|th| < a`, `sin a = L/(2R)`.
    Chord,
    /// Worn round: `r = R - (d/2) (1 + cos(2 pi R th/L))` for `|R th| < L/2`.
    Haversine,
}

/// A flat on a wheel, alike across the whole profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flat {
    /// Length along the nominal circle (m).
    pub length: f64,
    /// Depth at the middle (m).
    pub depth: f64,
    /// Angle of its middle (rad), towards `+x` at pitch 0.
    pub angle: f64,
    /// Its shape.
    pub shape: FlatShape,
    /// Half of the angle that it takes (rad).
    half: f64,
}

impl Flat {
    /// A fresh flat: a chord of this length (m) on a wheel of this radius (m), its middle at `angle` (rad).
    ///
    /// # Errors
    /// [`GeometryError::Value`] unless the length is positive and below the radius.
    pub fn chord(length: f64, angle: f64, radius: f64) -> Result<Self, GeometryError> {
        check_length(length, angle, radius)?;
        let half = (0.5 * length / radius).asin();
        let depth = radius * (1.0 - half.cos());
        Ok(Self { length, depth, angle, shape: FlatShape::Chord, half })
    }

    /// A worn flat of this length and depth (m), its middle at `angle` (rad). Of depth 0 it is none.
    ///
    /// # Errors
    /// [`GeometryError::Value`] unless the length is positive and below the radius, and the depth is not
    /// negative and below a tenth of the length.
    pub fn haversine(
        length: f64,
        depth: f64,
        angle: f64,
        radius: f64,
    ) -> Result<Self, GeometryError> {
        check_length(length, angle, radius)?;
        if !(depth >= 0.0 && depth < 0.1 * length) {
            let range = "0 and above, and below a tenth of the flat's length (m)";
            return Err(GeometryError::Value { name: "flat.depth", value: depth, range });
        }
        let half = 0.5 * length / radius;
        Ok(Self { length, depth, angle, shape: FlatShape::Haversine, half })
    }

    /// Change of the radius (m) at a material angle (rad), and its derivative (m/rad), on a wheel of this radius.
    fn at(&self, th: f64, radius: f64) -> [f64; 2] {
        let from_middle = turned_to_middle(th - self.angle);
        if from_middle.abs() >= self.half {
            return [0.0; 2];
        }
        match self.shape {
            FlatShape::Chord => {
                let (sin, cos) = from_middle.sin_cos();
                let r = radius * self.half.cos() / cos;
                [r - radius, r * sin / cos]
            }
            FlatShape::Haversine => {
                let rate = PI / self.half;
                let (sin, cos) = (rate * from_middle).sin_cos();
                [-0.5 * self.depth * (1.0 + cos), 0.5 * self.depth * rate * sin]
            }
        }
    }
}

fn check_length(length: f64, angle: f64, radius: f64) -> Result<(), GeometryError> {
    if !(length > 0.0 && length < radius) {
        let range = "above 0 m and below the wheel's radius";
        return Err(GeometryError::Value { name: "flat.length", value: length, range });
    }
    if !angle.is_finite() {
        return Err(GeometryError::Value { name: "flat.angle", value: angle, range: "finite" });
    }
    Ok(())
}

/// The same angle between -pi and pi.
fn turned_to_middle(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// A harmonic of a wheel out of round: `dr = amplitude sin(order th + phase)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waviness {
    /// Waves on the circle.
    pub order: u32,
    /// Amplitude (m).
    pub amplitude: f64,
    /// Phase (rad).
    pub phase: f64,
}

/// A wave along a rail: `dz = amplitude sin(2 pi u/wavelength + phase)`, `u` along the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corrugation {
    /// Wavelength (m).
    pub wavelength: f64,
    /// Amplitude (m).
    pub amplitude: f64,
    /// Phase (rad).
    pub phase: f64,
}

/// Variation of a wheel around its axle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WheelVariation {
    /// Profiles at angles, in place of the one profile.
    pub slices: Option<Arc<SliceSurface>>,
    /// Flats.
    pub flats: Vec<Flat>,
    /// Harmonics.
    pub waviness: Vec<Waviness>,
}

/// Variation of a rail along the track.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RailVariation {
    /// Profiles at places along the track, in place of the one profile.
    pub slices: Option<Arc<SliceSurface>>,
    /// Waves.
    pub corrugation: Vec<Corrugation>,
}

impl WheelVariation {
    /// Without what changes nothing; `None` where nothing is left.
    pub(crate) fn pruned(mut self, radius: f64) -> Result<Option<Self>, GeometryError> {
        for wave in &self.waviness {
            let Waviness { order, amplitude, phase } = *wave;
            check_wave("waviness", [amplitude, phase], 0.1 * radius)?;
            if order == 0 || order > 2000 {
                let value = f64::from(order);
                let range = "1 to 2000 waves";
                return Err(GeometryError::Value { name: "waviness.order", value, range });
            }
        }
        self.flats.retain(|flat| flat.depth > 0.0);
        self.waviness.retain(|wave| wave.amplitude != 0.0);
        let is_round = self.slices.is_none() && self.flats.is_empty() && self.waviness.is_empty();
        Ok((!is_round).then_some(self))
    }

    /// Change of the radius (m) at a material angle (rad), and its derivative (m/rad).
    pub(crate) fn radial(&self, th: f64, radius: f64) -> [f64; 2] {
        let flats = self.flats.iter().map(|flat| flat.at(th, radius));
        let waves = self.waviness.iter().map(|wave| {
            let order = f64::from(wave.order);
            let (sin, cos) = (order * th + wave.phase).sin_cos();
            [wave.amplitude * sin, wave.amplitude * order * cos]
        });
        flats.chain(waves).fold([0.0; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]])
    }

    /// The shortest wave or feature along the circle (m), by which the search for contacts steps.
    pub(crate) fn shortest(&self, radius: f64) -> f64 {
        let waves = self.waviness.iter().map(|wave| TAU * radius / f64::from(wave.order));
        let flats = self.flats.iter().map(|flat| 0.5 * flat.length);
        waves.chain(flats).fold(f64::INFINITY, f64::min)
    }
}

impl RailVariation {
    /// Without what changes nothing; `None` where nothing is left.
    pub(crate) fn pruned(mut self) -> Result<Option<Self>, GeometryError> {
        for wave in &self.corrugation {
            let Corrugation { wavelength, amplitude, phase } = *wave;
            if !(wavelength >= 1e-3 && wavelength.is_finite()) {
                let (name, range) = ("corrugation.wavelength", "1e-3 m and above");
                return Err(GeometryError::Value { name, value: wavelength, range });
            }
            check_wave("corrugation", [amplitude, phase], 0.1 * wavelength)?;
        }
        self.corrugation.retain(|wave| wave.amplitude != 0.0);
        let is_prism = self.slices.is_none() && self.corrugation.is_empty();
        Ok((!is_prism).then_some(self))
    }

    /// Change of the height (m, down) at a place along the track, and its slope.
    pub(crate) fn down(&self, u: f64) -> [f64; 2] {
        self.corrugation.iter().fold([0.0; 2], |sum, wave| {
            let rate = TAU / wave.wavelength;
            let (sin, cos) = (rate * u + wave.phase).sin_cos();
            [sum[0] + wave.amplitude * sin, sum[1] + wave.amplitude * rate * cos]
        })
    }

    /// The shortest wave along the track (m).
    pub(crate) fn shortest(&self) -> f64 {
        self.corrugation.iter().map(|wave| wave.wavelength).fold(f64::INFINITY, f64::min)
    }
}

/// Amplitude and phase of a wave.
fn check_wave(
    of: &'static str,
    [amplitude, phase]: [f64; 2],
    most: f64,
) -> Result<(), GeometryError> {
    if amplitude.is_nan() || amplitude.abs() >= most {
        let range = "finite, and small beside the wave's length or the wheel";
        return Err(GeometryError::Value { name: amplitude_of(of), value: amplitude, range });
    }
    if !phase.is_finite() {
        return Err(GeometryError::Value { name: "phase", value: phase, range: "finite (rad)" });
    }
    Ok(())
}

fn amplitude_of(of: &'static str) -> &'static str {
    if of == "waviness" { "waviness.amplitude" } else { "corrugation.amplitude" }
}
