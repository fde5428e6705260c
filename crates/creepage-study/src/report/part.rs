//! Parts of a report that are no single number: words, counts, patches, laws, temperatures.

use std::collections::BTreeMap;

use creepage::friction_law::RollingFriction;
use creepage::gap::Rectangle;
use creepage::normal::Patch;
use serde::Serialize;

use super::quantity::Report;
use crate::{CurvedJson, Damage, Heat};

/// An entry of a report that is no single number.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum ReportPart {
    Text(Option<String>),
    Names(Option<Vec<&'static str>>),
    Count(usize),
    Numbers(Option<Vec<f64>>),
    Report(Option<Report>),
    Reports(Vec<Report>),
    Patches(Vec<PatchJson>),
    Friction(Option<FrictionLawJson>),
    Damage(Option<Damage>),
    Heat(Option<Heat>),
    Curved(Option<CurvedJson>),
    Details(BTreeMap<&'static str, DetailJson>),
}

impl ReportPart {
    /// Reports that it lists, each with its place in a list.
    pub(super) fn reports(&self) -> impl Iterator<Item = (Option<usize>, &Report)> {
        let (one, many) = match self {
            Self::Report(one) => (one.as_ref(), &[][..]),
            Self::Reports(many) => (None, &many[..]),
            _ => (None, &[][..]),
        };
        let many = many.iter().enumerate().map(|(k, report)| (Some(k), report));
        one.map(|report| (None, report)).into_iter().chain(many)
    }
}

impl From<&str> for ReportPart {
    fn from(words: &str) -> Self {
        Self::Text(Some(words.into()))
    }
}

/// One connected contact area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct PatchJson {
    /// The rectangle around it (m).
    extent_m: ExtentJson,
    /// Area (m^2).
    area_m2: f64,
    /// Load (N).
    load_n: f64,
    /// Centre of pressure `[x, y]` (m).
    centroid_m: [f64; 2],
}

/// A rectangle (m).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct ExtentJson {
    x: [f64; 2],
    y: [f64; 2],
}

impl From<&Patch> for PatchJson {
    fn from(patch: &Patch) -> Self {
        let Rectangle { x, y } = patch.extent();
        Self {
            extent_m: ExtentJson { x, y },
            area_m2: patch.area(),
            load_n: patch.load(),
            centroid_m: patch.centroid(),
        }
    }
}

/// How friction varies: by the speed of slip, or across the contact.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct FrictionLawJson {
    /// Coefficient at rest, the `mu` of all quantities.
    at_rest: f64,
    /// Coefficient at very high speed.
    kinetic: f64,
    /// `[drop, half speed (m/s)]` of each term.
    terms: Vec<[f64; 2]>,
    /// Distance of slip over which friction follows the speed (m), where it does.
    memory_distance_m: Option<f64>,
    /// The least speed that slip counts as in that (m/s).
    memory_speed_m_per_s: Option<f64>,
    /// `[temperature (degrees Celsius), coefficient]` of cold and of hot surfaces, where it depends on the
    /// temperature; else `null`.
    by_temperature: Option<[[f64; 2]; 2]>,
    /// `[y (m), coefficient]` where friction differs across the contact; else `null`.
    across: Option<Vec<[f64; 2]>>,
}

impl From<RollingFriction> for FrictionLawJson {
    fn from(friction: RollingFriction) -> Self {
        let (law, memory) = (friction.law(), friction.memory());
        Self {
            at_rest: law.at_rest(),
            kinetic: law.kinetic(),
            terms: law.terms().iter().map(|term| [term.drop, term.half_speed]).collect(),
            memory_distance_m: memory.map(|memory| memory.distance()),
            memory_speed_m_per_s: memory.map(|memory| memory.speed()),
            by_temperature: friction.of_temperature().map(|law| {
                let (range, ends) = (law.range(), law.ends());
                [0, 1].map(|k| [range[k], ends[k]])
            }),
            across: friction.by_place().map(|across| across.points().to_vec()),
        }
    }
}

/// A number that only one theory gives.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct DetailJson {
    /// What it is, in words.
    pub(crate) label: &'static str,
    /// The number.
    pub(crate) value: f64,
}
