//! The case file of a contact that rolls by a history.

use creepage::TheorySpec;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::{Table, Value};

use super::error::HistoryError;
use crate::CaseError;
use crate::case::body::Body;
use crate::case::friction::FrictionValue;
use crate::case::keys;
use crate::case::layer::LayerSection;
use crate::case::radius::Radius;
use crate::case::schema::schema_of;
use crate::case::slip::SlipPoints;
use crate::gap::GapFile;

/// A case file of a contact that rolls as a table says.
#[derive(Debug, Clone, PartialEq)]
pub struct RollFile {
    pub(super) bodies: Bodies,
    pub(super) start: StartSection,
}

/// The two bodies by their radii, or by their gap.
#[allow(clippy::large_enum_variant)] // one a history
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Bodies {
    Smooth(SmoothFile),
    Shaped(GapFile),
}

/// A contact that rolls as a table says, in SI units: two elastic bodies, what presses them together,
/// and the state in which they start. Bodies of any shape have the sections [gap] and [contact] of
/// steady rolling, and [start].
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage case file of a history")]
pub(super) struct SmoothFile {
    /// The upper body, such as a wheel.
    pub(super) upper: Body,
    /// The lower body, such as a rail.
    pub(super) lower: Body,
    /// The contact of the two: an ellipse by `normal_force`, or a line by `line_load`.
    pub(super) contact: ContactSection,
    /// A layer between the bodies.
    pub(super) layer: Option<LayerSection>,
    /// The rolling velocity, for friction that depends on the speed of slip; the table says the rest.
    #[serde(default)]
    pub(super) creepage: SpeedSection,
    /// The state in which rolling starts.
    #[serde(default)]
    pub(super) start: StartSection,
    /// The theory, "exact", "fastsim" or "variational", and its options.
    #[serde(default)]
    #[schemars(with = "TheorySpec")]
    pub(super) solve: Table,
}

/// The load and the friction, and what is known of the contact area.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ContactSection {
    /// Normal force N (N); of all rows that have none of their own. Give this or `line_load`.
    pub(super) normal_force: Option<f64>,
    /// Coefficient of friction mu, or how it depends on the speed of slip or on the place.
    pub(super) friction: FrictionValue,
    /// Angle from the upper body's rolling section to the lower body's (degrees); 0 by default.
    pub(super) angle: Option<f64>,
    /// Semi-axis of the contact ellipse along the rolling direction (m). Both semi-axes replace the
    /// bodies' radii.
    pub(super) semi_axis_rolling: Option<f64>,
    /// Semi-axis of the contact ellipse across the rolling direction (m).
    pub(super) semi_axis_lateral: Option<f64>,
    /// Normal force per length of two cylinders with parallel axes (N/m), by whose `radius_rolling` the
    /// contact is a line. Forces are then per length too.
    pub(super) line_load: Option<f64>,
    /// With `line_load`: radius of one cylinder on a plane that is curved as the two together (m), in
    /// place of the bodies' radii.
    pub(super) radius_rolling: Option<Radius>,
    /// With `line_load`: length of the cylinders (m), needed where a creepage is prescribed.
    pub(super) length: Option<f64>,
    /// Rigid slip of the upper body relative to the lower, over the rolling velocity, that differs from place to
    /// place and stands still in the contact: added to that of creepage and spin in every row. CSV file beside the
    /// case file with the columns x, y (m), longitudinal, lateral, or these as lists: the points of a rectangular
    /// grid, in any order. Theory exact.
    #[schemars(with = "SlipPoints")]
    #[serde(default)]
    pub(super) slip: Option<SlipPoints>,
}

/// How fast the contact rolls.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SpeedSection {
    /// Rolling velocity V (m/s).
    pub(super) speed: Option<f64>,
}

/// How the traction is distributed before rolling.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct StartSection {
    /// "none" by default; "steady": rolling has been steady, with the motion of the first row; "shift":
    /// the bodies were shifted against each other by the forces below.
    #[serde(default)]
    pub(super) traction: StartTraction,
    /// With "shift": longitudinal force on the lower body (N), held while shifting.
    pub(super) longitudinal_force: Option<f64>,
    /// With "shift": lateral force on the lower body (N), held while shifting.
    pub(super) lateral_force: Option<f64>,
}

/// The state in which rolling starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RollStart {
    /// No traction.
    None,
    /// Steady rolling with the motion of the first row or step.
    Steady,
    /// A shift by a longitudinal and a lateral force on the lower body (N).
    Shift([f64; 2]),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum StartTraction {
    /// No traction.
    #[default]
    None,
    /// That of steady rolling with the motion of the first row.
    Steady,
    /// That of a shift.
    Shift,
}

/// Sections that say how the bodies move, whose place the history takes.
const MOTION: [&str; 3] = ["creepage", "wanted", "motion"];

/// Sections that are for steady rolling.
const STEADY: [(&str, &str); 2] = [
    (
        "damage",
        "its laws take the motion of one passage; give creepage and forces of a row to `creepage solve`",
    ),
    (
        "heat",
        "a surface is as hot as what its particles met on their way through the contact, and its formulas take that for \
         the same all the while, which it is not in a history; where rolling has become steady, some contact lengths \
         after a change, give a row's motion to `creepage solve`",
    ),
];

/// Whether a section holds the rolling velocity alone.
fn is_speed(section: &Value) -> bool {
    section.as_table().is_some_and(|table| table.keys().all(|key| key == "speed"))
}

impl RollFile {
    /// Reads the text of a case file and checks its form: TOML, sections, keys and kinds of values.
    ///
    /// # Errors
    /// [`HistoryError`] that says where the text is not such a case file.
    pub fn read(text: &str) -> Result<Self, HistoryError> {
        let table: Table = text.parse().map_err(CaseError::Toml)?;
        let is_motion = |section: &&str| {
            table.get(*section).is_some_and(|value| *section != "creepage" || !is_speed(value))
        };
        if let Some(section) = MOTION.into_iter().find(is_motion) {
            return Err(HistoryError::Section { section });
        }
        let steady = STEADY.into_iter().find(|(section, _)| table.contains_key(*section));
        if let Some((section, why)) = steady {
            return Err(HistoryError::Steady { section, why });
        }
        if table.contains_key("gap") {
            return Self::shaped(table);
        }
        keys::check(&table, &roll_json_schema())?;
        let file: SmoothFile = toml::from_str(text).map_err(CaseError::Toml)?;
        Ok(Self { start: file.start.clone(), bodies: Bodies::Smooth(file) })
    }

    /// A file with `[gap]`: one of steady rolling, with the start besides.
    fn shaped(mut table: Table) -> Result<Self, HistoryError> {
        let start = match table.remove("start") {
            None => StartSection::default(),
            Some(section) => section.try_into().map_err(CaseError::Toml)?,
        };
        let file = GapFile::read(&table.to_string())?;
        Ok(Self { start, bodies: Bodies::Shaped(file) })
    }

    /// The contact of a case file of steady rolling: its creepage or motion, or the forces wanted of it, and what
    /// it asks of damage and heat are not used, only `[creepage] speed`.
    ///
    /// # Errors
    /// As [`RollFile::read`].
    pub fn of_case(text: &str) -> Result<Self, HistoryError> {
        let mut table: Table = text.parse().map_err(CaseError::Toml)?;
        for unused in ["wanted", "motion", "damage", "heat"] {
            table.remove(unused);
        }
        if let Some(Value::Table(creepage)) = table.get_mut("creepage") {
            creepage.retain(|key, _| key == "speed");
        }
        Self::read(&table.to_string())
    }

    /// What it has that has no effect, in words.
    #[must_use]
    pub fn notes(&self) -> Vec<&'static str> {
        let Bodies::Smooth(file) = &self.bodies else { return Vec::new() };
        let is_idle = file.contact.line_load.is_some() && file.solve.contains_key("resolution");
        let note = "[solve] resolution has no effect: a line that rolls in steps has 50 elements";
        is_idle.then_some(note).into_iter().collect()
    }

    /// The same with another start.
    #[must_use]
    pub fn with_start(self, start: RollStart) -> Self {
        let (traction, force) = match start {
            RollStart::None => (StartTraction::None, None),
            RollStart::Steady => (StartTraction::Steady, None),
            RollStart::Shift(force) => (StartTraction::Shift, Some(force)),
        };
        let [longitudinal_force, lateral_force] = [0, 1].map(|k| force.map(|force| force[k]));
        Self { start: StartSection { traction, longitudinal_force, lateral_force }, ..self }
    }
}

/// The JSON schema (draft 2020-12) of the case file of a history, for editors and validators.
///
/// ```
/// let schema = creepage_study::roll_json_schema();
/// assert!(schema["properties"]["start"]["properties"]["traction"].is_object());
/// ```
#[must_use]
pub fn roll_json_schema() -> serde_json::Value {
    let mut schema = schema_of::<SmoothFile>();
    let theories = schema["properties"]["solve"]["oneOf"].as_array_mut();
    for theory in theories.into_iter().flatten() {
        if theory["properties"]["theory"]["const"] == TheorySpec::default().facts().name {
            theory["required"] = serde_json::Value::Array(Vec::new());
        }
    }
    schema
}
