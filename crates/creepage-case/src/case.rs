//! A whole case file, and the case that it describes.

use creepage::Hertz;
use creepage::rolling::{Creepage, Scaling, SiCreepage};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::body::Body;
use crate::contact::Contact;
use crate::creepage::CreepageSection;
use crate::error::CaseError;
use crate::keys;
use crate::schema::json_schema;
use crate::solve::Solve;

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
    /// How to solve the case.
    #[serde(default)]
    solve: Solve,
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
    /// The theory and its options.
    pub solve: Solve,
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

    /// The case for a theory of rolling.
    ///
    /// # Errors
    /// As [`CaseFile::hertz`]; also when friction or creepage is missing or out of range, and
    /// when the ellipse stands askew to the rolling direction.
    pub fn case(&self) -> Result<Case, CaseError> {
        let contact = self.hertz()?;
        self.check_aligned(&contact)?;
        let friction = self.contact.friction.ok_or_else(|| CaseError::Missing {
            section: "contact".into(),
            key: "friction".into(),
        })?;
        let scaling = Scaling::new(&contact, friction).map_err(CaseError::invalid("contact"))?;
        let (creepage, si_creepage) = self.creepage.resolve(scaling)?;
        Ok(Case { contact, friction, creepage, si_creepage, solve: self.solve.clone() })
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
