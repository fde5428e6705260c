//! `[rail.guard]`: a guard or check rail beside a rail, on which the back of the flange runs.

use std::path::Path;

use creepage_rail::{Place, Profile, Rail, Role, Side};
use schemars::JsonSchema;
use serde::Deserialize;

use super::case::ProfileNote;
use super::error::{WheelsetFileError, needed};
use super::friction::RailFrictionValue;
use super::profile::loaded;
use super::sections::ReadingSection;
use crate::case::CaseError;

/// Depth below the track plane down to which a flangeway is measured (m), where no gauge has one.
const DEPTH: f64 = 0.014;

/// A guard or check rail beside a rail: the back of the flange runs on its field side.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct GuardSection {
    /// Name of a standard profile, else a file beside the case file; its running face on its field side.
    pub(super) profile: Option<String>,
    /// The profile's points [y, z] (m) in place of a name, y to the field side, z down.
    pub(super) points: Option<Vec<[f64; 2]>>,
    /// What the profile's file does not show, or is to be read as, and how it is smoothed.
    #[schemars(with = "ReadingSection")]
    #[serde(default)]
    pub(super) reading: Option<ReadingSection>,
    /// true where the rail is grooved: the profile of [rail] has the guard beside a groove, on the track side.
    /// In place of a profile and its place.
    pub(super) grooved: Option<bool>,
    /// Distance from the gauge face of the running rail to the guard's running face (m), both down to
    /// `gauge_height` (else 14 mm) below the track plane. Give this or `position`.
    pub(super) flangeway: Option<f64>,
    /// Height of its highest point over the track plane (m), with `flangeway`; 0 by default.
    pub(super) height: Option<f64>,
    /// Where its profile's origin lies in place of `flangeway`: [from the track centre, down from the track
    /// plane] (m).
    pub(super) position: Option<[f64; 2]>,
    /// Turn of the profile as given (rad), positive inclines the head to the track centre; 0 by default.
    pub(super) cant: Option<f64>,
    /// Friction on it, where it differs from that on the running rail.
    #[schemars(with = "RailFrictionValue")]
    #[serde(default)]
    pub(super) friction: Option<RailFrictionValue>,
}

impl GuardSection {
    /// Whether the running rail's own profile has it.
    pub(super) fn is_grooved(&self) -> bool {
        self.grooved == Some(true)
    }

    /// Refuses a place and a profile of its own where the rail is grooved.
    pub(super) fn check(&self, section: &'static str) -> Result<(), CaseError> {
        if !self.is_grooved() {
            return Ok(());
        }
        let own = [
            ("profile", self.profile.is_some()),
            ("points", self.points.is_some()),
            ("reading", self.reading.is_some()),
            ("flangeway", self.flangeway.is_some()),
            ("height", self.height.is_some()),
            ("position", self.position.is_some()),
            ("cant", self.cant.is_some()),
        ];
        match own.into_iter().find(|(_, is_given)| *is_given) {
            Some((key, _)) => {
                let [first, second] = ["grooved", key].map(|key| (section, key));
                Err(CaseError::Conflict { first, second })
            }
            None => Ok(()),
        }
    }

    /// Its profile, with a note where it comes from a file.
    fn profile(
        &self,
        (section, side): (&'static str, Side),
        directory: &Path,
    ) -> Result<(Profile, Option<ProfileNote>), WheelsetFileError> {
        let given = (self.profile.as_deref(), self.points.as_deref());
        loaded(given, (section, Role::Rail, side, self.reading), directory)
    }

    /// The rail of a side with this one beside it; `section` is what the file calls it.
    pub(super) fn beside(
        &self,
        rail: Rail,
        (section, side, place): (&'static str, Side, Place),
        directory: &Path,
    ) -> Result<(Rail, Option<ProfileNote>), WheelsetFileError> {
        let (profile, note) = self.profile((section, side), directory)?;
        let geometry = WheelsetFileError::geometry(section);
        let cant = self.cant.unwrap_or(0.0);
        let conflict = |key| {
            let [first, second] = ["position", key].map(|key| (section, key));
            Err(CaseError::Conflict { first, second }.into())
        };
        let guarded = match (self.position, self.flangeway, self.height) {
            (Some(_), Some(_), _) => return conflict("flangeway"),
            (Some(_), None, Some(_)) => return conflict("height"),
            (Some(position), None, None) => {
                Rail::new(&profile, cant, Place::At(position)).map(|guard| rail.with_guard(guard))
            }
            (None, flangeway, height) => {
                let flangeway = needed(section, "flangeway", flangeway)?;
                let depth = if let Place::Gauge { height, .. } = place { height } else { DEPTH };
                rail.guarded(&profile, cant, [flangeway, height.unwrap_or(0.0), depth])
            }
        };
        Ok((guarded.map_err(geometry)?, note))
    }
}
