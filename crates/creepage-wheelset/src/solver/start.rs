//! Start of the search for equilibrium: from nothing, or from a position that was solved.

use creepage_rail::{Position, Side};

use super::WheelsetSolver;
use super::normal_contact::{PatchWarmStart, PressedWheel};
use super::tangential::{Rolled, TractionWarmStart};
use super::vertical_load::{LoadLine, Target};
use crate::resultant::ContactForces;
use crate::solved::{SolvedWheel, SolvedWheelset};
use crate::tilt::Placed;
use crate::warm_start::{LateralForceRatios, PitchState};
use crate::{Load, WheelsetError, WheelsetPose};

/// A wheel in a position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) side: Side,
    pub(crate) position: Position,
    /// What it is expected to carry there, where the step that led here tells.
    pub(crate) expected: Option<LoadLine>,
    /// How far the step went down (m) and rolled (rad).
    pub(crate) moved: [f64; 2],
}

impl Place {
    pub(crate) fn new(side: Side, position: Position) -> Self {
        Self { side, position, expected: None, moved: [0.0; 2] }
    }

    /// Down (m) and rolled (rad) by so much, from what the wheel carries.
    pub(crate) fn stepped(&self, line: &LoadLine, moved: [f64; 2]) -> Self {
        let Position { z, roll, .. } = self.position;
        let position = Position { z: z + moved[0], roll: roll + moved[1], ..self.position };
        Self { position, expected: Some(line.after(moved)), moved, ..*self }
    }
}

/// Start of the search, and what its last evaluation tells.
#[derive(Debug, Clone, Default)]
pub(crate) struct Start {
    /// Friction over load of contacts.
    pub(crate) shares: LateralForceRatios,
    pub(crate) pitch: [PitchState; 2],
    /// Moments of the left and the right wheel about `x` through the wheelset's centre over their vertical
    /// forces (m).
    pub(crate) levers: [f64; 2],
    pub(crate) pressures: Vec<PatchWarmStart>,
    pub(crate) friction: Vec<TractionWarmStart>,
    /// Where the wheels stand nearly, beside a position that was solved.
    pub(crate) places: Option<Vec<Place>>,
    /// Roll (rad) and depths of the left and the right wheel below first touch (m) in a position farther off.
    pub(super) previous_depths: Option<(f64, [f64; 2])>,
}

/// Depths below the height of first touch (m).
const DEPTHS: [f64; 2] = [1e-9, 0.02];
/// Depth of a wheel over that of a sphere of its radius under the same load (Hertz), about.
const FACTOR: f64 = 0.8;

impl WheelsetSolver<'_> {
    /// What is known of no position at all.
    pub(crate) fn start(&self) -> Start {
        let lever = 0.5 * self.press.running.wheelset().tape_distance();
        Start { levers: [-lever, lever], ..Start::default() }
    }

    /// What a solved position tells of one farther off.
    pub(super) fn far_from(&self, before: &SolvedWheelset) -> Start {
        Start { previous_depths: self.previous_depths(before), ..self.after(before) }
    }

    /// What a solved position tells of one beside it.
    pub(super) fn after(&self, before: &SolvedWheelset) -> Start {
        let radius = self.press.running.wheelset().radius();
        let contacts = before.wheels().flat_map(SolvedWheel::contacts);
        Start {
            shares: LateralForceRatios::solved(before),
            pitch: before.pitch,
            levers: before.levers(radius).unwrap_or(self.start().levers),
            pressures: PatchWarmStart::solved(before),
            friction: contacts.filter_map(TractionWarmStart::of_fine_grid).collect(),
            places: None,
            previous_depths: None,
        }
    }

    /// Roll and depths of a solved position.
    fn previous_depths(&self, before: &SolvedWheelset) -> Option<(f64, [f64; 2])> {
        let mut depths = [FIRST_DEPTH; 2];
        let mut previous_depths = None;
        for wheel in before.wheels() {
            let Position { y, z, roll, yaw } = wheel.position;
            let touch = self.press.running.first_touch(wheel.side, y, roll, yaw).ok()?;
            depths[usize::from(wheel.side == Side::Right)] =
                (z - touch).clamp(DEPTHS[0], DEPTHS[1]);
            previous_depths = Some((roll, depths));
        }
        previous_depths
    }

    /// Slope of a load to the power 2/3 by the depth (N^(2/3)/m), about that of Hertz.
    pub(super) fn hertzian_slope(&self) -> f64 {
        let pair = self.press.pair;
        let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
        let radius = self.press.running.wheelset().radius();
        modulus.cbrt().powi(2) * radius.cbrt() / FACTOR
    }

    /// Wheels that nearly carry what is asked for: so deep below first touch as Hertz has it, or as they stood
    /// before; `part` of that.
    pub(super) fn first_places(
        &self,
        stance: &WheelsetPose,
        target: &Target,
        start: &Start,
        part: f64,
    ) -> Result<Vec<Place>, WheelsetError> {
        let running = self.press.running;
        let sides: &[Side] = match &stance.side {
            Some(side) => std::slice::from_ref(side),
            None => &[Side::Left, Side::Right],
        };
        let WheelsetPose { y, yaw, .. } = *stance;
        let given = stance.roll.or(stance.side.map(|_| 0.0));
        let roll = match given.or(start.previous_depths.map(|(roll, _)| roll)) {
            Some(roll) => roll,
            None => running.resting(y, yaw, None).map_err(WheelsetError::Resting)?.roll,
        };
        let at = |z: f64| {
            let place = |&side: &Side| Place::new(side, Position { y, z, roll, yaw });
            sides.iter().map(place).collect::<Vec<_>>()
        };
        if let Some(Load::Height(z)) = stance.load {
            return Ok(at(z));
        }
        let load = target.sum(sides).unwrap_or(0.0) / sides.len() as f64;
        let hertzian = load.cbrt().powi(2) / self.hertzian_slope();
        let under = |side: Side| -> Result<f64, WheelsetError> {
            let touch = running.first_touch(side, y, roll, yaw);
            let touch = touch.map_err(|source| WheelsetError::Position { side, source })?;
            let depth = match start.previous_depths {
                Some((_, depths)) => depths[usize::from(side == Side::Right)],
                None => hertzian.clamp(DEPTHS[0], DEPTHS[1]),
            };
            Ok(touch + part * depth)
        };
        let heights = sides.iter().map(|side| under(*side)).collect::<Result<Vec<_>, _>>()?;
        Ok(match target {
            // One without a load hangs at the other's height.
            Target::OwnHeights(_) => {
                let carries = sides.iter().position(|side| target.of_wheel(*side) > Some(0.0));
                let of_carrying = carries.map_or(f64::NAN, |index| heights[index]);
                let mut places = at(of_carrying);
                for (place, height) in places.iter_mut().zip(&heights) {
                    if target.of_wheel(place.side) > Some(0.0) {
                        place.position.z = *height;
                    }
                }
                places
            }
            Target::Together(_) => at(heights.iter().copied().fold(f64::INFINITY, f64::min)),
            _ => at(heights.iter().sum::<f64>() / heights.len() as f64),
        })
    }
}

/// Depth (m) of a wheel that was not solved.
const FIRST_DEPTH: f64 = 40e-6;

impl Start {
    /// What pressures and friction of an evaluation tell the next one.
    pub(super) fn evaluated(
        &mut self,
        wheels: &[PressedWheel<'_>],
        rolled: &[Rolled<'_>],
        pitch: [PitchState; 2],
    ) {
        self.shares = ratios(wheels, rolled);
        self.pressures = PatchWarmStart::of(wheels);
        self.friction = TractionWarmStart::of(wheels, rolled);
        self.pitch = pitch;
        self.levers = levers(wheels, rolled).unwrap_or(self.levers);
    }
}

/// Lateral and longitudinal force over load of contacts that rolled.
pub(super) fn ratios(wheels: &[PressedWheel<'_>], rolled: &[Rolled<'_>]) -> LateralForceRatios {
    let mut shares = LateralForceRatios::default();
    for (one, rolled) in wheels.iter().flat_map(|wheel| &wheel.contacts).zip(rolled) {
        let friction = [rolled.force.lateral, rolled.force.longitudinal];
        shares.push(one.contact.side, one.contact.spot(), friction.map(|force| force / one.load()));
    }
    shares
}

/// Moments of both wheels about `x` through the wheelset's centre over their vertical forces (m); `None` where
/// one carries nothing.
pub(super) fn levers(wheels: &[PressedWheel<'_>], rolled: &[Rolled<'_>]) -> Option<[f64; 2]> {
    let mut rolled = rolled.iter();
    let mut lever = |wheel: &PressedWheel<'_>| {
        let Position { y, z, .. } = wheel.position;
        let centre = [0.0, y, z - wheel.radius];
        let (mut moment, mut vertical) = (0.0, 0.0);
        for pressed in &wheel.contacts {
            let (contact, friction) = (&pressed.contact, rolled.next()?.force);
            let acting = ContactForces::new(friction, pressed.load(), pressed.normal.centroid());
            let (force, about) = acting.about(contact.reference, contact.tilt(), centre);
            moment += about[0];
            vertical += force[2];
        }
        (vertical > 0.0).then(|| moment / vertical)
    };
    let [left, right] = wheels else { return None };
    Some([lever(left)?, lever(right)?])
}
