//! A wheelset solved: its contacts, what they do to the rails, what may be off.

use std::borrow::Cow;
use std::sync::Arc;

use creepage::coulomb::{ElementField, NearTractions};
use creepage::normal::NormalContact;
use creepage::{Scaling, SiCreepage, SiForce, Solution, Status, normal};
use creepage_rail::{Motion, Position, RollingCreepage, Side};

use super::case::RigidSlip;
use super::correction::Correction;
use super::derivatives::WheelsetDerivatives;
use super::field::Field;
use super::nearby::{Drift, Pitch};
use super::resultant::{Acting, Resultant};
use crate::{Caution, Damage, GapTheory, Heat, adhesion};

/// A wheelset whose contacts are solved.
#[derive(Debug, Clone)]
pub struct SolvedWheelset {
    /// The left wheel; `None` where the right one was solved alone.
    pub left: Option<SolvedWheel>,
    /// The right wheel; `None` where the left one was solved alone.
    pub right: Option<SolvedWheel>,
    /// How it moves, with the pitch rate that was given or found; of independent wheels their mean, each of
    /// which has its own: [`SolvedWheel::pitch_rate`].
    pub motion: Motion,
    /// Whether each wheel turns by itself.
    pub is_independent: bool,
    /// Whether it runs backwards: then contacts have their `x` along the track still, and the areas that
    /// [`SolvedContact::normal`] holds are those of the mirror image fore and aft.
    pub is_reversed: bool,
    /// Coefficient of friction, the largest where it varies.
    pub friction: f64,
    /// What the surfaces slide by before they deform.
    pub slip: RigidSlip,
    /// The theory of rolling.
    pub theory: GapTheory,
    /// How its forces change with its position and motion, where that was asked for:
    /// [`WheelsetCase::derivatives`](crate::WheelsetCase::derivatives).
    pub derivatives: Option<WheelsetDerivatives>,
    /// Mean nominal radius of the wheels (m).
    pub(super) radius: f64,
    /// Where a position nearby finds its pitch rates.
    pub(super) pitch: [Pitch; 2],
    /// How it came to stand elsewhere than was expected from the position before, if there was one.
    pub(super) drift: Option<Drift>,
}

/// One wheel of a solved wheelset.
#[derive(Debug, Clone)]
pub struct SolvedWheel {
    /// Its side of the track.
    pub side: Side,
    /// Where the wheelset stands for it.
    pub position: Position,
    /// Its angular velocity about the axle (rad/s).
    pub pitch_rate: f64,
    /// How far its wheel would have to go down to touch (m), where it touches nothing.
    pub clearance: Option<f64>,
    /// How far its rail gave way on its springs, to the right and down (m), where it lies on any.
    pub deflection: Option<[f64; 2]>,
    /// How far it was brought down from first touch to carry its load (m); zero where its height
    /// was given.
    pub(super) depth: f64,
    /// How its vertical force was found to change as the wheelset goes down (N/m) and rolls (N/rad).
    pub(super) by: Option<[f64; 2]>,
    /// Origin of the rail's profile in track axes (m).
    pub rail_origin: [f64; 3],
    pub(super) contacts: Vec<SolvedContact>,
}

/// One place of contact, in one plane: mostly one area, several where they lie close together.
///
/// Its axes are `x` forward, `s = (cos angle, sin angle)` in the track's `(y, z)`, and the normal
/// into the rail; its forces are those of the wheel on the rail.
#[derive(Debug, Clone)]
pub struct SolvedContact {
    /// Its side of the track.
    pub side: Side,
    /// The reference point in track axes (m), on the rail.
    pub reference: [f64; 3],
    /// Rotation about `x` from the track's `z` to the normal into the rail (rad).
    pub angle: f64,
    /// `y` of the reference point in the rail's profile (m), to the field side.
    pub y_rail: f64,
    /// `y` of the reference point in the wheel's profile (m), to the field side.
    pub y_wheel: f64,
    /// Pressure and areas, in the contact plane about the reference point.
    pub normal: NormalContact,
    /// How far its load may be off (N): that of the pressure where it stands, and what its wheel may
    /// stand too high or too low where that was sought under a given load.
    pub load_error: f64,
    /// Creepage and spin at the reference point.
    pub creepage: RollingCreepage,
    /// Tangential force, with the moment about the normal through the reference point.
    pub force: SiForce,
    /// Its error bars, where the theory has them.
    pub force_error: Option<SiForce>,
    /// Whether rolling was solved.
    pub status: Status,
    /// Energy turned to heat per metre rolled (J/m), from traction and slip.
    pub dissipation: Option<f64>,
    /// The units of what its elements hold.
    pub scaling: Scaling,
    /// Wear and fatigue numbers, where `[damage]` asks for them.
    pub damage: Option<Damage>,
    /// Temperatures, where `[heat]` asks for them.
    pub heat: Option<Heat>,
    /// What is to be held against them.
    pub(super) heat_caution: Option<Caution>,
    pub(super) is_reversed: bool,
    /// The largest coefficient of friction.
    pub(super) friction: f64,
    /// The theory's name, where friction falls with the speed of slip and it takes that at rest.
    pub(super) at_rest: Option<&'static str>,
    /// By how much the rail's surface turns from one side of its areas to the other (rad).
    pub(super) turn: f64,
    /// Its friction in these units.
    pub(super) solution: Solution,
    /// How its coarse grid was corrected, where it followed a position nearby.
    pub(super) correction: Option<Arc<Correction>>,
    pub(super) field: Field,
    /// What is to be held against the profiles.
    pub(super) rough: Vec<Caution>,
}

impl SolvedContact {
    /// Normal force (N).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.normal.load().value
    }

    /// What it does to the rail, with the moment about `point`.
    fn on_rail(&self, point: [f64; 3]) -> Resultant {
        let (sin, cos) = self.angle.sin_cos();
        let load = self.normal.load();
        let acting = Acting::new(self.force, load.value, self.centre_of_pressure());
        let (force, moment) = acting.about(self.reference, self.angle, point);
        let force_error = self.force_error.map(|error| {
            [
                error.longitudinal,
                (error.lateral * cos).abs() + (self.load_error * sin).abs(),
                (error.lateral * sin).abs() + (load.error * cos).abs(),
            ]
        });
        Resultant { force, force_error, moment }
    }

    /// Its elements.
    #[must_use]
    pub fn elements(&self) -> Cow<'_, [ElementField]> {
        let elements = self.field.elements();
        if self.is_reversed {
            return elements.iter().map(ElementField::fore_and_aft).collect();
        }
        elements
    }

    /// The centre of pressure in the contact plane (m), from the reference point.
    #[must_use]
    pub fn centre_of_pressure(&self) -> [f64; 2] {
        let [x, s] = self.normal.centroid();
        [if self.is_reversed { -x } else { x }, s]
    }

    /// Its mirror image fore and aft.
    fn fore_and_aft(mut self) -> Self {
        self.is_reversed = !self.is_reversed;
        self.reference[0] = -self.reference[0];
        self.force = SiForce {
            longitudinal: -self.force.longitudinal,
            moment: -self.force.moment,
            ..self.force
        };
        self.creepage = RollingCreepage {
            longitudinal: -self.creepage.longitudinal,
            spin: -self.creepage.spin,
            ..self.creepage
        };
        self
    }

    /// From which a position close by may start, where the theory has them.
    pub(super) fn tractions(&self) -> Option<&Arc<NearTractions>> {
        self.field.tractions()
    }

    /// Adhesion area over contact area, 0 to 1.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        adhesion::share(&self.elements())
    }

    /// What is to be held against its solution.
    #[must_use]
    pub fn cautions(&self) -> Vec<Caution> {
        let RollingCreepage { longitudinal, lateral, spin, .. } = self.creepage;
        let creepage = SiCreepage { longitudinal, lateral, spin };
        let kappa_over_mu = self.normal.pair().kappa() / self.friction;
        let status = (self.status != Status::Solved).then_some(Caution::Status(self.status));
        let slides = Caution::large_creepage(creepage).map(Caution::of_a_wheel);
        let peak = self.normal.peak_pressure().value;
        let shear_yield = self.damage.as_ref().map(|damage| peak / damage.peak_over_shear_yield);
        let yields = Caution::yields(peak, self.normal.pair().shear_modulus(), shear_yield);
        let at_rest = self.at_rest.map(|theory| Caution::ConstantFriction { theory });
        let all = status
            .into_iter()
            .chain(at_rest)
            .chain(slides)
            .chain(yields)
            .chain(Caution::turns(self.turn))
            .chain(self.heat_caution);
        let all = all.chain(Caution::deep(&self.normal));
        let all =
            all.chain(Caution::like_bodies(kappa_over_mu)).chain(Caution::of_areas(&self.normal));
        // Its points across are as many as are looked up.
        let all = all.filter(|caution| !matches!(caution, Caution::CoarseGap { .. }));
        all.chain(self.rough.iter().copied()).collect()
    }

    /// Extent of its areas along `x` and along `s` (m), from the reference point.
    #[must_use]
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let union = |one: [f64; 2], other: [f64; 2]| [one[0].min(other[0]), one[1].max(other[1])];
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [x, s] = self
            .normal
            .patches()
            .iter()
            .map(normal::Patch::extent)
            .fold([nothing; 2], |[x, s], area| [union(x, area.x), union(s, area.y)]);
        [if self.is_reversed { [-x[1], -x[0]] } else { x }, s]
    }

    /// A place of the contact plane in track axes (m).
    #[must_use]
    pub fn in_track(&self, [x, s]: [f64; 2]) -> [f64; 3] {
        let (sin, cos) = self.angle.sin_cos();
        let [a, b, c] = self.reference;
        [a + x, b + s * cos, c + s * sin]
    }
}

impl SolvedWheel {
    /// Its places of contact, the most loaded first; none where it hangs above its rail.
    #[must_use]
    pub fn contacts(&self) -> &[SolvedContact] {
        &self.contacts
    }

    pub(super) fn contacts_mut(&mut self) -> &mut [SolvedContact] {
        &mut self.contacts
    }

    /// How far its running circle stands above the height at which the nominal one touches the track
    /// plane (m); negative where it hangs below, zero where it touches nothing.
    #[must_use]
    pub fn height(&self) -> f64 {
        let Position { z, roll, .. } = self.position;
        let [_, y, _] = self.rail_origin;
        if self.contacts.is_empty() { 0.0 } else { -(z + roll * y) }
    }

    /// Force on the rail in track axes, with its moment about the origin of the rail's profile.
    #[must_use]
    pub fn on_rail(&self) -> Resultant {
        self.contacts
            .iter()
            .fold(Resultant::NONE, |sum, contact| sum + contact.on_rail(self.rail_origin))
    }
}

impl SolvedWheelset {
    /// Its mirror image fore and aft, which runs the other way.
    pub(super) fn fore_and_aft(mut self) -> Self {
        self.is_reversed = !self.is_reversed;
        self.motion = Motion {
            speed: -self.motion.speed,
            pitch_rate: -self.motion.pitch_rate,
            yaw_rate: -self.motion.yaw_rate,
            ..self.motion
        };
        for wheel in self.left.iter_mut().chain(&mut self.right) {
            wheel.position.yaw = -wheel.position.yaw;
            wheel.pitch_rate = -wheel.pitch_rate;
            let contacts = std::mem::take(&mut wheel.contacts).into_iter();
            wheel.contacts = contacts.map(SolvedContact::fore_and_aft).collect();
        }
        self
    }

    /// Remembers how far a rail gave way.
    pub(super) fn deflect(&mut self, side: Side, by: [f64; 2]) {
        let wheels = self.left.iter_mut().chain(&mut self.right);
        wheels.filter(|wheel| wheel.side == side).for_each(|wheel| wheel.deflection = Some(by));
    }

    /// How one of its wheels moves.
    pub(super) fn motion_of(&self, wheel: &SolvedWheel) -> Motion {
        Motion { pitch_rate: wheel.pitch_rate, ..self.motion }
    }

    /// Moments of the left and the right wheel about `x` through the wheelset's centre over their vertical
    /// forces (m); `None` where one is missing or carries nothing.
    pub(super) fn levers(&self, radius: f64) -> Option<[f64; 2]> {
        let lever = |wheel: &Option<SolvedWheel>| {
            let wheel = wheel.as_ref()?;
            let Position { y, z, .. } = wheel.position;
            let centre = [0.0, y, z - radius];
            let contacts = wheel.contacts.iter();
            let sum = contacts.fold(Resultant::NONE, |sum, c| sum + c.on_rail(centre));
            (sum.force[2] > 0.0).then(|| sum.moment[0] / sum.force[2])
        };
        Some([lever(&self.left)?, lever(&self.right)?])
    }

    /// The wheels that were solved, the left one first.
    pub fn wheels(&self) -> impl Iterator<Item = &SolvedWheel> {
        self.left.iter().chain(&self.right)
    }

    /// Where the wheelset stands; at the mean height where each wheel was pressed on by itself.
    #[must_use]
    pub fn position(&self) -> Position {
        let count = self.wheels().count().max(1) as f64;
        let z = self.wheels().map(|wheel| wheel.position.z).sum::<f64>() / count;
        self.wheels()
            .next()
            .map_or_else(Position::default, |wheel| Position { z, ..wheel.position })
    }

    /// Force (N) and moment (N m) of the rails on the wheelset about its centre, in track axes. Where each
    /// wheel was pressed on by itself its centre is taken at the mean height.
    #[must_use]
    pub fn wrench(&self, radius: f64) -> [[f64; 3]; 2] {
        let Position { y, z, .. } = self.position();
        let centre = [0.0, y, z - radius];
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for wheel in self.wheels() {
            let about =
                wheel.contacts.iter().fold(Resultant::NONE, |sum, c| sum + c.on_rail(centre));
            force = [0, 1, 2].map(|k: usize| force[k] - about.force[k]);
            moment = [0, 1, 2].map(|k: usize| moment[k] - about.moment[k]);
        }
        [force, moment]
    }

    /// The worst status of its contacts.
    #[must_use]
    pub fn status(&self) -> Status {
        let statuses = self.wheels().flat_map(SolvedWheel::contacts).map(|contact| {
            match contact.normal.status() {
                normal::Status::Converged => contact.status,
                normal::Status::NotConverged { .. } => Status::NotConverged,
            }
        });
        statuses.fold(
            Status::Solved,
            |worst, status| {
                if worst == Status::Solved { status } else { worst }
            },
        )
    }

    /// What is to be held against the solution, each with its side; of several contacts on a rough
    /// profile the most loaded one says so.
    #[must_use]
    pub fn cautions(&self) -> Vec<(Side, Caution)> {
        let contacts = self.wheels().flat_map(SolvedWheel::contacts);
        let climbs = |wheel: &SolvedWheel| Some((wheel.side, Caution::climbs(wheel.height())?));
        let mut all: Vec<(Side, Caution)> = self.wheels().filter_map(climbs).collect();
        for (side, caution) in
            contacts.flat_map(|c| c.cautions().into_iter().map(|caution| (c.side, caution)))
        {
            if !all.iter().any(|(known, said)| *known == side && said.says(&caution)) {
                all.push((side, caution));
            }
        }
        all
    }

    /// The same in words.
    #[must_use]
    pub fn caution_words(&self) -> Vec<String> {
        let words = |(side, caution): &(Side, Caution)| match side {
            Side::Left => format!("left wheel: {caution}"),
            Side::Right => format!("right wheel: {caution}"),
        };
        self.cautions().iter().map(words).collect()
    }

    /// The largest error bar of a force, in parts of its contact's `mu N`.
    pub(super) fn worst_error(&self) -> f64 {
        let contacts = self.wheels().flat_map(SolvedWheel::contacts);
        let errors = contacts.filter_map(|contact| {
            let SiForce { longitudinal, lateral, .. } = contact.force_error?;
            Some(longitudinal.max(lateral) / contact.scaling.force)
        });
        errors.fold(0.0, f64::max)
    }
}
