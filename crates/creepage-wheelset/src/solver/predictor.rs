//! Predictor of the pose beside a solved position: by the undeformed bodies, before anything is pressed.

use creepage_rail::{Contact, Position, Side, WheelsetOnTrack};

use super::normal_contact::{PatchWarmStart, roll_lever};
use super::start::{Place, Start};
use super::vertical_load::{LoadLine, Target};
use crate::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::tilt::{Placed, distance};
use crate::warm_start::{LateralForceRatios, PredictorCorrection};
use crate::{Load, WheelsetPose};

/// Shift (m) and yaw (rad) by which a position is near.
const MAX_PREDICTED_STEP: [f64; 2] = [1.001e-4, 1.001e-3];

/// The places of wheels that were solved nearby, and what they should carry; `None` where they were
/// farther off, or nothing is to be sought.
pub(crate) fn places(
    before: &SolvedWheelset,
    stance: &WheelsetPose,
    running: &WheelsetOnTrack,
    target: &Target,
) -> Option<Vec<Place>> {
    if *target == Target::Nothing {
        return None;
    }
    let sides: &[Side] = match &stance.side {
        Some(side) => std::slice::from_ref(side),
        None => &[Side::Left, Side::Right],
    };
    let wheels: Vec<&SolvedWheel> = before.wheels().collect();
    let is_same = wheels.iter().map(|wheel| &wheel.side).eq(sides);
    if !is_same || !wheels.iter().all(|wheel| is_near(wheel.position, stance)) {
        return None;
    }
    let place = |wheel: &&SolvedWheel| Place {
        expected: Some(wheel.line),
        ..Place::new(wheel.side, shifted(wheel.position, stance))
    };
    let mut places: Vec<Place> = wheels.iter().map(place).collect();
    let lines = wheels.iter().zip(&places).map(|(wheel, place)| line(wheel, place, running));
    if let Some(lines) = lines.collect::<Option<Vec<_>>>()
        && let Some(moves) = target.step(&lines)
    {
        for (place, [down, turn]) in places.iter_mut().zip(moves) {
            place.position.z += down;
            place.position.roll += turn;
        }
    }
    Some(places)
}

fn is_near(position: Position, stance: &WheelsetPose) -> bool {
    let shift = [stance.y - position.y, stance.yaw - position.yaw].map(f64::abs);
    shift[0] < MAX_PREDICTED_STEP[0] && shift[1] < MAX_PREDICTED_STEP[1]
}

fn given_roll(stance: &WheelsetPose) -> Option<f64> {
    stance.roll.or(stance.side.map(|_| 0.0))
}

/// A wheel's position carried along to another shift and yaw.
fn shifted(Position { z, roll, .. }: Position, stance: &WheelsetPose) -> Position {
    let z = if let Some(Load::Height(z)) = stance.load { z } else { z };
    Position { y: stance.y, z, roll: given_roll(stance).unwrap_or(roll), yaw: stance.yaw }
}

fn vertical(wheel: &SolvedWheel) -> f64 {
    wheel.contacts().iter().map(|own| own.load() * own.tilt().vertical_ratio(share(own))).sum()
}

/// Lateral and longitudinal force over load.
pub(crate) fn share(own: &SolvedContact) -> [f64; 2] {
    [own.force.lateral, own.force.longitudinal].map(|force| force / own.load())
}

impl PatchWarmStart {
    /// Those of a solved position.
    pub(crate) fn solved(solved: &SolvedWheelset) -> Vec<Self> {
        let contacts = solved.wheels().flat_map(SolvedWheel::contacts);
        contacts.map(|own| Self::new(own.side, own.spot(), &own.normal)).collect()
    }
}

impl LateralForceRatios {
    /// Those of a solved position.
    pub(crate) fn solved(solved: &SolvedWheelset) -> Self {
        let mut shares = Self::default();
        for contact in solved.wheels().flat_map(SolvedWheel::contacts) {
            shares.push(contact.side, contact.spot(), share(contact));
        }
        shares
    }
}

/// What a wheel carries in its new place by the stiffness of its contacts and how much nearer the
/// undeformed bodies are there; `None` where they touch in more or fewer places.
fn line(wheel: &SolvedWheel, place: &Place, running: &WheelsetOnTrack) -> Option<(Side, LoadLine)> {
    let contacts = running.contacts_of(wheel.side, &place.position).ok()?;
    let Position { y, z, .. } = place.position;
    let centre = [y, z - running.wheelset().radius()];
    let (mut force, mut by) = (vertical(wheel), [0.0; 2]);
    for own in wheel.contacts() {
        let contact = nearest(own, &contacts)?;
        let nearer = contact.approach - own.normal.approach().value;
        let stiffness = own.normal.stiffness() * contact.tilt().vertical_ratio(share(own));
        force += stiffness * nearer;
        by[0] += stiffness * contact.tilt().down()[2];
        by[1] += stiffness * roll_lever(contact, centre);
    }
    let is_alike = contacts.len() == wheel.contacts().len() && force > 0.0;
    is_alike.then(|| (wheel.side, LoadLine::of_force(force, by)))
}

pub(crate) fn nearest<'c, 'a>(
    own: &SolvedContact,
    contacts: &'c [Contact<'a>],
) -> Option<&'c Contact<'a>> {
    let distance = |contact: &Contact<'_>| distance(contact.spot(), own.spot());
    contacts.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

impl PredictorCorrection {
    /// From where wheels were expected on a step; what they still lack of their load is made up for.
    pub(crate) fn new(
        expected: &[Position],
        before: &SolvedWheelset,
        solved: &SolvedWheelset,
        stance: &WheelsetPose,
    ) -> Self {
        let lines: Vec<_> = solved.wheels().map(|wheel| (wheel.side, wheel.line)).collect();
        let levers = solved.levers(solved.radius).unwrap_or_default();
        let last = Target::new(stance, levers).ok().and_then(|target| target.step(&lines));
        let last = last.unwrap_or_else(|| vec![[0.0; 2]; expected.len()]);
        let drift = |((from, wheel), [down, turn]): ((&Position, &SolvedWheel), [f64; 2])| {
            let to = wheel.position;
            [to.z + down - from.z, to.roll + turn - from.roll]
        };
        let by = expected.iter().zip(solved.wheels()).zip(last).map(drift).collect();
        let faster = [0, 1].map(|k: usize| {
            let rates = solved.pitch[k].rate.zip(before.pitch[k].rate);
            rates.map_or(0.0, |(to, from)| to - from)
        });
        let (mut shares, known) =
            (LateralForceRatios::solved(solved), LateralForceRatios::solved(before));
        shares.add_times(-1.0, &known);
        let step = step(before, [stance.y, stance.yaw]);
        Self { step, by, faster, shares, sides: sides_beyond(before, solved) }
    }

    /// How many times this step another one is; `None` where it is much longer or goes another way.
    pub(crate) fn times(&self, before: &SolvedWheelset, stance: &WheelsetPose) -> Option<f64> {
        const LONGEST: f64 = 2.0;
        const ASIDE: f64 = 0.1;
        let ([a, b], [c, d]) = (self.step, step(before, [stance.y, stance.yaw]));
        let square = a * a + b * b;
        let [times, aside] = [a * c + b * d, a * d - b * c].map(|product| product / square);
        (times.abs() < LONGEST && aside.abs() < ASIDE).then_some(times)
    }

    /// Corrects what is expected of a step so many times this one.
    pub(in crate::solver) fn correct(&self, start: &mut Start, times: f64, stance: &WheelsetPose) {
        let is_free = [!matches!(stance.load, Some(Load::Height(_))), given_roll(stance).is_none()];
        let [down, turn] = is_free.map(|is_free| if is_free { times } else { 0.0 });
        for (place, by) in start.places.iter_mut().flatten().zip(&self.by) {
            place.position.z += down * by[0];
            place.position.roll += turn * by[1];
        }
        for (pitch, faster) in start.pitch.iter_mut().zip(self.faster) {
            pitch.rate = pitch.rate.map(|rate| rate + times * faster);
        }
        start.shares.add_times(times, &self.shares);
        for (known, beyond) in start.pressures.iter_mut().zip(&self.sides) {
            known.drift(beyond, times);
        }
    }
}

/// By how much the areas of each contact reach further out (m) than from those before was to be expected;
/// nothing where these were others.
fn sides_beyond(before: &SolvedWheelset, solved: &SolvedWheelset) -> Vec<Vec<[f64; 2]>> {
    let known = PatchWarmStart::solved(before);
    let beyond = |own: &SolvedContact| {
        own.normal.sides_beyond(PatchWarmStart::next_to(own.side, own.spot(), &known)?)
    };
    let contacts = solved.wheels().flat_map(SolvedWheel::contacts);
    contacts.map(|own| beyond(own).unwrap_or_default()).collect()
}

/// The step to a shift and a yaw, over what is near.
fn step(before: &SolvedWheelset, [y, yaw]: [f64; 2]) -> [f64; 2] {
    let from = before.position();
    [(y - from.y) / MAX_PREDICTED_STEP[0], (yaw - from.yaw) / MAX_PREDICTED_STEP[1]]
}
