//! Wear and fatigue numbers of a solved case.

mod numbers;
mod output;
mod rows;
mod section;

pub(crate) use numbers::DamageInput;
pub use numbers::{Damage, WearRow};
pub(crate) use rows::{middle, of_elements, states};
pub(crate) use section::DamageSection;
pub use section::DamageWanted;

use creepage::damage::{FatigueStress, Shakedown, ShakedownBlock, shakedown_and_fatigue};
use creepage::subsurface::Body;

use crate::stresses::StressError;
use crate::{SolvedCase, Stresses};

impl SolvedCase {
    /// Wear and fatigue numbers by the laws that the case's `[damage]` sets, computed when they are first
    /// asked for; `None` where it has none.
    ///
    /// # Errors
    /// [`StressError`] for tractions that are not finite, where the shakedown limit is wanted.
    pub fn damage(&self) -> Result<Option<&Damage>, StressError> {
        let damage = self.damage.get_or_init(|| self.compute_damage());
        damage.as_ref().map(Option::as_ref).map_err(Clone::clone)
    }

    fn compute_damage(&self) -> Result<Option<Damage>, StressError> {
        let Some(wanted) = self.case.damage() else { return Ok(None) };
        let (scaling, rows) = (self.scaling(), self.rows());
        let input = DamageInput {
            force: scaling.si_force(self.solution().force),
            creepage: scaling.si_creepage(self.creepage()),
            normal: self.load().value,
            area: self.area().value,
            peak: self.peak_pressure().value,
            speed: self.case.speed(),
            rows: rows.as_deref(),
        };
        let limit = wanted.shakedown.then(|| self.shakedown(wanted)).transpose()?;
        Ok(Some(Damage::new(wanted, &input, limit)))
    }

    /// Melan's bound for the lower body, and where it fatigues.
    fn shakedown(&self, wanted: &DamageWanted) -> Result<(Shakedown, FatigueStress), StressError> {
        let ([_, half], [_, lower]) = (self.box_around(), self.case.solids());
        let (interior, settled) = Stresses::interior(self, lower, Body::Lower)?;
        let block = ShakedownBlock { top: settled, ..ShakedownBlock::of(half) };
        Ok(shakedown_and_fatigue(&interior, &block, &wanted.constants.dang_van)?)
    }
}
