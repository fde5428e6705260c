//! A position beside one that was solved: by few elements, and what these lacked there of all elements.
//!
//! What few elements lack changes slowly as a wheelset moves, mostly by a thirtieth of what friction changes by.
//! So it is carried along until that makes friction unsure.

use std::sync::Arc;

use creepage::coulomb::{NearTractions, Resolution};
use creepage::{Force, Solution};

use super::beside::nearest;
use super::pressed::{Pressed, PressedWheel};
use super::rolled::{KnownFriction, Method, Rolled, Rolling};
use super::settle::settle;
use super::{Start, WheelsetSolver};
use crate::wheelset::nearby::Drift;
use crate::wheelset::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::{GapTheory, Stance, Travel, WheelsetError};

const FEW: Method = Method::Exact(Resolution::COARSE);
/// Shift (m) and yaw (rad) of a step that is followed: over longer ones friction changes too much.
const NEAR: [f64; 2] = [2.001e-5, 2.001e-4];
/// What few elements lack changes by no more than such parts of the changes of their friction and of its error
/// bar, in nine cases of ten (13,000 pairs of positions up to 70 um apart, of both examples at three yaws).
const OF_CHANGE: [f64; 2] = [0.05, 0.5];
/// By which part of themselves error bars may grow by that.
const UNSURE: f64 = 0.5;

/// What few elements lack of the friction on a contact, in its units.
#[derive(Debug, Clone)]
pub(in crate::wheelset) struct Lack {
    /// Shift and yaw where all elements were solved.
    at: [f64; 2],
    /// How many are few.
    elements: usize,
    /// Friction there by few elements, and how much more it is by all.
    few: Solution,
    more: Force,
    more_power: f64,
    /// Error bars by all elements, and their tractions.
    error: Force,
    pub(super) tractions: Arc<NearTractions>,
}

impl Lack {
    /// `None` for a theory without elements.
    fn new(
        own: &SolvedContact,
        at: [f64; 2],
        rolled: &Rolled<'_>,
        elements: usize,
    ) -> Option<Self> {
        let SolvedContact { solution, scaling, dissipation, .. } = own;
        let few = rolled.solution;
        Some(Self {
            at,
            elements,
            few,
            more: difference(solution.force, few.force),
            more_power: (*dissipation)? / (scaling.force * scaling.slip) - rolled.power?,
            error: solution.error?,
            tractions: Arc::clone(own.tractions()?),
        })
    }

    /// Friction and its power by few elements, with what these lack.
    pub(super) fn made_up(&self, few: Solution, power: Option<f64>) -> (Solution, Option<f64>) {
        let more = self.unsure(&few);
        let error = sum(self.error, Force { fx: more, fy: more, mz: more });
        let all = Solution { force: sum(few.force, self.more), error: Some(error), ..few };
        (all, power.map(|power| power + self.more_power))
    }

    /// What friction may be off by that few elements have changed to this.
    fn unsure(&self, few: &Solution) -> f64 {
        let bars = few.error.zip(self.few.error);
        let changes = [
            difference(few.force, self.few.force),
            bars.map_or(Force::default(), |(here, there)| difference(here, there)),
        ];
        changes.iter().zip(OF_CHANGE).map(|(change, part)| part * change.fx.hypot(change.fy)).sum()
    }

    /// Whether friction that was made up is sure enough, or would be if it were unsure so many times as much.
    fn is_sure(&self, own: &SolvedContact, times: f64) -> bool {
        let Force { fx, fy, .. } = self.error;
        let grown = own.solution.error.map_or(f64::INFINITY, |error| error.fx - fx);
        times * grown <= UNSURE * fx.max(fy) && own.elements().len() == self.elements
    }

    /// How many times as far as one position another is from where all elements were solved; as far where the one
    /// is there.
    fn times(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let far = |there: [f64; 2]| {
            let [shift, yaw] = [0, 1].map(|k: usize| (there[k] - self.at[k]) / NEAR[k]);
            shift.hypot(yaw)
        };
        if far(from) > 0.0 { far(to) / far(from) } else { 1.0 }
    }
}

fn sum(a: Force, b: Force) -> Force {
    Force { fx: a.fx + b.fx, fy: a.fy + b.fy, mz: a.mz + b.mz }
}

fn difference(a: Force, b: Force) -> Force {
    Force { fx: a.fx - b.fx, fy: a.fy - b.fy, mz: a.mz - b.mz }
}

impl<'a> WheelsetSolver<'a> {
    /// As [`WheelsetSolver::next`], two to three times quicker: for walks in steps up to 20 um and 0.2 mrad.
    ///
    /// The full theory by few elements, and what these lacked of all of them at a position before, which changes
    /// slowly. Error bars grow by what it may have changed since; where that is half of them, or the step is longer,
    /// all elements are solved as by [`WheelsetSolver::next`]. Forces differ from those by a twentieth of the error
    /// bars in the median, by less than half in 98 of 100 positions; heat, which has no error bar, by some
    /// thousandths. [`SolvedContact::elements`] are the few ones.
    ///
    /// ```
    /// use creepage_study::{Stance, WheelsetFile};
    /// let case = WheelsetFile::read("
    /// wheel = { profile = 'S1002', radius = 0.46 }
    /// rail = { profile = 'UIC60', cant = 0.025 }
    /// track = { gauge = 1.435, gauge_height = 0.014 }
    /// wheelset = { back_to_back = 1.36, y = 0.001, yaw = 0.0, roll = 'free', axle_load = 200e3 }
    /// motion = { speed = 30.0, pitch_rate = 'free' }
    /// contact = { friction = 0.3 }
    /// materials = { shear_modulus = 82e9, poisson = 0.28 }
    /// ")?.case(std::path::Path::new(""))?;
    /// let (solver, travel) = (case.solver()?, case.travel.unwrap());
    /// let mut solved = solver.solve(&case.stance, &travel)?;
    /// for step in 1..5 {
    ///     let stance = Stance { y: 0.001 + 1e-5 * f64::from(step), ..case.stance };
    ///     solved = solver.follow(&solved, &stance, &travel)?;
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
        stance: &Stance,
        travel: &Travel,
    ) -> Result<SolvedWheelset, WheelsetError> {
        match self.followed(before, stance, travel) {
            Some(solved) => Ok(solved),
            None => self.next(before, stance, travel),
        }
    }

    /// `None` where that leads nowhere or is too unsure.
    fn followed(
        &self,
        before: &SolvedWheelset,
        stance: &Stance,
        travel: &Travel,
    ) -> Option<SolvedWheelset> {
        let contacts = || before.wheels().flat_map(SolvedWheel::contacts);
        let (from, to) = (before.shift_and_yaw(), [stance.y, stance.yaw]);
        let is_near = (0..2).all(|k| (to[k] - from[k]).abs() < NEAR[k]);
        let will_be_sure = |own: &SolvedContact| {
            own.lack.as_ref().is_none_or(|lack| lack.is_sure(own, lack.times(from, to)))
        };
        if !matches!(self.theory, GapTheory::Exact(_)) || !is_near || !contacts().all(will_be_sure)
        {
            return None;
        }
        let (mut start, expected) =
            self.beside(before, stance).unwrap_or_else(|| (Start::after(before), Vec::new()));
        let known: Option<Vec<_>> = contacts().map(KnownFriction::by_few).collect();
        start.friction = known.or_else(|| self.lacking(before))?;
        let mut solved = settle(self, (stance, travel, stance.load?), start, FEW).ok()?;
        let is_sure =
            |own: &SolvedContact| own.lack.as_ref().is_some_and(|lack| lack.is_sure(own, 1.0));
        let is_accurate = self.rolling.len() == 1 || solved.worst_error() <= self.accuracy;
        if !is_accurate || !solved.wheels().flat_map(SolvedWheel::contacts).all(is_sure) {
            return None;
        }
        solved.drift = Some(Drift::new(&expected, before, &solved, stance));
        Some(solved)
    }

    /// Friction by few elements where all were solved, with what they lack.
    fn lacking(&self, before: &SolvedWheelset) -> Option<Vec<KnownFriction>> {
        let wheels = before.wheels().map(|wheel| self.as_pressed(wheel));
        let wheels: Vec<PressedWheel<'a>> = wheels.collect::<Option<_>>()?;
        let rollings = Rolling::all(&wheels, self.friction, self.slip, (FEW, &[])).ok()?;
        let own = before.wheels().flat_map(SolvedWheel::contacts);
        let lacking = |(rolling, own): (&Rolling<'_, '_>, &SolvedContact)| {
            let rolled = rolling.roll(&before.motion, None).ok()?;
            let mut known = KnownFriction::of_rolled(&rolling.pressed.contact, &rolled)?;
            let lack = Lack::new(own, before.shift_and_yaw(), &rolled, rolling.elements())?;
            known.lack = Some(Arc::new(lack));
            Some(known)
        };
        rollings.iter().zip(own).map(lacking).collect()
    }

    /// A solved wheel as it was pressed.
    fn as_pressed(&self, wheel: &SolvedWheel) -> Option<PressedWheel<'a>> {
        let SolvedWheel { side, position, depth, .. } = *wheel;
        let running = self.press.running;
        let contacts = running.contacts_of(side, &position).ok()?;
        let pressed = |own: &SolvedContact| {
            let contact = *nearest(own, &contacts)?;
            Some(Pressed { contact, normal: own.normal.clone() })
        };
        let contacts = wheel.contacts().iter().map(pressed).collect::<Option<_>>()?;
        let radius = running.wheelset().radius();
        Some(PressedWheel { side, position, radius, depth, contacts })
    }
}

impl SolvedWheelset {
    fn shift_and_yaw(&self) -> [f64; 2] {
        let position = self.position();
        [position.y, position.yaw]
    }
}
