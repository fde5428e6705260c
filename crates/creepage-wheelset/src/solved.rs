//! Solved wheelset: its contacts, their forces on the rails, and its warnings.

use std::borrow::Cow;
use std::sync::Arc;

use creepage::coulomb::{ElementField, TangentialWarmStart};
use creepage::normal::NormalContact;
use creepage::{Scaling, SiForce, Solution, Status, normal};
use creepage_rail::{Motion, Position, RollingCreepage, Side};

use crate::correction::Correction;
use crate::derivatives::WheelsetDerivatives;
use crate::field::Field;
use crate::pose::RigidSlip;
use crate::resultant::{ContactForces, Resultant};
use crate::rough::{Roughness, Unmeasured};
use crate::solver::LoadLine;
use crate::tilt::Placed;
use crate::warm_start::{PitchState, PredictorCorrection};
use creepage::theory::AreaTheory;

/// Solved wheelset, with its contacts.
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
    /// Its place along the track (m) and how far its wheels have rolled on (rad), where surfaces vary along rolling.
    pub place: Option<[f64; 2]>,
    /// Coefficient of friction, the largest where it varies.
    pub friction: f64,
    /// The least coefficient of all places on the rails.
    pub least_friction: f64,
    /// What the surfaces slide by before they deform.
    pub slip: RigidSlip,
    /// The theory of rolling.
    pub theory: AreaTheory,
    /// How its forces change with its position and motion, where that was asked for:
    /// [`WheelsetSolver::derivatives`](crate::WheelsetSolver::derivatives).
    pub derivatives: Option<WheelsetDerivatives>,
    /// Mean nominal radius of the wheels (m).
    pub radius: f64,
    /// Where a position nearby finds its pitch rates.
    pub(crate) pitch: [PitchState; 2],
    /// How it came to stand elsewhere than was expected from the position before, if there was one.
    pub(crate) drift: Option<PredictorCorrection>,
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
    /// The least distance in the cross-section between the wheel and its guard rail (m), zero where they touch;
    /// `None` where there is no guard rail.
    pub guard_clearance: Option<f64>,
    /// How far its rail gave way on its springs, to the right and down (m), where it lies on any.
    pub deflection: Option<[f64; 2]>,
    /// What it carries beyond the load that was asked of it (N): below 1e-4 of that, but where loads jump.
    pub missed_load: f64,
    /// Its vertical force, and how that was found to change.
    pub(crate) line: LoadLine,
    /// Origin of the rail's profile in track axes (m).
    pub rail_origin: [f64; 3],
    /// Error bars of its force on the rail in track axes (N), where the theory has them.
    pub(crate) force_error: Option<[f64; 3]>,
    pub(crate) contacts: Vec<SolvedContact>,
}

/// Where surfaces that vary along rolling end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SurfaceLimits {
    /// Whether a part of a rail begins or ends within the overlap: the area is cut there, and how high the
    /// pressure is at that edge depends on the resolution.
    pub is_cut: bool,
    /// Whether it lies beyond the rail's slices, where the surface is taken to go on alike.
    pub is_beyond: bool,
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
    /// Turn about `s` after that (rad), which lowers the plane ahead: 0 unless surfaces vary along rolling.
    pub slope: f64,
    /// Where its surfaces end, where wheel or rail vary along rolling.
    pub varying: Option<SurfaceLimits>,
    /// Whether it lies on the guard rail: the rail is that one, here and in [`SolvedContact::y_rail`].
    pub is_on_guard: bool,
    /// `y` of the reference point in the rail's profile (m), to the field side.
    pub y_rail: f64,
    /// `y` of the reference point in the wheel's profile (m), to the field side.
    pub y_wheel: f64,
    /// Pressure and areas, in the contact plane about the reference point.
    pub normal: NormalContact,
    /// How far its load may be off (N). Where a load is given, the height makes up for what pressures err by:
    /// a contact that carries its wheel alone has its load but for friction's error.
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
    pub(crate) is_reversed: bool,
    /// The largest coefficient of friction.
    pub friction: f64,
    /// The theory's name, where friction falls with the speed of slip and it takes that at rest.
    pub at_rest: Option<&'static str>,
    /// By how much the rail's surface turns from one side of its areas to the other (rad).
    pub turn: f64,
    /// Its friction in these units.
    pub(crate) solution: Solution,
    /// How its coarse grid was corrected, where it followed a position nearby.
    pub(crate) correction: Option<Arc<Correction>>,
    pub(crate) field: Field,
    /// Its profiles that are rough where they touch.
    pub rough: Vec<Roughness>,
    /// Its profiles without points somewhere in its areas.
    pub unmeasured: Vec<Unmeasured>,
}

impl SolvedContact {
    /// Normal force (N).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.normal.load().value
    }

    /// Energy turned to heat per metre rolled (J/m): by tractions and slip where the theory has both, else by its force
    /// and creepage.
    #[must_use]
    pub fn heat(&self) -> f64 {
        let (force, creepage) = (self.force, self.creepage);
        self.dissipation.unwrap_or(
            force.longitudinal * creepage.longitudinal
                + force.lateral * creepage.lateral
                + force.moment * creepage.spin,
        )
    }

    /// What it does to the rail, with the moment about `point`.
    fn on_rail(&self, point: [f64; 3]) -> Resultant {
        let [along, across, normal] = self.tilt().axes();
        let load = self.normal.load();
        let acting = ContactForces::new(self.force, load.value, self.centre_of_pressure());
        let (force, moment) = acting.about(self.reference, self.tilt(), point);
        let force_error = self.force_error.map(|error| {
            [0, 1, 2].map(|i: usize| {
                (error.longitudinal * along[i]).abs()
                    + (error.lateral * across[i]).abs()
                    + (self.load_error * normal[i]).abs()
            })
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
        self.slope = -self.slope;
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
    pub(crate) fn tractions(&self) -> Option<&Arc<TangentialWarmStart>> {
        self.field.tractions()
    }

    /// Adhesion area over contact area, 0 to 1.
    #[must_use]
    pub fn adhesion_share(&self) -> f64 {
        creepage::coulomb::adhesion_share(&self.elements())
    }

    /// Extent of its areas along `x` and along `s` (m), from the reference point.
    #[must_use]
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let [x, s] = self.normal.extent();
        [if self.is_reversed { [-x[1], -x[0]] } else { x }, s]
    }

    /// A place of the contact plane in track axes (m).
    #[must_use]
    pub fn in_track(&self, [x, s]: [f64; 2]) -> [f64; 3] {
        self.tilt().place(self.reference, [x, s])
    }
}

impl SolvedWheel {
    /// Its places of contact, the most loaded first; none where it hangs above its rail.
    #[must_use]
    pub fn contacts(&self) -> &[SolvedContact] {
        &self.contacts
    }

    pub(crate) fn contacts_mut(&mut self) -> &mut [SolvedContact] {
        &mut self.contacts
    }

    /// How far its running circle stands above the height at which the nominal one touches the track
    /// plane (m), or the plane to which springs let its rail down; negative where it hangs below, zero where it touches
    /// nothing.
    #[must_use]
    pub fn height(&self) -> f64 {
        let Position { z, roll, .. } = self.position;
        let [_, y, _] = self.rail_origin;
        let [_, down] = self.deflection.unwrap_or_default();
        let is_on_rail = self.contacts.iter().any(|contact| !contact.is_on_guard);
        if is_on_rail { down - (z + roll * y) } else { 0.0 }
    }

    /// Force on the guard rail in track axes, with its moment about the origin of the *running* rail's profile;
    /// `None` where there is no guard rail.
    #[must_use]
    pub fn on_guard(&self) -> Option<Resultant> {
        self.guard_clearance?;
        let contacts = self.contacts.iter().filter(|contact| contact.is_on_guard);
        Some(contacts.fold(Resultant::NONE, |sum, c| sum + c.on_rail(self.rail_origin)))
    }

    /// Force on the rail in track axes, with its moment about the origin of the rail's profile: with that on its
    /// guard rail, [`SolvedWheel::on_guard`], where there is one.
    #[must_use]
    pub fn on_rail(&self) -> Resultant {
        let contacts = self.contacts.iter();
        let sum = contacts.fold(Resultant::NONE, |sum, one| sum + one.on_rail(self.rail_origin));
        Resultant { force_error: self.force_error, ..sum }
    }
}

impl SolvedWheelset {
    /// Its mirror image fore and aft, which runs the other way.
    pub(crate) fn fore_and_aft(mut self) -> Self {
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
    pub(crate) fn deflect(&mut self, side: Side, by: [f64; 2]) {
        let wheels = self.left.iter_mut().chain(&mut self.right);
        wheels.filter(|wheel| wheel.side == side).for_each(|wheel| wheel.deflection = Some(by));
    }

    /// How one of its wheels moves.
    pub(crate) fn motion_of(&self, wheel: &SolvedWheel) -> Motion {
        Motion { pitch_rate: wheel.pitch_rate, ..self.motion }
    }

    /// Moments of the left and the right wheel about `x` through the wheelset's centre over their vertical
    /// forces (m); `None` where one is missing or carries nothing.
    pub(crate) fn levers(&self, radius: f64) -> Option<[f64; 2]> {
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

    /// The largest error bar of a force, in parts of its contact's `mu N`.
    pub(crate) fn worst_error(&self) -> f64 {
        let contacts = self.wheels().flat_map(SolvedWheel::contacts);
        let errors = contacts.filter_map(|contact| {
            let SiForce { longitudinal, lateral, .. } = contact.force_error?;
            Some(longitudinal.max(lateral) / contact.scaling.force)
        });
        errors.fold(0.0, f64::max)
    }
}
