//! The contacts of a wheelset solved: where it stands under its load, what presses on each
//! contact, how it rolls there.

mod bracketed_root;
mod continuation;
mod cross_patch;
mod derivative;
mod equilibrium;
mod error_propagation;
mod excess;
mod implicit_derivative;
mod load_balance;
mod motion_derivative;
mod normal_contact;
mod pose_derivative;
mod predictor;
mod solution;
mod step;
mod stood;
mod tangential;

use creepage::SolidPair;
use creepage::normal;
use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec};
use creepage_rail::{Position, Side, WheelsetOnTrack};
use rayon::prelude::*;

use self::equilibrium::{CandidatePose, settle};
use self::load_balance::{Balance, Guess};
use self::normal_contact::{NormalSolver, PatchWarmStart, PressedWheel};
use self::step::Place;
pub use self::stood::PressedContacts;
use self::tangential::{Method, Rolled, TractionWarmStart};
use crate::error::WheelsetError;
use crate::friction::{RailFriction, of_side};
use crate::pose::{Load, Patches, RigidSlip, WheelsetPose, WheelsetVelocity};
use crate::resultant::Acting;
use crate::solved::{SolvedWheel, SolvedWheelset};
use crate::tilt::Placed;
use crate::warm_start::{LateralForceRatios, PitchState, PredictorCorrection};

/// A wheelset on its track, prepared to be solved in many positions.
#[derive(Debug, Clone)]
pub struct WheelsetSolver<'a> {
    press: NormalSolver<'a>,
    friction: [RailFriction; 2],
    /// On the left and the right guard rail, where it differs from that of the rail.
    guard_friction: [Option<RailFriction>; 2],
    slip: RigidSlip,
    theory: AreaTheory,
    rolling: Vec<Method>,
    accuracy: f64,
}

impl<'a> WheelsetSolver<'a> {
    /// Prepares wheels and rails of materials `pair` (wheel above rail) with friction on the left and on the
    /// right rail.
    ///
    /// # Errors
    /// [`WheelsetError::Invalid`] for options out of range.
    pub fn new(
        running: &'a WheelsetOnTrack,
        pair: SolidPair,
        friction: [RailFriction; 2],
        theory: AreaTheory,
    ) -> Result<Self, WheelsetError> {
        let (resolution, rolling, accuracy) = match theory {
            AreaTheory::Exact(options) => {
                let (resolutions, accuracy) =
                    options.resolutions().map_err(WheelsetError::invalid("solve"))?;
                let rolling = resolutions.into_iter().map(Method::Exact).collect();
                (pressed_by(options), rolling, accuracy)
            }
            AreaTheory::Simplified(kind, cells) => {
                (normal::Resolution::STANDARD, vec![Method::Simplified(kind, cells)], 0.0)
            }
        };
        let patches = Patches::Together;
        let press = NormalSolver { running, pair, resolution, patches, follows: false };
        let (guard_friction, slip) = ([None, None], RigidSlip::Flat);
        Ok(Self { press, friction, guard_friction, slip, theory, rolling, accuracy })
    }

    /// With the rigid slip of its contacts, and whether areas in planes of their own feel each other.
    #[must_use]
    pub fn with_model(self, slip: RigidSlip, patches: Patches) -> Self {
        Self { slip, press: NormalSolver { patches, ..self.press }, ..self }
    }

    /// With friction of their own on the left and the right guard rail; without one that of the rail beside it.
    #[must_use]
    pub fn with_guard_friction(self, guard_friction: [Option<RailFriction>; 2]) -> Self {
        Self { guard_friction, ..self }
    }

    /// The friction that a contact has.
    pub(crate) fn friction_on(&self, contact: &creepage_rail::Contact<'_>) -> &RailFriction {
        let guard = &self.guard_friction[usize::from(contact.side == Side::Right)];
        let rail = of_side(&self.friction, contact.side);
        guard.as_ref().filter(|_| contact.is_on_guard).unwrap_or(rail)
    }

    /// The same wheelset on another track, or in another place of it.
    #[must_use]
    pub fn on<'b>(&self, running: &'b WheelsetOnTrack) -> WheelsetSolver<'b> {
        let NormalSolver { pair, resolution, patches, follows, .. } = self.press;
        WheelsetSolver {
            press: NormalSolver { running, pair, resolution, patches, follows },
            friction: self.friction.clone(),
            guard_friction: self.guard_friction.clone(),
            slip: self.slip,
            theory: self.theory,
            rolling: self.rolling.clone(),
            accuracy: self.accuracy,
        }
    }

    /// Its wheels and rails.
    #[must_use]
    pub fn running(&self) -> &WheelsetOnTrack {
        self.press.running
    }

    /// The same wheelset with one coefficient of friction on all rails.
    #[must_use]
    pub fn with_friction(&self, friction: f64) -> Self {
        let friction = [RailFriction::Constant(friction), RailFriction::Constant(friction)];
        Self { friction, guard_friction: [None, None], ..self.clone() }
    }

    /// Solves the wheelset where it stands, as it moves. The same bits whatever was solved before.
    ///
    /// A wheelset that runs backwards (`speed < 0`) is solved as its mirror image fore and aft.
    ///
    /// # Errors
    /// [`WheelsetError`] where no load is given, wheels and rails do not meet, or nothing carries
    /// the load.
    pub fn solve(
        &self,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
    ) -> Result<SolvedWheelset, WheelsetError> {
        if travel.is_backward() {
            self.check_backward()?;
            let solved = self.solve(&stance.fore_and_aft(), &travel.fore_and_aft())?;
            return Ok(solved.fore_and_aft());
        }
        let load = match stance.load {
            Some(Load::Wheel(load)) => Some(load),
            Some(Load::Wheels([left, right])) => Some(left.midpoint(right)),
            Some(Load::Axle(load)) => Some(if stance.side.is_some() { load } else { 0.5 * load }),
            Some(Load::Loaded { load, .. }) => Some(0.5 * load),
            Some(Load::Height(_)) | None => None,
        };
        let NormalSolver { running, pair, .. } = self.press;
        let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
        let radius = running.wheelset().radius();
        let guess = load.map(|load| Guess::under_load(load, modulus, radius)).unwrap_or_default();
        self.from(stance, travel, &Start { guess, ..self.start() })
    }

    /// A wheelset that runs backwards is solved as its mirror image, which surfaces that vary do not have.
    fn check_backward(&self) -> Result<(), WheelsetError> {
        let what = "running backwards ([motion] speed below zero; turn the track and the wheels round instead)";
        if self.press.running.is_alike_backwards() {
            Ok(())
        } else {
            Err(WheelsetError::Varies { what })
        }
    }

    /// What is known of no position at all.
    fn start(&self) -> Start {
        let lever = 0.5 * self.press.running.wheelset().tape_distance();
        Start { levers: [-lever, lever], ..Start::default() }
    }

    /// The same from a position nearby that was solved before: quicker.
    ///
    /// # Errors
    /// As [`WheelsetSolver::solve`].
    pub fn next(
        &self,
        before: &SolvedWheelset,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
    ) -> Result<SolvedWheelset, WheelsetError> {
        // A wheel that hangs has no place to go on from.
        let hangs = matches!(stance.load, Some(Load::Wheels(loads)) if loads.contains(&0.0));
        if hangs || before.is_reversed != travel.is_backward() {
            return self.solve(stance, travel);
        }
        if travel.is_backward() {
            self.check_backward()?;
            let before = before.clone().fore_and_aft();
            let solved = self.next(&before, &stance.fore_and_aft(), &travel.fore_and_aft())?;
            return Ok(solved.fore_and_aft());
        }
        let Some((start, expected)) = self.beside(before, stance) else {
            return self.from(stance, travel, &self.after(before));
        };
        let mut solved = self.from(stance, travel, &start)?;
        solved.drift = Some(PredictorCorrection::new(&expected, before, &solved, stance));
        Ok(solved)
    }

    /// What a solved position tells of others.
    fn after(&self, before: &SolvedWheelset) -> Start {
        let levers = before.levers(self.press.running.wheelset().radius());
        Start { levers: levers.unwrap_or(self.start().levers), ..Start::after(before) }
    }

    /// What a solved position tells of one beside it, and where the wheels were expected there by the
    /// undeformed bodies alone; `None` where it is farther off.
    fn beside(
        &self,
        before: &SolvedWheelset,
        stance: &WheelsetPose,
    ) -> Option<(Start, Vec<Position>)> {
        let start = self.after(before);
        let load = stance.load.map(|load| load.by_levers(start.levers));
        let here = WheelsetPose { load, ..*stance };
        let places = predictor::places(before, &here, self.press.running)?;
        let expected = places.iter().map(|place| place.position).collect();
        let mut start = Start { places: Some(places), ..start };
        if let Some(drift) = &before.drift
            && let Some(times) = drift.times(before, stance)
        {
            drift.correct(&mut start, times, stance);
        }
        Some((start, expected))
    }

    fn from(
        &self,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
        start: &Start,
    ) -> Result<SolvedWheelset, WheelsetError> {
        // Once to the threads that solve contacts, not for each step.
        rayon::scope(|_| self.by_methods(stance, travel, start))
    }

    /// By one method after another until the wanted accuracy is met.
    fn by_methods(
        &self,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
        start: &Start,
    ) -> Result<SolvedWheelset, WheelsetError> {
        let load = stance.load.ok_or(WheelsetError::NoLoad)?;
        let (last, first) = self.rolling.split_last().unwrap_or((&Method::STANDARD, &[]));
        for method in first {
            let solved = settle(self, (stance, travel, load), start.clone(), *method)?;
            if solved.worst_error() <= self.accuracy {
                return Ok(solved);
            }
        }
        settle(self, (stance, travel, load), start.clone(), *last)
    }

    /// Where wheels carry the load, by coarse pressures unless nothing is to be sought.
    fn sought(
        &self,
        stance: &WheelsetPose,
        load: Load,
        shares: &LateralForceRatios,
        guess: &Guess,
    ) -> Result<CandidatePose<'a>, WheelsetError> {
        let coarse = NormalSolver { resolution: normal::Resolution::COARSE, ..self.press };
        let is_given = matches!(load, Load::Height(_)) && stance.is_fixed();
        let press = if is_given { &self.press } else { &coarse };
        let balance = Balance { press, stance, shares, guess: guess.clone() };
        let coarse = balance.wheels(load)?;
        Ok(CandidatePose { places: Place::of(&coarse, stance, load, shares), coarse })
    }

    /// Wheels in their places with fine pressures.
    fn refined(
        &self,
        sought: &CandidatePose<'a>,
        known: &[PatchWarmStart],
        follows: bool,
    ) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let press = NormalSolver { follows, ..self.press };
        let coarse = PatchWarmStart::of(&sought.coarse);
        let known = if known.is_empty() { &coarse } else { known };
        let fine = |&Place { side, position, depth, .. }: &Place| {
            Ok(PressedWheel { depth, ..press.wheel(side, position, known)? })
        };
        sought.places.par_iter().map(fine).collect()
    }
}

/// How finely bodies are pressed that roll by the full theory with these options.
fn pressed_by(options: ExactOptions) -> normal::Resolution {
    match options.resolution {
        ResolutionSpec::Named(NamedResolution::Fast) => normal::Resolution::FAST,
        ResolutionSpec::Named(NamedResolution::Fine) => normal::Resolution::FINE,
        _ => normal::Resolution::STANDARD,
    }
}

/// What a solved position tells of those nearby.
#[derive(Debug, Clone, Default)]
struct Start {
    shares: LateralForceRatios,
    guess: Guess,
    pitch: [PitchState; 2],
    /// Moments of the left and the right wheel about `x` through the wheelset's centre over their vertical
    /// forces (m).
    levers: [f64; 2],
    /// Fine pressures.
    fine: Vec<PatchWarmStart>,
    friction: Vec<TractionWarmStart>,
    /// Where the wheels stand nearly, beside a position that was solved.
    places: Option<Vec<Place>>,
}

impl Start {
    /// With coarse pressures where they were sought, and what was known before.
    fn of(
        coarse: &[PressedWheel<'_>],
        wheels: &[PressedWheel<'_>],
        rolled: &[Rolled<'_>],
        pitch: [PitchState; 2],
        before: &Self,
    ) -> Self {
        let mut shares = LateralForceRatios::default();
        shares.scaled_as(&before.shares);
        for (one, rolled) in wheels.iter().flat_map(|wheel| &wheel.contacts).zip(rolled) {
            let contact = &one.contact;
            let friction = [rolled.force.lateral, rolled.force.longitudinal];
            shares.push(contact.side, contact.spot(), friction.map(|force| force / one.load()));
        }
        let roll = wheels.first().map(|wheel| wheel.position.roll);
        let mut guess = Guess { roll, ..before.guess.clone() };
        if !coarse.is_empty() {
            guess.known = PatchWarmStart::of(coarse);
        }
        for (coarse, fine) in coarse.iter().zip(wheels) {
            let scale = fine.vertical(&shares) / coarse.vertical(&shares);
            shares.set_scale(fine.side, scale);
        }
        for wheel in wheels.iter().filter(|wheel| wheel.depth > 0.0) {
            guess.depths[usize::from(wheel.side == Side::Right)] = wheel.depth;
        }
        let friction = TractionWarmStart::of(wheels, rolled);
        let levers = levers(wheels, rolled).unwrap_or(before.levers);
        Self {
            shares,
            guess,
            pitch,
            levers,
            fine: PatchWarmStart::of(wheels),
            friction,
            places: None,
        }
    }

    /// The same with friction halfway from what it was taken for.
    fn halfway_from(mut self, before: &LateralForceRatios) -> Self {
        self.shares.halfway_from(before);
        self
    }

    fn after(before: &SolvedWheelset) -> Self {
        let shares = LateralForceRatios::solved(before);
        let fine = PatchWarmStart::solved(before);
        let contacts = before.wheels().flat_map(SolvedWheel::contacts);
        let friction = contacts.filter_map(TractionWarmStart::of_fine_grid).collect();
        let mut guess = Guess { known: fine.clone(), ..Guess::default() };
        for wheel in before.wheels() {
            guess.roll = Some(wheel.position.roll);
            if wheel.depth > 0.0 {
                guess.depths[usize::from(wheel.side == Side::Right)] = wheel.depth;
            }
        }
        let (pitch, levers) = (before.pitch, [0.0; 2]);
        Self { shares, guess, pitch, levers, fine, friction, places: None }
    }
}

/// Moments of both wheels about `x` through the wheelset's centre over their vertical forces (m); `None` where
/// one carries nothing.
fn levers(wheels: &[PressedWheel<'_>], rolled: &[Rolled<'_>]) -> Option<[f64; 2]> {
    let mut rolled = rolled.iter();
    let mut lever = |wheel: &PressedWheel<'_>| {
        let Position { y, z, .. } = wheel.position;
        let centre = [0.0, y, z - wheel.radius];
        let (mut moment, mut vertical) = (0.0, 0.0);
        for pressed in &wheel.contacts {
            let (contact, friction) = (&pressed.contact, rolled.next()?.force);
            let acting = Acting::new(friction, pressed.load(), pressed.normal.centroid());
            let (force, about) = acting.about(contact.reference, contact.tilt(), centre);
            moment += about[0];
            vertical += force[2];
        }
        (vertical > 0.0).then(|| moment / vertical)
    };
    let [left, right] = wheels else { return None };
    Some([lever(left)?, lever(right)?])
}
