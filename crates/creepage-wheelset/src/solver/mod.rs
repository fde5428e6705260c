//! Wheelset solver: equilibrium under the load, pressure of each contact, and rolling there.

mod continuation;
mod cross_patch;
mod derivative;
mod equilibrium;
mod error_propagation;
mod excess;
mod implicit_derivative;
mod motion_derivative;
mod normal_contact;
mod pitch_rate;
mod pose_derivative;
mod predictor;
mod solution;
mod start;
mod tangential;
mod vertical_load;

use creepage::SolidPair;
use creepage::normal;
use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec};
use creepage_rail::{Position, Side, WheelsetOnTrack};

use self::equilibrium::settle;
use self::normal_contact::NormalSolver;
pub use self::normal_contact::PressedContacts;
use self::start::Start;

use self::tangential::Method;
pub(crate) use self::vertical_load::{LoadLine, Target};
use crate::error::WheelsetError;
use crate::friction::{RailFriction, of_side};
use crate::pose::{Load, Patches, RigidSlip, WheelsetPose, WheelsetVelocity};
use crate::solved::SolvedWheelset;
use crate::warm_start::PredictorCorrection;

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
        self.from(stance, travel, &self.start())
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
        if hangs(stance) || before.is_reversed != travel.is_backward() {
            return self.solve(stance, travel);
        }
        if travel.is_backward() {
            self.check_backward()?;
            let before = before.clone().fore_and_aft();
            let solved = self.next(&before, &stance.fore_and_aft(), &travel.fore_and_aft())?;
            return Ok(solved.fore_and_aft());
        }
        let Some((start, expected)) = self.beside(before, stance) else {
            return self.from(stance, travel, &self.far_from(before));
        };
        let mut solved = self.from(stance, travel, &start)?;
        solved.drift = Some(PredictorCorrection::new(&expected, before, &solved, stance));
        Ok(solved)
    }

    /// What a solved position tells of one beside it, and where the wheels were expected there by the
    /// undeformed bodies alone; `None` where it is farther off.
    fn beside(
        &self,
        before: &SolvedWheelset,
        stance: &WheelsetPose,
    ) -> Option<(Start, Vec<Position>)> {
        let start = self.after(before);
        let target = Target::new(stance, start.levers).ok()?;
        let places = predictor::places(before, stance, self.press.running, &target)?;
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

    /// By one method after another until the wanted accuracy is met, each from where the one before ended.
    fn by_methods(
        &self,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
        start: &Start,
    ) -> Result<SolvedWheelset, WheelsetError> {
        let (last, first) = self.rolling.split_last().unwrap_or((&Method::STANDARD, &[]));
        let mut start = start.clone();
        for method in first {
            let solved = settle(self, stance, travel, start.clone(), *method)?;
            if solved.worst_error() <= self.accuracy {
                return Ok(solved);
            }
            if !hangs(stance)
                && let Some((here, _)) = self.beside(&solved, stance)
            {
                start = here;
            }
        }
        settle(self, stance, travel, start, *last)
    }
}

/// Whether a wheel is to carry nothing: it has no place to go on from.
fn hangs(stance: &WheelsetPose) -> bool {
    matches!(stance.load, Some(Load::Wheels(loads)) if loads.contains(&0.0))
}

/// How finely bodies are pressed that roll by the full theory with these options.
fn pressed_by(options: ExactOptions) -> normal::Resolution {
    match options.resolution {
        ResolutionSpec::Named(NamedResolution::Fast) => normal::Resolution::FAST,
        ResolutionSpec::Named(NamedResolution::Fine) => normal::Resolution::FINE,
        _ => normal::Resolution::STANDARD,
    }
}
