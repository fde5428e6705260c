//! Wear and fatigue numbers, in the forms that engineers compare.
//!
//! Each number starts from forces and creepages of the whole contact, from the state of each element
//! of it ([`ElementState`]), or from the elastic stresses below it ([`shakedown`]). All quantities are
//! SI; the laws' own units (N/mm2, ug/m/mm2) stay inside.
//!
//! The laws are fits to measurements on certain steels; every constant can be replaced, and its
//! documentation names the source. *Unverified* marks constants that were taken down from memory and not
//! compared with the printed source: check them before a decision rests on them.

use crate::check::{self, InvalidValue};

mod archard;
mod ball;
mod energy;
mod fatigue;
mod passage;
mod shakedown;
mod wear;

pub use archard::{Archard, ArchardWear, WearZone};
pub use energy::{ElementState, Row, TGamma};
pub use fatigue::{Ekberg, Wlrm, local_surface_index, surface_index};
pub use passage::{DangVan, Passage};
pub use shakedown::{FatigueStress, Shakedown, ShakedownBlock, shakedown, shakedown_and_fatigue};
pub use wear::{Bre, Usfd};

/// The constants of every law, to be kept and replaced in one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DamageConstants {
    /// Wear by T gamma over the area.
    pub usfd: Usfd,
    /// Wear by T gamma.
    pub bre: Bre,
    /// Wear by pressure and slip.
    pub archard: Archard,
    /// Rolling contact fatigue of rails by T gamma.
    pub wlrm: Wlrm,
    /// Fatigue of wheels below the surface.
    pub ekberg: Ekberg,
    /// Fatigue limit by the stresses over a passage.
    pub dang_van: DangVan,
    /// Yield stress in shear `k` under cyclic loading (Pa): 300e6 for rail steel R260. *Unverified.*
    pub shear_yield: f64,
    /// Density that turns the mass worn into a depth (kg/m3): 7850, steel.
    pub density: f64,
}

impl DamageConstants {
    /// What the numbers are divided by, and what must not be negative, is so.
    ///
    /// # Errors
    /// [`InvalidValue`] that names the constant.
    pub fn checked(self) -> Result<Self, InvalidValue> {
        let Self { usfd, bre, archard, wlrm, ekberg, dang_van, shear_yield, density } = self;
        for (name, value) in [
            ("shear_yield", shear_yield),
            ("density", density),
            ("archard.hardness", archard.hardness),
            ("ekberg.limit", ekberg.limit),
            ("dang_van.limit", dang_van.limit),
        ] {
            check::positive(name, value)?;
        }
        for (name, value) in [
            ("usfd.mild_slope", usfd.mild_slope),
            ("usfd.severe_rate", usfd.severe_rate),
            ("usfd.catastrophic_from", usfd.catastrophic_from),
            ("usfd.catastrophic_slope", usfd.catastrophic_slope),
            ("bre.mild_slope", bre.mild_slope),
            ("archard.mild", archard.mild),
            ("archard.severe", archard.severe),
            ("archard.seizure", archard.seizure),
            ("archard.seizure_from", archard.seizure_from),
            ("wlrm.scale", wlrm.scale),
            ("dang_van.mean_weight", dang_van.mean_weight),
        ] {
            let is_valid = value.is_finite() && value >= 0.0;
            check::require(is_valid, name, value, "finite and not negative")?;
        }
        let finite = [bre.severe, bre.plateau, archard.severe_between];
        for value in finite.as_flattened().iter().chain([&ekberg.residual, &ekberg.residual_weight])
        {
            check::finite("a constant of [damage]", *value)?;
        }
        let [from, to] = bre.plateau;
        check::require(from >= 0.0, "bre.plateau", from, "not negative")?;
        check::require(to >= from, "bre.plateau", to, "rising")?;
        let Wlrm { start, worst, balance, .. } = wlrm;
        let rising = start < worst && worst < balance && balance.is_finite();
        check::require(rising, "wlrm.worst", worst, "between wlrm.start and wlrm.balance")?;
        Ok(self)
    }
}

impl Default for DamageConstants {
    fn default() -> Self {
        Self {
            usfd: Usfd::default(),
            bre: Bre::default(),
            archard: Archard::default(),
            wlrm: Wlrm::default(),
            ekberg: Ekberg::default(),
            dang_van: DangVan::default(),
            shear_yield: 300e6,
            density: 7850.0,
        }
    }
}
