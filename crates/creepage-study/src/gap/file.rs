//! Case file with `[gap]`: its sections, and the case that they describe.

use std::path::Path;

use creepage::gap::Gap;
use creepage::{InvalidValue, SolidPair, TheorySpec};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use toml::Table;

use super::case::{GapCase, LoadOrApproach};
use super::creepage::{SiCreepageSection, SiGiven, SiWantedSection};
use super::curved::Surface;
use super::error::GapCaseError;
use super::shape::GapSection;
use super::vary::{GapValue, GapVaried};
use crate::case::body::Body;
use crate::case::friction::FrictionValue;
use crate::case::layer::LayerSection;
use crate::case::motion::MotionSection;
use crate::case::schema::schema_of;
use crate::case::slip::SlipPoints;
use crate::case::{keys, solve};
use crate::damage::DamageSection;
use crate::heat::HeatSection;
use crate::{CaseError, Sources};

/// A rolling-contact case of two bodies of any shape, in SI units.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage case file with [gap]")]
pub struct GapFile {
    upper: Material,
    lower: Material,
    gap: GapSection,
    contact: PressedSection,
    layer: Option<LayerSection>,
    damage: Option<DamageSection>,
    heat: Option<HeatSection>,
    #[serde(default)]
    creepage: SiCreepageSection,
    motion: Option<MotionSection>,
    #[serde(default)]
    wanted: SiWantedSection,
    #[serde(default)]
    #[schemars(with = "TheorySpec")]
    solve: Table,
}

/// One body's material; [gap] has the shape of both.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Material {
    /// Shear modulus G (Pa). Give this or `young_modulus`.
    shear_modulus: Option<f64>,
    /// Young's modulus E (Pa). Give this or `shear_modulus`.
    young_modulus: Option<f64>,
    /// Poisson's ratio, 0 to 0.5.
    poisson: f64,
}

/// What presses the bodies together, exactly one of `normal_force` and `approach`, and the friction.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PressedSection {
    /// Normal force N (N).
    normal_force: Option<f64>,
    /// Approach of the bodies (m), counted like the gap: they penetrate by the approach less h.
    approach: Option<f64>,
    /// Coefficient of friction mu, or a law by the speed of slip or across the contact, whose largest
    /// value is mu.
    friction: FrictionValue,
    /// Whether the contact lies in a plane, the default, or along the curve of a groove.
    #[serde(default)]
    surface: Surface,
    /// Rigid slip of the upper body relative to the lower, over the rolling velocity, that differs from place to
    /// place: added to that of creepage and spin. CSV file beside the case file with the columns x, y (m),
    /// longitudinal, lateral, or these as lists: the points of a rectangular grid, in any order. Theory exact.
    #[schemars(with = "SlipPoints")]
    #[serde(default)]
    slip: Option<SlipPoints>,
}

/// The JSON schema (draft 2020-12) of a case file with `[gap]`.
///
/// ```
/// let schema = creepage_study::gap_json_schema();
/// assert!(schema["properties"]["gap"]["properties"]["polynomial"].is_object());
/// ```
#[must_use]
pub fn gap_json_schema() -> Value {
    let mut schema = schema_of::<GapFile>();
    if let Some(theories) = schema["properties"]["solve"]["oneOf"].as_array_mut() {
        let name = |theory: &Value| theory["properties"]["theory"]["const"].clone();
        theories.retain(|theory| TheorySpec::OF_AREAS.iter().any(|known| name(theory) == **known));
        for theory in theories.iter_mut().filter(|theory| name(theory) == "exact") {
            theory["required"] = Value::Array(Vec::new());
        }
    }
    schema
}

/// Keys of other case files, and what stands in their place.
const FOREIGN: [(&str, &[&str], &str); 5] = [
    ("upper", &["radius_rolling", "radius_lateral"], SHAPE),
    ("lower", &["radius_rolling", "radius_lateral"], SHAPE),
    ("contact", &["semi_axis_rolling", "semi_axis_lateral", "angle"], SHAPE),
    ("creepage", &["xi", "eta", "chi"], "give longitudinal, lateral, spin (SI units)"),
    ("wanted", &["fx", "fy", "mz"], "give longitudinal_force, lateral_force (N), moment (N m)"),
];
const SHAPE: &str = "the shape of both bodies is in [gap], [upper] and [lower] give materials only";

impl GapFile {
    /// Reads the text of a case file and checks its form.
    ///
    /// # Errors
    /// [`GapCaseError`] for a text that is not TOML, unknown or missing keys, values of the wrong
    /// kind.
    pub fn read(text: &str) -> Result<Self, GapCaseError> {
        Self::of(&keys::parse(text)?, text)
    }

    /// The same where the sections of the text are known.
    pub(crate) fn of(table: &Table, text: &str) -> Result<Self, GapCaseError> {
        for (section, keys, instead) in FOREIGN {
            let content = table.get(section).and_then(toml::Value::as_table);
            let key = keys.iter().find(|key| content.is_some_and(|c| c.contains_key(**key)));
            if let Some(key) = key {
                return Err(GapCaseError::Foreign { section, key, instead });
            }
        }
        keys::check(table, &gap_json_schema())?;
        let mut file: Self = toml::from_str(text).map_err(CaseError::from)?;
        if let Some(motion) = &file.motion {
            // Bodies of any shape have no centre that goes without saying.
            file.creepage = motion.creepage([None; 2], &file.creepage.of_ellipses())?.into();
        }
        Ok(file)
    }

    /// Checks the numbers; files of points stand in `directory`.
    ///
    /// # Errors
    /// [`GapCaseError`] with section, key and value.
    pub fn case(&self, directory: &Path) -> Result<GapCase, GapCaseError> {
        let case = self.case_with(directory, |section, pair| section.gap(directory, pair))?;
        Ok(GapCase { sources: self.sources(directory), ..case })
    }

    /// The files of points that it names, which stand in `directory`.
    #[must_use]
    pub fn sources(&self, directory: &Path) -> Sources {
        let slip = self.contact.slip.as_ref().and_then(|slip| slip.file(directory));
        self.gap.sources(directory).with(&Sources::new(slip))
    }

    /// As [`GapFile::case`], where the gap comes from elsewhere than from a file just read.
    pub(super) fn case_with(
        &self,
        directory: &Path,
        gap: impl FnOnce(&GapSection, SolidPair) -> Result<Gap, GapCaseError>,
    ) -> Result<GapCase, GapCaseError> {
        let given = self.creepage.given(&self.wanted)?;
        Ok(GapCase { given, ..self.at_rest_with(directory, gap)? })
    }

    /// The same without creepage: how the bodies move is said elsewhere.
    ///
    /// # Errors
    /// As [`GapFile::case`].
    pub fn case_at_rest(&self, directory: &Path) -> Result<GapCase, GapCaseError> {
        let case = self.at_rest_with(directory, |section, pair| section.gap(directory, pair))?;
        if case.curved.is_some() { Err(GapCaseError::CurvedSteady) } else { Ok(case) }
    }

    fn at_rest_with(
        &self,
        directory: &Path,
        gap: impl FnOnce(&GapSection, SolidPair) -> Result<Gap, GapCaseError>,
    ) -> Result<GapCase, GapCaseError> {
        let (upper, lower) = (self.upper.body(), self.lower.body());
        let solids = [upper.solid("upper")?, lower.solid("lower")?];
        let pair = SolidPair::new(solids[0], solids[1]);
        let (gap, shape) = (gap(&self.gap, pair)?, self.gap.shape());
        let pressed = self.contact.pressed()?;
        let (speed, theory) = (self.creepage.speed()?, self.theory()?);
        let friction = positive("friction", self.contact.friction.at_rest()?)?;
        let heat = self.heat.as_ref().map(|section| section.wanted(speed)).transpose()?;
        let curved = match self.contact.surface {
            Surface::Plane => None,
            Surface::Curved => Some(Box::new(self.gap.curved()?)),
        };
        let others = [("damage", self.damage.is_some()), ("heat", self.heat.is_some())];
        Ok(GapCase {
            gap,
            curved,
            shape,
            roller: self.gap.roller(),
            sources: Sources::default(),
            pair,
            pressed,
            friction,
            rolling_friction: self.contact.friction.rolling(speed, heat)?,
            layer: self.layer.as_ref().map(LayerSection::layer).transpose()?,
            slip: self
                .contact
                .slip
                .as_ref()
                .map(|slip| slip.read(directory, others))
                .transpose()?,
            damage: self.damage.as_ref().map(DamageSection::wanted_without_limit).transpose()?,
            heat,
            given: SiGiven::AT_REST,
            speed,
            solids,
            theory,
        })
    }

    /// Its sections of which rows of many have no numbers.
    #[must_use]
    pub fn left_out_of_rows(&self) -> Vec<&'static str> {
        self.damage.iter().map(|_| "damage").collect()
    }

    /// Whether temperatures are wanted.
    pub(super) fn has_heat(&self) -> bool {
        self.heat.is_some()
    }

    /// Whether it has a rolling velocity.
    pub(super) fn has_speed(&self) -> bool {
        self.creepage.speed.is_some()
    }

    /// Puts a row's value into its place; a shape or what presses replaces the other forms of it.
    pub(super) fn set(&mut self, varied: GapVaried, value: &GapValue) {
        let Self { gap, contact, creepage, wanted, .. } = self;
        let number = match value {
            GapValue::File(name) => return gap.replace(varied, name),
            GapValue::Number(number) => *number,
        };
        match varied {
            GapVaried::Section | GapVaried::Grid => {}
            GapVaried::RadiusRolling => gap.radius_rolling = Some(number),
            GapVaried::NormalForce => {
                (contact.normal_force, contact.approach) = (Some(number), None);
            }
            GapVaried::Approach => (contact.normal_force, contact.approach) = (None, Some(number)),
            GapVaried::Friction => contact.friction = FrictionValue::Constant(number),
            GapVaried::Longitudinal => creepage.longitudinal = Some(number),
            GapVaried::Lateral => creepage.lateral = Some(number),
            GapVaried::Spin => creepage.spin = Some(number),
            GapVaried::Speed => creepage.speed = Some(number),
            GapVaried::LongitudinalForce => wanted.longitudinal_force = Some(number),
            GapVaried::LateralForce => wanted.lateral_force = Some(number),
            GapVaried::Moment => wanted.moment = Some(number),
        }
    }

    /// The theory of `[solve]`.
    ///
    /// # Errors
    /// [`GapCaseError`] for a theory or an option that needs an ellipse.
    pub fn theory(&self) -> Result<TheorySpec, GapCaseError> {
        let theory = solve::from_table(&self.solve).map_err(CaseError::from)?;
        theory.check_on_areas()?;
        Ok(theory)
    }
}

impl Material {
    /// As a body without a shape.
    fn body(&self) -> Body {
        let Self { shear_modulus, young_modulus, poisson } = *self;
        Body { shear_modulus, young_modulus, poisson, radius_rolling: None, radius_lateral: None }
    }
}

impl PressedSection {
    fn pressed(&self) -> Result<LoadOrApproach, CaseError> {
        let section = "contact";
        match (self.normal_force, self.approach) {
            (Some(load), None) => Ok(LoadOrApproach::Load(positive("normal_force", load)?)),
            (None, Some(value)) if value.is_finite() => Ok(LoadOrApproach::Approach(value)),
            (None, Some(value)) => {
                let valid = "a finite number";
                Err(CaseError::invalid(section)(InvalidValue {
                    quantity: "approach",
                    value,
                    valid,
                }))
            }
            (None, None) => {
                Err(CaseError::MissingEither { section, keys: ["normal_force", "approach"] })
            }
            (Some(_), Some(_)) => Err(CaseError::Conflict {
                first: (section, "normal_force"),
                second: (section, "approach"),
            }),
        }
    }
}

fn positive(quantity: &'static str, value: f64) -> Result<f64, CaseError> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    let valid = "finite and greater than zero";
    Err(CaseError::invalid("contact")(InvalidValue { quantity, value, valid }))
}
