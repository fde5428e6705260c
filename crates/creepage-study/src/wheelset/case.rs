//! Case of a wheelset, every number of it checked.

use std::path::PathBuf;

use creepage::{SolidPair, TheorySpec};
use creepage_rail::file::Action;
use creepage_rail::{Side, WheelsetOnTrack};

use creepage::theory::AreaTheory;
use creepage_wheelset::{
    ASKED, Patches, RailFriction, RailSprings, RigidSlip, SolvedWheelset, StepsStart,
    WheelsetDerivatives, WheelsetPose, WheelsetSolver, WheelsetVelocity, asked,
};

use super::error::{WheelsetFileError, section};
use super::report::WheelsetReport;
use super::vehicle::VehicleInCurve;
use crate::case::CaseError;
use crate::{DamageWanted, HeatWanted, Sources};

/// A wheelset in its track.
#[derive(Debug, Clone)]
pub struct WheelsetCase {
    /// Wheels and rails.
    pub running: WheelsetOnTrack,
    /// Where the wheelset stands.
    pub stance: WheelsetPose,
    /// The vehicle that gives its loads by speed and curve, where the file has it.
    pub vehicle: Option<VehicleInCurve>,
    /// How it moves, where that is given.
    pub travel: Option<WheelsetVelocity>,
    /// Wheel and rail, where their materials are given.
    pub solids: Option<SolidPair>,
    /// Friction on the left and the right rail, where it is given.
    pub friction: Option<[RailFriction; 2]>,
    /// Friction on the left and the right guard rail, where it differs from that of the rail.
    pub guard_friction: [Option<RailFriction>; 2],
    /// Springs of the left and the right rail, where they lie on any.
    pub springs: [Option<RailSprings>; 2],
    /// What the surfaces slide by before they deform.
    pub slip: RigidSlip,
    /// Whether areas in planes of their own feel each other.
    pub patches: Patches,
    /// The laws of wear and fatigue, where their numbers are wanted.
    pub damage: Option<DamageWanted>,
    /// What is wanted of temperatures; wheels are the upper bodies.
    pub heat: Option<HeatWanted>,
    /// From which tractions wheels begin that roll in steps.
    pub start: StepsStart,
    /// The theory and its options.
    pub theory: TheorySpec,
    /// Profile files, and what had to be found in them.
    pub notes: Vec<ProfileNote>,
}

impl WheelsetCase {
    /// The profile files it was read from.
    #[must_use]
    pub fn sources(&self) -> Sources {
        Sources::new(self.notes.iter().map(|note| &note.path))
    }
}

/// A profile's file, and what was found in it that nobody had said.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileNote {
    /// The file.
    pub path: PathBuf,
    /// What was found, assumed and done.
    pub actions: Vec<Action>,
}

impl WheelsetCase {
    /// Prepares to solve this wheelset in its position and others.
    ///
    /// # Errors
    /// [`WheelsetFileError`] where materials or friction are missing, the theory is not one that
    /// solves contacts of any shape, or rails lie on springs.
    pub fn solver(&self) -> Result<WheelsetSolver<'_>, WheelsetFileError> {
        if self.is_sprung() {
            return Err(WheelsetFileError::RigidRails {
                what: "a position by itself, with derivatives or in rows,",
            });
        }
        self.solver_on_rails()
    }

    /// Whether a rail has a guard rail beside it.
    pub(super) fn is_guarded(&self) -> bool {
        let is_there = |side| self.running.track().rail(side).guard().is_some();
        [Side::Left, Side::Right].into_iter().any(is_there)
    }

    /// Refuses surfaces that vary along rolling.
    pub(super) fn is_alike_along(&self, what: &'static str) -> Result<(), WheelsetFileError> {
        if self.running.varies() { Err(WheelsetFileError::Varies { what }) } else { Ok(()) }
    }

    /// Its wheels and rails at another place along the track (m), the wheels turned on by `pitch` (rad); NaN is the
    /// case's own.
    ///
    /// # Errors
    /// [`WheelsetFileError`] for numbers that are infinite.
    pub fn place(&self, s: f64, pitch: f64) -> Result<WheelsetOnTrack, WheelsetFileError> {
        let own = self.running.place();
        let or = |value: f64, own: f64| if value.is_nan() { own } else { value };
        let running = self.running.clone().at(or(s, own[0]), or(pitch, own[1]));
        running.map_err(WheelsetFileError::geometry("wheelset"))
    }

    /// The same at such a place.
    ///
    /// # Errors
    /// As [`WheelsetCase::place`].
    pub fn at(&self, s: f64, pitch: f64) -> Result<Self, WheelsetFileError> {
        Ok(Self { running: self.place(s, pitch)?, ..self.clone() })
    }

    /// Whether a rail that is asked for lies on springs.
    pub(super) fn is_sprung(&self) -> bool {
        let is_there = |side: Side| self.stance.side.is_none_or(|alone| alone == side);
        let [left, right] = self.springs;
        (left.is_some() && is_there(Side::Left)) || (right.is_some() && is_there(Side::Right))
    }

    /// The position and the motion of numbers as of [`ASKED`]; NaN is the wheelset's own. Loads that follow from a
    /// vehicle's statics are those at the speed asked for.
    ///
    /// # Errors
    /// [`WheelsetFileError`] for numbers that are not finite or contradict each other or the file.
    pub fn asked(
        &self,
        numbers: &[f64; ASKED.len()],
    ) -> Result<(WheelsetPose, WheelsetVelocity), WheelsetFileError> {
        self.asked_in_curve(numbers, f64::NAN)
    }

    /// The same in a curve of this curvature (1/m); NaN is the wheelset's own.
    ///
    /// # Errors
    /// As [`WheelsetCase::asked`].
    pub(super) fn asked_in_curve(
        &self,
        numbers: &[f64; ASKED.len()],
        curvature: f64,
    ) -> Result<(WheelsetPose, WheelsetVelocity), WheelsetFileError> {
        let own = self.travel.unwrap_or_default();
        let curvature = if curvature.is_nan() { own.curvature } else { curvature };
        let travel = WheelsetVelocity { curvature, ..own };
        let (mut pose, travel) = asked((self.stance, travel), numbers)?;
        let Some(vehicle) = &self.vehicle else { return Ok((pose, travel)) };
        let is_given = |key: &str| {
            ASKED.iter().zip(numbers).any(|(name, value)| *name == key && !value.is_nan())
        };
        if let Some(key) = ["axle_load", "roll_moment"].into_iter().find(|key| is_given(key)) {
            let [first, second] = ["mass", key].map(|key| ("wheelset", key));
            return Err(CaseError::Conflict { first, second }.into());
        }
        if !is_given("z") {
            pose.load = Some(vehicle.load(travel.speed, travel.curvature)?);
        }
        Ok((pose, travel))
    }

    fn solver_on_rails(&self) -> Result<WheelsetSolver<'_>, WheelsetFileError> {
        let theory = AreaTheory::new(&self.theory);
        let theory = theory.map_err(|error| WheelsetFileError::Theory(Box::new(error.into())))?;
        let pair = self.solids.ok_or_else(|| section("materials", "shear_modulus, poisson"))?;
        let friction = self.friction.clone().ok_or_else(|| section("contact", "friction"))?;
        let solver = WheelsetSolver::new(&self.running, pair, friction, theory)?;
        let solver = solver.with_guard_friction(self.guard_friction.clone());
        Ok(solver.with_model(self.slip, self.patches))
    }

    /// Derivatives of the forces on the rails where this wheelset was solved, by what the case gives
    /// of its position and motion.
    ///
    /// # Errors
    /// As [`WheelsetSolver::derivatives`].
    pub fn derivatives(
        &self,
        solved: &SolvedWheelset,
    ) -> Result<WheelsetDerivatives, WheelsetFileError> {
        let travel = self.travel.ok_or_else(|| section("motion", "speed"))?;
        Ok(self.solver()?.derivatives(solved, &self.stance, &travel)?)
    }

    /// Solves this wheelset.
    ///
    /// # Errors
    /// As [`WheelsetCase::solver`] and [`WheelsetSolver::solve`], and where load or motion are
    /// missing.
    pub fn solve(&self) -> Result<WheelsetReport, WheelsetFileError> {
        let travel = self.travel.ok_or_else(|| section("motion", "speed"))?;
        let solver = self.solver_on_rails()?;
        let solved = if self.is_sprung() {
            solver.solve_on_springs(&self.springs, &self.stance, &travel)?
        } else {
            solver.solve(&self.stance, &travel)?
        };
        let mut solved = WheelsetReport::from(solved);
        if let Some(wanted) = &self.damage {
            solved.add_damage(wanted, self.running.wheelset().radius());
        }
        if let Some(wanted) = &self.heat {
            solved.add_heat(wanted, self.theory.facts().name);
        }
        Ok(solved)
    }
}
