//! `[creepage]` and `[wanted]` of a contact of any shape: in SI units alone.

use creepage::coulomb::Constraints;
use creepage::{Creepage, InvalidValue, Scaling, SiCreepage};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::CaseError;
use crate::case::creepage::{CreepageSection, given};

/// Velocity of the upper body relative to the lower, over the rolling velocity, at the origin of
/// coordinates. What is left out is zero, unless [wanted] asks for it.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SiCreepageSection {
    /// Longitudinal creepage, positive along the rolling direction.
    pub(super) longitudinal: Option<f64>,
    /// Lateral creepage, positive to the right of the rolling direction.
    pub(super) lateral: Option<f64>,
    /// Spin (rad/m), positive from the rolling direction to the right.
    pub(super) spin: Option<f64>,
    /// Rolling velocity (m/s), for the frictional power in watts; a law of friction by the speed of slip
    /// needs it.
    pub(super) speed: Option<f64>,
}

/// Forces of the upper body on the lower that are wanted. Together with [creepage] exactly three
/// quantities are given, zeros too; the creepages that are left out are found.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SiWantedSection {
    /// Longitudinal force (N).
    pub(super) longitudinal_force: Option<f64>,
    /// Lateral force (N).
    pub(super) lateral_force: Option<f64>,
    /// Moment about the normal through the origin of coordinates (N m).
    pub(super) moment: Option<f64>,
}

/// Prescribed creepage and forces, in SI units: three creepages, or three of six.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SiGiven {
    /// Creepages; all of them where no force is wanted.
    pub(super) creepage: [Option<f64>; 3],
    /// Wanted forces.
    pub(super) force: [Option<f64>; 3],
}

const CREEPAGES: [&str; 3] = ["longitudinal", "lateral", "spin"];
pub(super) const FORCES: [&str; 3] = ["longitudinal_force", "lateral_force", "moment"];

impl From<CreepageSection> for SiCreepageSection {
    /// Of what is given in SI units.
    fn from(given: CreepageSection) -> Self {
        let CreepageSection { longitudinal, lateral, spin, speed, .. } = given;
        Self { longitudinal, lateral, spin, speed }
    }
}

impl SiCreepageSection {
    /// The same as a case of an ellipse has it.
    pub(super) fn of_ellipses(&self) -> CreepageSection {
        let Self { longitudinal, lateral, spin, speed } = *self;
        CreepageSection { longitudinal, lateral, spin, speed, ..CreepageSection::default() }
    }

    /// What is given here and in [wanted].
    pub(super) fn given(&self, wanted: &SiWantedSection) -> Result<SiGiven, CaseError> {
        let creepage = [self.longitudinal, self.lateral, self.spin];
        let force = [wanted.longitudinal_force, wanted.lateral_force, wanted.moment];
        let names: Vec<_> = given(CREEPAGES, creepage).chain(given(FORCES, force)).collect();
        check(CREEPAGES, creepage).map_err(CaseError::invalid("creepage"))?;
        check(FORCES, force).map_err(CaseError::invalid("wanted"))?;
        if names.is_empty() {
            return Err(CaseError::MissingSection {
                section: "creepage".into(),
                needs: CREEPAGES.join(", "),
            });
        }
        if force == [None; 3] {
            let creepage = creepage.map(|value| value.or(Some(0.0)));
            return Ok(SiGiven { creepage, force });
        }
        if names.len() != 3 {
            return Err(CaseError::NotThree { given: names });
        }
        Ok(SiGiven { creepage, force })
    }

    /// Rolling velocity (m/s).
    pub(super) fn speed(&self) -> Result<Option<f64>, CaseError> {
        match self.speed {
            Some(value) if !(value.is_finite() && value > 0.0) => {
                let valid = "finite and greater than zero";
                Err(CaseError::invalid("creepage")(InvalidValue {
                    quantity: "speed",
                    value,
                    valid,
                }))
            }
            speed => Ok(speed),
        }
    }
}

fn check(names: [&'static str; 3], values: [Option<f64>; 3]) -> Result<(), InvalidValue> {
    let valid = "a finite number";
    let wrong = names.into_iter().zip(values).find_map(|(quantity, value)| {
        value.filter(|value| !value.is_finite()).map(|value| (quantity, value))
    });
    wrong.map_or(Ok(()), |(quantity, value)| Err(InvalidValue { quantity, value, valid }))
}

impl SiGiven {
    /// No creepage.
    pub(super) const AT_REST: Self = Self { creepage: [Some(0.0); 3], force: [None; 3] };

    /// A creepage, and no force.
    pub(super) fn at(creepage: SiCreepage) -> Result<Self, CaseError> {
        let SiCreepage { longitudinal, lateral, spin } = creepage;
        let creepage = [longitudinal, lateral, spin].map(Some);
        check(CREEPAGES, creepage).map_err(CaseError::invalid("creepage"))?;
        Ok(Self { creepage, force: [None; 3] })
    }

    /// Whether the creepages are given, rather than to be found.
    pub(crate) fn is_creepage(&self) -> bool {
        self.force == [None; 3]
    }

    /// The creepage in the contact's units, zero where none is given.
    pub(crate) fn creepage(&self, scaling: Scaling) -> Result<Creepage, CaseError> {
        let [longitudinal, lateral, spin] = self.creepage.map(|value| value.unwrap_or(0.0));
        scaling
            .creepage(SiCreepage { longitudinal, lateral, spin })
            .map_err(CaseError::invalid("creepage"))
    }

    /// The constraints in the contact's units; `reach` is the largest distance of the contact from
    /// the origin (m). A force cannot exceed `mu N`, nor a moment that at this distance.
    pub(super) fn constraints(
        &self,
        scaling: Scaling,
        reach: f64,
    ) -> Result<Constraints, CaseError> {
        let most = [scaling.force, scaling.force, scaling.force * reach];
        for ((key, value), most) in FORCES.into_iter().zip(self.force).zip(most) {
            let value = value.unwrap_or(0.0);
            if value.abs() > most {
                return Err(CaseError::BeyondFriction { key, value, most });
            }
        }
        let creepage = self.creepage(scaling)?.components();
        let [xi, eta, chi] = [0, 1, 2].map(|k| self.creepage[k].map(|_| creepage[k]));
        let units = [scaling.force, scaling.force, scaling.force * scaling.length];
        let [fx, fy, mz] = [0, 1, 2].map(|k| self.force[k].map(|value| value / units[k]));
        Ok(Constraints { xi, eta, chi, fx, fy, mz })
    }

    /// Names of what was given, where creepages were found.
    pub(super) fn known(&self) -> Option<Vec<&'static str>> {
        let names = given(CREEPAGES, self.creepage).chain(given(FORCES, self.force));
        (!self.is_creepage()).then(|| names.collect())
    }
}
