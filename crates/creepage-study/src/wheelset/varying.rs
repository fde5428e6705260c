//! Sections of wheels and rails that vary along rolling: slices, flats, harmonics, corrugation.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use creepage_rail::file::SliceList;
use creepage_rail::{Corrugation, Flat, Profile, Role, Side, Slice, SliceSurface, Waviness};
use schemars::JsonSchema;
use serde::Deserialize;

use super::case::ProfileNote;
use super::error::{WheelsetFileError, checked, needed};
use super::profile::{RequestedProfile, of_points};
use super::sections::ReadingSection;
use crate::case::CaseError;

/// A flat of a wheel, alike across its profile.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FlatSection {
    /// Length along the nominal circle (m).
    length: f64,
    /// Depth at its middle (m); that of a chord follows from its length.
    depth: Option<f64>,
    /// Angle of its middle around the wheel (rad), from straight down towards +x at pitch 0; 0 by default.
    angle: Option<f64>,
    /// "chord": fresh, with edges; "haversine" (the default): worn round.
    shape: Option<FlatShapeName>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum FlatShapeName {
    Chord,
    Haversine,
}

/// One flat or several.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "expected a flat { length, depth, angle, shape = \"chord\" or \"haversine\" }, or several in \
        brackets"
)]
pub(super) enum FlatValue {
    One(FlatSection),
    Several(Vec<FlatSection>),
}

/// A harmonic of a wheel: dr = amplitude sin(order th + phase).
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WavinessSection {
    /// Waves on the circle.
    order: u32,
    /// Amplitude (m).
    amplitude: f64,
    /// Phase (rad); 0 by default.
    phase: Option<f64>,
}

/// A wave along a rail: dz = amplitude sin(2 pi u/wavelength + phase), u along the track.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CorrugationSection {
    /// Wavelength (m).
    wavelength: f64,
    /// Amplitude (m).
    amplitude: f64,
    /// Phase (rad); 0 by default.
    phase: Option<f64>,
}

/// Parts of a chord's depth by which a given one may differ from it.
const SAME_DEPTH: f64 = 0.01;

impl FlatValue {
    pub(super) fn flats(
        &self,
        section: &'static str,
        radius: f64,
    ) -> Result<Vec<Flat>, WheelsetFileError> {
        let all = match self {
            Self::One(one) => std::slice::from_ref(one),
            Self::Several(all) => all,
        };
        all.iter().map(|flat| flat.flat(section, radius)).collect()
    }
}

impl FlatSection {
    fn flat(&self, section: &'static str, radius: f64) -> Result<Flat, WheelsetFileError> {
        let Self { length, depth, angle, shape } = *self;
        let angle = angle.unwrap_or(0.0);
        let is_valid = angle.is_nan() || angle.abs() <= TAU;
        checked(section, "flat.angle", angle, is_valid, "within 2 pi rad of zero")?;
        let made = if shape == Some(FlatShapeName::Chord) {
            let chord =
                Flat::chord(length, angle, radius).map_err(WheelsetFileError::geometry(section))?;
            let is_other = |depth: &f64| {
                let off = (depth / chord.depth - 1.0).abs();
                off.is_nan() || off >= SAME_DEPTH
            };
            if let Some(value) = depth.filter(is_other) {
                let needs = chord.depth;
                return Err(WheelsetFileError::ChordDepth { section, value, needs });
            }
            Ok(chord)
        } else {
            Flat::haversine(length, needed(section, "flat.depth", depth)?, angle, radius)
        };
        made.map_err(WheelsetFileError::geometry(section))
    }
}

impl From<&WavinessSection> for Waviness {
    fn from(of: &WavinessSection) -> Self {
        let WavinessSection { order, amplitude, phase } = *of;
        Self { order, amplitude, phase: phase.unwrap_or(0.0) }
    }
}

impl From<&CorrugationSection> for Corrugation {
    fn from(of: &CorrugationSection) -> Self {
        let CorrugationSection { wavelength, amplitude, phase } = *of;
        Self { wavelength, amplitude, phase: phase.unwrap_or(0.0) }
    }
}

/// A file of slices: profiles at places along the track or around a wheel.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct SlicesFile {
    slices: Vec<SliceEntry>,
    /// Features, from 1, along which the surface has an edge.
    #[serde(default)]
    kinks: Vec<usize>,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct SliceEntry {
    /// Place along the track (m), or angle around the wheel (rad).
    u: f64,
    profile: Option<String>,
    points: Option<Vec<[f64; 2]>>,
    /// Shift of the profile to the field side and down (m).
    #[serde(default)]
    dy: f64,
    #[serde(default)]
    dz: f64,
    /// Arc lengths of features (m), negative where absent.
    #[serde(default)]
    features: Vec<f64>,
    /// Whether the surface has a kink along the track here.
    #[serde(default)]
    kink: bool,
}

impl SlicesFile {
    /// In place of the reference program's list.
    fn of_list(list: SliceList) -> Self {
        let entry = |(u, name, features): (f64, String, Vec<f64>)| SliceEntry {
            u,
            profile: Some(name),
            points: None,
            dy: 0.0,
            dz: 0.0,
            features,
            kink: false,
        };
        Self { slices: list.slices.into_iter().map(entry).collect(), kinks: list.kinks }
    }
}

/// What is asked of slices: section, role, side, and how profiles are to be read.
pub(super) type SlicesAsked = (&'static str, Role, Side, Option<ReadingSection>);

/// The surface through the slices of a file, with notes of the files read.
pub(super) fn surface(
    name: &str,
    (section, role, side, reading): SlicesAsked,
    directory: &Path,
) -> Result<(Arc<SliceSurface>, Vec<ProfileNote>), WheelsetFileError> {
    reading.map_or(Ok(()), |reading| reading.check(section))?;
    let path = directory.join(name);
    let text = fs::read(&path).map_err(|source| WheelsetFileError::NoSlices {
        section,
        path: path.clone(),
        source,
    })?;
    let text = String::from_utf8_lossy(&text);
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let file = if matches!(extension.as_str(), "slcs" | "slcw") {
        let list = SliceList::read(&text, role);
        SlicesFile::of_list(list.map_err(|source| WheelsetFileError::SliceList {
            section,
            path: path.clone(),
            source,
        })?)
    } else {
        toml::from_str(&text).map_err(|source| WheelsetFileError::SlicesToml {
            section,
            path: path.clone(),
            source: Box::new(source),
        })?
    };
    let beside = path.parent().unwrap_or(directory);
    let mut notes = vec![ProfileNote { path: path.clone(), actions: Vec::new() }];
    let mut slices = Vec::with_capacity(file.slices.len());
    for entry in file.slices {
        let (profile, note) = entry.profile((section, role, side, reading), beside)?;
        if let Some(mut note) = note {
            // What was found in all alike is said once.
            if notes.iter().skip(1).any(|known| known.actions == note.actions) {
                note.actions = Vec::new();
            }
            if !notes.iter().any(|known| known.path == note.path) {
                notes.push(note);
            }
        }
        let features =
            entry.features.iter().map(|s| (*s >= 0.0 || s.is_nan()).then_some(*s)).collect();
        for (key, value) in [("dy", entry.dy), ("dz", entry.dz)] {
            super::error::checked("slices", key, value, value.abs() < 1.0, "finite, below 1 m")?;
        }
        let shift = [entry.dy, entry.dz];
        slices.push(Slice { u: entry.u, profile, shift, features, kink: entry.kink });
    }
    let surface = SliceSurface::new(role, &slices, &file.kinks);
    let surface = surface.map_err(|source| WheelsetFileError::Slices { section, path, source })?;
    Ok((Arc::new(surface), notes))
}

impl SliceEntry {
    fn profile(
        &self,
        (section, role, side, reading): SlicesAsked,
        directory: &Path,
    ) -> Result<(Profile, Option<ProfileNote>), WheelsetFileError> {
        match (&self.profile, &self.points) {
            (Some(_), Some(_)) => {
                let [first, second] = ["profile", "points"].map(|key| ("slices", key));
                Err(CaseError::Conflict { first, second }.into())
            }
            (None, Some(points)) => {
                let smoothing =
                    reading.map(|reading| reading.smoothing_of_points(section)).transpose()?;
                let smoothing = smoothing.flatten();
                Ok((of_points((section, role), points, smoothing)?, None))
            }
            (name, None) => {
                let name = needed("slices", "profile", name.as_deref())?;
                let standard = creepage_rail::Standard::named(name).is_some();
                let reading = reading.filter(|_| !standard);
                RequestedProfile { section, name, role, side, reading }.load(directory)
            }
        }
    }
}
