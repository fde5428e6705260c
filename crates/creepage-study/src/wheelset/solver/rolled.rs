//! Rolling on the contacts of a wheelset whose pressure is known.

use std::sync::Arc;

use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified, SimplifiedSolved};
use creepage::coulomb::{NearTractions, NonHertzian, NonHertzianSolved, Resolution};
use creepage::theory::{Jacobian, Solved};
use creepage::{Scaling, SiCreepage, SiForce, Solution};
use creepage_rail::{Contact, Motion, RollingCreepage, Side};
use rayon::prelude::*;

use super::apart::in_track;
use super::pressed::{Pressed, PressedWheel};
use super::root::Root;
use crate::case::CaseError;
use crate::wheelset::case::RigidSlip;
use crate::wheelset::correction::Correction;
use crate::wheelset::curving::{Curving, RigidMotion};
use crate::wheelset::nearby::Pitch;
use crate::wheelset::solved::SolvedContact;
use crate::{Travel, WheelsetError};

/// By which theory contacts roll, and how finely.
#[derive(Debug, Clone, Copy)]
pub(super) enum Method {
    Exact(Resolution),
    /// With cells in each row along rolling and rows in the widest area.
    Simplified(Simplified, [usize; 2]),
}

/// Of the moment of all friction about the axle, in parts of what it could be: as small beside its error bar
/// as what a load may miss.
pub(super) const BALANCED: f64 = 1e-5;

impl Method {
    pub(super) const STANDARD: Self = Self::Exact(Resolution::STANDARD);

    /// Methods that come nearer to this one, and down to which part of the load missed each is good enough:
    /// the loads follow from friction, which `fastsim` tells a hundred times quicker than the full theory.
    pub(super) fn stages(self) -> Vec<(Self, f64)> {
        match self {
            Self::Exact(_) => vec![
                (Self::Simplified(Simplified::Fastsim, [20, 10]), 5e-3),
                (Self::Exact(Resolution::FAST), 2.5e-3),
                (self, 0.0),
            ],
            Self::Simplified(..) => vec![(self, 0.0)],
        }
    }
}

/// A theory prepared for a contact.
#[derive(Debug)]
pub(super) enum Prepared {
    Exact(Box<NonHertzian>),
    Simplified(Arc<NonHertzianSimplified>),
}

/// A contact rolled.
#[derive(Debug)]
pub(super) enum Answer<'r> {
    Exact(Box<NonHertzianSolved<'r>>),
    Simplified(SimplifiedSolved<'r>, &'r Arc<NonHertzianSimplified>),
}

impl Prepared {
    fn new(pressed: &Pressed<'_>, friction: f64, method: Method) -> Result<Self, CaseError> {
        let normal = &pressed.normal;
        Ok(match method {
            Method::Exact(resolution) => {
                let theory = NonHertzian::new(normal, friction, resolution);
                Self::Exact(Box::new(theory.map_err(CaseError::invalid("contact"))?))
            }
            Method::Simplified(kind, cells) => {
                let theory = NonHertzianSimplified::new(normal, friction, kind, cells);
                Self::Simplified(Arc::new(theory.map_err(CaseError::invalid("solve"))?))
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
        near: Option<&NearTractions>,
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
                solved.go_on(creepage, more);
                solved
            }
            (_, Some(near)) => Box::new(theory.solve_near(creepage, more, near)),
            (_, None) => Box::new(theory.solve_curved(creepage, more)),
        })
    }
}

/// The friction on a contact in a position close by.
#[derive(Debug, Clone)]
pub(super) struct KnownFriction {
    side: Side,
    y_rail: f64,
    tractions: Arc<NearTractions>,
    /// How a coarse grid is corrected.
    pub(super) correction: Option<Arc<Correction>>,
}

impl KnownFriction {
    /// That of a solved contact by its fine grid, where the theory has tractions.
    pub(super) fn of_fine_grid(contact: &SolvedContact) -> Option<Self> {
        let tractions = match &contact.correction {
            Some(correction) => &correction.tractions,
            None => contact.tractions()?,
        };
        let tractions = Arc::clone(tractions);
        Some(Self { side: contact.side, y_rail: contact.y_rail, tractions, correction: None })
    }

    /// That of a solved contact by its coarse grid, where that was corrected.
    pub(super) fn of_coarse_grid(contact: &SolvedContact) -> Option<Self> {
        let correction = Some(Arc::clone(contact.correction.as_ref()?));
        let tractions = Arc::clone(contact.tractions()?);
        Some(Self { side: contact.side, y_rail: contact.y_rail, tractions, correction })
    }

    /// That of some wheels.
    pub(super) fn of(wheels: &[PressedWheel<'_>], rolled: &[Rolled<'_>]) -> Vec<Self> {
        let contacts = wheels.iter().flat_map(|wheel| &wheel.contacts).zip(rolled);
        contacts.filter_map(|(pressed, rolled)| Self::of_rolled(&pressed.contact, rolled)).collect()
    }

    pub(super) fn of_rolled(contact: &Contact<'_>, rolled: &Rolled<'_>) -> Option<Self> {
        let Answer::Exact(solved) = &rolled.solved else { return None };
        let tractions = Arc::new(solved.tractions());
        let correction = rolled.correction.clone();
        Some(Self { side: contact.side, y_rail: contact.y_rail, tractions, correction })
    }

    /// That next to a contact.
    fn next_to(contact: &Contact<'_>, all: &[Self]) -> Option<Self> {
        let own = all.iter().filter(|known| known.side == contact.side);
        let distance = |known: &Self| (known.y_rail - contact.y_rail).abs();
        own.min_by(|a, b| distance(a).total_cmp(&distance(b))).cloned()
    }
}

impl Answer<'_> {
    pub(super) fn as_solved(&self) -> &dyn Solved {
        match self {
            Self::Exact(solved) => &**solved,
            Self::Simplified(solved, _) => solved,
        }
    }

    /// The derivative of its force by the creepage.
    pub(super) fn jacobian(&mut self) -> Option<Jacobian> {
        match self {
            Self::Exact(solved) => solved.jacobian(),
            Self::Simplified(solved, _) => solved.jacobian(),
        }
    }
}

/// A contact prepared for rolling.
#[derive(Debug)]
pub(super) struct Rolling<'w, 'a> {
    pub(super) wheel: &'w PressedWheel<'a>,
    pub(super) pressed: &'w Pressed<'a>,
    theory: Prepared,
    pub(super) slip: RigidSlip,
    near: Option<KnownFriction>,
}

/// The same, rolled.
#[derive(Debug)]
pub(super) struct Rolled<'r> {
    pub(super) motion: RigidMotion,
    pub(super) creepage: RollingCreepage,
    pub(super) scaling: Scaling,
    pub(super) solved: Answer<'r>,
    /// The force with its moment about the reference point, in units and in SI.
    pub(super) solution: Solution,
    pub(super) force: SiForce,
    /// Frictional power, where the theory has it.
    pub(super) power: Option<f64>,
    /// How its coarse grid was corrected.
    pub(super) correction: Option<Arc<Correction>>,
}

impl<'w, 'a> Rolling<'w, 'a> {
    pub(super) fn all(
        wheels: &'w [PressedWheel<'a>],
        friction: f64,
        slip: RigidSlip,
        (method, known): (Method, &[KnownFriction]),
    ) -> Result<Vec<Self>, WheelsetError> {
        let contacts =
            wheels.iter().flat_map(|wheel| wheel.contacts.iter().map(move |one| (wheel, one)));
        contacts
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|(wheel, pressed)| {
                let theory = Prepared::new(pressed, friction, method)?;
                let near = KnownFriction::next_to(&pressed.contact, known);
                Ok(Self { wheel, pressed, theory, slip, near })
            })
            .collect()
    }

    /// Rolls in a motion; from `before` in one nearby.
    pub(super) fn roll<'r>(
        &'r self,
        motion: &Motion,
        before: Option<Rolled<'r>>,
    ) -> Result<Rolled<'r>, WheelsetError> {
        let contact = &self.pressed.contact;
        let creepage = self.creepage(motion)?;
        let RollingCreepage { longitudinal, lateral, spin, .. } = creepage;
        let scaling = self.theory.scaling();
        let given = scaling.creepage(SiCreepage { longitudinal, lateral, spin });
        let given = given.map_err(CaseError::invalid("motion"))?;
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
        Ok(Rolled { motion, creepage, scaling, solved, solution, force, power, correction })
    }

    pub(super) fn creepage(&self, motion: &Motion) -> Result<RollingCreepage, WheelsetError> {
        let contact = &self.pressed.contact;
        contact.creepage(motion).ok_or(WheelsetError::NotForward { side: contact.side })
    }

    pub(super) fn scaling(&self) -> Scaling {
        self.theory.scaling()
    }

    /// Elements of the full theory.
    pub(super) fn elements(&self) -> usize {
        match &self.theory {
            Prepared::Exact(theory) => theory.elements(),
            Prepared::Simplified(_) => 0,
        }
    }

    /// Moment of the friction about the axle (N m), positive when it turns the wheelset forward
    /// seen from the rail: pressure has none, for a wheel's normals meet its axle.
    pub(super) fn axle_moment(&self, force: SiForce) -> f64 {
        let contact = &self.pressed.contact;
        let (sin, cos) = contact.angle.sin_cos();
        let [x, y, z] = in_track(contact, [0.0; 2]);
        let arm = [x, y - self.wheel.position.y, z - self.centre_height()];
        let [fx, fy, fz] = [force.longitudinal, force.lateral * cos, force.lateral * sin];
        let moment = [
            arm[1] * fz - arm[2] * fy,
            arm[2] * fx - arm[0] * fz - force.moment * sin,
            arm[0] * fy - arm[1] * fx + force.moment * cos,
        ];
        let axle = self.axle();
        moment.iter().zip(axle).map(|(m, a)| m * a).sum()
    }

    fn centre_height(&self) -> f64 {
        self.wheel.position.z - self.wheel.radius
    }

    /// Direction of the axle, to the right.
    fn axle(&self) -> [f64; 3] {
        let position = self.wheel.position;
        let ((sin, cos), (sin_roll, cos_roll)) = (position.yaw.sin_cos(), position.roll.sin_cos());
        [-sin, cos * cos_roll, cos * sin_roll]
    }
}

/// The motion of a wheelset with its pitch rate: the given one, or that at which friction has no
/// moment about the axle, or no more than `enough` of what it could be; how its contacts roll then, and
/// what a position nearby may start from.
pub(super) fn motion<'r>(
    rollings: &'r [Rolling<'_, '_>],
    travel: &Travel,
    radius: f64,
    (guess, enough): (Pitch, f64),
) -> Result<(Motion, Vec<Rolled<'r>>, Pitch), WheelsetError> {
    const STEPS: usize = 60;
    /// Of the rate of a wheel that rolls on its nominal circle.
    const NARROW: f64 = 1e-13;
    let Travel { speed, pitch_rate, lateral_velocity, vertical_velocity, roll_rate, yaw_rate } =
        *travel;
    let others =
        Motion { lateral_velocity, vertical_velocity, roll_rate, yaw_rate, ..Motion::default() };
    let with = |pitch_rate| Motion { speed, pitch_rate, ..others };
    let at = |motion: Motion, before: Vec<Rolled<'r>>| {
        let mut before: Vec<_> = before.into_iter().map(Some).collect();
        before.resize_with(rollings.len(), || None);
        let pairs = rollings.par_iter().zip(before);
        let rolled = pairs.map(|(one, before)| one.roll(&motion, before));
        let rolled = rolled.collect::<Result<Vec<_>, WheelsetError>>()?;
        let pitch = Pitch { rate: Some(motion.pitch_rate), slope: guess.slope };
        Ok::<_, WheelsetError>((motion, rolled, pitch))
    };
    let nominal = speed / radius;
    if let Some(rate) = pitch_rate {
        return at(with(rate), Vec::new());
    }
    if rollings.is_empty() {
        return at(with(nominal), Vec::new());
    }
    let most: f64 = rollings.iter().map(|r| r.theory.scaling().force * radius).sum();
    // A slip unit of creepage is about what it takes for a force unit.
    let by_slip = |r: &Rolling<'_, '_>| {
        2.0 * r.theory.scaling().force / r.theory.scaling().slip * radius * radius / speed
    };
    let slope = guess.slope.unwrap_or_else(|| rollings.iter().map(by_slip).sum());
    let mut search = Root::new(guess.rate.unwrap_or(nominal), [0.2 * nominal, 5.0 * nominal]);
    let mut before = Vec::new();
    for _ in 0..STEPS {
        let (motion, rolled, pitch) = at(with(search.at), before)?;
        // A wheel that turns faster drags the rail back.
        let moments = rollings.iter().zip(&rolled);
        let moment: f64 = moments.map(|(one, rolled)| -one.axle_moment(rolled.force)).sum();
        let is_found = moment.abs() < enough * most;
        if is_found || search.is_spent(NARROW * nominal) {
            let known = search.slope().or(guess.slope);
            search.next_by_chord(moment, slope);
            let rate = if is_found { Some(search.at) } else { pitch.rate };
            return Ok((motion, rolled, Pitch { rate, slope: known }));
        }
        search.next_by_chord(moment, slope);
        before = rolled;
    }
    Err(WheelsetError::PitchNotFound)
}
