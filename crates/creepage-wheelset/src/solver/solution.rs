//! Solution of an equilibrium, as a solved wheelset keeps it.

use std::sync::Arc;

use creepage::normal::NormalContact;
use creepage_rail::{Contact, Motion, Side, WheelsetOnTrack};

use super::WheelsetSolver;
use super::normal_contact::{PressedContact, PressedWheel};
use super::pitch_rate::Turning;
use super::tangential::{Answer, Rolled, Rolling};
use super::vertical_load::LoadLine;
use crate::WheelsetVelocity;
use crate::field::{Field, March};
use crate::friction::RailFriction;
use crate::pose::PitchRate;
use crate::rough;
use crate::solved::{SolvedContact, SolvedWheel, SolvedWheelset, SurfaceLimits};

impl WheelsetSolver<'_> {
    /// Wheels in their places, with contacts that rolled.
    pub(crate) fn solved(
        &self,
        (wheels, lines): (&[PressedWheel<'_>], &[(Side, LoadLine)]),
        rollings: &[Rolling<'_, '_>],
        turning: &Turning<'_>,
        travel: &WheelsetVelocity,
    ) -> SolvedWheelset {
        let solved = |(wheel, (_, line)): (&PressedWheel<'_>, &(Side, LoadLine))| {
            let all = rollings.iter().zip(&turning.rolled);
            let own = all.filter(|(rolling, _)| rolling.wheel.side == wheel.side);
            let contacts = own.map(|(one, rolled)| SolvedContact::new(one.pressed, rolled));
            let motion = turning.motions[usize::from(wheel.side == Side::Right)];
            let contacts = contacts.collect();
            SolvedWheel::new(wheel, (*line, motion.pitch_rate), self.press.running, contacts)
        };
        let wheels = wheels.iter().zip(lines).map(solved).collect();
        self.whole(wheels, turning, travel)
    }

    fn whole(
        &self,
        wheels: Vec<SolvedWheel>,
        turning: &Turning<'_>,
        travel: &WheelsetVelocity,
    ) -> SolvedWheelset {
        let [on_left, on_right] = turning.motions;
        let pitch_rate = on_left.pitch_rate.midpoint(on_right.pitch_rate);
        let frictions = || self.friction.iter().chain(self.guard_friction.iter().flatten());
        let running = self.press.running;
        let mut solved = SolvedWheelset {
            left: None,
            right: None,
            motion: Motion { pitch_rate, ..on_left },
            is_independent: matches!(travel.pitch, PitchRate::Independent(_)),
            is_reversed: false,
            place: running.varies().then(|| running.place()),
            friction: frictions().map(RailFriction::largest).fold(0.0, f64::max),
            least_friction: frictions().map(RailFriction::least).fold(f64::INFINITY, f64::min),
            slip: self.slip,
            theory: self.theory,
            derivatives: None,
            radius: running.wheelset().radius(),
            pitch: turning.pitch,
            drift: None,
        };
        for wheel in wheels {
            match wheel.side {
                Side::Left => solved.left = Some(wheel),
                Side::Right => solved.right = Some(wheel),
            }
        }
        solved
    }
}

impl SolvedWheel {
    fn new(
        wheel: &PressedWheel<'_>,
        (line, pitch_rate): (LoadLine, f64),
        running: &WheelsetOnTrack,
        mut contacts: Vec<SolvedContact>,
    ) -> Self {
        let PressedWheel { side, position, .. } = *wheel;
        let [y, z] = running.track().rail(side).origin();
        contacts.sort_by(|a, b| b.load().total_cmp(&a.load()));
        let rail_origin = [0.0, side.sense() * y, z];
        let clearance = if contacts.is_empty() {
            let touch = running.touch(side, position.y, position.roll, position.yaw);
            touch.ok().map(|touch| (touch.z - position.z).max(0.0))
        } else {
            None
        };
        let guard_clearance = running.guard_clearance(side, &position).ok().flatten();
        let deflection = None;
        Self {
            side,
            position,
            pitch_rate,
            clearance,
            guard_clearance,
            deflection,
            missed_load: 0.0,
            line,
            rail_origin,
            force_error: None,
            contacts,
        }
    }
}

impl SolvedContact {
    fn new(pressed: &PressedContact<'_>, rolled: &Rolled<'_>) -> Self {
        let (contact, scaling) = (&pressed.contact, rolled.scaling);
        let solution = rolled.solution;
        let load = pressed.normal.load();
        let heat = scaling.force * scaling.slip;
        Self {
            side: contact.side,
            reference: contact.reference,
            angle: contact.angle,
            slope: contact.slope,
            varying: contact
                .varies()
                .then_some(SurfaceLimits { is_cut: contact.is_cut, is_beyond: contact.is_beyond }),
            is_on_guard: contact.is_on_guard,
            y_rail: contact.y_rail,
            y_wheel: contact.y_wheel,
            normal: pressed.normal.clone(),
            load_error: load.error,
            creepage: rolled.creepage,
            force: rolled.force,
            force_error: solution.error.map(|error| scaling.si_force(error)),
            status: solution.status,
            dissipation: rolled.power.map(|power| heat * power),
            scaling,
            solution,
            correction: rolled.correction.clone(),
            field: Field::of(rolled),
            is_reversed: false,
            friction: rolled.friction,
            at_rest: rolled.at_rest,
            turn: turn(contact, &pressed.normal),
            rough: rough::of_contact(contact, &pressed.normal),
            unmeasured: rough::unmeasured(contact, &pressed.normal),
        }
    }
}

/// By how much the rail's surface turns from one side of the pressed areas to the other (rad).
fn turn(contact: &Contact<'_>, normal: &NormalContact) -> f64 {
    let ends = normal.patches().iter().flat_map(|patch| patch.extent().y);
    let tilts = ends.filter_map(|s| Some(contact.at(s)?.tilt));
    let [low, high] = tilts.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], tilt| {
        [low.min(tilt), high.max(tilt)]
    });
    (high - low).max(0.0)
}

impl Field {
    fn of(rolled: &Rolled<'_>) -> Self {
        match &rolled.solved {
            Answer::Exact(solved) => Self::Exact(solved.elements(), Arc::new(solved.tractions())),
            Answer::Simplified(_, theory) => {
                let (theory, motion) = (Arc::clone(theory), rolled.motion.clone());
                Self::Simplified(Box::new(March { theory, motion }))
            }
        }
    }
}
