//! Tangential solution on contacts whose pressure is known.

use std::sync::Arc;

use creepage::approximate::non_hertzian::{NonHertzianSimplified, Simplified, SimplifiedSolved};
use creepage::coulomb::{NonHertzian, NonHertzianSolved, Resolution, TangentialWarmStart};
use creepage::friction_law::RollingFriction;
use creepage::theory::{Jacobian, Solved};
use creepage::{Scaling, SiCreepage, SiForce, Solution};
use creepage_rail::{Contact, Motion, Position, RollingCreepage, Side};
use rayon::prelude::*;

use super::WheelsetSolver;
use super::cross_patch::in_track;
use super::normal_contact::{PressedContact, PressedWheel};
use crate::WheelsetError;
use crate::correction::Correction;
use crate::curving::{Curving, RigidMotion};
use crate::pose::RigidSlip;
use crate::resultant::ContactForces;
use crate::solved::SolvedContact;
use crate::tilt::{Placed, distance};

/// Tangential theory, and its resolution.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Method {
    Exact(Resolution),
    /// With cells in each row along rolling and rows in the widest area.
    Simplified(Simplified, [usize; 2]),
}

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

    pub(super) fn scaling(&self) -> Scaling {
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
    pub(super) theory: Prepared,
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
    pub(super) fn along_track(&self, force: SiForce) -> f64 {
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
