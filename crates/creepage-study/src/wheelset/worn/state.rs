//! State of a run of wear: profiles, records, and the file in which they outlive a kill.

use std::fs;
use std::io::Write;
use std::path::Path;

use creepage_rail::{Profile, Role, Side, WheelMeasures, WheelsetOnTrack};
use serde::{Deserialize, Serialize};

use super::error::WearError;
use super::limits::WearEnd;
use super::nodes::Nodes;
use super::rates::Rates;
use super::section::{WearPlan, WornBodies};
use crate::WholeFile;
use crate::sources::keep_foreign;
use crate::wheelset::WheelsetCase;

/// What the file of a run begins with.
const HEAD: &[u8] = b"{\"creepage_wear\":1,";
/// Amplitude of the conicity (m).
const AMPLITUDE: f64 = 3e-3;

/// A wheel or a rail of one side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WornBody {
    /// The left wheel.
    WheelLeft,
    /// The right wheel.
    WheelRight,
    /// The left rail.
    RailLeft,
    /// The right rail.
    RailRight,
}

impl WornBody {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::WheelLeft, Self::WheelRight, Self::RailLeft, Self::RailRight];

    /// `wheel_left`, `wheel_right`, `rail_left` or `rail_right`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::WheelLeft => "wheel_left",
            Self::WheelRight => "wheel_right",
            Self::RailLeft => "rail_left",
            Self::RailRight => "rail_right",
        }
    }

    /// Its side.
    #[must_use]
    pub const fn side(self) -> Side {
        match self {
            Self::WheelLeft | Self::RailLeft => Side::Left,
            Self::WheelRight | Self::RailRight => Side::Right,
        }
    }

    /// Wheel or rail.
    #[must_use]
    pub const fn role(self) -> Role {
        match self {
            Self::WheelLeft | Self::WheelRight => Role::Wheel,
            Self::RailLeft | Self::RailRight => Role::Rail,
        }
    }
}

/// The bodies that wear, in the order of [`WornBody::ALL`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Bodies([Option<Nodes>; 4]);

impl Bodies {
    /// Those that are new.
    pub(super) fn new(case: &WheelsetCase, plan: &WearPlan) -> Self {
        Self(WornBody::ALL.map(|body| {
            let wears = match body.role() {
                Role::Wheel => plan.body != WornBodies::Rail,
                Role::Rail => plan.body != WornBodies::Wheel,
            };
            let is_there = case.stance.side.is_none_or(|side| side == body.side());
            let [wheel, rail] = case.running.profiles(body.side());
            let profile = if body.role() == Role::Wheel { wheel } else { rail };
            let radius = match body.role() {
                Role::Wheel => case.running.wheelset().wheel(body.side()).radius(),
                Role::Rail => f64::INFINITY,
            };
            (wears && is_there).then(|| Nodes::of(profile, radius, plan.spacing))
        }))
    }

    pub(super) fn of(&self, body: WornBody) -> Option<&Nodes> {
        self.0.get(body as usize)?.as_ref()
    }

    /// Wheels and rails with these profiles.
    pub(super) fn running(&self, new: &WheelsetOnTrack) -> Result<WheelsetOnTrack, WearError> {
        let profile = |body: WornBody| -> Result<Option<Profile>, WearError> {
            self.of(body)
                .map(|nodes| {
                    let wrong = |source| WearError::Profile { body: body.name(), source };
                    nodes.profile(body.role()).map_err(wrong)
                })
                .transpose()
        };
        let [a, b, c, d] = WornBody::ALL.map(profile);
        let [a, b, c, d] = [a?, b?, c?, d?];
        Ok(new.with_profiles([a.as_ref(), b.as_ref()], [c.as_ref(), d.as_ref()])?)
    }

    /// These after a part of what they would lose over the whole distance was taken off.
    pub(super) fn worn(&self, rates: &Rates, part: f64) -> Result<Self, WearError> {
        let mut worn = self.clone();
        for (k, body) in WornBody::ALL.into_iter().enumerate() {
            let (Some(nodes), Some(rate)) = (&self.0[k], &rates.of[k]) else { continue };
            let volumes: Vec<f64> = rate.iter().map(|volume| part * volume).collect();
            let new = nodes.worn(&volumes).ok_or(WearError::Crosses { body: body.name() })?;
            worn.0[k] = Some(Nodes { by_law: nodes.by_law + part * rates.by_law[k], ..new });
        }
        Ok(worn)
    }

    /// The same with points laid anew where that is needed.
    pub(super) fn even(self, spacing: f64) -> Self {
        Self(self.0.map(|nodes| nodes.map(|nodes| nodes.even(spacing))))
    }

    /// By how much the volume that is gone differs from what the law asked for, in parts of it.
    pub(super) fn imbalance(&self) -> f64 {
        let off = |nodes: &Nodes| {
            let Nodes { volume, by_law, .. } = nodes;
            if *by_law > 0.0 { (volume / by_law - 1.0).abs() } else { volume.abs() }
        };
        self.0.iter().flatten().map(off).fold(0.0, f64::max)
    }
}

/// A wheel or a rail at a stop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WornProfile {
    /// Its points `(y, z)` (m): `y` to the field side, `z` down.
    pub points: Vec<[f64; 2]>,
    /// Depth taken off at each (m), along the normal.
    pub depth: Vec<f64>,
    /// Indices of kinks.
    pub corners: Vec<usize>,
    /// Area of the section taken off (m2).
    pub area: f64,
    /// Volume taken off a wheel (m3), a rail per metre (m3/m).
    pub volume: f64,
    /// Flange height, thickness, slope, hollow (m) of a wheel that has them.
    pub measures: Option<[f64; 4]>,
}

impl WornProfile {
    /// The greatest depth (m).
    #[must_use]
    pub fn greatest(&self) -> f64 {
        self.depth.iter().copied().fold(0.0, f64::max)
    }
}

/// Stop of a run, at an even part of the distance, where profiles are written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WearStop {
    /// Distance that the wheels ran (m).
    pub distance: f64,
    /// Passages over the rails.
    pub passages: f64,
    /// Steps that it took.
    pub steps: usize,
    /// Equivalent conicity at 3 mm, where there is one.
    pub conicity: Option<f64>,
    /// The bodies that wear, in the order of [`WornBody::ALL`].
    pub bodies: [Option<WornProfile>; 4],
}

impl WearStop {
    /// A body, where it wears.
    #[must_use]
    pub fn of(&self, body: WornBody) -> Option<&WornProfile> {
        self.bodies.get(body as usize)?.as_ref()
    }
}

/// State of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct State {
    creepage_wear: u32,
    /// Of the case, the plan and the program.
    key: u32,
    /// Part of the whole distance.
    pub(super) part: f64,
    pub(super) steps: usize,
    /// The greatest depth that the next step tries (m).
    pub(super) trial: f64,
    /// Steps whose contacts changed by more than is good; steps cut short for the sake of ripples.
    pub(super) rough: usize,
    pub(super) cut: usize,
    /// Situations that did not converge, over all steps.
    pub(super) doubtful: usize,
    pub(super) bodies: Bodies,
    pub(super) stops: Vec<WearStop>,
    /// Why it ends before its distance, where it does.
    pub(super) ended: Option<WearEnd>,
    pub(super) cautions: Vec<Noted>,
}

/// Cautions about the solutions of situations, of one kind, over the whole run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Noted {
    /// Its words without numbers.
    kind: String,
    /// The first one, with its situation and the part of the distance.
    first: String,
    situation: usize,
    part: f64,
    count: usize,
}

impl Noted {
    pub(super) fn words(&self) -> String {
        let Self { first, situation, part, count, .. } = self;
        let times = if *count > 1 { format!(", {count} times in all") } else { String::new() };
        format!("situation {situation} after {:.1} % of the way{times}: {first}", 100.0 * part)
    }
}

impl State {
    /// Keeps a caution of a situation; of those that differ by numbers alone the first, and how many they are.
    pub(super) fn note(&mut self, situation: usize, words: &str) {
        let kind: String = words.chars().filter(|c| c.is_alphabetic()).collect();
        let kind = kind.replace("GPa", "MPa");
        match self.cautions.iter_mut().find(|noted| noted.kind == kind) {
            Some(noted) => noted.count += 1,
            None => self.cautions.push(Noted {
                kind,
                first: words.to_owned(),
                situation,
                part: self.part,
                count: 1,
            }),
        }
    }

    pub(super) fn new(case: &WheelsetCase, plan: &WearPlan) -> Self {
        Self {
            creepage_wear: 1,
            key: key(case, plan),
            part: 0.0,
            steps: 0,
            trial: plan.step_depth,
            rough: 0,
            cut: 0,
            doubtful: 0,
            bodies: Bodies::new(case, plan),
            stops: Vec::new(),
            ended: None,
            cautions: Vec::new(),
        }
    }

    /// What an earlier run of the same case left in `path`, or a new one. A file that is none, or of another
    /// case, stays as it is.
    pub(super) fn resume(
        case: &WheelsetCase,
        plan: &WearPlan,
        path: &Path,
    ) -> Result<Self, WearError> {
        keep_foreign(path, HEAD)
            .map_err(|source| WearError::State { path: path.into(), source })?;
        let new = Self::new(case, plan);
        let found =
            fs::read(path).ok().and_then(|bytes| serde_json::from_slice::<Self>(&bytes).ok());
        match found {
            Some(found) if found.key == new.key => Ok(found),
            Some(State { steps, .. }) if steps > 0 => {
                Err(WearError::OtherRun { path: path.into(), steps })
            }
            _ => Ok(new),
        }
    }

    pub(super) fn save(&self, path: &Path) -> Result<(), WearError> {
        let failed = |source| WearError::State { path: path.into(), source };
        let bytes = serde_json::to_vec(self).map_err(|error| failed(error.into()))?;
        let mut file = WholeFile::create(path).map_err(failed)?;
        file.write_all(&bytes).and_then(|()| file.finish()).map_err(failed)
    }

    /// Where the run stands.
    pub(super) fn now(&self, case: &WheelsetCase, plan: &WearPlan) -> Result<WearStop, WearError> {
        let running = self.bodies.running(&case.running)?;
        let conicity = case.stance.side.is_none().then(|| {
            let difference = running.radius_differences(0.5, Some(0.0)).ok()?;
            difference.conicity(AMPLITUDE).ok()
        });
        let worn = |body: WornBody| {
            let nodes = self.bodies.of(body)?;
            let [wheel, _] = running.profiles(body.side());
            let back = running.wheelset().wheel(body.side()).flange_back();
            let measured = (body.role() == Role::Wheel).then(|| WheelMeasures::of(wheel, back));
            let measures = measured
                .flatten()
                .map(|m| [m.flange_height, m.flange_thickness, m.flange_slope, m.hollow]);
            let Nodes { points, depth, corners, area, volume, .. } = nodes.clone();
            Some(WornProfile { points, depth, corners, area, volume, measures })
        };
        Ok(WearStop {
            distance: self.part * plan.distance,
            passages: self.part * plan.passages,
            steps: self.steps,
            conicity: conicity.flatten(),
            bodies: WornBody::ALL.map(worn),
        })
    }
}

/// Tells one case and plan from another, in this version of the program.
fn key(case: &WheelsetCase, plan: &WearPlan) -> u32 {
    crc32fast::hash(format!("{} {case:?} {plan:?}", env!("CARGO_PKG_VERSION")).as_bytes())
}
