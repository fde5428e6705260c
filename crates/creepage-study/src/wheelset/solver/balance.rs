//! The height and the roll at which the rails carry the load.
//!
//! Loads rise with the height, and a wheel's height under its load falls with the other's: every
//! unknown is the root of a rising function, found inside a bracket.

use creepage_rail::{Position, Side};
use rayon::prelude::*;

use super::pressed::{Known, Press, PressedWheel, Shares};
use super::root::Root;
use crate::{Load, Stance, WheelsetError};

/// A bracket narrower than this, of a logarithm or a roll, has nothing left to search.
const NARROW: f64 = 1e-9;
/// Depths below the height of first touch (m).
const DEPTHS: [f64; 2] = [1e-9, 0.02];
/// Roll to either side of the start (rad).
const ROLL: f64 = 0.05;
const STEPS: usize = 80;

/// To which part a load is met: pressures found by elements scatter by more than those found by
/// strips, and a search that does not end soon meets their scatter.
pub(super) fn enough(step: usize) -> f64 {
    if step < 8 { 1e-5 } else { 1e-4 }
}

/// Where a search may begin.
#[derive(Debug, Clone)]
pub(super) struct Guess {
    pub(super) roll: Option<f64>,
    /// Depths of the left and the right wheel below the height of first touch (m).
    pub(super) depths: [f64; 2],
    /// Pressures close by.
    pub(super) known: Vec<Known>,
}

impl Guess {
    /// Depths of wheels that each carry `load` on a body of the modulus `E*` and a radius: about
    /// those of Hertz.
    pub(super) fn under_load(load: f64, modulus: f64, radius: f64) -> Self {
        const FACTOR: f64 = 0.8;
        let depth = FACTOR * (load / modulus).powf(2.0 / 3.0) / radius.cbrt();
        Self { depths: [depth.clamp(DEPTHS[0], DEPTHS[1]); 2], ..Self::default() }
    }
}

impl Default for Guess {
    fn default() -> Self {
        Self { roll: None, depths: [40e-6; 2], known: Vec::new() }
    }
}

/// A wheelset that is to be put on its track.
#[derive(Debug, Clone)]
pub(super) struct Balance<'s, 'a> {
    pub(super) press: &'s Press<'a>,
    pub(super) stance: &'s Stance,
    pub(super) shares: &'s Shares,
    pub(super) guess: Guess,
}

impl<'a> Balance<'_, 'a> {
    /// The wheels that there are, in their positions.
    pub(super) fn wheels(&self, load: Load) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        const BOTH: [Side; 2] = [Side::Left, Side::Right];
        let Stance { side, roll, .. } = *self.stance;
        match (side, roll, load) {
            (Some(side), roll, Load::Height(z)) => {
                self.at(&[side], z, roll.unwrap_or(0.0), &self.guess.known)
            }
            (Some(side), roll, Load::Wheel(load) | Load::Axle(load)) => {
                self.lowered(&[side], roll.unwrap_or(0.0), load)
            }
            (None, Some(roll), Load::Height(z)) => self.at(&BOTH, z, roll, &self.guess.known),
            (None, Some(roll), Load::Axle(load)) => self.lowered(&BOTH, roll, load),
            (None, Some(roll), Load::Wheel(load)) => {
                let [left, right] = BOTH.map(|side| self.lowered(&[side], roll, load));
                Ok([left?, right?].concat())
            }
            (None, None, Load::Height(z)) => self.evened(z),
            (None, None, Load::Axle(load)) => self.level(0.5 * load),
            (None, None, Load::Wheel(load)) => self.level(load),
        }
    }

    fn at(
        &self,
        sides: &[Side],
        z: f64,
        roll: f64,
        known: &[Known],
    ) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let Stance { y, yaw, .. } = *self.stance;
        let position = Position { y, z, roll, yaw };
        sides.par_iter().map(|&side| self.press.wheel(side, position, known)).collect()
    }

    /// The height at which the first of some wheels touches.
    fn touch(&self, sides: &[Side], roll: f64) -> Result<f64, WheelsetError> {
        let Stance { y, yaw, .. } = *self.stance;
        let mut rest = f64::INFINITY;
        for &side in sides {
            let touch = self.press.running.touch(side, y, roll, yaw);
            rest = rest.min(touch.map_err(|source| WheelsetError::Position { side, source })?.z);
        }
        Ok(rest)
    }

    /// Wheels at a roll, brought down from first touch until they carry `load` together. The search
    /// goes by the logarithm of the depth, in which that of the load is nearly linear.
    fn lowered(
        &self,
        sides: &[Side],
        roll: f64,
        load: f64,
    ) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let rest = self.touch(sides, roll)?;
        let [left, right] = self.guess.depths;
        let start = if sides == [Side::Left] { left } else { right };
        let mut search = Root::new(start.ln(), DEPTHS.map(f64::ln));
        let (mut refused, mut known) = (None, self.guess.known.clone());
        for step in 0..STEPS {
            let depth = search.at.exp();
            let mut wheels = match self.at(sides, rest + depth, roll, &known) {
                Ok(wheels) => wheels,
                // Too deep for the profiles: the height, if there is one, lies above.
                Err(error @ WheelsetError::Position { .. }) => {
                    refused = Some(error);
                    search.next(f64::INFINITY, None);
                    if search.is_spent(NARROW) {
                        break;
                    }
                    continue;
                }
                Err(error) => return Err(error),
            };
            let carried: f64 = wheels.iter().map(|wheel| wheel.expected(self.shares)).sum();
            let excess = if carried > 0.0 { (carried / load).ln() } else { f64::NEG_INFINITY };
            if excess.abs() < enough(step) || (search.is_spent(NARROW) && refused.is_none()) {
                for wheel in &mut wheels {
                    wheel.depth = depth;
                }
                return Ok(wheels);
            }
            let stiffness: f64 = wheels.iter().map(|wheel| wheel.stiffness(self.shares)).sum();
            search.next(excess, Some(stiffness * depth / carried));
            known = Known::of(&wheels);
        }
        Err(refused.unwrap_or(WheelsetError::LoadNotFound { load }))
    }

    /// The roll and the height at which each wheel carries `load`: by Newton's method in both, and
    /// where that leads nowhere, one inside the other.
    fn level(&self, load: f64) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        const STEPS: usize = 20;
        let sides = [Side::Left, Side::Right];
        let mut roll = self.start_of_roll()?;
        let rest = [self.touch(&[Side::Left], roll)?, self.touch(&[Side::Right], roll)?];
        let [left, right] = self.guess.depths;
        let mut z = (rest[0] + left).midpoint(rest[1] + right);
        let mut known = self.guess.known.clone();
        for _ in 0..STEPS {
            let Ok(mut wheels) = self.at(&sides, z, roll, &known) else { break };
            let excess = self.excess(&wheels, load);
            if excess.iter().all(|one| one.abs() < enough(0)) {
                for wheel in &mut wheels {
                    wheel.depth = z - self.touch(&[wheel.side], roll)?;
                }
                return Ok(wheels);
            }
            let Some([down, turn]) = self.step(&wheels, excess) else { break };
            (z, roll) = (z + down, roll + turn);
            known = Known::of(&wheels);
        }
        self.level_by_halving(load)
    }

    /// The logarithms of what two wheels carry over `load`.
    fn excess(&self, wheels: &[PressedWheel<'_>], load: f64) -> [f64; 2] {
        let of = |wheel: Option<&PressedWheel<'_>>| {
            wheel.map_or(f64::NAN, |wheel| (wheel.expected(self.shares) / load).ln())
        };
        [of(wheels.first()), of(wheels.get(1))]
    }

    /// Newton's step in height and roll, no longer than takes the loads to a third; `None` where
    /// a wheel hangs in the air.
    fn step(&self, wheels: &[PressedWheel<'_>], excess: [f64; 2]) -> Option<[f64; 2]> {
        const LARGEST: f64 = 1.1;
        let row = |wheel: &PressedWheel<'_>| {
            let carried = wheel.expected(self.shares);
            let by = [wheel.stiffness(self.shares), wheel.stiffness_by_roll(self.shares)];
            by.map(|by| by / carried)
        };
        let [left, right] = pair(wheels)?.map(row);
        let largest = excess[0].abs().max(excess[1].abs());
        let [a, b] = excess.map(|one| -one * (LARGEST / largest).min(1.0));
        let determinant = left[0] * right[1] - left[1] * right[0];
        let step = [a * right[1] - b * left[1], b * left[0] - a * right[0]];
        let [down, turn] = step.map(|part| part / determinant);
        let usable = down.abs() < DEPTHS[1] && turn.abs() < ROLL && largest.is_finite();
        usable.then_some([down, turn])
    }

    /// The roll at which each wheel carries `load` at one height.
    fn level_by_halving(&self, load: f64) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let start = self.start_of_roll()?;
        let mut search = Root::new(start, [start - ROLL, start + ROLL]);
        let mut balance = self.clone();
        for step in 0..STEPS {
            let [left, right] =
                [Side::Left, Side::Right].map(|side| balance.lowered(&[side], search.at, load));
            let wheels = [left?, right?].concat();
            let Some([left, right]) = pair(&wheels) else { break };
            balance.guess.depths = [left.depth, right.depth];
            balance.guess.known = Known::of(&wheels);
            let tilt = left.position.z - right.position.z;
            let depth = left.depth.min(right.depth);
            if tilt.abs() < enough(step) * depth || search.is_spent(NARROW * depth) {
                return Ok(wheels);
            }
            let lever = |wheel: &PressedWheel<'_>| {
                wheel.stiffness_by_roll(self.shares) / wheel.stiffness(self.shares)
            };
            search.next(tilt, Some(lever(right) - lever(left)));
        }
        Err(WheelsetError::LoadNotFound { load })
    }

    /// The roll at which both wheels carry the same at a height.
    fn evened(&self, z: f64) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let start = self.start_of_roll()?;
        let mut search = Root::new(start, [start - ROLL, start + ROLL]);
        let mut known = self.guess.known.clone();
        for step in 0..STEPS {
            let wheels = self.at(&[Side::Left, Side::Right], z, search.at, &known)?;
            known = Known::of(&wheels);
            let Some([left, right]) = pair(&wheels) else { break };
            let [low, high] = [left, right].map(|wheel| wheel.expected(self.shares));
            let (excess, sum) = (high - low, high + low);
            if excess.abs() <= enough(step) * sum || search.is_spent(1e-13) {
                return Ok(wheels);
            }
            let [fall, rise] = [left, right].map(|wheel| wheel.stiffness_by_roll(self.shares));
            let slope = rise - fall;
            search.next(excess, Some(slope));
        }
        Err(WheelsetError::RollNotFound { z })
    }

    /// The roll at which both wheels touch.
    fn start_of_roll(&self) -> Result<f64, WheelsetError> {
        let Stance { y, yaw, .. } = *self.stance;
        if let Some(roll) = self.guess.roll {
            return Ok(roll);
        }
        let resting = self.press.running.resting(y, yaw, None);
        Ok(resting.map_err(WheelsetError::Resting)?.roll)
    }
}

fn pair<'w, 'a>(wheels: &'w [PressedWheel<'a>]) -> Option<[&'w PressedWheel<'a>; 2]> {
    match wheels {
        [left, right] => Some([left, right]),
        _ => None,
    }
}
