//! `[wear]`: what a wheelset runs through, how far, and what wears.

use std::fs;
use std::path::{Path, PathBuf};

use creepage::damage::DamageConstants;
use schemars::JsonSchema;
use serde::Deserialize;

use super::error::WearError;
use super::limits::{LimitSection, WearLimit};
use crate::case::schema::schema_of;
use crate::case::{CaseError, keys};
use crate::separator::Separator;
use crate::wheelset::WheelsetCase;
use crate::wheelset::error::checked;
use creepage_wheelset::ASKED;

const WEAR: &str = "wear";

/// Wear over a distance: situations with their shares of it, a law, what wears.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(in crate::wheelset) struct WearSection {
    /// "archard" (the default): Jendel's map; "usfd": energy over area. Constants stand in [damage].
    #[schemars(with = "WearLaw")]
    #[serde(default)]
    law: WearLaw,
    /// What wears: "wheel" (the default), "rail" or "both".
    #[schemars(with = "WornBodies")]
    #[serde(default)]
    body: WornBodies,
    /// "each" (the default): every wheel and rail by itself; "mean": both sides alike by the mean of both, as
    /// of wheelsets that are turned round and curves to both sides.
    #[schemars(with = "WornSides")]
    #[serde(default)]
    sides: WornSides,
    /// Distance that wheels run (m).
    distance: Option<f64>,
    /// Passages of such wheelsets over the rails.
    passages: Option<f64>,
    /// The greatest depth that a step takes off (m); 1e-4 by default.
    step_depth: Option<f64>,
    /// Standard deviation of the bell by which depth is smoothed along the profile (m); 2e-3 by default.
    smoothing_length: Option<f64>,
    /// Distance of the profile's points (m); 2.5e-4 by default.
    spacing: Option<f64>,
    /// At how many even stops profiles are written; 10 by default.
    stops: Option<u32>,
    /// CSV file of situations beside this one, in place of [[wear.situation]].
    table: Option<PathBuf>,
    /// Situations; without any the file's own position and motion.
    #[serde(default)]
    situation: Vec<SituationSection>,
    /// Every situation spread about its position by normal distributions.
    #[serde(default)]
    #[schemars(with = "SpreadSection")]
    spread: Option<SpreadSection>,
    /// Measures at which the run ends.
    #[serde(default)]
    #[schemars(with = "LimitSection")]
    limits: LimitSection,
}

/// Normal distributions about the position of every situation: even places over three standard deviations to
/// both sides, weighed by the bell.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SpreadSection {
    /// Standard deviation of y (m).
    #[serde(default)]
    y: f64,
    /// Standard deviation of the yaw (rad).
    #[serde(default)]
    yaw: f64,
    /// Places of each; 13 by default.
    places: Option<u32>,
}

/// A text of `[wear]` alone.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct WearFile {
    wear: WearSection,
}

/// A situation: what it leaves out is the file's own.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SituationSection {
    /// Its part of the distance; parts are divided by their sum.
    share: f64,
    /// Lateral position (m).
    y: Option<f64>,
    /// Height, down (m).
    z: Option<f64>,
    /// Roll (rad).
    roll: Option<f64>,
    /// Yaw (rad).
    yaw: Option<f64>,
    /// Load on both rails (N).
    axle_load: Option<f64>,
    /// Moment about x that presses the right wheel down (N m).
    roll_moment: Option<f64>,
    /// Speed (m/s).
    speed: Option<f64>,
    /// Angular velocity about the axle (rad/s).
    pitch_rate: Option<f64>,
    /// Velocity to the right (m/s).
    lateral_velocity: Option<f64>,
    /// Velocity down (m/s).
    vertical_velocity: Option<f64>,
    /// Angular velocity about x (rad/s).
    roll_rate: Option<f64>,
    /// Angular velocity about z (rad/s).
    yaw_rate: Option<f64>,
    /// Coefficient of friction on both rails.
    friction: Option<f64>,
    /// Curvature of the track (1/m), positive in a right-hand curve.
    curvature: Option<f64>,
}

/// By what law a contact wears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WearLaw {
    /// Archard's, with Jendel's map of coefficients.
    #[default]
    Archard,
    /// Energy over area (Sheffield).
    Usfd,
}

/// What wears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WornBodies {
    /// Wheels, over the distance.
    #[default]
    Wheel,
    /// Rails, over the passages.
    Rail,
    /// Both, side by side.
    Both,
}

/// Whether sides wear alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WornSides {
    /// Each by itself.
    #[default]
    Each,
    /// Both by the mean of both.
    Mean,
}

/// One situation of a wheelset, with its part of the distance. NaN is the wheelset's own.
#[derive(Debug, Clone, PartialEq)]
pub struct WearSituation {
    /// Its part of the distance.
    pub share: f64,
    /// Position, load and motion as of [`ASKED`] (SI units).
    pub asked: [f64; ASKED.len()],
    /// Coefficient of friction on both rails.
    pub friction: f64,
    /// Curvature of the track (1/m).
    pub curvature: f64,
}

/// Wear over a distance, every number of it checked.
#[derive(Debug, Clone, PartialEq)]
pub struct WearPlan {
    /// What the wheelset runs through; shares have the sum 1.
    pub situations: Vec<WearSituation>,
    /// The law.
    pub law: WearLaw,
    /// Its constants.
    pub constants: DamageConstants,
    /// What wears.
    pub body: WornBodies,
    /// Whether sides wear alike.
    pub sides: WornSides,
    /// Distance that wheels run (m); 0 where rails alone wear.
    pub distance: f64,
    /// Passages over the rails; 0 where wheels alone wear.
    pub passages: f64,
    /// The greatest depth that a step takes off (m).
    pub step_depth: f64,
    /// Standard deviation of the bell by which depth is smoothed (m).
    pub smoothing_length: f64,
    /// Distance of the profile's points (m).
    pub spacing: f64,
    /// How many even stops there are.
    pub stops: u32,
    /// The table of situations, where there is one.
    pub table: Option<PathBuf>,
    /// Measures at which the run ends; none: it runs the whole distance.
    pub limits: Vec<WearLimit>,
}

/// Theories that tell the slip in every element.
const WITH_SLIP: [&str; 3] = ["exact", "fastsim", "saturated"];
const MOST_SITUATIONS: usize = 100_000;
/// A spread reaches as many standard deviations to both sides.
const REACH: f64 = 3.0;

const COLUMNS: [&str; 15] = [
    "share",
    "friction",
    "curvature",
    "y",
    "z",
    "roll",
    "yaw",
    "axle_load",
    "roll_moment",
    "speed",
    "pitch_rate",
    "lateral_velocity",
    "vertical_velocity",
    "roll_rate",
    "yaw_rate",
];

impl WearSection {
    /// The plan for a wheelset, its table in `directory`.
    pub(in crate::wheelset) fn plan(
        &self,
        case: &WheelsetCase,
        directory: &Path,
    ) -> Result<WearPlan, WearError> {
        let positive = |key: &'static str, value: f64, most: f64, valid: &'static str| {
            checked(WEAR, key, value, value > 0.0 && value <= most, valid)
        };
        let need = |key: &'static str, value: Option<f64>, is_needed: bool| match value {
            Some(value) => positive(key, value, f64::MAX, "positive and finite"),
            None if is_needed => Err(CaseError::Missing { section: WEAR.into(), key: key.into() }),
            None => Ok(0.0),
        };
        let spacing =
            positive("spacing", self.spacing.unwrap_or(2.5e-4), 2e-3, "above 0 m, at most 2e-3 m")?;
        let spacing = checked(WEAR, "spacing", spacing, spacing >= 2e-5, "2e-5 m at least")?;
        let stops = self.stops.unwrap_or(10);
        checked(WEAR, "stops", f64::from(stops), (1..=1000).contains(&stops), "1 to 1000")?;
        let table = self.table.as_ref().map(|table| directory.join(table));
        let mut situations = match &table {
            Some(_) if !self.situation.is_empty() => {
                let [first, second] = ["table", "situation"].map(|key| (WEAR, key));
                return Err(CaseError::Conflict { first, second }.into());
            }
            Some(path) => read_table(path)?,
            None if self.situation.is_empty() => vec![WearSituation::own()],
            None => {
                let situations = self.situation.iter().map(SituationSection::situation);
                situations.collect::<Result<_, _>>()?
            }
        };
        if let Some(spread) = &self.spread {
            situations = spread.over(&situations, case)?;
        }
        let count = situations.len();
        let valid = "100,000 situations at most";
        checked(WEAR, "situation", count as f64, count <= MOST_SITUATIONS, valid)?;
        share_out(&mut situations)?;
        let plan = WearPlan {
            situations,
            law: self.law,
            constants: case.damage.as_ref().map(|wanted| wanted.constants).unwrap_or_default(),
            body: self.body,
            sides: self.sides,
            distance: need("distance", self.distance, self.body != WornBodies::Rail)?,
            passages: need("passages", self.passages, self.body != WornBodies::Wheel)?,
            step_depth: positive(
                "step_depth",
                self.step_depth.unwrap_or(1e-4),
                2e-3,
                "above 0 m, at most 2e-3 m",
            )?,
            smoothing_length: positive(
                "smoothing_length",
                self.smoothing_length.unwrap_or(2e-3),
                2e-2,
                "above 0 m, at most 2e-2 m",
            )?,
            spacing,
            stops,
            table,
            limits: self.limits.limits()?,
        };
        plan.check(case)?;
        Ok(plan)
    }
}

impl SpreadSection {
    /// Each situation at every place of the spread; shares have the sums they had.
    fn over(
        &self,
        situations: &[WearSituation],
        case: &WheelsetCase,
    ) -> Result<Vec<WearSituation>, WearError> {
        const SECTION: &str = "wear.spread";
        let places = self.places.unwrap_or(13);
        checked(SECTION, "places", f64::from(places), (2..=1001).contains(&places), "2 to 1001")?;
        for (key, sd, most) in [("y", self.y, 0.05), ("yaw", self.yaw, 0.1)] {
            checked(SECTION, key, sd, sd >= 0.0 && sd <= most, "0 or more, y to .05 m, yaw to .1")?;
        }
        // Places in standard deviations, with weights of the sum 1.
        let bell = |sd: f64| -> Vec<[f64; 2]> {
            if sd == 0.0 {
                return vec![[0.0, 1.0]];
            }
            let at = |k: u32| REACH * (2.0 * f64::from(k) / f64::from(places - 1) - 1.0);
            let weight = |t: f64| (-0.5 * t * t).exp();
            let whole: f64 = (0..places).map(|k| weight(at(k))).sum();
            (0..places).map(|k| [sd * at(k), weight(at(k)) / whole]).collect()
        };
        let (across, turned) = (bell(self.y), bell(self.yaw));
        let own = |value: f64, own: f64| if value.is_nan() { own } else { value };
        let mut all = Vec::new();
        for situation in situations {
            for ([y, part], [yaw, other]) in
                across.iter().flat_map(|one| turned.iter().map(move |other| (one, other)))
            {
                let mut spread = situation.clone();
                spread.share *= part * other;
                for (name, by, given) in [("y", y, case.stance.y), ("yaw", yaw, case.stance.yaw)] {
                    if let Some(place) = spread.number(name) {
                        *place = own(*place, given) + by;
                    }
                }
                all.push(spread);
            }
            if all.len() > MOST_SITUATIONS {
                break;
            }
        }
        Ok(all)
    }
}

impl WearPlan {
    /// The plan of a text that holds `[wear]` alone, for a wheelset; its table in `directory`.
    ///
    /// # Errors
    /// [`WearError`] as by [`WheelsetFile::wear`](crate::WheelsetFile::wear).
    pub fn read(text: &str, case: &WheelsetCase, directory: &Path) -> Result<Self, WearError> {
        keys::check(&keys::parse(text)?, &schema_of::<WearFile>())?;
        let file: WearFile = toml::from_str(text).map_err(CaseError::from)?;
        file.wear.plan(case, directory)
    }

    /// What can be seen before anything is solved.
    fn check(&self, case: &WheelsetCase) -> Result<(), WearError> {
        let running = &case.running;
        let track = running.track();
        let alike =
            running.wheelset().is_mirrored() && track.left.profile() == track.right.profile();
        if self.sides == WornSides::Mean && (case.stance.side.is_some() || !alike) {
            return Err(WearError::Mean);
        }
        let theory = case.theory.facts().name;
        if !WITH_SLIP.contains(&theory) {
            return Err(WearError::Theory { theory, known: &WITH_SLIP });
        }
        if case.travel.is_none() {
            return Err(crate::wheelset::error::section("motion", "speed").into());
        }
        for situation in &self.situations {
            case.asked_in_curve(&situation.asked, situation.curvature)?;
            let friction = situation.friction;
            let is_valid = friction.is_nan() || (friction > 0.0 && friction <= 5.0);
            checked(WEAR, "friction", friction, is_valid, "above 0, at most 5")?;
            let curvature = situation.curvature;
            let is_valid = curvature.is_nan() || curvature.abs() <= 1.0;
            checked(WEAR, "curvature", curvature, is_valid, "-1 to 1 a metre")?;
        }
        case.solver()?;
        Ok(())
    }
}

impl WearSituation {
    /// The wheelset's own, over the whole distance.
    fn own() -> Self {
        Self { share: 1.0, asked: [f64::NAN; ASKED.len()], friction: f64::NAN, curvature: f64::NAN }
    }

    /// The number of a column.
    fn number(&mut self, column: &str) -> Option<&mut f64> {
        match column {
            "share" => Some(&mut self.share),
            "friction" => Some(&mut self.friction),
            "curvature" => Some(&mut self.curvature),
            other => {
                let k = ASKED.iter().position(|name| *name == other)?;
                self.asked.get_mut(k)
            }
        }
    }
}

impl SituationSection {
    fn situation(&self) -> Result<WearSituation, WearError> {
        let mut situation = WearSituation { share: self.share, ..WearSituation::own() };
        let given = [
            ("y", self.y),
            ("z", self.z),
            ("roll", self.roll),
            ("yaw", self.yaw),
            ("axle_load", self.axle_load),
            ("roll_moment", self.roll_moment),
            ("speed", self.speed),
            ("pitch_rate", self.pitch_rate),
            ("lateral_velocity", self.lateral_velocity),
            ("vertical_velocity", self.vertical_velocity),
            ("roll_rate", self.roll_rate),
            ("yaw_rate", self.yaw_rate),
            ("friction", self.friction),
            ("curvature", self.curvature),
        ];
        for (column, value) in given {
            if let (Some(place), Some(value)) = (situation.number(column), value) {
                *place = checked("wear.situation", column, value, !value.is_nan(), "a number")?;
            }
        }
        Ok(situation)
    }
}

/// Divides the shares by their sum.
fn share_out(situations: &mut [WearSituation]) -> Result<(), WearError> {
    let sum: f64 = situations.iter().map(|situation| situation.share).sum();
    let good = situations.iter().all(|situation| situation.share >= 0.0);
    if !(good && sum > 0.0 && sum.is_finite()) {
        return Err(WearError::Shares);
    }
    for situation in situations {
        situation.share /= sum;
    }
    Ok(())
}

/// Situations, a row each; an empty cell is the wheelset's own. Columns may be separated by semicolons or tabs.
fn read_table(path: &Path) -> Result<Vec<WearSituation>, WearError> {
    let failed = |source| WearError::Table { path: path.into(), source };
    let text = fs::read_to_string(path).map_err(|source| failed(source.into()))?;
    let text = text.trim_start_matches('\u{feff}');
    let separator = Separator::of(text);
    let mut reader = separator.reader().from_reader(text.as_bytes());
    let mut columns = Vec::new();
    for name in reader.headers().map_err(failed)? {
        let Some(column) = COLUMNS.iter().find(|column| **column == name) else {
            let (column, known) = (name.to_owned(), COLUMNS.to_vec());
            return Err(WearError::Column { path: path.into(), column, known });
        };
        if columns.contains(column) {
            return Err(WearError::Twice { path: path.into(), column });
        }
        columns.push(*column);
    }
    if !columns.contains(&"share") {
        return Err(CaseError::Missing {
            section: "wear, header of its table".into(),
            key: "share".into(),
        }
        .into());
    }
    let mut situations = Vec::new();
    for (k, record) in reader.records().enumerate() {
        let record = record.map_err(failed)?;
        let mut situation = WearSituation { share: f64::NAN, ..WearSituation::own() };
        for (column, text) in columns.iter().copied().zip(&record) {
            if text.is_empty() {
                continue;
            }
            let value = separator.number(text).filter(|value| value.is_finite());
            let wrong =
                || WearError::Cell { path: path.into(), row: k + 1, column, text: text.to_owned() };
            let value = value.ok_or_else(wrong)?;
            if let Some(place) = situation.number(column) {
                *place = value;
            }
        }
        situations.push(situation);
    }
    Ok(situations)
}
