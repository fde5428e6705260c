//! Equilibrium of a wheelset: the height and the roll at which its wheels carry what is asked of them.
//!
//! Newton's method on the vertical forces to the power 2/3 ([`Target`]), with the stiffness of the contacts as
//! Jacobian, Broyden's updates for what that does not know, and a trust region. The pitch rate, at which friction
//! balances the torque, is eliminated at each evaluation. Coarse pressures and quick friction come first, as a start.

use creepage::normal;
use creepage_rail::{Position, Side};
use rayon::prelude::*;

use super::WheelsetSolver;
use super::normal_contact::{NormalSolver, PatchWarmStart, PressedWheel};
use super::pitch_rate::{self, turning};
use super::start::{Place, Start, levers, ratios};
use super::tangential::{Method, Rolling};
use super::vertical_load::{LoadLine, Target};
use crate::solved::SolvedWheelset;
use crate::warm_start::LateralForceRatios;
use crate::{WheelsetError, WheelsetPose, WheelsetVelocity};

/// Evaluations after which the search is given up; and of one stage, after which forces that scatter are met within
/// their error bars.
const MAX_EVALUATIONS: usize = 48;
const MAX_OF_STAGE: usize = 12;
/// To which part of its error bar, and of itself, a load is met.
const LOAD_TOLERANCES: [f64; 2] = [0.2, 1e-4];
/// A load missed by more than this part of itself is not met, however wide its error bar.
const MAX_MISSED: f64 = 0.01;
/// What may be left of friction's moment about the axle, in parts of what that could be, by stages before the last.
const ROUGHLY_BALANCED: f64 = 3e-4;
/// The trust region's first radius, in parts of the forces to the power 2/3, its least one, and how a rejected step
/// shrinks it.
const FIRST_RADIUS: f64 = 0.3;
const LEAST_RADIUS: f64 = 1e-6;
const SHRINKS: f64 = 0.25;
/// The part of the expected gain that a step must bring for the radius to double.
const GAINS: f64 = 0.75;
/// Residuals that do not count as a step back: forces scatter by as much.
const SCATTER: f64 = 5e-4;
/// Below this residual pressures follow those of the step before.
const FOLLOWS: f64 = 0.015;
/// A part of the residual at which the next stage begins: closer, friction is worth more than another step.
const NEXT_STAGE_BELOW: f64 = 0.25;
/// Friction is solved again if a step with frozen friction leaves more than this part of the residual.
const MAX_RESIDUAL_PART: f64 = 0.5;

/// How finely an evaluation presses and rolls, and the residual at which the next stage begins.
#[derive(Debug, Clone, Copy)]
struct Stage {
    resolution: normal::Resolution,
    method: Method,
    load_tolerance: f64,
}

/// Solves a wheelset that stands, moves and is loaded like this, by one method.
pub(crate) fn settle(
    solver: &WheelsetSolver<'_>,
    stance: &WheelsetPose,
    travel: &WheelsetVelocity,
    start: Start,
    method: Method,
) -> Result<SolvedWheelset, WheelsetError> {
    let mut search = EquilibriumSearch::new(solver, stance, travel, start, method)?;
    for _ in 0..MAX_EVALUATIONS {
        if let Some(solved) = search.evaluate()? {
            return Ok(solved);
        }
    }
    Err(WheelsetError::NotSettled)
}

/// A position that was evaluated, from which steps are taken.
struct Iterate {
    places: Vec<Place>,
    lines: Vec<(Side, LoadLine)>,
    residual: f64,
    /// Whether friction is that of this position.
    is_rolled: bool,
}

struct EquilibriumSearch<'w, 'a> {
    solver: &'w WheelsetSolver<'a>,
    stance: &'w WheelsetPose,
    travel: &'w WheelsetVelocity,
    target: Target,
    /// Stages still to come, the present one first.
    stages: Vec<Stage>,
    /// What the last accepted evaluation tells.
    start: Start,
    /// The last accepted position of this stage.
    iterate: Option<Iterate>,
    /// Where to evaluate next.
    trial: Vec<Place>,
    radius: f64,
    /// Length of the trial step in units of the radius, and its part of Newton's.
    step: f64,
    part: f64,
    evaluations: usize,
    /// Whether pressures known have error bars, and whether they lie close by.
    has_bars: bool,
    is_near: bool,
    /// By how much friction changed the residual when it was found last by this stage.
    friction_changed: f64,
    /// Whether loads are met within their error bars only.
    is_scattered: bool,
    /// The best solution that meets loads within their error bars, with its residual, once forces came no closer.
    within_bars: Option<(f64, SolvedWheelset)>,
    /// Part of the depth at which the search begins; `None` once it has begun.
    depth: Option<f64>,
    /// Why the last trial was refused.
    refused: Option<WheelsetError>,
}

impl<'w, 'a> EquilibriumSearch<'w, 'a> {
    fn new(
        solver: &'w WheelsetSolver<'a>,
        stance: &'w WheelsetPose,
        travel: &'w WheelsetVelocity,
        mut start: Start,
        method: Method,
    ) -> Result<Self, WheelsetError> {
        let target = Target::new(stance, start.levers)?;
        let beside = start.places.take();
        let is_near = beside.is_some();
        let mut stages = stages(method, solver.press.resolution);
        if is_near || target == Target::Nothing {
            stages.drain(..stages.len() - 1);
        }
        let (trial, depth) = match beside {
            Some(places) => (places, None),
            None => (solver.first_places(stance, &target, &start, 1.0)?, Some(1.0)),
        };
        Ok(Self {
            solver,
            stance,
            travel,
            target,
            stages,
            start,
            iterate: None,
            trial,
            radius: FIRST_RADIUS,
            step: 0.0,
            part: 1.0,
            evaluations: 0,
            has_bars: is_near,
            is_near,
            friction_changed: if is_near { 0.0 } else { f64::INFINITY },
            is_scattered: false,
            within_bars: None,
            depth,
            refused: None,
        })
    }

    /// Presses, rolls and says whether what is asked for is met; else steps on.
    fn evaluate(&mut self) -> Result<Option<SolvedWheelset>, WheelsetError> {
        let stage = self.stages[0];
        self.evaluations += 1;
        self.is_scattered |= self.evaluations > MAX_OF_STAGE;
        if self.is_scattered
            && let Some((_, solved)) = self.within_bars.take()
        {
            return Ok(Some(solved));
        }
        let wheels = match self.pressed(stage.resolution) {
            Ok(wheels) => wheels,
            Err(error) => return self.refuse(error).map(|()| None),
        };
        // By the friction of the position before.
        let mut lines = self.lines(&wheels, &self.start.shares)?;
        let by_known = self.target.residual(&lines);
        if self.is_step_back(by_known) {
            return self.reject(&lines).map(|()| None);
        }
        if self.defers_friction(&wheels, by_known) {
            self.update_slopes(&mut lines);
            self.start.pressures = PatchWarmStart::of(&wheels);
            self.accept(lines, by_known, false)?;
            return Ok(None);
        }

        let by = (stage.method, &self.start.friction[..]);
        let rollings = Rolling::all(&wheels, self.solver, self.travel.speed, by)?;
        let is_last = self.stages.len() == 1;
        let moment_tolerance = if is_last { pitch_rate::BALANCED } else { ROUGHLY_BALANCED };
        let radius = self.solver.press.running.wheelset().radius();
        let guess = (self.start.pitch, moment_tolerance);
        let turning = match turning(&rollings, self.travel, radius, guess) {
            Ok(turning) => turning,
            Err(error) => return self.refuse(error).map(|()| None),
        };
        let shares = ratios(&wheels, &turning.rolled);
        let levers = levers(&wheels, &turning.rolled).unwrap_or(self.start.levers);
        self.target = Target::new(self.stance, levers)?;
        let mut rolled = self.lines(&wheels, &shares)?;
        let residual = self.target.residual(&rolled);
        self.friction_changed = (residual - by_known).abs();
        let was_rolled = self.iterate.as_ref().is_some_and(|iterate| iterate.is_rolled);
        if was_rolled && self.is_step_back(residual) {
            return self.reject(&rolled).map(|()| None);
        }
        // Slopes are learnt from positions whose friction was found alike.
        if was_rolled {
            self.update_slopes(&mut rolled);
        } else {
            self.update_slopes(&mut lines);
            for ((_, line), (_, known)) in rolled.iter_mut().zip(&lines) {
                line.by = known.by;
            }
        }
        let solved = || {
            let mut solved =
                self.solver.solved((&wheels, &rolled), &rollings, &turning, self.travel);
            let missed = self.missed(&wheels, &shares);
            solved.propagate_errors(&self.target, (self.stance, self.travel), missed);
            solved
        };
        if is_last && self.is_met(&wheels, &shares) {
            self.check_hanging(&wheels)?;
            return Ok(Some(solved()));
        }
        let is_best = self.within_bars.as_ref().is_none_or(|(best, _)| residual < *best);
        if is_last
            && is_best
            && self.radius < FIRST_RADIUS
            && self.is_within(&wheels, &shares, within_bar)
            && self.check_hanging(&wheels).is_ok()
        {
            self.within_bars = Some((residual, solved()));
        }
        self.start.evaluated(&wheels, &turning.rolled, turning.pitch);
        self.accept(rolled, residual, true)?;
        Ok(None)
    }

    /// The wheels of the trial under pressure.
    fn pressed(
        &mut self,
        resolution: normal::Resolution,
    ) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let is_near = match &self.iterate {
            Some(iterate) => iterate.residual < FOLLOWS,
            None => self.is_near,
        };
        let follows = self.has_bars && is_near && !self.is_scattered;
        let press = NormalSolver { resolution, follows, ..self.solver.press };
        let known = &self.start.pressures;
        let wheel = |place: &Place| press.wheel(place.side, place.position, known);
        let wheels = self.trial.par_iter().map(wheel).collect::<Result<Vec<_>, _>>()?;
        self.has_bars |= self.stages.len() == 1 && !follows;
        Ok(wheels)
    }

    /// What the wheels carry by some friction, and how stiff that is.
    fn lines(
        &self,
        wheels: &[PressedWheel<'_>],
        shares: &LateralForceRatios,
    ) -> Result<Vec<(Side, LoadLine)>, WheelsetError> {
        let line = |wheel: &PressedWheel<'_>| {
            let force = wheel.vertical(shares);
            let line = if force > 0.0 {
                let by = [wheel.stiffness(shares), wheel.stiffness_by_roll(shares)];
                LoadLine::of_force(force, by)
            } else {
                self.hanging(wheel)?
            };
            Ok((wheel.side, line))
        };
        wheels.iter().map(line).collect()
    }

    /// A wheel that hangs goes on the line of Hertz's sphere below zero.
    fn hanging(&self, wheel: &PressedWheel<'_>) -> Result<LoadLine, WheelsetError> {
        let PressedWheel { side, position: Position { y, z, roll, yaw }, .. } = *wheel;
        let touch = self.solver.press.running.first_touch(side, y, roll, yaw);
        let touch = touch.map_err(|source| WheelsetError::Position { side, source })?;
        let slope = self.solver.hertzian_slope();
        let lever = self.solver.start().levers[usize::from(side == Side::Right)];
        Ok(LoadLine { root: slope * (z - touch).min(0.0), by: [slope, slope * lever] })
    }

    /// Whether friction need not be found here: it costs more than pressing, or is known from a position beside, and
    /// by the known one the load is missed by more than friction changed last.
    fn defers_friction(&self, wheels: &[PressedWheel<'_>], residual: f64) -> bool {
        let has_stepped = self.iterate.as_ref().is_some_and(|iterate| {
            !iterate.is_rolled && residual >= MAX_RESIDUAL_PART * iterate.residual
        });
        let is_cheap = matches!(self.stages[0].method, Method::Simplified(..));
        let is_first = self.is_near && self.iterate.is_none();
        let may_defer = (!is_cheap || is_first) && !has_stepped && !self.is_scattered;
        let is_met = match self.stages[..] {
            [Stage { load_tolerance, .. }, _, ..] => residual < NEXT_STAGE_BELOW * load_tolerance,
            _ => self.is_met(wheels, &self.start.shares),
        };
        may_defer && residual > self.friction_changed && !is_met
    }

    fn is_step_back(&self, residual: f64) -> bool {
        let before = self.iterate.as_ref().map(|iterate| iterate.residual);
        before.is_some_and(|before| residual > before.max(SCATTER)) && !self.is_scattered
    }

    /// Whether each wheel carries what is asked of it.
    fn is_met(&self, wheels: &[PressedWheel<'_>], shares: &LateralForceRatios) -> bool {
        self.is_within(wheels, shares, |error, carried| {
            // Fine pressures that depend on where they began scatter within their error bars.
            if self.is_scattered {
                within_bar(error, carried)
            } else {
                (LOAD_TOLERANCES[0] * error).min(LOAD_TOLERANCES[1] * carried)
            }
        })
    }

    /// Whether each wheel misses no more than a tolerance (N), by the error bar of its load and by what it carries.
    fn is_within(
        &self,
        wheels: &[PressedWheel<'_>],
        shares: &LateralForceRatios,
        tolerance: impl Fn(f64, f64) -> f64,
    ) -> bool {
        let missed = self.target.missed(&forces(wheels, shares));
        wheels.iter().zip(missed).all(|(wheel, missed)| {
            // A wheel that is to carry nothing must hang, which is checked apart.
            self.target.of_wheel(wheel.side) == Some(0.0)
                || missed.abs() <= tolerance(wheel.load_error(), wheel.vertical(shares))
        })
    }

    /// What the left and the right wheel miss (N).
    fn missed(&self, wheels: &[PressedWheel<'_>], shares: &LateralForceRatios) -> [f64; 2] {
        let mut missed = [0.0; 2];
        for (wheel, own) in wheels.iter().zip(self.target.missed(&forces(wheels, shares))) {
            missed[usize::from(wheel.side == Side::Right)] = own;
        }
        missed
    }

    /// A wheel that is to carry nothing must hang above its rail.
    fn check_hanging(&self, wheels: &[PressedWheel<'_>]) -> Result<(), WheelsetError> {
        let lies_in_rail = |wheel: &&PressedWheel<'_>| {
            self.target.of_wheel(wheel.side) == Some(0.0) && !wheel.contacts.is_empty()
        };
        match wheels.iter().find(lies_in_rail) {
            Some(&PressedWheel { side, .. }) => Err(WheelsetError::Sinks { side }),
            None => Ok(()),
        }
    }

    /// Slopes of lines at the trial, from the step that led there.
    fn update_slopes(&self, lines: &mut [(Side, LoadLine)]) {
        if self.iterate.is_none() && !self.is_near {
            return;
        }
        for ((_, line), place) in lines.iter_mut().zip(&self.trial) {
            if let Some(expected) = place.expected.filter(|_| line.root > 0.0) {
                line.update_slopes(&expected, place.moved);
            }
        }
    }

    /// Goes on from the trial: to the next stage where it is close enough.
    fn accept(
        &mut self,
        lines: Vec<(Side, LoadLine)>,
        residual: f64,
        is_rolled: bool,
    ) -> Result<(), WheelsetError> {
        if let Some(before) = &self.iterate
            && before.residual - residual > GAINS * self.part * before.residual
        {
            self.radius = self.radius.max(2.0 * self.step);
        }
        self.refused = None;
        self.depth = None;
        let places =
            self.trial.iter().map(|place| Place::new(place.side, place.position)).collect();
        self.iterate = Some(Iterate { places, lines, residual, is_rolled });
        self.step_on()?;
        if let [Stage { load_tolerance, .. }, _, ..] = self.stages[..]
            && is_rolled
            && (residual < load_tolerance || self.is_scattered)
        {
            // The next stage has forces of its own, which are compared with none of this one.
            self.stages.remove(0);
            self.iterate = None;
            (self.evaluations, self.is_scattered) = (0, false);
            (self.radius, self.friction_changed) = (FIRST_RADIUS, 0.0);
        }
        Ok(())
    }

    /// A trial that came no closer: its slopes are learnt, and a shorter step is taken from where it began.
    fn reject(&mut self, lines: &[(Side, LoadLine)]) -> Result<(), WheelsetError> {
        if let Some(iterate) = &mut self.iterate {
            for (((_, own), (_, found)), place) in
                iterate.lines.iter_mut().zip(lines).zip(&self.trial)
            {
                let mut found = *found;
                if let Some(expected) = place.expected.filter(|_| found.root > 0.0) {
                    found.update_slopes(&expected, place.moved);
                    own.by = found.by;
                }
            }
        }
        self.shrink()
    }

    /// A trial that cannot be pressed.
    fn refuse(&mut self, error: WheelsetError) -> Result<(), WheelsetError> {
        const HALVINGS: f64 = 1e-4;
        let is_position = matches!(error, WheelsetError::Position { .. });
        if self.iterate.is_some() {
            self.refused = Some(error);
            return self.shrink();
        }
        match self.depth {
            // The first depth lies too deep for the profiles.
            Some(depth) if is_position && depth > HALVINGS && self.target != Target::Nothing => {
                self.depth = Some(0.5 * depth);
                self.trial = self.solver.first_places(
                    self.stance,
                    &self.target,
                    &self.start,
                    0.5 * depth,
                )?;
                Ok(())
            }
            _ => Err(error),
        }
    }

    fn shrink(&mut self) -> Result<(), WheelsetError> {
        self.radius = SHRINKS * self.step.min(self.radius);
        if self.radius >= LEAST_RADIUS {
            return self.step_on();
        }
        // Forces jump here, or nothing deeper carries the load.
        if let Some(error) = self.refused.take() {
            return Err(error);
        }
        if self.is_scattered {
            return Err(WheelsetError::NotSettled);
        }
        self.is_scattered = true;
        self.step_on()
    }

    /// The next trial: Newton's step within the trust region.
    fn step_on(&mut self) -> Result<(), WheelsetError> {
        let Some(Iterate { places, lines, .. }) = &self.iterate else { return Ok(()) };
        let step = self.target.step(lines).ok_or_else(|| self.not_found())?;
        let size = |((side, line), moved): (&(Side, LoadLine), &[f64; 2])| {
            let change = line.after(*moved).root - line.root;
            change.abs() / self.target.scale(*side, lines)
        };
        let sizes = lines.iter().zip(&step).map(size).filter(|size| size.is_finite());
        let size = sizes.fold(0.0, f64::max);
        let part = if size > self.radius { self.radius / size } else { 1.0 };
        (self.step, self.part) = (part * size, part);
        let pairs = places.iter().zip(lines).zip(&step);
        let stepped = |((place, (_, line)), step): ((&Place, &(Side, LoadLine)), &[f64; 2])| {
            place.stepped(line, step.map(|moved| part * moved))
        };
        self.trial = pairs.map(stepped).collect();
        Ok(())
    }

    fn not_found(&self) -> WheelsetError {
        let sides: Vec<Side> = self.trial.iter().map(|place| place.side).collect();
        match (self.target.sum(&sides), self.stance.load) {
            (Some(load), _) => WheelsetError::LoadNotFound { load },
            (None, Some(crate::Load::Height(z))) => WheelsetError::RollNotFound { z },
            _ => WheelsetError::NotSettled,
        }
    }
}

/// What may be missed (N) of a load that scatters within its error bar.
fn within_bar(error: f64, carried: f64) -> f64 {
    error.min(MAX_MISSED * carried)
}

/// Vertical forces of wheels (N).
fn forces(wheels: &[PressedWheel<'_>], shares: &LateralForceRatios) -> Vec<(Side, f64)> {
    wheels.iter().map(|wheel| (wheel.side, wheel.vertical(shares))).collect()
}

/// The stages that come nearer to a method: loads follow from friction, which `fastsim` tells a hundred times
/// quicker than the full theory.
fn stages(method: Method, resolution: normal::Resolution) -> Vec<Stage> {
    use creepage::approximate::non_hertzian::Simplified;
    use creepage::coulomb::Resolution;
    let last = Stage { resolution, method, load_tolerance: 0.0 };
    let coarse = |method, load_tolerance| Stage {
        resolution: normal::Resolution::COARSE,
        method,
        load_tolerance,
    };
    match method {
        Method::Exact(_) => vec![
            coarse(Method::Simplified(Simplified::Fastsim, [20, 10]), 0.01),
            coarse(Method::Exact(Resolution::FAST), 2e-3),
            last,
        ],
        Method::Simplified(..) => vec![coarse(method, 0.01), last],
    }
}
