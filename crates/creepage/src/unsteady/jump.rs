//! Jumps of forces and loads between two steps.

use super::history::Creep;
use super::level::Stage;
use super::motion::{Motion, Prescribed};
use super::rolling::{Rolling, RollingState};
use crate::coulomb::influence::Tractions;

/// A change of the load by more than this fraction is a jump.
const SMOOTH_LOAD: f64 = 0.05;
/// So is a change of a prescribed force by more than this part of `mu N`: the shift that it takes is
/// one of the bodies at rest, smaller ones are part of the next step.
const JUMP: f64 = 0.05;

impl Rolling {
    /// Whether motion and load go on without a jump; a prescribed force that jumps has shifted the
    /// bodies then.
    pub(super) fn continues(&mut self, motion: &Motion) -> bool {
        let RollingState { next_load, motion: last, .. } = self.travel;
        if next_load > 0.0 && self.force_jumps(motion) {
            self.shift_on(motion);
            return false;
        }
        last.is_some_and(|last| motion.continues(&last))
    }

    /// Whether the next load follows without a jump.
    pub(super) fn load_is_smooth(&self) -> bool {
        let RollingState { load, next_load, .. } = self.travel;
        (next_load - load).abs() <= SMOOTH_LOAD * load
    }

    /// Whether a force is prescribed that differs by much from the present one.
    fn force_jumps(&self, motion: &Motion) -> bool {
        let differs = |(one, present): (&Prescribed, f64)| {
            one.force().is_some_and(|force| (force - present).abs() > JUMP * self.travel.next_load)
        };
        motion.components().iter().zip(self.travel.force).any(differs)
    }

    /// Shifts the bodies, without rolling, until the prescribed forces are met: what happens before
    /// the next step begins. Where friction under the present load cannot give them, they are met in
    /// that step, in which the load grows.
    pub(super) fn shift_on(&mut self, motion: &Motion) {
        let is_nothing = motion.force() == 0.0 && self.is_at_rest();
        if is_nothing || motion.nearly_slides(self.travel.load) {
            return;
        }
        let (before, stage) = (self.keep(), Stage::Shift { begins: self.is_at_rest() });
        if self.solve(stage, &motion.without_creepage()) {
            self.tracks.iter_mut().for_each(|track| track.remember(stage));
            self.tracks.iter_mut().zip(before).for_each(|(track, (_, creep))| track.creep = creep);
        } else {
            self.go_back(before);
        }
    }

    /// Whether there is no traction yet.
    pub(super) fn is_at_rest(&self) -> bool {
        self.travel.force.iter().all(|part| *part == 0.0) && self.tracks[0].past.0.len() == 1
    }

    /// The bodies touch again, without traction.
    pub(super) fn press_together(&mut self, load: f64) {
        let scale = load.cbrt();
        self.tracks.iter_mut().for_each(|track| track.begin(scale));
        self.travel.load = load;
    }

    /// The present solution of both grids.
    pub(super) fn keep(&self) -> [(Tractions, Creep); 2] {
        self.tracks.each_ref().map(|track| (track.state.traction.clone(), track.creep))
    }

    pub(super) fn go_back(&mut self, before: [(Tractions, Creep); 2]) {
        for (track, (traction, creep)) in self.tracks.iter_mut().zip(before) {
            (track.state.traction, track.creep) = (traction, creep);
        }
    }
}
