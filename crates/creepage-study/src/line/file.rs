//! The case file of a line contact.

use creepage::approximate::carter::LineContact;
use creepage::friction_law::RollingFriction;
use creepage::viscoelastic::Relaxation;
use creepage::{InvalidValue, SolidPair};
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Table;

use crate::case::body::Body;
use crate::case::friction::FrictionValue;
use crate::case::keys;
use crate::case::radius::{Radius, line_radii};
use crate::case::schema::schema_of;
use crate::{CaseError, Caution};

/// Two cylinders with parallel axes that roll steadily, in SI units; forces are per length of the cylinders.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage case file of a line contact")]
pub struct LineFile {
    /// The upper body, such as a wheel.
    pub(super) upper: Body,
    /// The lower body, such as a rail.
    pub(super) lower: Body,
    /// The load, the friction.
    pub(super) contact: ContactSection,
    /// How the upper body moves against the lower, unless [wanted] has a force.
    #[serde(default)]
    pub(super) creepage: MotionSection,
    /// The force to which the creepage is found.
    pub(super) wanted: Option<WantedSection>,
    /// How both bodies give way in time; their moduli are the glassy ones then.
    pub(super) relaxation: Option<RelaxationSection>,
    /// The theory.
    #[serde(default)]
    pub(super) solve: SolveSection,
}

/// The load and the friction.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ContactSection {
    /// Normal force per length of the cylinders (N/m).
    pub(super) line_load: f64,
    /// Coefficient of friction mu.
    pub(super) friction: FrictionValue,
    /// Radius of one cylinder on a plane that is curved as the two together (m), in place of the bodies' radii.
    pub(super) radius_rolling: Option<Radius>,
    /// Length of the cylinders (m): `roll` needs it, steady rolling does not.
    pub(super) length: Option<f64>,
}

/// The motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MotionSection {
    /// Longitudinal creepage, positive along the rolling direction.
    pub(super) longitudinal: Option<f64>,
    /// Dimensionless creepage xi, in mu a / rho.
    pub(super) xi: Option<f64>,
    /// Rolling velocity (m/s); viscoelastic bodies need it.
    pub(super) speed: Option<f64>,
}

/// The force that is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct WantedSection {
    /// Longitudinal force on the lower body per length (N/m).
    pub(super) longitudinal_force: Option<f64>,
    /// The same over mu N.
    pub(super) fx: Option<f64>,
}

/// A shear compliance that grows from 1/G to (1 + ratio)/G as 1 - exp(-t/time); Poisson's ratio stays.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RelaxationSection {
    /// How much softer the bodies are in the end: G of fast loads over that of slow ones, less 1.
    pub(super) ratio: f64,
    /// Retardation time of the compliance (s).
    pub(super) time: f64,
}

/// The theory.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SolveSection {
    /// "exact" (the default), or "carter", which takes the bodies for like ones.
    #[serde(default)]
    #[schemars(with = "LineTheory")]
    pub(super) theory: LineTheory,
}

/// A theory of a line contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LineTheory {
    /// Pressure and friction solved together; closed forms where there are any.
    #[default]
    Exact,
    /// Carter's, of like elastic bodies.
    Carter,
}

impl LineTheory {
    /// Its name in files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Carter => "carter",
        }
    }

    /// The theory of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        [Self::Exact, Self::Carter].into_iter().find(|theory| theory.name() == name)
    }
}

/// Prescribed motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Given {
    /// The creepage `upsilon_x`.
    Creepage(f64),
    /// The force on the lower body (N/m).
    Force(f64),
}

/// A line contact with its motion, every number of it checked.
#[derive(Debug, Clone, PartialEq)]
pub struct LineCase {
    pub(super) pair: SolidPair,
    pub(super) line: LineContact,
    pub(super) load: f64,
    pub(super) friction: f64,
    /// `1/(1/R1 + 1/R2)` (m).
    pub(super) radius: f64,
    pub(super) given: Given,
    pub(super) speed: Option<f64>,
    pub(super) relaxation: Option<Relaxation>,
    pub(super) theory: LineTheory,
    pub(super) cautions: Vec<Caution>,
}

impl LineFile {
    /// Whether a text is one of these: `[contact] line_load` tells.
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        let table = text.parse::<Table>().unwrap_or_default();
        table.get("contact").is_some_and(|contact| contact.get("line_load").is_some())
    }

    /// Reads the text of a case file and checks its form.
    ///
    /// # Errors
    /// [`CaseError`] that says where the text is not such a file.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        let table = keys::parse(text)?;
        keys::check(&table, &schema_of::<Self>())?;
        Ok(toml::from_str(text)?)
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// [`CaseError`] with section, key and value.
    pub fn case(&self) -> Result<LineCase, CaseError> {
        let solids = [self.upper.solid("upper")?, self.lower.solid("lower")?];
        let pair = SolidPair::new(solids[0], solids[1]);
        let radii = line_radii([&self.upper, &self.lower], self.contact.radius_rolling)?;
        let load = self.contact.line_load;
        let line = LineContact::new(pair, radii, load).map_err(CaseError::invalid("contact"))?;
        let friction = self.friction()?;
        positive("contact", "length", self.contact.length)?;
        let speed = positive("creepage", "speed", self.creepage.speed)?;
        let given = self.given(&line, friction * load, friction)?;
        let relaxation = self.relaxation(solids[0] == solids[1], speed)?;
        let bodies = [&self.upper, &self.lower];
        let smallest = bodies.into_iter().filter_map(Body::smallest_radius);
        let radius = 0.25 * line.rho();
        let smallest = smallest.fold(f64::INFINITY, f64::min);
        let smallest = if smallest.is_finite() { smallest } else { radius };
        let sizes = [line.half_width(), smallest];
        let cautions = Caution::line_units(sizes, [line.peak_pressure(), pair.shear_modulus()]);
        let theory = self.solve.theory;
        Ok(LineCase {
            pair,
            line,
            load,
            friction,
            radius,
            given,
            speed,
            relaxation,
            theory,
            cautions,
        })
    }

    /// The coefficient, which is constant.
    fn friction(&self) -> Result<f64, CaseError> {
        let value = self.contact.friction.at_rest()?;
        let law: Option<RollingFriction> =
            self.contact.friction.rolling(self.creepage.speed, None)?;
        if law.is_some() {
            return Err(CaseError::LawOnLine);
        }
        let is_valid = value.is_finite() && value > 0.0;
        let valid = "finite and greater than zero";
        let invalid = InvalidValue { quantity: "friction", value, valid };
        if is_valid { Ok(value) } else { Err(CaseError::invalid("contact")(invalid)) }
    }

    fn given(&self, line: &LineContact, most: f64, friction: f64) -> Result<Given, CaseError> {
        let creepages = [("longitudinal", self.creepage.longitudinal), ("xi", self.creepage.xi)];
        let wanted = self.wanted.unwrap_or(WantedSection { longitudinal_force: None, fx: None });
        let forces = [("longitudinal_force", wanted.longitudinal_force), ("fx", wanted.fx)];
        let creepages = creepages.into_iter().map(|(key, value)| ("creepage", key, value));
        let forces = forces.into_iter().map(|(key, value)| ("wanted", key, value));
        let mut all = creepages
            .chain(forces)
            .filter_map(|(section, key, value)| value.map(|value| (section, key, value)));
        let Some((section, key, value)) = all.next() else {
            return Err(CaseError::MissingSection {
                section: "creepage".into(),
                needs: "longitudinal or xi, or [wanted] longitudinal_force or fx".into(),
            });
        };
        if let Some((other, second, _)) = all.next() {
            let (first, second) = ((section, key), (other, second));
            return Err(CaseError::Conflict { first, second });
        }
        let invalid = |valid| CaseError::Invalid {
            section,
            invalid: InvalidValue { quantity: key, value, valid },
        };
        if !value.is_finite() {
            return Err(invalid("a finite number"));
        }
        let force = match key {
            "longitudinal" => return Ok(Given::Creepage(value)),
            "xi" => {
                let unit = friction * line.half_width() / line.rho();
                return Ok(Given::Creepage(value * unit));
            }
            "fx" => value * most,
            _ => value,
        };
        if force.abs() < most {
            Ok(Given::Force(force))
        } else {
            Err(invalid("less than mu N in size, where the bodies slide at any creepage"))
        }
    }

    fn relaxation(
        &self,
        are_like: bool,
        speed: Option<f64>,
    ) -> Result<Option<Relaxation>, CaseError> {
        let Some(RelaxationSection { ratio, time }) = self.relaxation else { return Ok(None) };
        if !are_like {
            return Err(CaseError::UnlikeRelaxation);
        }
        if self.solve.theory == LineTheory::Carter {
            let (first, second) = (("relaxation", "ratio"), ("solve", "theory = \"carter\""));
            return Err(CaseError::Conflict { first, second });
        }
        positive("relaxation", "ratio", Some(ratio))?;
        positive("relaxation", "time", Some(time))?;
        if speed.is_none() {
            return Err(CaseError::Missing { section: "creepage".into(), key: "speed".into() });
        }
        Ok(Some(Relaxation { ratio, time }))
    }
}

impl LineCase {
    /// The same by another theory.
    ///
    /// # Errors
    /// [`CaseError`] for Carter's theory of viscoelastic bodies.
    pub fn by(self, theory: LineTheory) -> Result<Self, CaseError> {
        if theory == LineTheory::Carter && self.relaxation.is_some() {
            let (first, second) = (("relaxation", "ratio"), ("solve", "theory = \"carter\""));
            return Err(CaseError::Conflict { first, second });
        }
        Ok(Self { theory, ..self })
    }
}

fn positive(
    section: &'static str,
    key: &'static str,
    value: Option<f64>,
) -> Result<Option<f64>, CaseError> {
    match value {
        Some(value) if !(value.is_finite() && value > 0.0) => {
            let valid = "finite and greater than zero";
            Err(CaseError::invalid(section)(InvalidValue { quantity: key, value, valid }))
        }
        value => Ok(value),
    }
}
