//! The height and the roll at which the rails carry the load.
//!
//! Loads rise with the height, and a wheel's height under its load falls with the other's: every
//! unknown is the root of a rising function, found inside a bracket.

use creepage_rail::{Position, Side};
use rayon::prelude::*;

use super::bracketed_root::Root;
use super::normal_contact::{NormalSolver, PatchWarmStart, PressedWheel};
use super::step::{BroydenPolicy, learnt};
use crate::warm_start::LateralForceRatios;
use crate::{Load, WheelsetError, WheelsetPose};

/// A bracket narrower than this, of a logarithm or a roll, has nothing left to search.
const NARROW: f64 = 1e-9;
/// Depths below the height of first touch (m).
const DEPTHS: [f64; 2] = [1e-9, 0.02];
/// Roll to either side of the start (rad).
const ROLL: f64 = 0.05;
const STEPS: usize = 80;

/// To which part a load is met: pressures found by elements scatter by more than those found by
/// strips, and a search that does not end soon meets their scatter.
pub(crate) fn load_tolerance(step: usize) -> f64 {
    if step < 8 { 1e-5 } else { 1e-4 }
}

/// Where a search may begin.
#[derive(Debug, Clone)]
pub(crate) struct Guess {
    pub(crate) roll: Option<f64>,
    /// Depths of the left and the right wheel below the height of first touch (m).
    pub(crate) depths: [f64; 2],
    /// Pressures close by.
    pub(crate) known: Vec<PatchWarmStart>,
}

impl Guess {
    /// Depths of wheels that each carry `load` on a body of the modulus `E*` and a radius: about
    /// those of Hertz.
    pub(crate) fn under_load(load: f64, modulus: f64, radius: f64) -> Self {
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
pub(crate) struct Balance<'s, 'a> {
    pub(crate) press: &'s NormalSolver<'a>,
    pub(crate) stance: &'s WheelsetPose,
    pub(crate) shares: &'s LateralForceRatios,
    pub(crate) guess: Guess,
}

impl<'a> Balance<'_, 'a> {
    /// The wheels that there are, in their positions.
    pub(crate) fn wheels(&self, load: Load) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        const BOTH: [Side; 2] = [Side::Left, Side::Right];
        let WheelsetPose { side, roll, .. } = *self.stance;
        match (side, roll, load) {
            (Some(side), roll, Load::Height(z)) => {
                self.at(&[side], z, roll.unwrap_or(0.0), &self.guess.known)
            }
            (Some(side), roll, load) => {
                let load = match load {
                    Load::Wheel(load) | Load::Axle(load) | Load::Loaded { load, .. } => load,
                    other => other.of_wheel(side).ok_or(WheelsetError::NoLoad)?,
                };
                self.lowered(&[side], roll.unwrap_or(0.0), load)
            }
            (None, Some(roll), Load::Height(z)) => self.at(&BOTH, z, roll, &self.guess.known),
            (None, Some(roll), Load::Axle(load) | Load::Loaded { load, .. }) => {
                self.lowered(&BOTH, roll, load)
            }
            (None, Some(roll), Load::Wheel(load)) => self.each(roll, [load; 2]),
            (None, Some(roll), Load::Wheels(loads)) => self.each(roll, loads),
            (None, None, Load::Height(z)) => self.evened(z),
            (None, None, Load::Axle(load) | Load::Loaded { load, .. }) => {
                self.level([0.5 * load; 2])
            }
            (None, None, Load::Wheel(load)) => self.level([load; 2]),
            (None, None, Load::Wheels(loads)) => {
                let mut sides = BOTH.into_iter().zip(loads);
                match sides.find(|(_, load)| *load <= 0.0) {
                    Some((side, _)) => Err(WheelsetError::Hangs { side }),
                    None => self.level(loads),
                }
            }
        }
    }

    /// Each wheel brought down by itself until it carries its load; one without a load hangs on the axle at the
    /// other's height.
    fn each(&self, roll: f64, loads: [f64; 2]) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let [left, right] = [(Side::Left, loads[0]), (Side::Right, loads[1])];
        let lowered = |(side, load): (Side, f64)| self.lowered(&[side], roll, load);
        if left.1 > 0.0 && right.1 > 0.0 {
            return Ok([lowered(left)?, lowered(right)?].concat());
        }
        let (hangs, carries) = if left.1 > 0.0 { (right, left) } else { (left, right) };
        let loaded = lowered(carries)?;
        let z = loaded.first().map_or(0.0, |wheel| wheel.position.z);
        if z > self.touch(&[hangs.0], roll)? {
            return Err(WheelsetError::Sinks { side: hangs.0 });
        }
        let lifted = self.at(&[hangs.0], z, roll, &self.guess.known)?;
        let in_order = if hangs.0 == Side::Left { [lifted, loaded] } else { [loaded, lifted] };
        Ok(in_order.concat())
    }

    fn at(
        &self,
        sides: &[Side],
        z: f64,
        roll: f64,
        known: &[PatchWarmStart],
    ) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let WheelsetPose { y, yaw, .. } = *self.stance;
        let position = Position { y, z, roll, yaw };
        sides.par_iter().map(|&side| self.press.wheel(side, position, known)).collect()
    }

    /// The height at which the first of some wheels touches.
    fn touch(&self, sides: &[Side], roll: f64) -> Result<f64, WheelsetError> {
        let WheelsetPose { y, yaw, .. } = *self.stance;
        let mut rest = f64::INFINITY;
        for &side in sides {
            let touch = self.press.running.first_touch(side, y, roll, yaw);
            rest = rest.min(touch.map_err(|source| WheelsetError::Position { side, source })?);
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
            if excess.abs() < load_tolerance(step) || (search.is_spent(NARROW) && refused.is_none())
            {
                for wheel in &mut wheels {
                    wheel.depth = depth;
                }
                return Ok(wheels);
            }
            let stiffness: f64 = wheels.iter().map(|wheel| wheel.stiffness(self.shares)).sum();
            search.next(excess, Some(stiffness * depth / carried));
            known = PatchWarmStart::of(&wheels);
        }
        Err(refused.unwrap_or(WheelsetError::LoadNotFound { load }))
    }

    /// To which part both loads are met by coarse pressures: these err by the least of that, and fine ones go on
    /// from there. Where they scatter by more, a few steps find that out; friction that is not known yet is worth
    /// more.
    fn coarse_tolerance(&self, step: usize) -> f64 {
        if self.shares.is_empty() {
            2e-2
        } else if step < 6 {
            1e-3
        } else {
            5e-3
        }
    }

    /// The roll and the height at which each wheel carries its load: by steps in both, and where those
    /// stagnate, one inside the other.
    fn level(&self, load: [f64; 2]) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        const STEPS: usize = 20;
        let sides = [Side::Left, Side::Right];
        let mut roll = self.start_of_roll()?;
        let rest = [self.touch(&[Side::Left], roll)?, self.touch(&[Side::Right], roll)?];
        let [left, right] = self.guess.depths;
        let mut z = (rest[0] + left).midpoint(rest[1] + right);
        let (mut known, mut last) = (self.guess.known.clone(), None);
        for step in 0..STEPS {
            let Ok(mut wheels) = self.at(&sides, z, roll, &known) else { break };
            let Some(here) = self.lines(&wheels, load, last) else { break };
            if here.iter().all(|line| line.excess.abs() < self.coarse_tolerance(step)) {
                for wheel in &mut wheels {
                    wheel.depth = z - self.touch(&[wheel.side], roll)?;
                }
                return Ok(wheels);
            }
            let Some([down, turn]) = moves(&here) else { break };
            (z, roll) = (z + down, roll + turn);
            (known, last) = (PatchWarmStart::of(&wheels), Some((here, [down, turn])));
        }
        self.level_by_halving(load)
    }

    /// What two wheels carry more than their loads, and how that changes: as learnt from the last step, where
    /// there is one; by stiffness else. `None` where a wheel hangs in the air.
    fn lines(
        &self,
        wheels: &[PressedWheel<'_>],
        loads: [f64; 2],
        last: Option<([LoadLine; 2], [f64; 2])>,
    ) -> Option<[LoadLine; 2]> {
        let line = |wheel: &PressedWheel<'_>, load: f64, before: Option<LoadLine>| {
            let carried = wheel.expected(self.shares);
            let stiffness = [wheel.stiffness(self.shares), wheel.stiffness_by_roll(self.shares)];
            let by = stiffness.map(|by| by / carried);
            let excess = (carried / load).ln();
            let Some((before, (_, moved))) = before.zip(last) else {
                return LoadLine { excess, by };
            };
            let missed = excess - before.expected_after(moved);
            LoadLine {
                excess,
                by: learnt(before.by, moved, missed, BroydenPolicy::WithinReason).unwrap_or(by),
            }
        };
        let before = last.map_or([None; 2], |(before, _)| before.map(Some));
        let [left, right] = pair(wheels)?;
        let lines = [line(left, loads[0], before[0]), line(right, loads[1], before[1])];
        lines.iter().all(|line| line.excess.is_finite()).then_some(lines)
    }

    /// The roll at which each wheel carries its load at one height.
    fn level_by_halving(&self, loads: [f64; 2]) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let start = self.start_of_roll()?;
        let mut search = Root::new(start, [start - ROLL, start + ROLL]);
        let mut balance = self.clone();
        for step in 0..STEPS {
            let sides = [(Side::Left, loads[0]), (Side::Right, loads[1])];
            let [left, right] = sides.map(|(side, load)| balance.lowered(&[side], search.at, load));
            let wheels = [left?, right?].concat();
            let Some([left, right]) = pair(&wheels) else { break };
            balance.guess.depths = [left.depth, right.depth];
            balance.guess.known = PatchWarmStart::of(&wheels);
            let tilt = left.position.z - right.position.z;
            let depth = left.depth.min(right.depth);
            if tilt.abs() < load_tolerance(step) * depth || search.is_spent(NARROW * depth) {
                return Ok(wheels);
            }
            let lever = |wheel: &PressedWheel<'_>| {
                wheel.stiffness_by_roll(self.shares) / wheel.stiffness(self.shares)
            };
            search.next(tilt, Some(lever(right) - lever(left)));
        }
        Err(WheelsetError::LoadNotFound { load: loads[0] + loads[1] })
    }

    /// The roll at which both wheels carry the same at a height.
    fn evened(&self, z: f64) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let start = self.start_of_roll()?;
        let mut search = Root::new(start, [start - ROLL, start + ROLL]);
        let mut known = self.guess.known.clone();
        for step in 0..STEPS {
            let wheels = self.at(&[Side::Left, Side::Right], z, search.at, &known)?;
            known = PatchWarmStart::of(&wheels);
            let Some([left, right]) = pair(&wheels) else { break };
            let [low, high] = [left, right].map(|wheel| wheel.expected(self.shares));
            let (excess, sum) = (high - low, high + low);
            if excess.abs() <= load_tolerance(step) * sum || search.is_spent(1e-13) {
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
        let WheelsetPose { y, yaw, .. } = *self.stance;
        if let Some(roll) = self.guess.roll {
            return Ok(roll);
        }
        let resting = self.press.running.resting(y, yaw, None);
        Ok(resting.map_err(WheelsetError::Resting)?.roll)
    }
}

/// The logarithm of what a wheel carries over its load, and its change as the wheelset goes down (1/m) and
/// rolls (1/rad).
#[derive(Debug, Clone, Copy)]
struct LoadLine {
    excess: f64,
    by: [f64; 2],
}

impl LoadLine {
    fn expected_after(&self, [down, turn]: [f64; 2]) -> f64 {
        self.excess + self.by[0] * down + self.by[1] * turn
    }
}

/// The step in height and roll that makes both loads right, no longer than takes them to a third; `None`
/// where that is too far.
fn moves(lines: &[LoadLine; 2]) -> Option<[f64; 2]> {
    const LARGEST: f64 = 1.1;
    let [left, right] = lines;
    let largest = left.excess.abs().max(right.excess.abs());
    let [a, b] = [left, right].map(|line| -line.excess * (LARGEST / largest).min(1.0));
    let determinant = left.by[0] * right.by[1] - left.by[1] * right.by[0];
    let step = [a * right.by[1] - b * left.by[1], b * left.by[0] - a * right.by[0]];
    let [down, turn] = step.map(|part| part / determinant);
    (down.abs() < DEPTHS[1] && turn.abs() < ROLL).then_some([down, turn])
}

fn pair<'w, 'a>(wheels: &'w [PressedWheel<'a>]) -> Option<[&'w PressedWheel<'a>; 2]> {
    match wheels {
        [left, right] => Some([left, right]),
        _ => None,
    }
}
