//! `[wear.limits]`: measures of the profiles at which a run ends, as where wheels are to be turned.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::WearError;
use super::state::{WearStop, WornBody};
use crate::wheelset::error::checked;

const LIMITS: &str = "wear.limits";

/// Measures at which a run ends.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LimitSection {
    /// The greatest flange height Sh (m).
    flange_height: Option<f64>,
    /// The least flange thickness Sd (m).
    flange_thickness: Option<f64>,
    /// The least flange slope qR (m).
    flange_slope: Option<f64>,
    /// The greatest hollow of the tread (m).
    hollow: Option<f64>,
    /// The greatest depth along the normal (m), of wheels and rails.
    depth: Option<f64>,
    /// The greatest equivalent conicity at 3 mm.
    conicity: Option<f64>,
}

/// Measure of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WearMeasure {
    /// Flange height Sh.
    FlangeHeight,
    /// Flange thickness Sd.
    FlangeThickness,
    /// Flange slope qR.
    FlangeSlope,
    /// Hollow of the tread.
    Hollow,
    /// The greatest depth along the normal.
    Depth,
    /// Equivalent conicity at 3 mm.
    Conicity,
}

impl WearMeasure {
    /// Its key in `[wear.limits]`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::FlangeHeight => "flange_height",
            Self::FlangeThickness => "flange_thickness",
            Self::FlangeSlope => "flange_slope",
            Self::Hollow => "hollow",
            Self::Depth => "depth",
            Self::Conicity => "conicity",
        }
    }

    /// Whether wear brings it down to its limit.
    const fn falls(self) -> bool {
        matches!(self, Self::FlangeThickness | Self::FlangeSlope)
    }

    /// Its values at a stop: of each body that has it, or of the wheelset.
    fn values(self, stop: &WearStop) -> Vec<(Option<WornBody>, f64)> {
        let of_bodies = |value: fn(&super::WornProfile) -> Option<f64>| {
            let of = |body| Some((Some(body), value(stop.of(body)?)?));
            WornBody::ALL.into_iter().filter_map(of).collect()
        };
        match self {
            Self::FlangeHeight => of_bodies(|worn| Some(worn.measures?[0])),
            Self::FlangeThickness => of_bodies(|worn| Some(worn.measures?[1])),
            Self::FlangeSlope => of_bodies(|worn| Some(worn.measures?[2])),
            Self::Hollow => of_bodies(|worn| Some(worn.measures?[3])),
            Self::Depth => of_bodies(|worn| Some(worn.greatest())),
            Self::Conicity => stop.conicity.map(|value| (None, value)).into_iter().collect(),
        }
    }
}

/// A measure and the value at which a run ends (m; the conicity is a number).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearLimit {
    /// What is measured.
    pub measure: WearMeasure,
    /// Where the run ends.
    pub limit: f64,
}

/// Reason of a run's end before its distance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WearEnd {
    /// What reached its limit.
    pub measure: WearMeasure,
    /// Whose measure it is; `None` for the wheelset's.
    pub body: Option<WornBody>,
    /// The limit (m; the conicity is a number).
    pub limit: f64,
}

impl WearEnd {
    /// In words, such as "hollow of `wheel_right` reaches the limit of 2 mm".
    #[must_use]
    pub fn words(&self) -> String {
        let of = self.body.map(|body| format!(" of {}", body.name())).unwrap_or_default();
        let limit = match self.measure {
            WearMeasure::Conicity => format!("{}", self.limit),
            // Without the rounding of the unit.
            _ => format!("{} mm", (1e9 * self.limit).round() / 1e6),
        };
        format!("{}{of} reaches the limit of {limit}", self.measure.key().replace('_', " "))
    }
}

impl LimitSection {
    pub(super) fn limits(&self) -> Result<Vec<WearLimit>, WearError> {
        use WearMeasure::{Conicity, Depth, FlangeHeight, FlangeSlope, FlangeThickness, Hollow};
        let given = [
            (FlangeHeight, self.flange_height),
            (FlangeThickness, self.flange_thickness),
            (FlangeSlope, self.flange_slope),
            (Hollow, self.hollow),
            (Depth, self.depth),
            (Conicity, self.conicity),
        ];
        let mut limits = Vec::new();
        for (measure, value) in given {
            let Some(limit) = value else { continue };
            let most = if measure == Conicity { 10.0 } else { 0.2 };
            let is_valid = limit > 0.0 && limit <= most;
            let valid = "positive, a length of .2 m or a conicity of 10 at most";
            checked(LIMITS, measure.key(), limit, is_valid, valid)?;
            limits.push(WearLimit { measure, limit });
        }
        Ok(limits)
    }
}

/// Refuses limits that new profiles have passed, or of what they do not have.
pub(super) fn check(limits: &[WearLimit], new: &WearStop) -> Result<(), WearError> {
    for WearLimit { measure, limit } in limits.iter().copied() {
        let values = measure.values(new);
        // The conicity of some new profiles cannot be computed at 3 mm, but that of worn ones can.
        if values.is_empty() && measure != WearMeasure::Conicity {
            return Err(WearError::NoMeasure { measure: measure.key() });
        }
        for (body, value) in values {
            if is_passed(measure, value, limit) {
                let body = body.map_or("the wheelset", WornBody::name);
                return Err(WearError::LimitPassed { measure: measure.key(), body, value, limit });
            }
        }
    }
    Ok(())
}

/// The first limit that is reached between two stops, and the part of the way between them where it is, as if the
/// measure changed evenly.
pub(super) fn reached(
    limits: &[WearLimit],
    before: &WearStop,
    after: &WearStop,
) -> Option<(WearEnd, f64)> {
    let mut first: Option<(WearEnd, f64)> = None;
    for WearLimit { measure, limit } in limits.iter().copied() {
        let old = measure.values(before);
        for (body, value) in measure.values(after) {
            if !is_passed(measure, value, limit) {
                continue;
            }
            let from = old.iter().find(|(other, _)| *other == body).map(|(_, value)| *value);
            let part = from.map_or(1.0, |from| ((limit - from) / (value - from)).clamp(0.0, 1.0));
            if first.is_none_or(|(_, least)| part < least) {
                first = Some((WearEnd { measure, body, limit }, part));
            }
        }
    }
    first
}

fn is_passed(measure: WearMeasure, value: f64, limit: f64) -> bool {
    if measure.falls() { value <= limit } else { value >= limit }
}
