//! The case file of a ball bearing.

use creepage::Solid;
use creepage::coulomb::Resolution;
use creepage_bearing::{
    BallBearing, BearingError, BearingLoad, BearingTheory, Control, Operation, SolvedBearing,
};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::case::body::Body;
use crate::case::schema::schema_of;
use crate::case::{CaseError, keys};

/// Error of a bearing's file or of its solution.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BearingCaseError {
    /// Its form, or a number out of its range.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// It cannot be solved.
    #[error("[bearing] {0}")]
    Solve(BearingError),
}

impl From<BearingError> for BearingCaseError {
    fn from(error: BearingError) -> Self {
        match error {
            BearingError::Invalid(invalid) => {
                CaseError::Invalid { section: "bearing", invalid }.into()
            }
            other => Self::Solve(other),
        }
    }
}

/// A bearing and how it runs, every number checked.
#[derive(Debug, Clone)]
pub struct BearingCase {
    /// The bearing.
    pub bearing: BallBearing,
    /// Load and speeds.
    pub operation: Operation,
    /// By what friction is found.
    pub theory: BearingTheory,
}

/// The text of a bearing's file, its form checked.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage bearing file", inline)]
pub struct BearingFile {
    /// The bearing, its load and its friction.
    bearing: BearingSection,
    /// The balls.
    ball: BallSection,
    /// The inner ring.
    inner: RingSection,
    /// The outer ring.
    outer: RingSection,
    /// The theory of friction.
    #[serde(default)]
    solve: SolveSection,
}

/// The bearing as a whole. Give `axial_load`, `radial_load` or both, or `ball_load`.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BearingSection {
    /// Diameter of the circle of the balls' centres (m).
    pitch_diameter: f64,
    /// Number of balls.
    balls: u32,
    /// Contact angle without load (rad); 0 for a deep groove bearing without clearance.
    contact_angle: f64,
    /// Axial force on the inner ring (N).
    axial_load: Option<f64>,
    /// Radial force on the inner ring (N), towards the first ball.
    radial_load: Option<f64>,
    /// Load of every ball on the inner race (N), in place of these.
    ball_load: Option<f64>,
    /// Coefficient of friction in both contacts of a ball.
    friction: f64,
    /// "balance" (the default): a ball's axis lies so that all moments of friction on it balance; "inner" or "outer":
    /// that race does not spin.
    #[serde(default)]
    control: ControlName,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum ControlName {
    #[default]
    Balance,
    Inner,
    Outer,
}

/// The balls.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BallSection {
    /// Diameter (m).
    diameter: f64,
    /// Density (kg/m3), for centrifugal force and gyroscopic moment: 7850 for steel, 3200 for silicon nitride.
    density: f64,
    /// Shear modulus G (Pa). Give this or `young_modulus`.
    shear_modulus: Option<f64>,
    /// Young's modulus E (Pa). Give this or `shear_modulus`.
    young_modulus: Option<f64>,
    /// Poisson's ratio, 0 to 0.5.
    poisson: f64,
}

/// A ring.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RingSection {
    /// Radius of the groove over the ball's diameter, above 0.5.
    osculation: f64,
    /// Angular velocity (rad/s).
    speed: f64,
    /// Shear modulus G (Pa), where the material differs from the balls'.
    shear_modulus: Option<f64>,
    /// Young's modulus E (Pa), where the material differs from the balls'.
    young_modulus: Option<f64>,
    /// Poisson's ratio, beside the modulus.
    poisson: Option<f64>,
}

/// The theory of friction.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SolveSection {
    /// "exact" (the default): the full theory; "fastsim"; "sliding": rigid bodies that slide everywhere, an upper bound.
    #[serde(default)]
    theory: TheoryName,
    /// "fast", "standard" (the default) or "fine": of the full theory.
    resolution: Option<ResolutionName>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum TheoryName {
    #[default]
    Exact,
    Fastsim,
    Sliding,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum ResolutionName {
    Fast,
    Standard,
    Fine,
}

/// The JSON schema (draft 2020-12) of a bearing's file, for editors and validators.
#[must_use]
pub fn bearing_json_schema() -> Value {
    schema_of::<BearingFile>()
}

impl BearingFile {
    /// Whether a text is meant as the file of a bearing: it has `[bearing]`.
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        text.parse::<toml::Table>().is_ok_and(|table| table.contains_key("bearing"))
    }

    /// Reads a file's text and checks its form.
    ///
    /// # Errors
    /// [`CaseError`] that says where it is not a bearing's file.
    pub fn read(text: &str) -> Result<Self, CaseError> {
        keys::check(&text.parse()?, &bearing_json_schema())?;
        Ok(toml::from_str(text)?)
    }

    /// The bearing that it describes.
    ///
    /// # Errors
    /// [`CaseError`] for numbers out of range and contradictions.
    pub fn case(&self) -> Result<BearingCase, CaseError> {
        let Self { bearing: section, ball, inner, outer, .. } = *self;
        let balls = material("ball", (ball.shear_modulus, ball.young_modulus), ball.poisson)?;
        let bearing = BallBearing {
            ball_diameter: ball.diameter,
            pitch_diameter: section.pitch_diameter,
            balls: section.balls as usize,
            contact_angle: section.contact_angle,
            osculation: [inner.osculation, outer.osculation],
            ball: balls,
            density: ball.density,
            rings: [inner.solid("inner", balls)?, outer.solid("outer", balls)?],
            friction: section.friction,
        };
        let invalid = CaseError::invalid("bearing");
        bearing.checked().map_err(&invalid)?;
        let control = match section.control {
            ControlName::Balance => Control::Balance,
            ControlName::Inner => Control::Inner,
            ControlName::Outer => Control::Outer,
        };
        let operation =
            Operation { load: section.load()?, speed: [inner.speed, outer.speed], control };
        match operation.checked() {
            Err(BearingError::Invalid(wrong)) => Err(invalid(wrong)),
            _ => Ok(BearingCase { bearing, operation, theory: self.solve.theory()? }),
        }
    }
}

impl BearingSection {
    fn load(&self) -> Result<BearingLoad, CaseError> {
        let conflict = |one, other| {
            let [first, second] = [one, other].map(|key| ("bearing", key));
            Err(CaseError::Conflict { first, second })
        };
        match (self.ball_load, self.axial_load, self.radial_load) {
            (Some(load), None, None) => Ok(BearingLoad::Ball(load)),
            (Some(_), Some(_), _) => conflict("ball_load", "axial_load"),
            (Some(_), None, Some(_)) => conflict("ball_load", "radial_load"),
            (None, None, None) => {
                let keys = ["axial_load (with radial_load)", "ball_load"];
                Err(CaseError::MissingEither { section: "bearing", keys })
            }
            (None, axial, radial) => Ok(BearingLoad::Rings {
                axial: axial.unwrap_or(0.0),
                radial: radial.unwrap_or(0.0),
            }),
        }
    }
}

impl RingSection {
    /// Its material: the balls' where it has none of its own.
    fn solid(&self, section: &'static str, balls: Solid) -> Result<Solid, CaseError> {
        match (self.shear_modulus.or(self.young_modulus), self.poisson) {
            (None, None) => Ok(balls),
            (_, Some(poisson)) => {
                material(section, (self.shear_modulus, self.young_modulus), poisson)
            }
            (Some(_), None) => {
                Err(CaseError::Missing { section: section.into(), key: "poisson".into() })
            }
        }
    }
}

impl SolveSection {
    fn theory(self) -> Result<BearingTheory, CaseError> {
        if let (Some(_), TheoryName::Fastsim | TheoryName::Sliding) = (self.resolution, self.theory)
        {
            return Err(CaseError::ResolutionOfExact);
        }
        Ok(match self.theory {
            TheoryName::Exact => BearingTheory::Exact(match self.resolution {
                Some(ResolutionName::Fast) => Resolution::FAST,
                Some(ResolutionName::Fine) => Resolution::FINE,
                Some(ResolutionName::Standard) | None => Resolution::STANDARD,
            }),
            TheoryName::Fastsim => BearingTheory::Fastsim([50, 50]),
            TheoryName::Sliding => BearingTheory::Sliding,
        })
    }
}

fn material(
    section: &'static str,
    (shear_modulus, young_modulus): (Option<f64>, Option<f64>),
    poisson: f64,
) -> Result<Solid, CaseError> {
    let (radius_rolling, radius_lateral) = (None, None);
    Body { shear_modulus, young_modulus, poisson, radius_rolling, radius_lateral }.solid(section)
}

impl BearingCase {
    /// Solves the bearing.
    ///
    /// # Errors
    /// [`BearingCaseError`] for loads that nothing carries and balls whose motion is not found.
    pub fn solve(&self) -> Result<SolvedBearing, BearingCaseError> {
        Ok(self.bearing.solve(&self.operation, self.theory)?)
    }

    /// The theory's name.
    #[must_use]
    pub fn theory_name(&self) -> &'static str {
        match self.theory {
            BearingTheory::Exact(_) => "exact",
            BearingTheory::Fastsim(_) => "fastsim",
            BearingTheory::Sliding => "sliding",
        }
    }
}
