//! A whole case file, and the case that it describes.

use creepage::Hertz;
use creepage::rolling::exact::Known;
use creepage::rolling::{Creepage, Scaling, SiCreepage};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::case::body::Body;
use crate::case::contact::Contact;
use crate::case::creepage::CreepageSection;
use crate::case::error::CaseError;
use crate::case::keys;
use crate::case::schema::schema_of;
use crate::case::solve::Solve;
use crate::case::wanted::WantedSection;

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
    contact: Contact,
    /// Creepage and spin. Needed for rolling, not for the contact alone.
    #[serde(default)]
    creepage: CreepageSection,
    /// Forces that are wanted in place of creepages.
    #[serde(default)]
    wanted: WantedSection,
    /// How to solve the case.
    #[serde(default)]
    solve: Solve,
}

/// The JSON schema (draft 2020-12) of a case file, for editors and validators.
///
/// ```
/// let schema = creepage_study::json_schema();
/// assert!(schema["properties"]["contact"]["properties"]["normal_force"].is_object());
/// ```
#[must_use]
pub fn json_schema() -> Value {
    schema_of::<CaseFile>()
}

/// One case, every number of it checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// The contact ellipse and its pressure.
    pub contact: Hertz,
    /// Coefficient of friction `mu`.
    pub friction: f64,
    /// Creepage and spin, dimensionless.
    pub creepage: Creepage,
    /// Creepage and spin in SI units.
    pub si_creepage: SiCreepage,
    /// Rolling velocity (m/s), where it is given.
    pub speed: Option<f64>,
    /// The theory and its options.
    pub solve: Solve,
}

/// A case whose creepage is to be found, every number of it checked.
#[derive(Debug, Clone, PartialEq)]
pub struct InverseCase {
    /// The contact ellipse and its pressure.
    pub contact: Hertz,
    /// Coefficient of friction `mu`.
    pub friction: f64,
    /// The three quantities that determine the others, dimensionless.
    pub known: Known,
    /// The units of the dimensionless quantities.
    pub scaling: Scaling,
    /// Rolling velocity (m/s), where it is given.
    pub speed: Option<f64>,
    /// The theory and its options.
    pub solve: Solve,
}

impl InverseCase {
    /// The case with the creepage that was found.
    #[must_use]
    pub fn found(self, creepage: Creepage) -> Case {
        let si_creepage = self.scaling.si_creepage(creepage);
        let Self { contact, friction, speed, solve, .. } = self;
        Case { contact, friction, creepage, si_creepage, speed, solve }
    }
}

impl CaseFile {
    /// Reads the text of a case file and checks its form: TOML, sections, keys and kinds of
    /// values.
    ///
    /// # Errors
    /// [`CaseError`] that says where the text is not a case file.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        keys::check(&text.parse()?, &json_schema())?;
        Ok(toml::from_str(text)?)
    }

    /// The contact alone; needs neither friction nor creepage.
    ///
    /// # Errors
    /// [`CaseError`] for numbers out of range, contradictions, and bodies without a contact
    /// ellipse.
    pub fn hertz(&self) -> Result<Hertz, CaseError> {
        self.contact.hertz(&self.upper, &self.lower)
    }

    /// Whether forces are wanted and the creepage is to be found.
    #[must_use]
    pub fn is_inverse(&self) -> bool {
        self.wanted.names().next().is_some()
    }

    /// The case for a theory of rolling.
    ///
    /// # Errors
    /// As [`CaseFile::hertz`]; also when friction or creepage is missing or out of range, when
    /// forces are wanted, and when the ellipse stands askew to the rolling direction.
    pub fn case(&self) -> Result<Case, CaseError> {
        let (contact, friction, scaling) = self.rolling_contact()?;
        if self.is_inverse() {
            return Err(CaseError::Wanted);
        }
        let (creepage, si_creepage) = self.creepage.resolve(scaling)?;
        let (speed, solve) = (self.creepage.speed()?, self.solve.clone());
        Ok(Case { contact, friction, creepage, si_creepage, speed, solve })
    }

    /// The case whose creepage is to be found.
    ///
    /// # Errors
    /// As [`CaseFile::case`]; also unless three quantities are given by `[creepage]` and
    /// `[wanted]` together.
    pub fn inverse(&self) -> Result<InverseCase, CaseError> {
        let (contact, friction, scaling) = self.rolling_contact()?;
        let known = self.wanted.known(&self.creepage, contact.ellipse(), scaling)?;
        let (speed, solve) = (self.creepage.speed()?, self.solve.clone());
        Ok(InverseCase { contact, friction, known, scaling, speed, solve })
    }

    /// The contact, the friction in it, and its units.
    fn rolling_contact(&self) -> Result<(Hertz, f64, Scaling), CaseError> {
        let contact = self.hertz()?;
        self.check_aligned(&contact)?;
        let friction = self.contact.friction.ok_or_else(|| CaseError::Missing {
            section: "contact".into(),
            key: "friction".into(),
        })?;
        let scaling = Scaling::new(&contact, friction).map_err(CaseError::invalid("contact"))?;
        Ok((contact, friction, scaling))
    }

    fn check_aligned(&self, contact: &Hertz) -> Result<(), CaseError> {
        // Rounding of an angle of 90 degrees, or of a circle's axes, is not a tilt.
        const TOLERANCE: f64 = 1e-9;
        let circular = 1.0 - contact.ellipse().g() < TOLERANCE;
        if circular || contact.angle().abs() < TOLERANCE {
            return Ok(());
        }
        Err(CaseError::Tilted {
            angle: self.contact.angle.unwrap_or(0.0),
            ellipse_angle: contact.angle().to_degrees(),
        })
    }
}
