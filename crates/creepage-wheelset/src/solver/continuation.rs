//! Continuation from a solved position: a coarse grid, corrected by what a fine one added there.

use std::sync::Arc;

use creepage::Status;
use creepage::coulomb::{Resolution, hidden_by_border};

use super::WheelsetSolver;
use super::equilibrium::settle;
use super::normal_contact::{PressedContact, PressedWheel};
use super::predictor::nearest;
use super::tangential::{Method, Rolled, Rolling, TractionWarmStart};
use crate::correction::{Correction, difference};
use crate::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::warm_start::PredictorCorrection;
use crate::{WheelsetError, WheelsetPose, WheelsetVelocity};
use creepage::theory::AreaTheory;

const COARSE: Method = Method::Exact(Resolution::COARSE);
/// Shift (m) and yaw (rad) of a step that is followed: over longer ones friction changes too much.
const MAX_FOLLOWED_STEP: [f64; 2] = [2.001e-5, 2.001e-4];

impl<'a> WheelsetSolver<'a> {
    /// As [`WheelsetSolver::next`], quicker along walks in steps up to 20 um and 0.2 mrad.
    ///
    /// The full theory on a coarse grid, corrected by what a fine one added at a position before, which changes
    /// slowly. Error bars grow by what it may have changed since, and by what those of the fine grid leave out because
    /// that finds the border of adhesion; where the first, with a twentieth of the bar, is half of the larger one, or the
    /// step is longer, the fine grid is solved as by [`WheelsetSolver::next`]. Forces differ from those by a twentieth of
    /// these bars in the median, by less than half in 99 of 100 positions; heat, which has
    /// no error bar, by some thousandths. [`SolvedContact::elements`] are those of the coarse grid.
    ///
    /// ```
    /// # use creepage::theory::{AreaTheory, ExactOptions};
    /// # use creepage::{Solid, SolidPair};
    /// # use creepage_rail::{Place, Standard, Track, Wheelset};
    /// # use creepage_wheelset::{Load, RailFriction, WheelsetPose, WheelsetSolver, WheelsetVelocity};
    /// # let place = Place::gauge(1.435, 0.014);
    /// # let track = Track::new(&Standard::Uic60.profile(), 0.025f64.atan(), place)?;
    /// # let running = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.360)?.on(track);
    /// # let steel = Solid::new(82e9, 0.28)?;
    /// # let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
    /// # let theory = AreaTheory::Exact(ExactOptions::default());
    /// # let solver = WheelsetSolver::new(&running, SolidPair::new(steel, steel), friction, theory)?;
    /// let load = Some(Load::Axle(200e3));
    /// let pose = WheelsetPose { side: None, y: 0.001, yaw: 0.0, roll: None, load };
    /// let velocity = WheelsetVelocity { speed: 30.0, ..WheelsetVelocity::default() };
    /// let mut solved = solver.solve(&pose, &velocity)?;
    /// for step in 1..5 {
    ///     let pose = WheelsetPose { y: 0.001 + 1e-5 * f64::from(step), ..pose };
    ///     solved = solver.follow(&solved, &pose, &velocity)?;
    /// }
    /// let carried: f64 = solved.wheels().map(|wheel| wheel.on_rail().force[2]).sum();
    /// assert!((carried - 200e3).abs() < 20.0); // newtons
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`WheelsetSolver::solve`].
    pub fn follow(
        &self,
        before: &SolvedWheelset,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
    ) -> Result<SolvedWheelset, WheelsetError> {
        if travel.is_backward() || before.is_reversed {
            return self.next(before, stance, travel);
        }
        match self.followed(before, stance, travel) {
            Some(solved) => Ok(solved),
            None => self.next(before, stance, travel),
        }
    }

    /// `None` where that fails or is too uncertain.
    fn followed(
        &self,
        before: &SolvedWheelset,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
    ) -> Option<SolvedWheelset> {
        let contacts = || before.wheels().flat_map(SolvedWheel::contacts);
        let (from, to) = (before.shift_and_yaw(), [stance.y, stance.yaw]);
        let is_near = (0..2).all(|k| (to[k] - from[k]).abs() < MAX_FOLLOWED_STEP[k]);
        let will_hold = |own: &SolvedContact| {
            own.correction.as_ref().is_none_or(|correction| {
                correction.holds(&own.solution, correction.times(from, to, MAX_FOLLOWED_STEP))
            })
        };
        if !matches!(self.theory, AreaTheory::Exact(_)) || !is_near || !contacts().all(will_hold) {
            return None;
        }
        let (mut start, expected) = match self.beside(before, stance) {
            Some((start, expected)) => (start, Some(expected)),
            None => (self.far_from(before), None),
        };
        let known: Option<Vec<_>> = contacts().map(TractionWarmStart::of_coarse_grid).collect();
        start.friction = known.or_else(|| self.corrections(before))?;
        let mut solved = settle(self, stance, travel, start, COARSE).ok()?;
        let is_accurate = self.rolling.len() == 1 || solved.worst_error() <= self.accuracy;
        if !is_accurate || !solved.wheels().flat_map(SolvedWheel::contacts).all(holds) {
            return None;
        }
        solved.drift =
            expected.map(|expected| PredictorCorrection::new(&expected, before, &solved, stance));
        Some(solved)
    }

    /// Friction by the coarse grid where the fine one was solved, with what that adds.
    fn corrections(&self, before: &SolvedWheelset) -> Option<Vec<TractionWarmStart>> {
        let wheels = before.wheels().map(|wheel| self.as_pressed(wheel));
        let wheels: Vec<PressedWheel<'a>> = wheels.collect::<Option<_>>()?;
        let rollings = Rolling::all(&wheels, self, before.motion.speed, (COARSE, &[])).ok()?;
        let own = before.wheels().flat_map(SolvedWheel::contacts);
        let corrected = |(rolling, own): (&Rolling<'_, '_>, &SolvedContact)| {
            let wheel = before.wheels().find(|wheel| wheel.side == rolling.wheel.side)?;
            let rolled = rolling.roll(&before.motion_of(wheel), None).ok()?;
            let mut known = TractionWarmStart::of_rolled(&rolling.pressed.contact, &rolled)?;
            let correction = correction(own, before.shift_and_yaw(), &rolled, rolling.elements())?;
            known.correction = Some(Arc::new(correction));
            Some(known)
        };
        rollings.iter().zip(own).map(corrected).collect()
    }

    /// A solved wheel as it was pressed.
    fn as_pressed(&self, wheel: &SolvedWheel) -> Option<PressedWheel<'a>> {
        let SolvedWheel { side, position, .. } = *wheel;
        let running = self.press.running;
        let contacts = running.contacts_of(side, &position).ok()?;
        let pressed = |own: &SolvedContact| {
            let contact = *nearest(own, &contacts)?;
            Some(PressedContact { contact, normal: own.normal.clone() })
        };
        let contacts = wheel.contacts().iter().map(pressed).collect::<Option<_>>()?;
        let radius = running.wheelset().radius();
        Some(PressedWheel { side, position, radius, contacts })
    }
}

/// What a fine grid added to a coarse one; `None` where that has no error bars.
fn correction(
    fine: &SolvedContact,
    at: [f64; 2],
    rolled: &Rolled<'_>,
    elements: usize,
) -> Option<Correction> {
    let SolvedContact { solution, scaling, dissipation, .. } = fine;
    let coarse = rolled.solution;
    let hidden = match fine.normal.patches() {
        [_] => hidden_by_border(solution.force, fine.elements().len()),
        _ => 0.0,
    };
    Some(Correction {
        at,
        elements,
        coarse,
        force: difference(solution.force, coarse.force),
        power: (*dissipation)? / (scaling.force * scaling.slip) - rolled.power?,
        error: solution.error?,
        hidden,
        tractions: Arc::clone(fine.tractions()?),
    })
}

/// Whether a contact that was followed has as many elements as there were, and its correction holds.
fn holds(own: &SolvedContact) -> bool {
    let holds = |correction: &Arc<Correction>| {
        own.elements().len() == correction.elements && correction.holds(&own.solution, 1.0)
    };
    own.status == Status::Solved && own.correction.as_ref().is_some_and(holds)
}

impl SolvedWheelset {
    fn shift_and_yaw(&self) -> [f64; 2] {
        let position = self.position();
        [position.y, position.yaw]
    }
}
