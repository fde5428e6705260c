//! Caution for profiles that are rough where they touch.

use creepage::{Solid, SolidPair};
use creepage_rail::{RadiusDifference, Side};
use creepage_wheelset::{Roughness, rough_profiles};

use super::case::WheelsetCase;
use crate::Caution;

impl From<Roughness> for Caution {
    fn from(Roughness { body, length, swing, pressure }: Roughness) -> Self {
        Self::Rough { body, length, swing, pressure }
    }
}

impl WheelsetCase {
    /// Profiles that are rough where wheel and rail touch, as of [`rough_profiles`]; in steel where no materials
    /// are given. `rolls` as for [`WheelsetCase::radius_difference`].
    #[must_use]
    pub fn rough_profiles(
        &self,
        difference: &RadiusDifference,
        rolls: bool,
    ) -> Vec<(Side, Caution)> {
        let steel = || Solid::new(82e9, 0.28).map(|solid| SolidPair::new(solid, solid));
        let Some(pair) = self.solids.or_else(|| steel().ok()) else { return Vec::new() };
        let rough = rough_profiles(&self.running, &pair, difference, rolls);
        rough.into_iter().map(|(side, rough)| (side, rough.into())).collect()
    }
}
