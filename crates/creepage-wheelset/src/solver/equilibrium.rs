//! The way to the position in which wheels carry their load, and roll there.
//!
//! The position is sought with coarse pressures, or taken from one nearby. At each position found
//! fine ones and rolling say what the wheels carry, and their stiffness where to go on to, until
//! they carry what was expected.

use creepage_rail::Side;

use super::normal_contact::{PatchWarmStart, PressedWheel};
use super::step::{self, BroydenPolicy, Place};
use super::tangential::{self, Method, Rolling};
use super::{Start, WheelsetSolver};
use crate::solved::SolvedWheelset;
use crate::warm_start::LateralForceRatios;
use crate::{Load, WheelsetError, WheelsetPose, WheelsetVelocity};

/// Rounds after which it is given up, and after which they might swing to and fro.
const ROUNDS: usize = 28;
const FEW: usize = 12;
/// To which part of its error bar, and of itself, a load is met.
const MET: [f64; 2] = [0.2, 1e-4];
/// What may be left of friction's moment about the axle, in parts of what that could be, by methods that
/// come before the last one.
const ROUGHLY_BALANCED: f64 = 3e-4;
/// A step on known friction that leaves more than this part of what was missed is followed by rolling.
const HELPS: f64 = 0.5;
/// To which part a search with coarse pressures may miss a load.
const CLOSE: f64 = 5e-3;

/// Solves a wheelset that stands, moves and is loaded like this, by one method.
pub(crate) fn settle(
    solver: &WheelsetSolver<'_>,
    (stance, travel, load): (&WheelsetPose, &WheelsetVelocity, Load),
    start: Start,
    method: Method,
) -> Result<SolvedWheelset, WheelsetError> {
    let load = shared(stance, start.levers)?.unwrap_or(load);
    let mut way = EquilibriumIteration::new(solver, (stance, travel, load), start, method);
    for round in 0..ROUNDS {
        if let Some(solved) = way.round(round)? {
            return Ok(solved);
        }
    }
    Err(WheelsetError::NotSettled)
}

/// The load shared over the wheels that roll freely under a given moment; `None` for other loads.
fn shared(stance: &WheelsetPose, levers: [f64; 2]) -> Result<Option<Load>, WheelsetError> {
    let Some(load @ Load::Loaded { .. }) = stance.load else { return Ok(None) };
    let shared = load.by_levers(levers);
    for (side, load) in [Side::Left, Side::Right].map(|side| (side, shared.of_wheel(side))) {
        if let Some(load) = load.filter(|load| load.is_nan() || *load <= 0.0) {
            return Err(WheelsetError::Lifts { side, load });
        }
    }
    Ok(Some(shared))
}

/// How far the way has come.
struct EquilibriumIteration<'w, 'a> {
    solver: &'w WheelsetSolver<'a>,
    stance: &'w WheelsetPose,
    travel: &'w WheelsetVelocity,
    load: Load,
    /// Whether the position is known, and nothing to be sought.
    is_given: bool,
    /// Whether it began at a position nearby.
    is_beside: bool,
    /// Whether pressures known have error bars.
    has_bars: bool,
    /// What the last round tells.
    start: Start,
    /// Where to look next; sought where `None`.
    places: Option<Vec<Place>>,
    method: Method,
    /// Methods still to come, and down to which part of the load missed each is good enough.
    stages: Vec<(Method, f64)>,
    /// What the last round missed; the same by the method of this one, and how many methods were to come when
    /// it rolled.
    missed: f64,
    last: f64,
    rolled_by: Option<usize>,
}

impl<'w, 'a> EquilibriumIteration<'w, 'a> {
    fn new(
        solver: &'w WheelsetSolver<'a>,
        (stance, travel, load): (&'w WheelsetPose, &'w WheelsetVelocity, Load),
        mut start: Start,
        method: Method,
    ) -> Self {
        let is_given = matches!(load, Load::Height(_)) && stance.is_fixed();
        let places = std::mem::take(&mut start.places);
        let is_beside = places.is_some();
        let mut stages = method.stages();
        stages.drain(..if is_given || is_beside { stages.len() - 1 } else { 0 });
        let (missed, last, rolled_by) = (f64::INFINITY, f64::INFINITY, None);
        Self {
            solver,
            stance,
            travel,
            load,
            is_given,
            is_beside,
            has_bars: is_given || is_beside,
            start,
            places,
            method,
            stages,
            missed,
            last,
            rolled_by,
        }
    }

    /// Presses, rolls and says whether the load is met; else where to go on.
    fn round(&mut self, round: usize) -> Result<Option<SolvedWheelset>, WheelsetError> {
        let mut sought = self.sought()?;
        let Some(wheels) = self.pressed(&sought, round)? else { return Ok(None) };
        if self.step_on_known_friction(&mut sought, &wheels, round) {
            return Ok(None);
        }
        let method = self.stages.first().map_or(self.method, |stage| stage.0);
        let radius = self.solver.press.running.wheelset().radius();
        let by = (method, &self.start.friction[..]);
        let rollings = Rolling::all(&wheels, self.solver, self.travel.speed, by)?;
        // The next method has a moment of its own.
        let enough = if self.stages.len() == 1 { tangential::BALANCED } else { ROUGHLY_BALANCED };
        let guess = (self.start.pitch, enough);
        let turning = tangential::turning(&rollings, self.travel, radius, guess)?;
        let next = Start::of(&sought.coarse, &wheels, &turning.rolled, turning.pitch, &self.start);
        let missed = sought.missed(&wheels, &next.shares);
        let is_shared = self.share_load(next.levers)?;
        if is_shared && self.is_met(&sought, &wheels, &next.shares, round) {
            let here = (&sought.places[..], &wheels[..]);
            let mut solved = self.solver.solved(here, &rollings, &turning, self.travel);
            let missed = sought.missed_by_wheel(&wheels, &next.shares, self.load);
            solved.propagate_errors(self.stance, self.load, missed);
            return Ok(Some(solved));
        }
        self.go_on(&mut sought, &wheels, next, (missed, round));
        Ok(None)
    }

    /// Shares a load under a given moment anew, as the wheels' levers have it; whether it was shared so
    /// already.
    fn share_load(&mut self, levers: [f64; 2]) -> Result<bool, WheelsetError> {
        let shared = shared(self.stance, levers)?;
        let (Some(Load::Wheels(loads)), Load::Wheels(before)) = (shared, self.load) else {
            return Ok(true);
        };
        self.load = Load::Wheels(loads);
        let sum = loads[0] + loads[1];
        Ok((loads[1] - before[1]).abs() < MET[1] * sum)
    }

    fn sought(&mut self) -> Result<CandidatePose<'a>, WheelsetError> {
        match self.places.take() {
            Some(places) => Ok(CandidatePose { places, coarse: Vec::new() }),
            None => {
                self.solver.sought(self.stance, self.load, &self.start.shares, &self.start.guess)
            }
        }
    }

    /// Wheels with fine pressures; `None` where what a step led to is no place for them.
    fn pressed(
        &mut self,
        sought: &CandidatePose<'a>,
        round: usize,
    ) -> Result<Option<Vec<PressedWheel<'a>>>, WheelsetError> {
        // What friction carries about is told by a quick method first: before, no finer pressure is worth its cost.
        let is_first = self.stages.len() > 1 && self.rolled_by.is_none();
        if self.is_given || (is_first && !sought.coarse.is_empty()) {
            return Ok(Some(sought.coarse.clone()));
        }
        let follows = self.follows(round);
        match self.solver.refined(sought, &self.start.fine, follows) {
            // A step may lead too far: the search looks elsewhere.
            Err(_) if sought.coarse.is_empty() => Ok(None),
            wheels => {
                self.has_bars |= !follows;
                wheels.map(Some)
            }
        }
    }

    /// Whether pressures that follow those known are enough: beside a solved position, and for the last
    /// steps to one.
    fn follows(&self, round: usize) -> bool {
        const NEAR: f64 = 0.02;
        let is_near = self.missed < NEAR || (self.is_beside && round == 0);
        self.has_bars && is_near && round < FEW
    }

    /// Beside a solved position friction is known nearly: no rolling before the load is met, or, where rolling
    /// costs less than pressing, after a first step by how the load follows friction too. Whether it went on so.
    fn step_on_known_friction(
        &mut self,
        sought: &mut CandidatePose<'a>,
        wheels: &[PressedWheel<'a>],
        round: usize,
    ) -> bool {
        let shares = &self.start.shares;
        let missed = sought.missed(wheels, shares);
        let has_rolled = !self.is_beside || self.rolled_by.is_some();
        let is_cheap = matches!(self.method, Method::Simplified(..));
        let is_met = sought.is_met(wheels, shares, tight_tolerance);
        let is_enough = is_met || missed >= HELPS * self.last || (is_cheap && round > 0);
        if has_rolled || (is_enough && self.has_bars) {
            return false;
        }
        (self.missed, self.last) = (missed, if is_enough { 0.0 } else { missed });
        let is_like = !is_cheap && round > 0;
        sought.learn(
            wheels,
            shares,
            if is_like { BroydenPolicy::WithinReason } else { BroydenPolicy::None },
        );
        self.places = step::places((&sought.places, wheels), self.stance, self.load, shares);
        self.start.fine = PatchWarmStart::of(wheels);
        true
    }

    /// Whether the wheels carry what was expected, by the last method.
    fn is_met(
        &self,
        sought: &CandidatePose<'_>,
        wheels: &[PressedWheel<'_>],
        shares: &LateralForceRatios,
        round: usize,
    ) -> bool {
        // Fine pressures that depend on where they began scatter within their error bars.
        let within = if round < FEW { tight_tolerance } else { |error, _| error };
        self.is_given || (self.stages.len() == 1 && sought.is_met(wheels, shares, within))
    }

    /// Where to look next, by which method, with what was learnt.
    fn go_on(
        &mut self,
        sought: &mut CandidatePose<'a>,
        wheels: &[PressedWheel<'a>],
        next: Start,
        (missed, round): (f64, usize),
    ) {
        let belief = if self.rolled_by != Some(self.stages.len()) {
            BroydenPolicy::None
        } else if missed > self.last {
            BroydenPolicy::Whole
        } else {
            BroydenPolicy::WithinReason
        };
        sought.learn(wheels, &next.shares, belief);
        // A step that helps, however little, tells how the next should go; so close no search helps.
        let is_close = missed < CLOSE;
        if is_close || round >= FEW || missed < self.last || self.rolled_by.is_none() {
            let here = (&sought.places[..], wheels);
            self.places = step::places(here, self.stance, self.load, &next.shares);
        }
        (self.missed, self.last, self.rolled_by) = (missed, missed, Some(self.stages.len()));
        if let [(_, good_enough), _, ..] = self.stages[..]
            && (missed < good_enough || round >= FEW)
        {
            self.stages.remove(0);
            self.last = f64::INFINITY;
        }
        self.start = if round < FEW { next } else { next.halfway_from(&self.start.shares) };
    }
}

/// What a wheel may carry more or less than its load (N), by the error bar of that.
fn tight_tolerance(error: f64, load: f64) -> f64 {
    (MET[0] * error).min(MET[1] * load)
}

/// Where the wheels should carry their load.
pub(crate) struct CandidatePose<'a> {
    pub(crate) places: Vec<Place>,
    /// What the search found there; nothing after a step.
    pub(crate) coarse: Vec<PressedWheel<'a>>,
}

impl CandidatePose<'_> {
    fn learn(
        &mut self,
        wheels: &[PressedWheel<'_>],
        shares: &LateralForceRatios,
        belief: BroydenPolicy,
    ) {
        let pairs = self.places.iter_mut().zip(wheels);
        pairs.for_each(|(place, wheel)| place.learn(wheel, shares, belief));
    }

    /// Whether each wheel carries what was expected, within so much of its error bar and its load.
    fn is_met(
        &self,
        wheels: &[PressedWheel<'_>],
        shares: &LateralForceRatios,
        within: fn(f64, f64) -> f64,
    ) -> bool {
        self.places.iter().zip(wheels).all(|(place, wheel)| {
            let carried = wheel.vertical(shares);
            (carried - place.expected).abs() <= within(wheel.load_error(), carried)
        })
    }

    /// How much the left and the right wheel miss of what was expected (N).
    fn missed_by_wheel(
        &self,
        wheels: &[PressedWheel<'_>],
        shares: &LateralForceRatios,
        load: Load,
    ) -> [f64; 2] {
        let mut missed = [0.0; 2];
        for (place, wheel) in self.places.iter().zip(wheels) {
            let wanted = load.of_wheel(wheel.side).unwrap_or(place.expected);
            missed[usize::from(wheel.side == Side::Right)] = wheel.vertical(shares) - wanted;
        }
        missed
    }

    /// What wheels carry more or less than expected, in parts of what they carry.
    fn missed(&self, wheels: &[PressedWheel<'_>], shares: &LateralForceRatios) -> f64 {
        let pairs = self.places.iter().zip(wheels);
        let off = |(place, wheel): (&Place, &PressedWheel<'_>)| {
            (wheel.vertical(shares) - place.expected).abs()
        };
        let off: f64 = pairs.map(off).sum();
        // A wheelset that hangs above its rails carries nothing and misses nothing.
        if off > 0.0 {
            off / wheels.iter().map(|one| one.vertical(shares)).sum::<f64>()
        } else {
            0.0
        }
    }
}
