//! The sections of a sweep file.

use creepage::InvalidValue;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use super::chain::ChainSection;
use super::loops::Loops;
use super::solve::SolveSection;
use crate::case::error::CaseError;
use crate::case::schema::schema_of;

/// A series of cases, in the dimensionless quantities of the thesis.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "creepage sweep file")]
pub(crate) struct SweepFile {
    /// The contact that all cases share.
    pub(crate) contact: ContactSection,
    /// How the cases are solved.
    #[serde(default)]
    pub(crate) solve: SolveSection,
    /// Creepage and spin of the cases.
    pub(crate) creepage: Loops,
    /// What a case starts from.
    #[serde(default)]
    pub(crate) chain: ChainSection,
    /// What the printed page of a case shows.
    #[serde(default)]
    pub(crate) page: PageSection,
}

#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ContactSection {
    /// Ratio a/b of the contact's semi-axes, along over across the rolling direction.
    pub(crate) a_over_b: f64,
    /// Combined Poisson's ratio.
    pub(crate) poisson: f64,
    /// How unlike the bodies are: kappa of (2.10) over the coefficient of friction; zero if not given.
    #[serde(default)]
    pub(crate) kappa_over_mu: f64,
}

#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PageSection {
    /// Lines y, in units of the major semi-axis, of which the page lists the points: those of the
    /// mesh in x.
    #[serde(default)]
    lines: Vec<f64>,
}

impl PageSection {
    pub(crate) fn lines(self) -> Result<Vec<f64>, CaseError> {
        let Some(&value) = self.lines.iter().find(|y| !y.is_finite()) else {
            return Ok(self.lines);
        };
        let invalid = InvalidValue { quantity: "lines", value, valid: "finite numbers" };
        Err(CaseError::invalid("page")(invalid))
    }
}

/// The JSON schema (draft 2020-12) of a sweep file, for editors and validators.
///
/// ```
/// let schema = creepage_study::sweep_json_schema();
/// assert!(schema["properties"]["creepage"]["properties"]["chi"].is_object());
/// ```
#[must_use]
pub fn sweep_json_schema() -> Value {
    schema_of::<SweepFile>()
}
