//! Profile that a case names: a standard one, or a file beside the case.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use creepage::InvalidValue;
use creepage_rail::file::{FileError, ReadOptions, Reading, SaidBy, read};
use creepage_rail::{Profile, ProfileError, Role, Side, SliceSurface, Smoothing, Standard};

use super::case::ProfileNote;
use super::error::{WheelsetFileError, needed};
use super::sections::ReadingSection;
use super::varying::{self, SlicesAsked};
use crate::case::CaseError;

/// A profile by its points (m), along it in either sense.
pub(super) fn of_points(
    (section, role): (&'static str, Role),
    points: &[[f64; 2]],
    smoothing: Option<Smoothing>,
) -> Result<Profile, WheelsetFileError> {
    let wrong = |source| WheelsetFileError::Points { section, source };
    if let Some(value) = points.as_flattened().iter().copied().find(|value| !value.is_finite()) {
        let invalid = InvalidValue { quantity: "points", value, valid: "finite" };
        return Err(CaseError::Invalid { section, invalid }.into());
    }
    let made = |points: &[[f64; 2]]| match smoothing {
        Some(smoothing) => Profile::smoothed(role, points, &[], smoothing),
        None => Profile::through(role, points, &[]),
    };
    match made(points) {
        Err(ProfileError::WrongSense { .. }) => {
            let turned: Vec<[f64; 2]> = points.iter().rev().copied().collect();
            made(&turned).map_err(wrong)
        }
        known => known.map_err(wrong),
    }
}

/// A profile that a section asks for.
pub(super) struct RequestedProfile<'a> {
    pub(super) section: &'static str,
    pub(super) name: &'a str,
    pub(super) role: Role,
    pub(super) side: Side,
    pub(super) reading: Option<ReadingSection>,
}

impl RequestedProfile<'_> {
    /// The profile, with a note where it comes from a file.
    pub(super) fn load(
        &self,
        directory: &Path,
    ) -> Result<(Profile, Option<ProfileNote>), WheelsetFileError> {
        if let Some(standard) = Standard::named(self.name) {
            self.check(standard.role())?;
            if self.reading.is_some() {
                let (section, profile) = (self.section, self.name.into());
                return Err(WheelsetFileError::NoFile { section, profile });
            }
            return Ok((standard.profile(), None));
        }
        let path = directory.join(self.name);
        let content = fs::read(&path).map_err(|source| self.nowhere(&path, source))?;
        let reading = self.reading(&content).map_err(|source| WheelsetFileError::Profile {
            section: self.section,
            path: path.clone(),
            source,
        })?;
        self.check(reading.profile.role())?;
        Ok((reading.profile, Some(ProfileNote { path, actions: reading.actions })))
    }

    /// What the file says it is goes before what the section is for; the shape and the section
    /// together go before the ending of its name.
    fn reading(&self, content: &[u8]) -> Result<Reading, FileError> {
        let wanted = self.reading.unwrap_or_default().wanted();
        let wanted = ReadOptions { side: Some(self.side), ..wanted };
        match read(self.name, content, &wanted) {
            Err(FileError::Ask { .. } | FileError::Role { by: SaidBy::Ending, .. }) => {
                read(self.name, content, &ReadOptions { role: Some(self.role), ..wanted })
            }
            known => known,
        }
    }

    fn check(&self, found: Role) -> Result<(), WheelsetFileError> {
        if found == self.role {
            return Ok(());
        }
        Err(WheelsetFileError::Role { section: self.section, profile: self.name.into(), found })
    }

    fn nowhere(&self, path: &Path, source: std::io::Error) -> WheelsetFileError {
        let fitting = Standard::NAMES.iter().filter(|(_, standard)| standard.role() == self.role);
        WheelsetFileError::NoProfile {
            section: self.section,
            profile: self.name.into(),
            names: fitting.map(|&(name, _)| name).collect(),
            path: path.into(),
            source,
        }
    }
}

/// Name or points of a profile, and the file of slices.
pub(super) type SurfaceNames<'a> = (Option<&'a str>, Option<&'a [[f64; 2]]>, Option<&'a str>);

/// One profile, or a surface through slices with the profile of the one nearest to 0.
pub(super) fn surface_of(
    (name, points, slices): SurfaceNames<'_>,
    asked: SlicesAsked,
    directory: &Path,
    notes: &mut Vec<ProfileNote>,
) -> Result<(Profile, Option<Arc<SliceSurface>>), WheelsetFileError> {
    let Some(slices) = slices else {
        return Ok((noted(loaded((name, points), asked, directory)?, notes), None));
    };
    let (section, ..) = asked;
    if let Some(other) = name.map(|_| "profile").or(points.map(|_| "points")) {
        let [first, second] = ["slices", other].map(|key| (section, key));
        return Err(CaseError::Conflict { first, second }.into());
    }
    let (surface, found) = varying::surface(slices, asked, directory)?;
    for note in found {
        noted(((), Some(note)), notes);
    }
    Ok((surface.profile().clone(), Some(surface)))
}

/// A profile by its name or its points, with a note where it comes from a file.
pub(super) fn loaded(
    given: (Option<&str>, Option<&[[f64; 2]]>),
    (section, role, side, reading): (&'static str, Role, Side, Option<ReadingSection>),
    directory: &Path,
) -> Result<(Profile, Option<ProfileNote>), WheelsetFileError> {
    reading.map_or(Ok(()), |reading| reading.check(section))?;
    match given {
        (Some(_), Some(_)) => {
            let [first, second] = ["profile", "points"].map(|key| (section, key));
            Err(CaseError::Conflict { first, second }.into())
        }
        (None, Some(points)) => {
            let smoothing =
                reading.map(|reading| reading.smoothing_of_points(section)).transpose()?;
            let smoothing = smoothing.flatten();
            Ok((of_points((section, role), points, smoothing)?, None))
        }
        (name, None) => {
            let name = needed(section, "profile", name)?;
            RequestedProfile { section, name, role, side, reading }.load(directory)
        }
    }
}

/// Keeps the note of a profile, once.
pub(super) fn noted<T>(
    (profile, note): (T, Option<ProfileNote>),
    notes: &mut Vec<ProfileNote>,
) -> T {
    notes.extend(note.filter(|note| !notes.contains(note)));
    profile
}
