//! `[gap] groove`: a round body in a groove, in a plane or along its curve.

use creepage::coulomb::InverseError;
use creepage::curved::{CurvedContact, CurvedError, CurvedForce, CurvedGap, CurvedRolling};
use creepage::normal::{self, NormalContact};
use creepage::{SiCreepage, Theory, TheorySpec};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::case::{GapCase, LoadOrApproach};
use super::error::GapCaseError;
use super::solver::{fineness, not_pressed, pressed};
use crate::solve::SolvedTheory;
use crate::{CaseError, SolvedCase};

/// A round upper body in a straight groove of the lower one.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct GrooveTable {
    /// Radius of the upper body across (m).
    inner: f64,
    /// Radius of the groove across (m), larger.
    outer: f64,
    /// Rolling radius of the upper body in the middle (m).
    rolling: f64,
}

impl GrooveTable {
    pub(super) fn curved(&self) -> Result<CurvedGap, CaseError> {
        CurvedGap::groove(self.inner, self.outer, self.rolling)
            .map_err(CaseError::invalid("gap groove"))
    }
}

/// Where the gap is measured, and where bodies slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum Surface {
    /// In one plane.
    #[default]
    Plane,
    /// Along the curve across, whose normal turns; with `[gap] groove`.
    Curved,
}

/// Quantities of a curved contact besides its pressure over `x` and the arc length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CurvedJson {
    /// By how much the surface turns from one side of the areas to the other (rad).
    pub turn_rad: f64,
    /// Force of pressure and friction along the middle's normal (N): the load.
    pub vertical_n: f64,
    /// Of which by friction (N).
    pub vertical_by_friction_n: f64,
    /// Force of pressure and friction on the lower body across (N).
    pub lateral_n: f64,
    /// Peak pressure of the same bodies in one plane (Pa).
    pub plane_peak_pressure_pa: f64,
    /// Approach of the same bodies in one plane (m).
    pub plane_approach_m: f64,
}

impl GapCase {
    /// A contact along a curve: pressed until pressure and friction carry the load, and rolled.
    pub(super) fn solve_curved(&self, curved: &CurvedGap) -> Result<SolvedCase, GapCaseError> {
        let TheorySpec::Exact(options) = &self.theory else {
            return Err(GapCaseError::CurvedTheory { name: self.theory.facts().name });
        };
        if self.rolling_friction.is_some() || self.layer.is_some() || self.slip.is_some() {
            return Err(GapCaseError::CurvedFriction);
        }
        let (resolutions, _) = options.resolutions().map_err(CaseError::invalid("solve"))?;
        let [roll] = resolutions[..] else { return Err(GapCaseError::CurvedAuto) };
        let press = fineness(&self.theory);
        let [x, y, spin] = self.given.creepage;
        let [wanted, lateral, moment] = self.given.force;
        if lateral.is_some() || moment.is_some() || wanted.is_some() && x.is_some() {
            return Err(GapCaseError::CurvedWanted);
        }
        let creepage = SiCreepage {
            longitudinal: x.unwrap_or(0.0),
            lateral: y.unwrap_or(0.0),
            spin: spin.unwrap_or(0.0),
        };
        let wrong = |error| self.not_curved(error);
        let (contact, rolling, creepage) = match self.pressed {
            LoadOrApproach::Load(load) => curved
                .rolled(self.pair, load, self.friction, creepage, wanted, (press, roll))
                .map_err(wrong)?,
            LoadOrApproach::Approach(approach) => {
                let contact = curved.pressed(self.pair, approach, press).map_err(wrong)?;
                let rolling =
                    contact.rolling(self.friction, roll).map_err(CaseError::invalid("contact"))?;
                let creepage = match wanted {
                    None => creepage,
                    Some(force) => rolling.find(force, creepage).map_err(wrong)?.0,
                };
                (contact, rolling, creepage)
            }
        };
        let more = self.curved_json(&contact, &rolling, creepage)?;
        let touching = rolling.contact().clone();
        let dimensionless =
            touching.scaling().creepage(creepage).map_err(CaseError::invalid("creepage"))?;
        let held = SolvedTheory::new(Box::new(rolling), |theory| theory.solved(dimensionless));
        let mut solved = self.kept(&touching, held);
        solved.curved = Some(more);
        Ok(solved.with_heat())
    }

    /// What it has besides, beside the same bodies in one plane.
    fn curved_json(
        &self,
        contact: &CurvedContact,
        rolling: &CurvedRolling,
        creepage: SiCreepage,
    ) -> Result<CurvedJson, GapCaseError> {
        let solved = rolling.solve(creepage).map_err(CaseError::invalid("creepage"))?;
        let CurvedForce { lateral, vertical, .. } = rolling.force(&solved);
        let plane = pressed(self, normal::Resolution::STANDARD)?;
        Ok(CurvedJson {
            turn_rad: contact.turn(),
            vertical_n: contact.vertical() + vertical,
            vertical_by_friction_n: vertical,
            lateral_n: contact.lateral() + lateral,
            plane_peak_pressure_pa: plane.peak_pressure().value,
            plane_approach_m: plane.approach().value,
        })
    }

    /// The pressure alone of a contact along a curve, without friction.
    pub(super) fn press_curved(
        &self,
        curved: &CurvedGap,
        resolution: normal::Resolution,
    ) -> Result<NormalContact, GapCaseError> {
        let contact = match self.pressed {
            LoadOrApproach::Load(load) => curved.under_load(self.pair, load, resolution),
            LoadOrApproach::Approach(approach) => curved.pressed(self.pair, approach, resolution),
        };
        contact.map(|contact| contact.normal().clone()).map_err(|error| self.not_curved(error))
    }

    fn not_curved(&self, error: CurvedError) -> GapCaseError {
        match error {
            CurvedError::Normal(source) => not_pressed(self, source),
            CurvedError::Value(invalid) => CaseError::invalid("contact")(invalid).into(),
            CurvedError::Inverse(source @ InverseError::NotReachable { .. }) => source.into(),
            other => GapCaseError::Curved { source: other },
        }
    }
}
