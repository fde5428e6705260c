//! `[damage]`: that wear and fatigue numbers are wanted, and their constants.

use creepage::InvalidValue;
use creepage::damage::{Archard, Bre, DamageConstants, DangVan, Ekberg, Usfd, Wlrm};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::CaseError;

/// Wear and fatigue numbers are wanted; constants that are left out are the usual ones.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct DamageSection {
    /// Wear by T gamma over the area (Sheffield).
    usfd: Usfd,
    /// Wear by T gamma (British Rail Research).
    bre: Bre,
    /// Wear by pressure and slip.
    archard: Archard,
    /// Rolling contact fatigue of rails by T gamma.
    wlrm: Wlrm,
    /// Fatigue of wheels below the surface.
    ekberg: Ekberg,
    /// Fatigue by the stresses over a passage; with `shakedown`.
    dang_van: DangVan,
    /// Yield stress in shear of the lower body under cyclic loading (Pa); 300e6 by default.
    shear_yield: f64,
    /// Density (kg/m3) that turns mass worn into depth; 7850 by default.
    density: f64,
    /// Diameter of the wheel (m), which British Rail Research's wear needs.
    wheel_diameter: Option<f64>,
    /// Whether the shakedown limit of the lower body and Dang Van's fatigue stress in it are wanted, which takes
    /// seconds; false by default.
    shakedown: bool,
}

impl Default for DamageSection {
    fn default() -> Self {
        let DamageConstants { usfd, bre, archard, wlrm, ekberg, dang_van, shear_yield, density } =
            DamageConstants::default();
        let (wheel_diameter, shakedown) = (None, false);
        Self {
            usfd,
            bre,
            archard,
            wlrm,
            ekberg,
            dang_van,
            shear_yield,
            density,
            wheel_diameter,
            shakedown,
        }
    }
}

/// Options of wear and fatigue numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DamageWanted {
    /// The constants of the laws.
    pub constants: DamageConstants,
    /// Diameter of the wheel (m), where it is given.
    pub wheel_diameter: Option<f64>,
    /// Whether the shakedown limit is wanted.
    pub shakedown: bool,
}

impl DamageSection {
    pub(crate) fn wanted(&self) -> Result<DamageWanted, CaseError> {
        let Self { usfd, bre, archard, wlrm, ekberg, dang_van, shear_yield, density, .. } = *self;
        let constants =
            DamageConstants { usfd, bre, archard, wlrm, ekberg, dang_van, shear_yield, density };
        let constants = constants.checked().map_err(CaseError::invalid("damage"))?;
        let of_steel = [
            ("density", density, density >= 10.0, "at least 10 kg/m3"),
            ("archard.hardness", archard.hardness, archard.hardness >= 1e6, "at least 1e6 Pa"),
            ("shear_yield", shear_yield, shear_yield <= 2e10, "positive, at most 2e10 Pa"),
            ("dang_van.limit", dang_van.limit, dang_van.limit >= 1e6, "at least 1e6 Pa"),
            ("ekberg.limit", ekberg.limit, ekberg.limit >= 1e6, "at least 1e6 Pa"),
            (
                "dang_van.limit",
                dang_van.limit,
                self.shakedown || dang_van == DangVan::default(),
                "left out unless shakedown = true, which computes the stresses that it takes",
            ),
        ];
        let diameter = self.wheel_diameter.map(|value| {
            ("wheel_diameter", value, value > 0.0 && value <= 10.0, "positive, at most 10 m")
        });
        // Numbers beyond those of any solid or wheel are in another unit.
        let wrong = of_steel.into_iter().chain(diameter).find(|(_, _, is_valid, _)| !is_valid);
        if let Some((quantity, value, _, valid)) = wrong {
            let invalid = InvalidValue { quantity, value, valid };
            return Err(CaseError::invalid("damage")(invalid));
        }
        let Self { wheel_diameter, shakedown, .. } = *self;
        Ok(DamageWanted { constants, wheel_diameter, shakedown })
    }
}

impl DamageSection {
    /// What is wanted of a contact whose shakedown limit is not computed.
    pub(crate) fn wanted_without_limit(&self) -> Result<DamageWanted, CaseError> {
        if self.shakedown { Err(CaseError::ShakedownOfAnyShape) } else { self.wanted() }
    }
}

impl DamageWanted {
    /// The laws whose constants are those from memory, which were not compared with the print.
    #[must_use]
    pub fn unverified(&self) -> Vec<&'static str> {
        let (own, usual) = (self.constants, DamageConstants::default());
        let laws = [
            ("archard", own.archard == usual.archard),
            ("bre", own.bre == usual.bre),
            ("wlrm", own.wlrm == usual.wlrm),
            ("ekberg", own.ekberg == usual.ekberg),
            ("dang_van", own.dang_van == usual.dang_van),
            ("shear_yield", own.shear_yield.to_bits() == usual.shear_yield.to_bits()),
        ];
        laws.into_iter().filter_map(|(law, is_usual)| is_usual.then_some(law)).collect()
    }
}
