//! `[rail]` and `[track]` as numbers: where rails lie, their springs and motion, the track's width and curvature.

use creepage_rail::{Deviation, Place, RailMotion};
use creepage_wheelset::RailSprings;

use super::error::{checked, needed};
use super::sections::{RailSection, TrackSection};
use crate::case::CaseError;

impl RailSection {
    /// How it stands beside where it was laid, if it does.
    pub(super) fn deviation(&self) -> Option<Deviation> {
        let Self { dy, dz, droll, .. } = *self;
        let or = |value: Option<f64>| value.unwrap_or(0.0);
        (dy.or(dz).or(droll)).map(|_| Deviation { y: or(dy), z: or(dz), roll: or(droll) })
    }

    /// The springs on which it lies, if it does.
    pub(super) fn springs(&self, section: &'static str) -> Result<Option<RailSprings>, CaseError> {
        let positive = |key, value: Option<f64>| {
            let value = needed(section, key, value)?;
            checked(section, key, value, value > 0.0 && value.is_finite(), "positive and finite")
        };
        let finite = |key, value: Option<f64>| {
            let value = value.unwrap_or(0.0);
            checked(section, key, value, value.is_finite(), "finite")
        };
        let Self { stiffness_y, stiffness_z, force_y, force_z, .. } = *self;
        if stiffness_y.or(stiffness_z).or(force_y).or(force_z).is_none() {
            return Ok(None);
        }
        let stiffness =
            [positive("stiffness_y", stiffness_y)?, positive("stiffness_z", stiffness_z)?];
        let force = [finite("force_y", force_y)?, finite("force_z", force_z)?];
        Ok(Some(RailSprings { stiffness, force }))
    }

    pub(super) fn motion(&self) -> RailMotion {
        let or = |value: Option<f64>| value.unwrap_or(0.0);
        RailMotion {
            lateral_velocity: or(self.dy_rate),
            vertical_velocity: or(self.dz_rate),
            roll_rate: or(self.droll_rate),
        }
    }
}

impl TrackSection {
    /// Its curvature (1/m), positive where it bends to the right.
    pub(super) fn curvature(&self) -> Result<f64, CaseError> {
        match (self.curve_radius, self.curvature) {
            (Some(_), Some(_)) => {
                let [first, second] = ["curve_radius", "curvature"].map(|key| ("track", key));
                Err(CaseError::Conflict { first, second })
            }
            (Some(radius), None) => {
                let is_valid = radius.abs() >= 1.0;
                let valid = "1 m at least to either side, and positive in a right-hand curve";
                Ok(1.0 / checked("track", "curve_radius", radius, is_valid, valid)?)
            }
            (None, curvature) => {
                let curvature = curvature.unwrap_or(0.0);
                let is_valid = curvature.abs() <= 1.0;
                checked("track", "curvature", curvature, is_valid, "-1 to 1 a metre")
            }
        }
    }

    pub(super) fn place(&self) -> Result<Place, CaseError> {
        const TRACK: &str = "track";
        // Beyond any track: millimetres.
        let positive = |key, value: f64| {
            checked(TRACK, key, value, value > 0.0 && value <= WIDEST, "positive, at most 10 m")
        };
        let gauge = self.gauge.map(|_| "gauge").or(self.gauge_height.map(|_| "gauge_height"));
        if self.rail_height.is_some() && self.rail_position.is_none() {
            return Err(CaseError::Missing { section: TRACK.into(), key: "rail_position".into() });
        }
        match (self.rail_position, gauge) {
            (Some(y), None) => {
                let is_valid = (0.0..=WIDEST).contains(&y);
                let valid = "zero, or positive, at most 10 m";
                let y = checked(TRACK, "rail_position", y, is_valid, valid)?;
                Ok(self.rail_height.map_or(Place::Origin(y), |z| Place::At([y, z])))
            }
            (Some(_), Some(key)) => {
                let first = (TRACK, "rail_position");
                Err(CaseError::Conflict { first, second: (TRACK, key) })
            }
            (None, None) => {
                let keys = ["gauge (with gauge_height)", "rail_position"];
                Err(CaseError::MissingEither { section: TRACK, keys })
            }
            (None, Some(_)) => Ok(Place::Gauge {
                gauge: positive("gauge", needed(TRACK, "gauge", self.gauge)?)?,
                height: positive(
                    "gauge_height",
                    needed(TRACK, "gauge_height", self.gauge_height)?,
                )?,
            }),
        }
    }
}

/// Width of a track (m) that none has.
pub(super) const WIDEST: f64 = 10.0;
