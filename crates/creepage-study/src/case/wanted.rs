//! `[wanted]`: forces to which the creepage is to be found.

use creepage::coulomb::Constraints;
use creepage::{Ellipse, Scaling};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::case::creepage::{CreepageSection, given};
use crate::case::error::CaseError;

/// Forces of the upper body on the lower that are wanted: either `longitudinal_force`,
/// `lateral_force`, `moment` or the dimensionless `fx`, `fy`, `mz`. Together with [creepage]
/// exactly three quantities are given, zeros too; the creepages that are left out are found.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WantedSection {
    /// Longitudinal force on the lower body (N), positive along the rolling direction: negative
    /// where a wheel drives.
    longitudinal_force: Option<f64>,
    /// Lateral force on the lower body (N), positive to the right of the rolling direction.
    lateral_force: Option<f64>,
    /// Moment about the normal on the lower body (N m), positive from the rolling direction to the
    /// right.
    moment: Option<f64>,
    /// Dimensionless longitudinal force.
    fx: Option<f64>,
    /// Dimensionless lateral force.
    fy: Option<f64>,
    /// Dimensionless moment.
    mz: Option<f64>,
}

const SECTION: &str = "wanted";
const SI_NAMES: [&str; 3] = ["longitudinal_force", "lateral_force", "moment"];
const NAMES: [&str; 3] = ["fx", "fy", "mz"];

impl WantedSection {
    /// The three quantities that determine the others, dimensionless.
    pub(crate) fn constraints(
        &self,
        creepage: &CreepageSection,
        ellipse: Ellipse,
        scaling: Scaling,
    ) -> Result<Constraints, CaseError> {
        let force = self.force(ellipse, scaling)?;
        let names: Vec<_> = creepage.names().chain(self.names()).collect();
        if names.len() != 3 {
            return Err(CaseError::NotThree { given: names });
        }
        let [xi, eta, chi] = creepage.known(scaling)?;
        let [fx, fy, mz] = force;
        Ok(Constraints { xi, eta, chi, fx, fy, mz })
    }

    fn si(&self) -> [Option<f64>; 3] {
        [self.longitudinal_force, self.lateral_force, self.moment]
    }

    fn dimensionless(&self) -> [Option<f64>; 3] {
        [self.fx, self.fy, self.mz]
    }

    /// Names of the forces that are wanted.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> {
        given(SI_NAMES, self.si()).chain(given(NAMES, self.dimensionless()))
    }

    fn force(&self, ellipse: Ellipse, scaling: Scaling) -> Result<[Option<f64>; 3], CaseError> {
        let (si, dimensionless) = (self.si(), self.dimensionless());
        let both = (given(SI_NAMES, si).next(), given(NAMES, dimensionless).next());
        if let (Some(first), Some(second)) = both {
            return Err(CaseError::Conflict { first: (SECTION, first), second: (SECTION, second) });
        }
        let arm = ellipse.major() / ellipse.c();
        let units = [scaling.force, scaling.force, scaling.force * scaling.length];
        within(SI_NAMES, si, [units[0], units[1], units[2] * arm])?;
        within(NAMES, dimensionless, [1.0, 1.0, arm])?;
        Ok([0, 1, 2].map(|k| dimensionless[k].or(si[k].map(|value| value / units[k]))))
    }
}

/// A force cannot exceed `mu N`, nor a moment that at the end of the larger semi-axis; how much less the moment can
/// reach is for the theory to say.
fn within(
    names: [&'static str; 3],
    values: [Option<f64>; 3],
    most: [f64; 3],
) -> Result<(), CaseError> {
    for ((key, value), most) in names.into_iter().zip(values).zip(most) {
        let value = value.unwrap_or(0.0);
        if value.is_nan() || value.abs() > most {
            return Err(CaseError::BeyondFriction { key, value, most });
        }
    }
    Ok(())
}
