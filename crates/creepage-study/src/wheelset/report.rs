//! Report of a solved wheelset: with cautions, wear and fatigue numbers; and the caution for profiles that are rough where they touch.

use super::case::WheelsetCase;
use crate::{Caution, Damage, Heat};
use creepage::{SiCreepage, SiForce, Solid, SolidPair, Status};
use creepage_rail::{RadiusDifference, RollingCreepage, Side};
use creepage_wheelset::{
    Roughness, SolvedContact, SolvedWheel, SolvedWheelset, Unmeasured, rough_profiles,
    unmeasured_profiles,
};
use std::ops::Deref;

/// A solved wheelset and what is reported of it: as text, JSON, files and pictures.
#[derive(Debug, Clone)]
pub struct WheelsetReport {
    /// The solution.
    pub solved: SolvedWheelset,
    /// Wear and fatigue numbers of each contact of the left and of the right wheel; empty where none are wanted.
    pub(super) damage: [Vec<Damage>; 2],
    /// Temperatures of each contact, and the cautions about them; empty where none are wanted.
    pub(super) heat: [Vec<(Option<Heat>, Vec<Caution>)>; 2],
}

impl From<SolvedWheelset> for WheelsetReport {
    fn from(solved: SolvedWheelset) -> Self {
        Self { solved, damage: [const { Vec::new() }; 2], heat: [const { Vec::new() }; 2] }
    }
}

impl Deref for WheelsetReport {
    type Target = SolvedWheelset;

    fn deref(&self) -> &SolvedWheelset {
        &self.solved
    }
}

impl WheelsetReport {
    /// Wear and fatigue numbers of the contacts of one wheel, in the order of its contacts; empty where `[damage]`
    /// does not ask for them.
    #[must_use]
    pub fn damage(&self, side: Side) -> &[Damage] {
        &self.damage[usize::from(side == Side::Right)]
    }

    /// Temperatures of one contact of a wheel, by its place among the wheel's contacts; `None` where `[heat]` does not ask
    /// for them.
    #[must_use]
    pub fn heat(&self, side: Side, contact: usize) -> Option<&Heat> {
        self.heat[usize::from(side == Side::Right)].get(contact)?.0.as_ref()
    }

    /// Cautions, each with its side; of several contacts on a rough profile the most loaded one says so.
    #[must_use]
    pub fn cautions(&self) -> Vec<(Side, Caution)> {
        let mut all = cautions(&self.solved, |side| self.damage(side));
        for (side, heat) in [Side::Left, Side::Right].into_iter().zip(&self.heat) {
            // Of several contacts the first that has any says so.
            let of_heat = heat.iter().map(|(_, own)| own).find(|own| !own.is_empty());
            all.extend(of_heat.into_iter().flatten().map(|caution| (side, *caution)));
        }
        all
    }

    /// The same in words.
    #[must_use]
    pub fn caution_words(&self) -> Vec<String> {
        words(&self.cautions())
    }
}

/// Cautions of a solved wheelset, each with its side.
#[must_use]
pub fn wheelset_cautions(solved: &SolvedWheelset) -> Vec<(Side, Caution)> {
    cautions(solved, |_| &[])
}

/// The same in words.
#[must_use]
pub fn wheelset_caution_words(solved: &SolvedWheelset) -> Vec<String> {
    words(&wheelset_cautions(solved))
}

fn words(cautions: &[(Side, Caution)]) -> Vec<String> {
    let words = |(side, caution): &(Side, Caution)| match side {
        _ if matches!(caution, Caution::LargeYaw { .. }) => caution.to_string(),
        Side::Left => format!("left wheel: {caution}"),
        Side::Right => format!("right wheel: {caution}"),
    };
    cautions.iter().map(words).collect()
}

fn cautions<'a>(
    solved: &SolvedWheelset,
    damage: impl Fn(Side) -> &'a [Damage],
) -> Vec<(Side, Caution)> {
    let climbs = |wheel: &SolvedWheel| Some((wheel.side, Caution::climbs(wheel.height())?));
    let mut all: Vec<(Side, Caution)> = solved.wheels().filter_map(climbs).collect();
    let yaws = Caution::large_yaw(solved.position().yaw);
    all.extend(solved.wheels().next().zip(yaws).map(|(wheel, yaws)| (wheel.side, yaws)));
    for wheel in solved.wheels() {
        let missed = Caution::load_missed(wheel.on_rail().force[2], wheel.missed_load);
        all.extend(missed.map(|missed| (wheel.side, missed)));
        let approaches = wheel.contacts().iter().map(|contact| contact.normal.approach().value);
        let load = wheel.contacts().iter().map(SolvedContact::load).sum();
        let shallow = Caution::shallow(approaches.fold(0.0, f64::max), load);
        all.extend(shallow.map(|shallow| (wheel.side, shallow)));
        let clearance = wheel.guard_clearance.filter(|clearance| *clearance > 0.0);
        all.extend(clearance.map(|clearance| (wheel.side, Caution::GuardApart { clearance })));
        for (k, contact) in wheel.contacts().iter().enumerate() {
            for caution in of_contact(contact, damage(wheel.side).get(k)) {
                if !all.iter().any(|(known, said)| *known == wheel.side && said.says(&caution)) {
                    all.push((wheel.side, caution));
                }
            }
        }
    }
    all
}

/// Cautions of one contact.
fn of_contact(contact: &SolvedContact, damage: Option<&Damage>) -> Vec<Caution> {
    let RollingCreepage { longitudinal, lateral, spin, .. } = contact.creepage;
    let creepage = SiCreepage { longitudinal, lateral, spin };
    let kappa_over_mu = contact.normal.pair().kappa() / contact.friction;
    let status = (contact.status != Status::Solved).then_some(Caution::Status(contact.status));
    let slides = Caution::large_creepage(creepage).map(Caution::of_a_wheel);
    let peak = contact.normal.peak_pressure().value;
    let shear_yield = damage.map(|damage| peak / damage.peak_over_shear_yield);
    let yields = Caution::yields(peak, contact.normal.pair().shear_modulus(), shear_yield);
    let at_rest = contact.at_rest.map(|theory| Caution::ConstantFriction { theory });
    let SiForce { longitudinal: along, lateral: across, .. } = contact.force;
    let beyond =
        Caution::beyond_friction(along.hypot(across) / (contact.friction * contact.load()));
    let all = status
        .into_iter()
        .chain(at_rest)
        .chain(beyond)
        .chain(slides)
        .chain(Caution::large_friction(contact.friction))
        .chain(yields)
        .chain(Caution::turns(contact.turn))
        .chain(contact.varying.filter(|ends| ends.is_cut).map(|_| Caution::CutPatch))
        .chain(contact.varying.filter(|ends| ends.is_beyond).map(|_| Caution::BeyondSlices));
    let all = all.chain(Caution::deep(&contact.normal));
    let all =
        all.chain(Caution::like_bodies(kappa_over_mu)).chain(Caution::of_areas(&contact.normal));
    // Its points across are as many as are looked up.
    let all = all.filter(|caution| !matches!(caution, Caution::CoarseGap { .. }));
    all.chain(contact.rough.iter().map(|rough| Caution::from(*rough)))
        .chain(contact.unmeasured.iter().map(|stretch| Caution::from(*stretch)))
        .collect()
}

impl From<Unmeasured> for Caution {
    fn from(Unmeasured { body, length }: Unmeasured) -> Self {
        Self::Unmeasured { body, length }
    }
}

impl From<Roughness> for Caution {
    fn from(Roughness { body, length, swing, pressure }: Roughness) -> Self {
        Self::Rough { body, length, swing, pressure }
    }
}

impl WheelsetCase {
    /// What is odd about a conicity: wheels that stand on their flanges in the middle of the track or `amplitude` (m) to
    /// either side, and profiles that are rough or not measured where wheel and rail touch, as of [`rough_profiles`] and
    /// [`unmeasured_profiles`]; in steel where no materials are given. `rolls` as for [`WheelsetCase::radius_difference`].
    #[must_use]
    pub fn conicity_cautions(
        &self,
        difference: &RadiusDifference,
        rolls: bool,
        amplitude: f64,
    ) -> Vec<(Side, Caution)> {
        let climbs = |side| {
            [0.0, -amplitude, amplitude].into_iter().find_map(|y| {
                let touch = self.running.touch(side, y, 0.0, 0.0).ok()?;
                Some((side, Caution::climbs(-touch.z)?))
            })
        };
        let sides = [Side::Left, Side::Right];
        let mut all: Vec<_> = sides.into_iter().filter_map(climbs).collect();
        let guarded =
            sides.into_iter().filter(|side| self.running.track().rail(*side).guard().is_some());
        all.extend(guarded.map(|side| (side, Caution::NoGuard)));
        let steel = || Solid::new(82e9, 0.28).map(|solid| SolidPair::new(solid, solid));
        let unmeasured = unmeasured_profiles(&self.running, difference, rolls);
        all.extend(unmeasured.into_iter().map(|(side, stretch)| (side, stretch.into())));
        let Some(pair) = self.solids.or_else(|| steel().ok()) else { return all };
        let rough = rough_profiles(&self.running, &pair, difference, rolls);
        all.extend(rough.into_iter().map(|(side, rough)| (side, rough.into())));
        all
    }

    /// The same in words.
    #[must_use]
    pub fn conicity_caution_words(
        &self,
        difference: &RadiusDifference,
        rolls: bool,
        amplitude: f64,
    ) -> Vec<String> {
        words(&self.conicity_cautions(difference, rolls, amplitude))
    }
}
