//! `[creepage]`: in SI units or dimensionless.

use creepage::rolling::{Creepage, Scaling, SiCreepage};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::CaseError;

/// Velocity of the upper body relative to the lower, over the rolling velocity: either
/// `longitudinal`, `lateral`, `spin` or the dimensionless `xi`, `eta`, `chi`. What is left out
/// is zero.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CreepageSection {
    /// Longitudinal creepage, positive along the rolling direction.
    longitudinal: Option<f64>,
    /// Lateral creepage, positive to the right of the rolling direction.
    lateral: Option<f64>,
    /// Spin (rad/m), positive from the rolling direction to the right.
    spin: Option<f64>,
    /// Dimensionless longitudinal creepage.
    xi: Option<f64>,
    /// Dimensionless lateral creepage.
    eta: Option<f64>,
    /// Dimensionless spin.
    chi: Option<f64>,
}

const SECTION: &str = "creepage";

impl CreepageSection {
    /// The creepage in both units.
    pub(crate) fn resolve(&self, scaling: Scaling) -> Result<(Creepage, SiCreepage), CaseError> {
        let si = given(
            ["longitudinal", "lateral", "spin"],
            [self.longitudinal, self.lateral, self.spin],
        );
        let dimensionless = given(["xi", "eta", "chi"], [self.xi, self.eta, self.chi]);
        match (si, dimensionless) {
            (Some(first), Some(second)) => {
                Err(CaseError::Conflict { first: (SECTION, first), second: (SECTION, second) })
            }
            (None, None) => Err(CaseError::MissingSection {
                section: SECTION.into(),
                needs: "longitudinal, lateral, spin, or xi, eta, chi".into(),
            }),
            (Some(_), None) => self.by_si(scaling),
            (None, Some(_)) => self.by_dimensionless(scaling),
        }
    }

    fn by_si(&self, scaling: Scaling) -> Result<(Creepage, SiCreepage), CaseError> {
        let si = SiCreepage {
            longitudinal: self.longitudinal.unwrap_or(0.0),
            lateral: self.lateral.unwrap_or(0.0),
            spin: self.spin.unwrap_or(0.0),
        };
        Ok((scaling.creepage(si).map_err(CaseError::invalid(SECTION))?, si))
    }

    fn by_dimensionless(&self, scaling: Scaling) -> Result<(Creepage, SiCreepage), CaseError> {
        let [xi, eta, chi] = [self.xi, self.eta, self.chi].map(|part| part.unwrap_or(0.0));
        let creepage = Creepage::new(xi, eta, chi).map_err(CaseError::invalid(SECTION))?;
        Ok((creepage, scaling.si_creepage(creepage)))
    }
}

/// The first name whose value is given.
fn given(names: [&'static str; 3], values: [Option<f64>; 3]) -> Option<&'static str> {
    names.into_iter().zip(values).find_map(|(name, value)| value.map(|_| name))
}
