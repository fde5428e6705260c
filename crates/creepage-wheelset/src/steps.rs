//! Transient rolling of a wheelset in steps: each contact remembers its tractions from position to position.
//!
//! In each position contacts are found and pressed as in steady rolling. What rolled before goes on: tractions stay
//! where they are on the rail, and each element's goes with the contact that now lies nearest, so that areas grow,
//! move, split and join. In a plane that turns, components along its own axes are kept.

use std::sync::Arc;

use creepage::coulomb::Resolution;
use creepage::theory::AreaTheory;
use creepage::unsteady::{Before, Motion, Rolled, Rolling};
use creepage::{InvalidValue, SiCreepage};
use creepage_rail::{Contact, RollingCreepage, Side};

use crate::error::WheelsetError;
use crate::field::Field;
use crate::pose::{RigidSlip, WheelsetPose, WheelsetVelocity};
use crate::solved::{SolvedContact, SolvedWheelset};
use crate::solver::WheelsetSolver;
use crate::tilt::{Placed, distance};

/// Tractions from which wheels begin to roll.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StepsStart {
    /// Just pressed together, without traction.
    #[default]
    Pressed,
    /// As if they had rolled in the first position's motion for ever.
    Steady,
}

/// Counts of contacts that go on, begin, end, split or join from one position to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactChanges {
    /// Contacts where nothing was before: they begin without traction.
    pub appeared: usize,
    /// Contacts that ended: their tractions are lost.
    pub vanished: usize,
    /// Contacts whose tractions went to more than one.
    pub split: usize,
    /// Contacts with tractions of more than one before.
    pub joined: usize,
}

impl ContactChanges {
    /// Whether every contact goes on as one.
    #[must_use]
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }
}

/// State of the wheels at the end of a step.
#[derive(Debug, Clone)]
pub struct SteppedWheelset {
    /// Their contacts, with the forces, tractions and status of this moment. Heights under a given load, and what
    /// areas in planes of their own do to each other, are those of steady rolling.
    pub solved: SolvedWheelset,
    /// How its contacts follow from those of the step before; of the first step nothing changes.
    pub changes: ContactChanges,
}

/// A contact that moves with its wheel.
#[derive(Debug, Clone)]
struct Moving {
    contact: SolvedContact,
    rail_origin: [f64; 3],
    rolling: Rolling,
}

/// Wheels on rails that roll in steps.
///
/// ```
/// use creepage::theory::{AreaTheory, ExactOptions};
/// use creepage::{Solid, SolidPair};
/// use creepage_rail::{Place, Side, Standard, Track, Wheelset};
/// use creepage_wheelset::{
///     Load, PitchRate, RailFriction, StepsStart, WheelSteps, WheelsetPose, WheelsetSolver, WheelsetVelocity,
/// };
/// let track = Track::new(&Standard::Uic60.profile(), 0.025f64.atan(), Place::gauge(1.435, 0.014))?;
/// let running = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.360)?.on(track);
/// let steel = Solid::new(82e9, 0.28)?;
/// let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
/// let theory = AreaTheory::Exact(ExactOptions::default());
/// let solver = WheelsetSolver::new(&running, SolidPair::new(steel, steel), friction, theory)?;
/// let (side, load) = (Some(Side::Right), Some(Load::Wheel(50e3)));
/// let pose = WheelsetPose { side, y: 0.0, yaw: 0.0, roll: None, load };
/// let pitch = PitchRate::Rigid(Some(1.002 / 0.46));
/// let velocity = WheelsetVelocity { speed: 1.0, pitch, ..WheelsetVelocity::default() };
/// let mut wheels = WheelSteps::new(StepsStart::Pressed);
/// let along = |one: &creepage_wheelset::SteppedWheelset| one.solved.wheels().next().map(|w| w.on_rail().force[0]);
/// let first = wheels.step(&solver, &pose, &velocity, 1e-3)?;
/// let second = wheels.step(&solver, &pose, &velocity, 1e-3)?;
/// assert!(along(&second) < along(&first)); // the wheel drives: it pushes the rail back, more and more
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct WheelSteps {
    start: StepsStart,
    contacts: Vec<Moving>,
    last: Option<SolvedWheelset>,
}

impl WheelSteps {
    /// Before the first step.
    #[must_use]
    pub fn new(start: StepsStart) -> Self {
        Self { start, ..Self::default() }
    }

    /// Rolls on by `length` (m) of the track to a position, with the motion of that position; nothing is changed
    /// where it fails.
    ///
    /// # Errors
    /// [`WheelsetError`] as [`WheelsetSolver::solve`]; for a theory other than the full one, a pitch rate that is
    /// not given, wheels that run backwards, a rigid slip other than flat, and friction that falls with slip, which
    /// needs a memory that is not carried.
    pub fn step(
        &mut self,
        solver: &WheelsetSolver<'_>,
        pose: &WheelsetPose,
        velocity: &WheelsetVelocity,
        length: f64,
    ) -> Result<SteppedWheelset, WheelsetError> {
        let valid = "above zero and finite";
        if !(length > 0.0 && length.is_finite()) {
            return Err(wrong(InvalidValue { quantity: "distance", value: length, valid }));
        }
        if velocity.is_free() {
            return Err(WheelsetError::Steps { what: "need a given pitch_rate" });
        }
        if velocity.is_backward() || velocity.speed == 0.0 {
            return Err(WheelsetError::Steps { what: "roll forwards: speed above zero" });
        }
        let near = self.last.as_ref().and_then(|last| solver.next(last, pose, velocity).ok());
        let solved = match near {
            Some(solved) => solved,
            None => solver.solve(pose, velocity)?,
        };
        let resolution = resolution(&solved)?;
        let mut contacts = Vec::new();
        for wheel in solved.wheels() {
            let places = solver
                .running()
                .contacts(&wheel.position)
                .map_err(|source| WheelsetError::Position { side: wheel.side, source })?;
            for contact in wheel.contacts() {
                let (friction, law) = place_of(contact, &places)
                    .map_or(Ok((contact.friction, None)), |place| {
                        solver.friction_on(place).on(place, velocity.speed)
                    })?;
                if law.is_some_and(|law| law.falls()) {
                    let what = "have friction that does not fall with slip";
                    return Err(WheelsetError::Steps { what });
                }
                let rolling = Rolling::on_areas(&contact.normal, friction, law, resolution);
                let (contact, rail_origin) = (contact.clone(), wheel.rail_origin);
                contacts.push(Moving { contact, rail_origin, rolling: rolling.map_err(wrong)? });
            }
        }
        let changes = self.carry_to(&mut contacts);
        let starts_steady = self.last.is_none() && self.start == StepsStart::Steady;
        let rolled = contacts
            .iter_mut()
            .map(|moving| moving.roll(length / velocity.speed, starts_steady))
            .collect::<Result<Vec<_>, _>>()?;
        let stepped = solved_with(&solved, contacts.iter().zip(&rolled));
        (self.contacts, self.last) = (contacts, Some(solved));
        Ok(SteppedWheelset { solved: stepped, changes })
    }

    /// Gives new contacts the tractions of those before.
    fn carry_to(&self, contacts: &mut [Moving]) -> ContactChanges {
        if self.last.is_none() {
            return ContactChanges::default();
        }
        let places: Vec<Place> = contacts.iter().map(Place::of).collect();
        let taker = |old: &Moving, at: [f64; 2]| {
            let known = places.iter().enumerate();
            let near = known.filter_map(|(index, place)| Some((index, place.beyond(old, at)?)));
            near.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(index, _)| index)
        };
        let takers: Vec<Vec<usize>> = self
            .contacts
            .iter()
            .map(|old| {
                let mut takers: Vec<usize> =
                    old.centres().filter_map(|centre| taker(old, centre)).collect();
                takers.sort_unstable();
                takers.dedup();
                takers
            })
            .collect();
        let mut changes = ContactChanges {
            vanished: takers.iter().filter(|takers| takers.is_empty()).count(),
            split: takers.iter().filter(|takers| takers.len() > 1).count(),
            ..ContactChanges::default()
        };
        for (index, moving) in contacts.iter_mut().enumerate() {
            let olds = self.contacts.iter().zip(&takers).filter(|(_, all)| all.contains(&index));
            let olds: Vec<&Moving> = olds.map(|(old, _)| old).collect();
            changes.appeared += usize::from(olds.is_empty());
            changes.joined += usize::from(olds.len() > 1);
            let taker = &taker;
            let goes_on: Vec<_> =
                olds.iter().map(|&old| move |at: [f64; 2]| taker(old, at) == Some(index)).collect();
            let before = olds.iter().zip(&goes_on).map(|(old, goes_on)| Before {
                rolling: &old.rolling,
                scaling: old.contact.scaling,
                origin: places[index].seen(old, [0.0; 2]),
                goes_on,
            });
            let before: Vec<Before<'_>> = before.collect();
            moving.rolling.carry(moving.contact.scaling, &before);
        }
        changes
    }
}

impl Moving {
    /// Rolls on for a time (s).
    fn roll(&mut self, time: f64, starts_steady: bool) -> Result<Rolled, WheelsetError> {
        let RollingCreepage { longitudinal, lateral, spin, speed } = self.contact.creepage;
        let scaling = self.contact.scaling;
        let given = scaling.creepage(SiCreepage { longitudinal, lateral, spin });
        let motion = Motion::from(given.map_err(wrong)?);
        if starts_steady {
            self.rolling.start_steady(&motion).map_err(wrong)?;
        }
        self.rolling.step(speed * time / scaling.length, &motion).map_err(wrong)
    }

    /// Centres of its elements in its plane (m).
    fn centres(&self) -> impl Iterator<Item = [f64; 2]> {
        let length = self.contact.scaling.length;
        self.rolling.elements().into_iter().map(move |one| one.point.position.map(|x| length * x))
    }
}

/// Where a new contact lies, beside those before.
#[derive(Debug, Clone, Copy)]
struct Place {
    side: Side,
    is_on_guard: bool,
    /// From the origin of the rail's profile (m).
    reference: [f64; 3],
    axes: [[f64; 3]; 2],
    extent: [[f64; 2]; 2],
}

impl Place {
    fn of(moving: &Moving) -> Self {
        let Moving { contact, rail_origin, .. } = moving;
        let [along, across, _] = contact.tilt().axes();
        Self {
            side: contact.side,
            is_on_guard: contact.is_on_guard,
            reference: less(contact.reference, *rail_origin),
            axes: [along, across],
            extent: contact.extent(),
        }
    }

    /// A place of an old contact's plane in the new one (m): what lies on the rail stays there, along the track
    /// it moves with the wheel.
    fn seen(&self, old: &Moving, at: [f64; 2]) -> [f64; 2] {
        let place = less(less(old.contact.in_track(at), old.rail_origin), self.reference);
        self.axes.map(|axis| axis.iter().zip(place).map(|(a, p)| a * p).sum())
    }

    /// How far such a place lies beyond the new contact's areas (m); `None` where it is another rail, or farther
    /// off than these are long and wide.
    fn beyond(&self, old: &Moving, at: [f64; 2]) -> Option<f64> {
        if (old.contact.side, old.contact.is_on_guard) != (self.side, self.is_on_guard) {
            return None;
        }
        let seen = self.seen(old, at);
        let beyond: [f64; 2] = [0, 1].map(|k: usize| {
            let [low, high] = self.extent[k];
            (low - seen[k]).max(seen[k] - high).max(0.0)
        });
        let is_near = (0..2).all(|k| beyond[k] <= self.extent[k][1] - self.extent[k][0]);
        is_near.then_some(beyond[0].hypot(beyond[1]))
    }
}

fn less(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k: usize| one[k] - other[k])
}

fn wrong(invalid: InvalidValue) -> WheelsetError {
    WheelsetError::invalid("steps")(invalid)
}

/// As finely as the grid of the full theory.
fn resolution(solved: &SolvedWheelset) -> Result<Resolution, WheelsetError> {
    let AreaTheory::Exact(options) = solved.theory else {
        return Err(WheelsetError::Steps { what: "take theory = \"exact\"" });
    };
    if solved.slip != RigidSlip::Flat {
        return Err(WheelsetError::Steps { what: "take slip = \"flat\"" });
    }
    let (resolutions, _) = options.resolutions().map_err(WheelsetError::invalid("solve"))?;
    match resolutions[..] {
        [one] => Ok(one),
        _ => Err(WheelsetError::Steps { what: "take one resolution, not \"auto\"" }),
    }
}

/// The undeformed place of a contact.
fn place_of<'p, 'a>(contact: &SolvedContact, places: &'p [Contact<'a>]) -> Option<&'p Contact<'a>> {
    let spot = contact.spot();
    let apart = |place: &&Contact<'_>| distance(place.spot(), spot);
    let own = places.iter().filter(|place| place.side == contact.side);
    own.min_by(|one, other| apart(one).total_cmp(&apart(other)))
}

/// A wheelset with the forces of its contacts as they rolled.
fn solved_with<'m>(
    steady: &SolvedWheelset,
    contacts: impl Iterator<Item = (&'m Moving, &'m Rolled)>,
) -> SolvedWheelset {
    let mut solved = steady.clone();
    let mut contacts = contacts;
    for wheel in solved.left.iter_mut().chain(&mut solved.right) {
        wheel.force_error = None;
        // Contacts stand in the order of the wheels'.
        for (contact, (moving, rolled)) in wheel.contacts_mut().iter_mut().zip(&mut contacts) {
            let scaling = contact.scaling;
            let solution = rolled.solution;
            contact.force = scaling.si_force(solution.force);
            contact.force_error = solution.error.map(|error| scaling.si_force(error));
            contact.status = solution.status;
            contact.dissipation = Some(scaling.force * scaling.slip * rolled.dissipation);
            contact.solution = solution;
            contact.correction = None;
            if let Some(tractions) = contact.tractions().map(Arc::clone) {
                contact.field = Field::Exact(moving.rolling.elements(), tractions);
            }
        }
    }
    solved
}
