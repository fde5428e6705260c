//! The contacts of a wheelset solved: where it stands under its load, what presses on each
//! contact, how it rolls there.

mod apart;
mod balance;
mod by_motion;
mod curving;
mod derivative;
mod found;
mod partial;
mod pressed;
mod rolled;
mod root;
mod step;

use creepage::SolidPair;
use creepage::normal;
use creepage::theory::{ExactOptions, NamedResolution, ResolutionSpec};
use creepage_rail::{Motion, Running, Side};
use rayon::prelude::*;

use self::balance::{Balance, Guess, enough};
use self::pressed::{Known, Press, Shares};
use self::rolled::{Method, Rolling};
use self::step::Place;
use super::case::{Load, RigidSlip, Stance, Travel, WheelsetCase};
use super::derivatives::WheelsetDerivatives;
use super::error::{WheelsetError, section};
use super::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::case::CaseError;
use crate::gap::{GapTheory, resolutions};

pub(super) use self::pressed::{Pressed, PressedWheel};
pub(super) use self::rolled::{Pitch, Rolled};

/// A wheelset on its track, prepared to be solved in many positions.
#[derive(Debug, Clone)]
pub struct WheelsetSolver<'a> {
    press: Press<'a>,
    friction: f64,
    slip: RigidSlip,
    theory: GapTheory,
    rolling: Vec<Method>,
    accuracy: f64,
}

impl WheelsetCase {
    /// Prepares to solve this wheelset in its position and others.
    ///
    /// # Errors
    /// [`WheelsetError`] where materials or friction are missing, or the theory is not one that
    /// solves contacts of any shape.
    pub fn solver(&self) -> Result<WheelsetSolver<'_>, WheelsetError> {
        let theory = GapTheory::new(&self.theory);
        let theory = theory.map_err(|error| WheelsetError::Theory(Box::new(error)))?;
        let pair = self.solids.ok_or_else(|| section("materials", "shear_modulus, poisson"))?;
        let friction = self.friction.ok_or_else(|| section("contact", "friction"))?;
        let solver = WheelsetSolver::new(&self.running, pair, friction, theory)?;
        Ok(WheelsetSolver { slip: self.slip, ..solver })
    }

    /// Derivatives of the forces on the rails where this wheelset was solved, by what the case gives
    /// of its position and motion.
    ///
    /// # Errors
    /// As [`WheelsetSolver::derivatives`].
    pub fn derivatives(
        &self,
        solved: &SolvedWheelset,
    ) -> Result<WheelsetDerivatives, WheelsetError> {
        let travel = self.travel.ok_or_else(|| section("motion", "speed"))?;
        self.solver()?.derivatives(solved, &self.stance, &travel)
    }

    /// Solves this wheelset.
    ///
    /// # Errors
    /// As [`WheelsetCase::solver`] and [`WheelsetSolver::solve`], and where load or motion are
    /// missing.
    pub fn solve(&self) -> Result<SolvedWheelset, WheelsetError> {
        let travel = self.travel.ok_or_else(|| section("motion", "speed"))?;
        let mut solved = self.solver()?.solve(&self.stance, &travel)?;
        if let Some(wanted) = &self.damage {
            solved.add_damage(wanted, self.running.wheelset().radius());
        }
        Ok(solved)
    }
}

impl<'a> WheelsetSolver<'a> {
    /// Prepares wheels and rails of materials `pair` (wheel above rail) and a coefficient of
    /// friction.
    ///
    /// # Errors
    /// [`CaseError`] for options out of range.
    pub fn new(
        running: &'a Running,
        pair: SolidPair,
        friction: f64,
        theory: GapTheory,
    ) -> Result<Self, CaseError> {
        let (resolution, rolling, accuracy) = match theory {
            GapTheory::Exact(options) => {
                let (resolutions, accuracy) = resolutions(options)?;
                let rolling = resolutions.into_iter().map(Method::Exact).collect();
                (pressed_by(options), rolling, accuracy)
            }
            GapTheory::Simplified(kind, cells) => {
                (normal::Resolution::STANDARD, vec![Method::Simplified(kind, cells)], 0.0)
            }
        };
        let press = Press { running, pair, resolution };
        Ok(Self { press, friction, slip: RigidSlip::Flat, theory, rolling, accuracy })
    }

    /// Solves the wheelset where it stands, as it moves.
    ///
    /// # Errors
    /// [`WheelsetError`] where no load is given, wheels and rails do not meet, or nothing carries
    /// the load.
    pub fn solve(&self, stance: &Stance, travel: &Travel) -> Result<SolvedWheelset, WheelsetError> {
        let load = match stance.load {
            Some(Load::Wheel(load)) => Some(load),
            Some(Load::Axle(load)) => Some(if stance.side.is_some() { load } else { 0.5 * load }),
            Some(Load::Height(_)) | None => None,
        };
        let Press { running, pair, .. } = self.press;
        let modulus = pair.shear_modulus() / (1.0 - pair.poisson());
        let radius = running.wheelset().radius();
        let guess = load.map(|load| Guess::under_load(load, modulus, radius)).unwrap_or_default();
        self.from(stance, travel, &Start { guess, ..Start::default() })
    }

    /// The same from a position nearby that was solved before: quicker.
    ///
    /// # Errors
    /// As [`WheelsetSolver::solve`].
    pub fn next(
        &self,
        before: &SolvedWheelset,
        stance: &Stance,
        travel: &Travel,
    ) -> Result<SolvedWheelset, WheelsetError> {
        self.from(stance, travel, &Start::after(before).beside(before, stance))
    }

    fn from(
        &self,
        stance: &Stance,
        travel: &Travel,
        start: &Start,
    ) -> Result<SolvedWheelset, WheelsetError> {
        let load = stance.load.ok_or(WheelsetError::NoLoad)?;
        let (last, first) = self.rolling.split_last().unwrap_or((&Method::STANDARD, &[]));
        for method in first {
            let solved = self.at(stance, travel, load, start.clone(), *method)?;
            if solved.worst_error() <= self.accuracy {
                return Ok(solved);
            }
        }
        self.at(stance, travel, load, start.clone(), *last)
    }

    /// The position is sought with coarse pressures, or taken from one nearby. At each position found fine
    /// ones and rolling say what the wheels carry, and their stiffness where to go on to, until they
    /// carry what was expected.
    fn at(
        &self,
        stance: &Stance,
        travel: &Travel,
        load: Load,
        mut start: Start,
        method: Method,
    ) -> Result<SolvedWheelset, WheelsetError> {
        const ROUNDS: usize = 28;
        /// Rounds after which they might swing to and fro.
        const FEW: usize = 12;
        /// To which part a load is met: far within its error bar.
        const MET: f64 = 3e-5;
        /// A step that leaves more than this part of what was missed is followed by a search, or by
        /// rolling.
        const HELPS: f64 = 0.5;
        let is_given = matches!(load, Load::Height(_)) && stance.is_fixed();
        let radius = self.press.running.wheelset().radius();
        let mut stages = method.stages();
        let is_beside = start.places.is_some();
        stages.drain(..if is_given || is_beside { stages.len() - 1 } else { 0 });
        let mut places = std::mem::take(&mut start.places);
        let (mut last, mut rolled_by) = (f64::INFINITY, None);
        for round in 0..ROUNDS {
            let mut sought = match places.take() {
                Some(places) => Sought { places, coarse: Vec::new() },
                None => self.sought(stance, load, &start.shares, &start.guess)?,
            };
            let wheels = match (!is_given).then(|| self.refined(&sought, &start.fine)) {
                None => sought.coarse.clone(),
                Some(Err(_)) if is_beside && round == 0 => continue,
                Some(wheels) => wheels?,
            };
            // Friction is known nearly: no rolling before the load is met.
            let missed = sought.missed(&wheels, &start.shares);
            if is_beside && rolled_by.is_none() && missed > MET && missed < HELPS * last {
                last = missed;
                sought.learn(&wheels, &start.shares, round > 0);
                places = step::places((&sought.places, &wheels), stance, load, &start.shares);
                start.fine = Known::of(&wheels);
                continue;
            }
            let (method, good_enough) = stages.first().copied().unwrap_or((method, 0.0));
            let rollings = Rolling::all(&wheels, self.friction, self.slip, method)?;
            let (motion, rolled, pitch) = rolled::motion(&rollings, travel, radius, start.pitch)?;
            let next = Start::of(&sought.coarse, &wheels, &rolled, pitch, &start);
            let carried: f64 = wheels.iter().map(|wheel| wheel.vertical(&next.shares)).sum();
            let missed = sought.missed(&wheels, &next.shares);
            // Fine pressures that depend on where they began scatter within their error bars.
            let within = if round < FEW { 0.0 } else { error_of_load(&wheels) / carried };
            if is_given || (stages.len() == 1 && missed <= enough(round).max(MET).max(within)) {
                return Ok(self.solved(&wheels, &rollings, &rolled, (motion, pitch)));
            }
            sought.learn(&wheels, &next.shares, rolled_by == Some(stages.len()));
            if round < FEW && (missed < HELPS * last || rolled_by.is_none()) {
                places = step::places((&sought.places, &wheels), stance, load, &next.shares);
            }
            (last, rolled_by) = (missed, Some(stages.len()));
            if stages.len() > 1 && (missed < good_enough || round >= FEW) {
                stages.remove(0);
                last = f64::INFINITY;
            }
            start = if round < FEW { next } else { next.halfway_from(&start.shares) };
        }
        Err(WheelsetError::NotSettled)
    }

    /// Where wheels carry the load, by coarse pressures unless nothing is to be sought.
    fn sought(
        &self,
        stance: &Stance,
        load: Load,
        shares: &Shares,
        guess: &Guess,
    ) -> Result<Sought<'a>, WheelsetError> {
        let coarse = Press { resolution: normal::Resolution::COARSE, ..self.press };
        let is_given = matches!(load, Load::Height(_)) && stance.is_fixed();
        let press = if is_given { &self.press } else { &coarse };
        let balance = Balance { press, stance, shares, guess: guess.clone() };
        let coarse = balance.wheels(load)?;
        Ok(Sought { places: Place::of(&coarse, stance, load, shares), coarse })
    }

    /// Wheels in their places with fine pressures.
    fn refined(
        &self,
        sought: &Sought<'a>,
        known: &[Known],
    ) -> Result<Vec<PressedWheel<'a>>, WheelsetError> {
        let coarse = Known::of(&sought.coarse);
        let known = if known.is_empty() { &coarse } else { known };
        let fine = |&Place { side, position, depth, .. }: &Place| {
            Ok(PressedWheel { depth, ..self.press.wheel(side, position, known)? })
        };
        sought.places.par_iter().map(fine).collect()
    }

    fn solved(
        &self,
        wheels: &[PressedWheel<'_>],
        rollings: &[Rolling<'_, '_>],
        rolled: &[Rolled<'_>],
        found: (Motion, Pitch),
    ) -> SolvedWheelset {
        let solved = |wheel: &PressedWheel<'_>| {
            let all = rollings.iter().zip(rolled);
            let own = all.filter(|(rolling, _)| rolling.wheel.side == wheel.side);
            let contacts =
                own.map(|(one, rolled)| SolvedContact::new(one.pressed, rolled, self.friction));
            SolvedWheel::new(wheel, self.press.running, contacts.collect())
        };
        let wheels = wheels.iter().map(solved).collect();
        SolvedWheelset::new(wheels, found, self.friction, self.slip, self.theory)
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

/// The error bar of the load of all contacts (N).
fn error_of_load(wheels: &[PressedWheel<'_>]) -> f64 {
    let contacts = wheels.iter().flat_map(|wheel| &wheel.contacts);
    contacts.map(|one| one.normal.load().error).sum()
}

/// Where the wheels should carry their load.
struct Sought<'a> {
    places: Vec<Place>,
    /// What the search found there; nothing after a step.
    coarse: Vec<PressedWheel<'a>>,
}

impl Sought<'_> {
    fn learn(&mut self, wheels: &[PressedWheel<'_>], shares: &Shares, is_like: bool) {
        let pairs = self.places.iter_mut().zip(wheels);
        pairs.for_each(|(place, wheel)| place.learn(wheel, shares, is_like));
    }

    /// What wheels carry more or less than expected, in parts of what they carry.
    fn missed(&self, wheels: &[PressedWheel<'_>], shares: &Shares) -> f64 {
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

/// What a solved position tells of those nearby.
#[derive(Debug, Clone, Default)]
struct Start {
    shares: Shares,
    guess: Guess,
    pitch: Pitch,
    /// Fine pressures.
    fine: Vec<Known>,
    /// Where the wheels stand nearly.
    places: Option<Vec<Place>>,
}

impl Start {
    /// With coarse pressures where they were sought, and what was known before.
    fn of(
        coarse: &[PressedWheel<'_>],
        wheels: &[PressedWheel<'_>],
        rolled: &[Rolled<'_>],
        pitch: Pitch,
        before: &Self,
    ) -> Self {
        let mut shares = Shares::default();
        shares.scaled_as(&before.shares);
        for (one, rolled) in wheels.iter().flat_map(|wheel| &wheel.contacts).zip(rolled) {
            let contact = &one.contact;
            shares.push(contact.side, contact.y_rail, rolled.force.lateral / one.load());
        }
        let roll = wheels.first().map(|wheel| wheel.position.roll);
        let mut guess = Guess { roll, ..before.guess.clone() };
        if !coarse.is_empty() {
            guess.known = Known::of(coarse);
        }
        for (coarse, fine) in coarse.iter().zip(wheels) {
            let scale = fine.vertical(&shares) / coarse.vertical(&shares);
            shares.set_scale(fine.side, scale);
        }
        for wheel in wheels.iter().filter(|wheel| wheel.depth > 0.0) {
            guess.depths[usize::from(wheel.side == Side::Right)] = wheel.depth;
        }
        Self { shares, guess, pitch, fine: Known::of(wheels), places: None }
    }

    /// The same with friction halfway from what it was taken for.
    fn halfway_from(mut self, before: &Shares) -> Self {
        self.shares.halfway_from(before);
        self
    }

    fn after(before: &SolvedWheelset) -> Self {
        let mut shares = Shares::default();
        let mut fine = Vec::new();
        for contact in before.wheels().flat_map(SolvedWheel::contacts) {
            shares.push(contact.side, contact.y_rail, contact.force.lateral / contact.load());
            fine.push(Known::new(contact.side, contact.y_rail, &contact.normal));
        }
        let mut guess = Guess { known: fine.clone(), ..Guess::default() };
        for wheel in before.wheels() {
            guess.roll = Some(wheel.position.roll);
            if wheel.depth > 0.0 {
                guess.depths[usize::from(wheel.side == Side::Right)] = wheel.depth;
            }
        }
        Self { shares, guess, pitch: before.pitch, fine, places: None }
    }

    /// The same where the wheels hardly go up or down since.
    fn beside(mut self, before: &SolvedWheelset, stance: &Stance) -> Self {
        self.places = step::beside(before, stance);
        self
    }
}
