//! Tangential solution on contacts whose pressure is known, and the search for the pitch rate.

use std::sync::Arc;

use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified, SimplifiedSolved};
use creepage::coulomb::{NonHertzian, NonHertzianSolved, Resolution, TangentialWarmStart};
use creepage::friction_law::RollingFriction;
use creepage::numerics::Root;
use creepage::theory::{Jacobian, Solved};
use creepage::{Scaling, SiCreepage, SiForce, Solution};
use creepage_rail::{Contact, Motion, Position, RollingCreepage, Side};
use rayon::prelude::*;

use super::WheelsetSolver;
use super::cross_patch::in_track;
use super::normal_contact::{PressedContact, PressedWheel};
use crate::correction::Correction;
use crate::curving::{Curving, RigidMotion};
use crate::pose::{Drive, PitchRate, RigidSlip};
use crate::resultant::ContactForces;
use crate::solved::SolvedContact;
use crate::tilt::{Placed, distance};
use crate::warm_start::PitchState;
use crate::{WheelsetError, WheelsetVelocity};

/// Tangential theory, and its resolution.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Method {
    Exact(Resolution),
    /// With cells in each row along rolling and rows in the widest area.
    Simplified(Simplified, [usize; 2]),
}

/// Of the moment of all friction about the axle, in parts of what it could be: as small beside its error bar
/// as what a load may miss.
pub(crate) const BALANCED: f64 = 1e-5;

impl Method {
    pub(crate) const STANDARD: Self = Self::Exact(Resolution::STANDARD);
}

/// A theory prepared for a contact.
#[derive(Debug)]
pub(crate) enum Prepared {
    Exact(Box<NonHertzian>),
    Simplified(Arc<NonHertzianSimplified>),
}

/// Solution of rolling on one contact.
#[derive(Debug)]
pub(crate) enum Answer<'r> {
    Exact(Box<NonHertzianSolved<'r>>),
    Simplified(SimplifiedSolved<'r>, &'r Arc<NonHertzianSimplified>),
}

impl Prepared {
    fn new(
        pressed: &PressedContact<'_>,
        (friction, law): (f64, Option<RollingFriction>),
        method: Method,
    ) -> Result<Self, WheelsetError> {
        let contact = creepage::Contact::of_areas(pressed.normal.clone(), friction);
        let contact = contact.map_err(WheelsetError::invalid("contact"))?;
        let contact = match law {
            Some(law) => contact.with_rolling_friction(law),
            None => contact,
        };
        Ok(match method {
            Method::Exact(resolution) => {
                let theory = NonHertzian::on(&contact, resolution);
                Self::Exact(Box::new(theory.map_err(WheelsetError::invalid("contact"))?))
            }
            Method::Simplified(kind, cells) => {
                let theory = NonHertzianSimplified::on(&contact, kind, cells);
                Self::Simplified(Arc::new(theory.map_err(WheelsetError::invalid("solve"))?))
            }
        })
    }

    fn scaling(&self) -> Scaling {
        match self {
            Self::Exact(theory) => theory.scaling(),
            Self::Simplified(theory) => theory.scaling(),
        }
    }

    /// From an answer to another motion, or from tractions close by. Simplified theories have one rigid
    /// slip in each row.
    fn roll<'r>(
        &'r self,
        motion: &RigidMotion,
        before: Option<Answer<'r>>,
        near: Option<&TangentialWarmStart>,
    ) -> Answer<'r> {
        let (creepage, more) = (motion.creepage, |at| motion.more(at));
        let theory = match self {
            Self::Exact(theory) => theory,
            Self::Simplified(theory) => {
                let solved = theory.solve_curved(creepage, |y| more([0.0, y]));
                return Answer::Simplified(solved, theory);
            }
        };
        Answer::Exact(match (before, near) {
            (Some(Answer::Exact(mut solved)), _) => {
                solved.resolve_at(creepage, more);
                solved
            }
            (_, Some(near)) => Box::new(theory.solve_near(creepage, more, near)),
            (_, None) => Box::new(theory.solve_curved(creepage, more)),
        })
    }
}

/// Warm start of a contact's tractions, from a position close by.
#[derive(Debug, Clone)]
pub(crate) struct TractionWarmStart {
    side: Side,
    spot: [f64; 2],
    tractions: Arc<TangentialWarmStart>,
    /// How a coarse grid is corrected.
    pub(crate) correction: Option<Arc<Correction>>,
}

impl TractionWarmStart {
    /// That of a solved contact by its fine grid, where the theory has tractions.
    pub(crate) fn of_fine_grid(contact: &SolvedContact) -> Option<Self> {
        let tractions = match &contact.correction {
            Some(correction) => &correction.tractions,
            None => contact.tractions()?,
        };
        let tractions = Arc::clone(tractions);
        Some(Self { side: contact.side, spot: contact.spot(), tractions, correction: None })
    }

    /// That of a solved contact by its coarse grid, where that was corrected.
    pub(crate) fn of_coarse_grid(contact: &SolvedContact) -> Option<Self> {
        let correction = Some(Arc::clone(contact.correction.as_ref()?));
        let tractions = Arc::clone(contact.tractions()?);
        Some(Self { side: contact.side, spot: contact.spot(), tractions, correction })
    }

    /// That of some wheels.
    pub(crate) fn of(wheels: &[PressedWheel<'_>], rolled: &[Rolled<'_>]) -> Vec<Self> {
        let contacts = wheels.iter().flat_map(|wheel| &wheel.contacts).zip(rolled);
        contacts.filter_map(|(pressed, rolled)| Self::of_rolled(&pressed.contact, rolled)).collect()
    }

    pub(crate) fn of_rolled(contact: &Contact<'_>, rolled: &Rolled<'_>) -> Option<Self> {
        let Answer::Exact(solved) = &rolled.solved else { return None };
        let tractions = Arc::new(solved.tractions());
        let correction = rolled.correction.clone();
        Some(Self { side: contact.side, spot: contact.spot(), tractions, correction })
    }

    /// That next to a contact.
    fn next_to(contact: &Contact<'_>, all: &[Self]) -> Option<Self> {
        let own = all.iter().filter(|known| known.side == contact.side);
        let distance = |known: &Self| distance(known.spot, contact.spot());
        own.min_by(|a, b| distance(a).total_cmp(&distance(b))).cloned()
    }
}

impl Answer<'_> {
    pub(crate) fn as_solved(&self) -> &dyn Solved {
        match self {
            Self::Exact(solved) => &**solved,
            Self::Simplified(solved, _) => solved,
        }
    }

    /// The derivative of its force by the creepage.
    pub(crate) fn jacobian(&mut self) -> Option<Jacobian> {
        match self {
            Self::Exact(solved) => solved.jacobian(),
            Self::Simplified(solved, _) => solved.jacobian(),
        }
    }
}

/// A contact prepared for rolling.
#[derive(Debug)]
pub(crate) struct Rolling<'w, 'a> {
    pub(crate) wheel: &'w PressedWheel<'a>,
    pub(crate) pressed: &'w PressedContact<'a>,
    theory: Prepared,
    pub(crate) slip: RigidSlip,
    /// The largest coefficient of friction.
    friction: f64,
    /// The theory's name, where friction falls with the speed of slip and it does not follow that.
    at_rest: Option<&'static str>,
    near: Option<TractionWarmStart>,
}

/// Contact with the solution of its rolling.
#[derive(Debug)]
pub(crate) struct Rolled<'r> {
    pub(crate) motion: RigidMotion,
    pub(crate) creepage: RollingCreepage,
    pub(crate) scaling: Scaling,
    pub(crate) solved: Answer<'r>,
    /// The force with its moment about the reference point, in units and in SI.
    pub(crate) solution: Solution,
    pub(crate) force: SiForce,
    /// Frictional power, where the theory has it.
    pub(crate) power: Option<f64>,
    /// How its coarse grid was corrected.
    pub(crate) correction: Option<Arc<Correction>>,
    /// The largest coefficient of friction.
    pub(crate) friction: f64,
    /// As of [`Rolling`].
    pub(crate) at_rest: Option<&'static str>,
}

impl<'w, 'a> Rolling<'w, 'a> {
    pub(crate) fn all(
        wheels: &'w [PressedWheel<'a>],
        solver: &WheelsetSolver<'_>,
        speed: f64,
        (method, known): (Method, &[TractionWarmStart]),
    ) -> Result<Vec<Self>, WheelsetError> {
        let WheelsetSolver { slip, .. } = solver;
        let contacts =
            wheels.iter().flat_map(|wheel| wheel.contacts.iter().map(move |one| (wheel, one)));
        contacts
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|(wheel, pressed)| {
                let resistance =
                    solver.friction_on(&pressed.contact).on(&pressed.contact, speed)?;
                let theory = Prepared::new(pressed, resistance, method)?;
                let near = TractionWarmStart::next_to(&pressed.contact, known);
                let (friction, law) = resistance;
                let falls = law.is_some_and(|law| law.falls());
                let is_left_out = falls && matches!(theory, Prepared::Simplified(_));
                let at_rest = is_left_out.then(|| solver.theory.name());
                Ok(Self { wheel, pressed, theory, slip: *slip, friction, at_rest, near })
            })
            .collect()
    }

    /// Rolls in a motion; from `before` in one nearby.
    pub(crate) fn roll<'r>(
        &'r self,
        motion: &Motion,
        before: Option<Rolled<'r>>,
    ) -> Result<Rolled<'r>, WheelsetError> {
        let contact = &self.pressed.contact;
        let creepage = self.creepage(motion)?;
        let RollingCreepage { longitudinal, lateral, spin, .. } = creepage;
        let scaling = self.theory.scaling();
        let given = scaling.creepage(SiCreepage { longitudinal, lateral, spin });
        let given = given.map_err(WheelsetError::invalid("motion"))?;
        let curving = match self.slip {
            RigidSlip::Flat => None,
            RigidSlip::Curved => Some(Curving::new(contact, motion, creepage)),
        };
        let motion = RigidMotion { creepage: given, scaling, curving };
        let before = before.map(|rolled| rolled.solved);
        let solved =
            self.theory.roll(&motion, before, self.near.as_ref().map(|near| &*near.tractions));
        let (mut solution, mut power) =
            (solved.as_solved().solution(), solved.as_solved().dissipation());
        let correction = self.near.as_ref().and_then(|near| near.correction.clone());
        if let Some(correction) = &correction {
            (solution, power) = correction.corrected(solution, power);
        }
        let force = scaling.si_force(solution.force);
        let Self { friction, at_rest, .. } = *self;
        Ok(Rolled {
            motion,
            creepage,
            scaling,
            solved,
            solution,
            force,
            power,
            correction,
            friction,
            at_rest,
        })
    }

    pub(crate) fn creepage(&self, motion: &Motion) -> Result<RollingCreepage, WheelsetError> {
        let contact = &self.pressed.contact;
        contact.creepage(motion).ok_or(WheelsetError::NotForward { side: contact.side })
    }

    pub(crate) fn scaling(&self) -> Scaling {
        self.theory.scaling()
    }

    /// Elements of the full theory.
    pub(crate) fn elements(&self) -> usize {
        match &self.theory {
            Prepared::Exact(theory) => theory.elements(),
            Prepared::Simplified(_) => 0,
        }
    }

    /// Moment of the friction about the axle (N m), positive when it turns the wheelset forward
    /// seen from the rail: pressure has none, for the normals of a round wheel meet its axle. Those of a wheel
    /// that varies do not, and its pressure counts.
    pub(crate) fn axle_moment(&self, force: SiForce) -> f64 {
        let contact = &self.pressed.contact;
        if contact.varies() {
            let load = if contact.wheel_varies() { self.pressed.load() } else { 0.0 };
            let acting = ContactForces::new(force, load, self.pressed.normal.centroid());
            let (_, moment) = acting.about(contact.reference, contact.tilt(), self.centre());
            return moment.iter().zip(self.axle()).map(|(m, a)| m * a).sum();
        }
        let (sin, cos) = contact.angle.sin_cos();
        let [x, y, z] = in_track(contact, [0.0; 2]);
        let [_, centre_y, centre_z] = self.centre();
        let arm = [x, y - centre_y, z - centre_z];
        let [fx, fy, fz] = [force.longitudinal, force.lateral * cos, force.lateral * sin];
        let moment = [
            arm[1] * fz - arm[2] * fy,
            arm[2] * fx - arm[0] * fz - force.moment * sin,
            arm[0] * fy - arm[1] * fx + force.moment * cos,
        ];
        let axle = self.axle();
        moment.iter().zip(axle).map(|(m, a)| m * a).sum()
    }

    /// Force on the rail along the track (N): of the friction, and of the pressure where its normal leans.
    fn along_track(&self, force: SiForce) -> f64 {
        let [along, across, normal] = self.pressed.contact.tilt().axes();
        force.longitudinal * along[0] + force.lateral * across[0] + self.pressed.load() * normal[0]
    }

    /// The wheelset's centre in track axes.
    pub(crate) fn centre(&self) -> [f64; 3] {
        let Position { y, z, .. } = self.wheel.position;
        [0.0, y, z - self.wheel.radius]
    }

    fn axle(&self) -> [f64; 3] {
        axle(self.wheel.position)
    }
}

/// Direction of the axle in track axes, to the right.
pub(crate) fn axle(position: Position) -> [f64; 3] {
    let ((sin, cos), (sin_roll, cos_roll)) = (position.yaw.sin_cos(), position.roll.sin_cos());
    [-sin, cos * cos_roll, cos * sin_roll]
}

/// Pitch rate of the wheels, with their contacts' rolling at it.
pub(crate) struct Turning<'r> {
    /// Of the left and of the right wheel.
    pub(crate) motions: [Motion; 2],
    pub(crate) rolled: Vec<Rolled<'r>>,
    /// What a position nearby may start from, of both wheels.
    pub(crate) pitch: [PitchState; 2],
}

/// Rolls in a motion with its pitch rates: given ones, or those at which friction balances the torque, or
/// pulls as wanted, to `moment_tolerance` of what it could.
pub(crate) fn turning<'r>(
    rollings: &'r [Rolling<'_, '_>],
    travel: &WheelsetVelocity,
    radius: f64,
    (guess, moment_tolerance): ([PitchState; 2], f64),
) -> Result<Turning<'r>, WheelsetError> {
    match travel.pitch {
        PitchRate::Rigid(rate) => {
            let search = PitchSearch { travel, rate, radius, guess: guess[0], moment_tolerance };
            let (motion, rolled, pitch) = search.run(rollings)?;
            Ok(Turning { motions: [motion; 2], rolled, pitch: [pitch; 2] })
        }
        PitchRate::Independent(rates) => {
            let count = rollings.iter().filter(|one| one.wheel.side == Side::Left).count();
            let (left, right) = rollings.split_at(count);
            let search = |k: usize| PitchSearch {
                travel,
                rate: rates[k],
                radius,
                guess: guess[k],
                moment_tolerance,
            };
            let (on_left, mut rolled, pitch_left) = search(0).run(left)?;
            let (on_right, more, pitch_right) = search(1).run(right)?;
            rolled.extend(more);
            let (motions, pitch) = ([on_left, on_right], [pitch_left, pitch_right]);
            Ok(Turning { motions, rolled, pitch })
        }
    }
}

/// The search for the pitch rate of wheels that turn together.
struct PitchSearch<'t> {
    travel: &'t WheelsetVelocity,
    rate: Option<f64>,
    radius: f64,
    guess: PitchState,
    moment_tolerance: f64,
}

impl PitchSearch<'_> {
    const MAX_STEPS: usize = 60;
    /// Of the rate of a wheel that rolls on its nominal circle: the narrowest bracket.
    const NARROW: f64 = 1e-13;
    /// The same: between these every wheel slides.
    const BRACKET: [f64; 2] = [0.2, 5.0];

    fn motion(&self, pitch_rate: f64) -> Motion {
        let WheelsetVelocity {
            speed,
            lateral_velocity,
            vertical_velocity,
            roll_rate,
            yaw_rate,
            ..
        } = *self.travel;
        let WheelsetVelocity { curvature, rails, .. } = *self.travel;
        Motion {
            speed,
            pitch_rate,
            lateral_velocity,
            vertical_velocity,
            roll_rate,
            yaw_rate,
            curvature,
            rails,
        }
    }

    fn at<'r>(
        &self,
        rollings: &'r [Rolling<'_, '_>],
        rate: f64,
        before: Vec<Rolled<'r>>,
    ) -> Result<(Motion, Vec<Rolled<'r>>, PitchState), WheelsetError> {
        let motion = self.motion(rate);
        let mut before: Vec<_> = before.into_iter().map(Some).collect();
        before.resize_with(rollings.len(), || None);
        let pairs = rollings.par_iter().zip(before);
        let rolled = pairs.map(|(one, before)| one.roll(&motion, before));
        let rolled = rolled.collect::<Result<Vec<_>, WheelsetError>>()?;
        Ok((motion, rolled, PitchState { rate: Some(rate), slope: self.guess.slope }))
    }

    fn run<'r>(
        &self,
        rollings: &'r [Rolling<'_, '_>],
    ) -> Result<(Motion, Vec<Rolled<'r>>, PitchState), WheelsetError> {
        let nominal = self.travel.speed / self.radius;
        if let Some(rate) = self.rate {
            return self.at(rollings, rate, Vec::new());
        }
        let most = self.most(rollings);
        if rollings.is_empty() {
            return match self.travel.drive {
                Drive::Torque(wanted) | Drive::Force(wanted) if wanted != 0.0 => {
                    Err(WheelsetError::TractionNotFound { wanted, most })
                }
                _ => self.at(rollings, nominal, Vec::new()),
            };
        }
        let slope = self.guess.slope.unwrap_or_else(|| self.first_slope(rollings));
        let bracket = Self::BRACKET.map(|times| times * nominal);
        let mut search = Root::new(self.guess.rate.unwrap_or(nominal), bracket);
        let mut before = Vec::new();
        for _ in 0..Self::MAX_STEPS {
            let (motion, rolled, pitch) = self.at(rollings, search.at, before)?;
            let excess = self.excess(rollings, &rolled);
            let is_found = excess.abs() < self.moment_tolerance * most;
            if is_found || search.is_spent(Self::NARROW * nominal) {
                if !is_found && bracket.iter().any(|end| (search.at / end - 1.0).abs() < 1e-6) {
                    let (Drive::Torque(wanted) | Drive::Force(wanted)) = self.travel.drive;
                    return Err(WheelsetError::TractionNotFound { wanted, most });
                }
                let known = search.slope().or(self.guess.slope);
                search.next_by_chord(excess, slope);
                let rate = if is_found { Some(search.at) } else { pitch.rate };
                return Ok((motion, rolled, PitchState { rate, slope: known }));
            }
            search.next_by_chord(excess, slope);
            before = rolled;
        }
        Err(WheelsetError::PitchNotFound)
    }

    /// The largest moment or force that friction can have.
    fn most(&self, rollings: &[Rolling<'_, '_>]) -> f64 {
        let lever = match self.travel.drive {
            Drive::Torque(_) => self.radius,
            Drive::Force(_) => 1.0,
        };
        rollings
            .iter()
            .map(|one| one.theory.scaling().force * lever)
            .fold(0.0, |sum, one| sum + one)
    }

    /// How much more friction holds the wheels back than wanted: rises with the pitch rate, for a wheel that
    /// turns faster drags the rail back.
    fn excess(&self, rollings: &[Rolling<'_, '_>], rolled: &[Rolled<'_>]) -> f64 {
        match self.travel.drive {
            Drive::Torque(torque) => {
                let pairs = rollings.iter().zip(rolled);
                let moment =
                    |(one, rolled): (&Rolling<'_, '_>, &Rolled<'_>)| -one.axle_moment(rolled.force);
                pairs.map(moment).sum::<f64>() - torque
            }
            Drive::Force(force) => {
                let pairs = rollings.iter().zip(rolled);
                force - pairs.map(|(one, rolled)| one.along_track(rolled.force)).sum::<f64>()
            }
        }
    }

    /// Change of the excess with the pitch rate, about: a slip unit of creepage is what it takes for a force
    /// unit.
    fn first_slope(&self, rollings: &[Rolling<'_, '_>]) -> f64 {
        let lever = match self.travel.drive {
            Drive::Torque(_) => self.radius,
            Drive::Force(_) => 1.0,
        };
        let by_slip = |one: &Rolling<'_, '_>| {
            let Scaling { force, slip, .. } = one.theory.scaling();
            2.0 * force / slip * self.radius * lever / self.travel.speed
        };
        rollings.iter().map(by_slip).sum()
    }
}
