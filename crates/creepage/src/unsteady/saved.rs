//! Saved state of a contact, to go on from it again: for a step that a larger program rejects, or as bytes for a run
//! that is interrupted.

use std::collections::VecDeque;

use super::control::{Control, Trend, Watched};
use super::fastsim::{self, RollingFastsim};
use super::history::{Past, TimeLevel};
use super::motion::{Motion, Prescribed};
use super::predictor;
use super::rolling::{Rolling, RollingState};
use super::variational::{RollingVariational, State};

/// Saved state of a contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Saved {
    tracks: [SavedTrack; 2],
    control: Control,
    travel: RollingState,
}

#[derive(Debug, Clone, PartialEq)]
struct SavedTrack {
    past: Past,
    creep: [f64; 3],
    traction: Vec<f64>,
    /// From which the limits of friction that depends on the slip go on.
    limits: Vec<f64>,
    /// How the last step changed the tractions.
    trend: Option<predictor::Trend>,
}

/// Error of bytes that are no state of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SavedError {
    /// They are damaged, cut off, or of another kind.
    #[error("these bytes hold no state of a rolling contact")]
    NoState,
    /// They are those of a contact with other elements.
    #[error("the state is that of a contact with other elements")]
    OtherElements,
    /// They are those of a contact of another case.
    #[error("the state is that of another contact")]
    OtherContact,
}

const MAGIC: [u8; 8] = *b"rolling5";

impl Rolling {
    /// What the contact remembers: going on from it gives the same, to the last bit.
    #[must_use]
    pub fn save(&self) -> Saved {
        let track = |track: &super::level::TransientLevel| {
            let mut traction = vec![0.0; 2 * track.elements.all.len()];
            track.state.traction.copy_to(&mut traction);
            let limits = track.state.limits.clone();
            let (past, trend) = (track.past.clone(), track.predictor.trend.clone());
            SavedTrack { past, creep: track.creep, traction, limits, trend }
        };
        let tracks = self.tracks.each_ref().map(track);
        Saved { tracks, control: self.control, travel: self.travel }
    }

    /// Goes back, or on, to what was saved.
    ///
    /// # Errors
    /// [`SavedError::OtherElements`] unless it was saved by a contact with as many elements.
    pub fn restore(&mut self, saved: &Saved) -> Result<(), SavedError> {
        let fits = |(track, saved): (&super::level::TransientLevel, &SavedTrack)| {
            let (elements, points) = (track.elements.all.len(), track.elements.points());
            let whole = |level: &TimeLevel| level.fits(points, elements);
            saved.traction.len() == 2 * elements
                && saved.limits.len() == elements
                && saved.trend.as_ref().is_none_or(|trend| trend.change.len() == 2 * elements)
                && !saved.past.0.is_empty()
                && saved.past.0.iter().all(whole)
        };
        if !self.tracks.iter().zip(&saved.tracks).all(fits) {
            return Err(SavedError::OtherElements);
        }
        for (track, saved) in self.tracks.iter_mut().zip(&saved.tracks) {
            track.state.traction.copy_from(&saved.traction);
            track.state.limits.clone_from(&saved.limits);
            track.past.clone_from(&saved.past);
            track.tractions.clear();
            track.creep = saved.creep;
            track.predictor.trend.clone_from(&saved.trend);
        }
        (self.control, self.travel) = (saved.control, saved.travel);
        Ok(())
    }
}

impl Saved {
    /// As bytes, which [`Saved::from_bytes`] reads on any machine.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Numbers::default();
        let RollingState { distance, load, next_load, motion, force } = self.travel;
        out.all(&[distance, load, next_load]);
        out.all(&force);
        out.motion(motion);
        out.all(&[self.control.next]);
        out.some(self.control.trend, |out, trend| {
            out.all(&trend.watched.force);
            out.all(&trend.watched.found);
            out.some(trend.rate, |out, rate| out.all(&rate));
        });
        for track in &self.tracks {
            track.write(&mut out);
        }
        out.sealed(MAGIC)
    }

    /// Reads what [`Saved::to_bytes`] wrote; `like` is a contact with the same elements.
    ///
    /// # Errors
    /// [`SavedError`] when the bytes are damaged.
    pub fn from_bytes(bytes: &[u8], like: &Rolling) -> Result<Self, SavedError> {
        let numbers = numbers(bytes, MAGIC).ok_or(SavedError::NoState)?;
        Self::read(numbers, like.control).ok_or(SavedError::NoState)
    }

    fn read(mut numbers: impl Iterator<Item = f64>, control: Control) -> Option<Self> {
        let from = &mut numbers;
        let [distance, load, next_load] = several(from)?;
        let force = several(from)?;
        let motion = if flag(from)? { Some(motion(from)?) } else { None };
        let next = from.next()?;
        let trend = if flag(from)? { Some(trend(from)?) } else { None };
        let tracks = [SavedTrack::read(from)?, SavedTrack::read(from)?];
        let travel = RollingState { distance, load, next_load, motion, force };
        Some(Self { tracks, control: Control { next, trend, ..control }, travel })
    }
}

const FASTSIM: [u8; 8] = *b"rollfas5";

impl RollingFastsim {
    /// What the contact remembers, as bytes.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        let fastsim::RollingState { distance, loads, creep, force } = self.travel;
        let past = self.past.clone();
        let track = SavedTrack { past, creep, traction: vec![], limits: vec![], trend: None };
        let mut out = Numbers(vec![distance]);
        out.all(&loads);
        out.all(&force);
        track.write(&mut out);
        out.sealed(FASTSIM)
    }

    /// Goes back, or on, to what was saved, to the last bit.
    ///
    /// # Errors
    /// [`SavedError`] for damaged bytes, and those of a contact with another number of cells.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SavedError> {
        let from = &mut numbers(bytes, FASTSIM).ok_or(SavedError::NoState)?;
        let [distance, now, next, fx, fy, mz] = several(from).ok_or(SavedError::NoState)?;
        let SavedTrack { past, creep, .. } = SavedTrack::read(from).ok_or(SavedError::NoState)?;
        let whole = |level: &TimeLevel| level.fits(self.size(), self.size());
        if past.0.is_empty() || !past.0.iter().all(whole) {
            return Err(SavedError::OtherElements);
        }
        let (loads, force) = ([now, next], [fx, fy, mz]);
        (self.past, self.travel) = (past, fastsim::RollingState { distance, loads, creep, force });
        Ok(())
    }
}

const VARIATIONAL: [u8; 8] = *b"rollvar1";

impl RollingVariational {
    /// What the contact remembers, as bytes.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        let State { distance, unresolved, creep, force, motion, now, before } = self.state();
        let mut out = Numbers(vec![*distance, *unresolved]);
        out.all(creep);
        out.all(force);
        out.motion(*motion);
        out.list(now);
        out.some(before.as_ref(), |out, (length, before)| {
            out.all(&[*length]);
            out.list(before);
        });
        out.sealed(VARIATIONAL)
    }

    /// Goes back, or on, to what was saved, to the last bit.
    ///
    /// # Errors
    /// [`SavedError`] for damaged bytes, and those of a contact with another degree or mesh.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SavedError> {
        let mut numbers = numbers(bytes, VARIATIONAL).ok_or(SavedError::NoState)?;
        let state = rolled_state(&mut numbers).ok_or(SavedError::NoState)?;
        if self.take(state) { Ok(()) } else { Err(SavedError::OtherElements) }
    }
}

fn rolled_state(from: &mut impl Iterator<Item = f64>) -> Option<State> {
    let [distance, unresolved] = several(from)?;
    let (creep, force) = (several(from)?, several(from)?);
    let motion = if flag(from)? { Some(motion(from)?) } else { None };
    let now = list(from)?;
    let before = if flag(from)? { Some((from.next()?, list(from)?)) } else { None };
    Some(State { distance, unresolved, creep, force, motion, now, before })
}

impl TimeLevel {
    /// Whether it has so many points of displacement, and friction of so many elements if of any.
    fn fits(&self, points: usize, elements: usize) -> bool {
        self.displacement.iter().all(|u| u.len() == points)
            && self.friction.iter().all(|values| [0, elements].contains(&values.len()))
    }
}

impl SavedTrack {
    fn write(&self, out: &mut Numbers) {
        out.all(&self.creep);
        out.list(&self.traction);
        out.list(&self.limits);
        out.some(self.trend.as_ref(), |out, trend| {
            out.all(&[trend.length]);
            out.list(&trend.change);
            out.some(trend.slope, |out, slope| out.all(slope.as_flattened()));
        });
        out.all(&[self.past.0.len() as f64]);
        for level in &self.past.0 {
            out.all(&[level.length, level.scale, f64::from(u8::from(level.smooth))]);
            out.all(&level.creep);
            level.displacement.iter().chain(&level.friction).for_each(|values| out.list(values));
        }
    }

    fn read(from: &mut impl Iterator<Item = f64>) -> Option<Self> {
        let creep = several(from)?;
        let (traction, limits) = (list(from)?, list(from)?);
        let trend = if flag(from)? {
            let (length, change) = (from.next()?, list(from)?);
            let slope = if flag(from)? {
                Some([several(from)?, several(from)?, several(from)?])
            } else {
                None
            };
            Some(predictor::Trend { length, change, slope })
        } else {
            None
        };
        let levels = count(from)?;
        let mut past = VecDeque::new();
        for _ in 0..levels {
            let [length, scale, smooth, xi, eta, chi] = several(from)?;
            past.push_back(TimeLevel {
                length,
                scale,
                creep: [xi, eta, chi],
                smooth: smooth != 0.0,
                displacement: [list(from)?, list(from)?],
                friction: [list(from)?, list(from)?, list(from)?],
            });
        }
        Some(Self { past: Past(past), creep, traction, limits, trend })
    }
}

/// Numbers in a row.
#[derive(Default)]
struct Numbers(Vec<f64>);

impl Numbers {
    fn all(&mut self, values: &[f64]) {
        self.0.extend_from_slice(values);
    }

    fn list(&mut self, values: &[f64]) {
        self.0.push(values.len() as f64);
        self.all(values);
    }

    fn motion(&mut self, motion: Option<Motion>) {
        self.some(motion.map(|motion| motion.components()), |out, parts| {
            for part in parts {
                let kind = f64::from(u8::from(part.force().is_some()));
                let value = part.force().or(part.creepage()).unwrap_or(0.0);
                out.all(&[kind, value]);
            }
        });
    }

    /// As bytes after a mark of their kind and a check sum.
    fn sealed(&self, magic: [u8; 8]) -> Vec<u8> {
        let body: Vec<u8> = self.0.iter().flat_map(|value| value.to_le_bytes()).collect();
        [&magic[..], &crc32fast::hash(&body).to_le_bytes(), &body].concat()
    }

    fn some<T>(&mut self, value: Option<T>, write: impl FnOnce(&mut Self, T)) {
        self.0.push(f64::from(u8::from(value.is_some())));
        if let Some(value) = value {
            write(self, value);
        }
    }
}

/// What [`Numbers::sealed`] wrote; `None` for bytes that are damaged or of another kind.
fn numbers(bytes: &[u8], magic: [u8; 8]) -> Option<impl Iterator<Item = f64>> {
    let (sum, body) = bytes.strip_prefix(&magic)?.split_at_checked(4)?;
    let is_whole = sum == crc32fast::hash(body).to_le_bytes() && body.len() % 8 == 0;
    is_whole.then(|| body.as_chunks::<8>().0.iter().map(|chunk| f64::from_le_bytes(*chunk)))
}

fn several<const N: usize>(from: &mut impl Iterator<Item = f64>) -> Option<[f64; N]> {
    let mut values = [0.0; N];
    for value in &mut values {
        *value = from.next()?;
    }
    Some(values)
}

fn flag(from: &mut impl Iterator<Item = f64>) -> Option<bool> {
    from.next().map(|value| value != 0.0)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked
fn count(from: &mut impl Iterator<Item = f64>) -> Option<usize> {
    let value = from.next()?;
    ((0.0..1e9).contains(&value) && value.fract() == 0.0).then_some(value as usize)
}

fn list(from: &mut impl Iterator<Item = f64>) -> Option<Vec<f64>> {
    let length = count(from)?;
    let values: Vec<f64> = from.take(length).collect();
    (values.len() == length).then_some(values)
}

fn motion(from: &mut impl Iterator<Item = f64>) -> Option<Motion> {
    let mut part = || {
        let [kind, value] = several(from)?;
        Some(if kind == 0.0 { Prescribed::Creepage(value) } else { Prescribed::Force(value) })
    };
    Some(Motion { longitudinal: part()?, lateral: part()?, spin: part()? })
}

fn trend(from: &mut impl Iterator<Item = f64>) -> Option<Trend> {
    let watched = Watched { force: several(from)?, found: several(from)? };
    let rate = if flag(from)? { Some(several(from)?) } else { None };
    Some(Trend { watched, rate })
}
