//! What the forces do: wear and fatigue numbers in the forms that engineers compare.
//!
//! Each number starts from forces and creepages of the whole contact, from the state of each element
//! of it ([`ElementState`]), or from the elastic stresses below it ([`shakedown`]). All quantities are
//! SI; the laws' own units (N/mm2, ug/m/mm2) stay inside.
//!
//! The laws are fits to measurements on certain steels; every constant can be replaced, and its
//! documentation names the source. *Unverified* marks constants that were taken down from memory and not
//! compared with the printed source: check them before a decision rests on them.

mod archard;
mod ball;
mod energy;
mod fatigue;
mod passage;
mod shakedown;
mod wear;

pub use archard::{Archard, ArchardWear, WearZone};
pub use energy::{ElementState, TGamma};
pub use fatigue::{Ekberg, Wlrm, local_surface_index, surface_index};
pub use passage::{DangVan, Passage};
pub use shakedown::{Shakedown, ShakedownBlock, shakedown};
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
