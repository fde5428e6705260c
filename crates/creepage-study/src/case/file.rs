//! Case file of a contact with an ellipse, and the case that it describes.

use std::path::Path;

use creepage::coulomb::Constraints;
use creepage::theory::UnknownTheory;
use creepage::{Contact, Creepage, Hertz, Solid, TheorySpec};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use toml::Table;

use super::body::Body;
use super::contact::ContactSection;
use super::creepage::CreepageSection;
use super::error::CaseError;
use super::keys;
use super::layer::LayerSection;
use super::motion::MotionSection;
use super::schema::schema_of;
use super::sections::{PressedBodies, Sections};
use super::solve;
use super::wanted::WantedSection;
use crate::Sources;
use crate::damage::{DamageSection, DamageWanted};
use crate::heat::{HeatSection, HeatWanted};

/// A rolling-contact case, in SI units: two elastic bodies, what presses them together, and
/// how they creep.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage case file")]
pub struct CaseFile {
    /// The upper body, such as a wheel.
    upper: Body,
    /// The lower body, such as a rail.
    lower: Body,
    /// The contact of the two.
    contact: ContactSection,
    /// A layer between the bodies.
    layer: Option<LayerSection>,
    /// Creepage and spin. Needed for rolling, not for the contact alone.
    #[serde(default)]
    creepage: CreepageSection,
    /// How both bodies move, in place of creepage and spin.
    motion: Option<MotionSection>,
    /// Forces that are wanted in place of creepages.
    #[serde(default)]
    wanted: WantedSection,
    /// Wear and fatigue numbers.
    damage: Option<DamageSection>,
    /// Temperatures of both surfaces.
    heat: Option<HeatSection>,
    /// The theory that solves the case, "exact" by default, and its options.
    #[serde(default)]
    #[schemars(with = "TheorySpec")]
    solve: Table,
}

/// The JSON schema (draft 2020-12) of a case file, for editors and validators.
///
/// ```
/// let schema = creepage_study::json_schema();
/// assert!(schema["properties"]["contact"]["properties"]["normal_force"].is_object());
/// ```
#[must_use]
pub fn json_schema() -> Value {
    let mut schema = schema_of::<CaseFile>();
    let theories = schema["properties"]["solve"]["oneOf"].as_array_mut();
    for theory in theories.into_iter().flatten() {
        if theory["properties"]["theory"]["const"] == TheorySpec::default().facts().name {
            theory["required"] = Value::Array(Vec::new());
        }
    }
    schema
}

/// One case, every number of it checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// The contact ellipse and its pressure.
    pub hertz: Hertz,
    /// Coefficient of friction `mu`, at rest where it depends on the slip.
    pub friction: f64,
    /// The two together, with a law of friction and a layer: what a theory is prepared for.
    pub contact: Contact,
    /// The materials of the upper and the lower body.
    pub solids: [Solid; 2],
    /// The creepage, or what determines it.
    pub given: Given,
    /// Rolling velocity (m/s), where it is given.
    pub speed: Option<f64>,
    /// The smallest of the bodies' radii (m), where they are given.
    pub smallest_radius: Option<f64>,
    /// By how much the slip varies across the contact, over the square of the place (1/m2), as the surfaces
    /// of conforming bodies curve alike.
    pub slip_by_groove: Option<f64>,
    /// What is wanted of wear and fatigue, if anything is.
    pub damage: Option<DamageWanted>,
    /// What is wanted of temperatures, if anything is.
    pub heat: Option<HeatWanted>,
    /// The theory and its options.
    pub theory: TheorySpec,
    /// The file of slips that it was read from, if any.
    pub(crate) sources: Sources,
}

/// Prescribed creepage, or prescribed forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// The creepage; the force is to be found.
    Creepage(Creepage),
    /// Three of the six quantities; the others are to be found.
    Constraints(Constraints),
}

impl Case {
    /// The creepage, where it is given.
    ///
    /// # Errors
    /// [`CaseError::Wanted`] where it is to be found.
    pub fn creepage(&self) -> Result<Creepage, CaseError> {
        match self.given {
            Given::Creepage(creepage) => Ok(creepage),
            Given::Constraints(_) => Err(CaseError::Wanted),
        }
    }

    /// The theory of that name for this case: the case's own with the options that it gives, any
    /// other with its default options.
    ///
    /// # Errors
    /// [`UnknownTheory`], with the nearest name if one is near.
    pub fn theory_named(&self, name: &str) -> Result<TheorySpec, UnknownTheory> {
        if self.theory.facts().name == name {
            return Ok(self.theory.clone());
        }
        TheorySpec::named(name)
    }

    /// Whether the options of the case's own theory are given up for those of `theories`.
    #[must_use]
    pub fn gives_up_options(&self, theories: &[TheorySpec]) -> bool {
        let own = self.theory.facts().name;
        let is_default = TheorySpec::named(own).is_ok_and(|default| default == self.theory);
        !is_default && !theories.iter().any(|theory| theory.facts().name == own)
    }
}

impl CaseFile {
    /// Reads the text of a case file and checks its form: TOML, sections, keys and kinds of
    /// values.
    ///
    /// # Errors
    /// [`CaseError`] that says where the text is not a case file.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        Self::of(&keys::parse(text)?, text)
    }

    /// The same where the sections of the text are known.
    pub(crate) fn of(table: &Table, text: &str) -> Result<Self, CaseError> {
        keys::check(table, &json_schema())?;
        let mut file: Self = toml::from_str(text)?;
        if let Some(motion) = &file.motion {
            let radii = [&file.upper, &file.lower].map(Body::rolling_radius);
            file.creepage = motion.creepage(radii, &file.creepage)?;
        }
        Ok(file)
    }

    /// The contact alone; needs neither friction nor creepage.
    ///
    /// # Errors
    /// [`CaseError`] for numbers out of range, contradictions, and bodies without a contact
    /// ellipse.
    pub fn hertz(&self) -> Result<Hertz, CaseError> {
        self.sections().hertz()
    }

    /// The smallest of the bodies' radii (m), its size, where one is given.
    #[must_use]
    pub fn smallest_radius(&self) -> Option<f64> {
        self.sections().smallest_radius()
    }

    /// What touches, and how it creeps.
    pub(crate) fn sections(&self) -> Sections {
        let Self { upper, lower, creepage, layer, heat, .. } = *self;
        Sections { upper, lower, contact: self.contact.clone(), layer, creepage, heat }
    }

    /// Whether forces are wanted.
    pub(crate) fn wants(&self) -> bool {
        self.wanted.names().next().is_some()
    }

    /// The theory of `[solve]`.
    ///
    /// # Errors
    /// [`CaseError`] for an unknown theory, and for options that it does not have.
    pub fn theory(&self) -> Result<TheorySpec, CaseError> {
        Ok(solve::from_table(&self.solve)?)
    }

    /// The materials of the upper and the lower body.
    ///
    /// # Errors
    /// [`CaseError`] for moduli out of range, none, or two of them.
    pub fn solids(&self) -> Result<[Solid; 2], CaseError> {
        Ok([self.upper.solid("upper")?, self.lower.solid("lower")?])
    }

    /// The case for a theory of rolling.
    ///
    /// # Errors
    /// As [`CaseFile::hertz`]; also when friction or creepage is missing or out of range, when the
    /// ellipse stands askew to the rolling direction, when forces are wanted and not three
    /// quantities are given by `[creepage]` and `[wanted]` together, and for options that the
    /// theory does not have. A file of slips stands in the working directory.
    pub fn case(&self) -> Result<Case, CaseError> {
        self.case_in(Path::new(""))
    }

    /// The same where a file of slips that it names stands in `directory`.
    ///
    /// # Errors
    /// As [`CaseFile::case`], and for a file that has no slips.
    pub fn case_in(&self, directory: &Path) -> Result<Case, CaseError> {
        let sections = self.sections();
        let PressedBodies { hertz, friction, contact, speed } = sections.touching()?;
        let contact = match &self.contact.slip {
            Some(slip) => contact.with_added_slip(slip.read(directory, self.by_creepage_alone())?),
            None => contact,
        };
        let scaling = contact.scaling();
        let given = if self.wants() {
            Given::Constraints(self.wanted.constraints(&self.creepage, hertz.ellipse(), scaling)?)
        } else {
            Given::Creepage(self.creepage.resolve(scaling)?)
        };
        let (theory, solids) = (self.theory()?, self.solids()?);
        let smallest_radius = sections.smallest_radius();
        let slip_by_groove = sections.slip_by_groove();
        let damage = self.damage()?;
        let heat = self.heat.as_ref().map(|section| section.wanted(speed)).transpose()?;
        Ok(Case {
            hertz,
            friction,
            contact,
            solids,
            given,
            speed,
            smallest_radius,
            slip_by_groove,
            damage,
            heat,
            theory,
            sources: self.sources(directory),
        })
    }

    /// The file of slips that it names, which stands in `directory`, if any.
    #[must_use]
    pub fn sources(&self, directory: &Path) -> Sources {
        let slip = self.contact.slip.as_ref();
        Sources::new(slip.and_then(|slip| slip.file(directory)))
    }

    /// Sections whose numbers follow from creepage and spin, and whether the file has them.
    fn by_creepage_alone(&self) -> [(&'static str, bool); 2] {
        [("damage", self.damage.is_some()), ("heat", self.heat.is_some())]
    }

    /// Whether the rigid slip differs from place to place.
    pub(crate) fn has_slip(&self) -> bool {
        self.contact.slip.is_some()
    }

    /// Whether friction is a law, or differs from place to place.
    pub(crate) fn friction_varies(&self) -> bool {
        self.contact.friction.as_ref().is_some_and(super::friction::FrictionValue::varies)
    }

    /// Whether temperatures are wanted.
    #[must_use]
    pub fn has_heat(&self) -> bool {
        self.heat.is_some()
    }

    /// Whether wear and fatigue numbers are wanted.
    #[must_use]
    pub fn has_damage(&self) -> bool {
        self.damage.is_some()
    }

    /// The laws of wear and fatigue, where their numbers are wanted.
    pub(crate) fn damage(&self) -> Result<Option<DamageWanted>, CaseError> {
        self.damage.as_ref().map(DamageSection::wanted).transpose()
    }
}
