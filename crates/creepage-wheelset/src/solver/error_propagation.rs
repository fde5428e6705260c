//! Error propagation in an equilibrium: linear, of independent errors of the contacts.
//!
//! Each contact has four sources of error: its load at the given approach, its two tangential forces and their
//! moment. Where a load is given, what a source adds to it is taken off again, for the wheelset stands so much higher;
//! so the load of a contact that carries its wheel alone is nearly without error. Where the pitch rate is found, what a
//! source adds to the moment about the axle, or to the longitudinal force where that is given, is taken off again
//! likewise, by all contacts that turn together. Sources are independent: squares add up.

use creepage::{Force, SiForce};
use creepage_rail::{Position, Side};

use super::pitch_rate::BALANCED;
use super::predictor::share;
use super::tangential::axle;
use super::vertical_load::Target;
use crate::Load;
use crate::pose::{Drive, PitchRate, WheelsetPose, WheelsetVelocity};
use crate::resultant::ContactForces;
use crate::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::tilt::Placed;

/// Of a load: so much is met by chance only.
const ROUNDING: f64 = 1e-6;

/// How often pitch rate and height make up for each other: a wheel goes up or down by friction's vertical part alone.
const PASSES: usize = 3;

/// An error of one contact, in track axes where it stands.
struct Source {
    /// Load (N).
    load: f64,
    /// Longitudinal and lateral force (N), and moment (N m), besides what follows from the load.
    friction: [f64; 3],
}

/// What a source, and the height and the pitch rate that make up for it, change of one contact.
#[derive(Debug, Clone, Copy, Default)]
struct Change {
    load: f64,
    friction: [f64; 3],
    /// Force on the rail in track axes (N).
    force: [f64; 3],
}

impl SolvedWheelset {
    /// Error bars of contacts and wheels, from each contact's own, and from how much of their loads (N) the left
    /// and the right wheel miss.
    pub(crate) fn propagate_errors(
        &mut self,
        target: &Target,
        (stance, travel): (&WheelsetPose, &WheelsetVelocity),
        missed: [f64; 2],
    ) {
        for wheel in self.left.iter_mut().chain(&mut self.right) {
            wheel.missed_load = missed[place(wheel.side)];
        }
        let missed = self.with_transfer(stance, missed);
        let mut wheels: Vec<&mut SolvedWheel> =
            self.left.iter_mut().chain(&mut self.right).collect();
        propagate(&mut wheels, target, (travel, self.radius), missed);
    }

    /// The same with the load that errors of lateral forces, `radius` below the wheelset's centre, move from wheel to
    /// wheel under a given moment.
    fn with_transfer(&self, stance: &WheelsetPose, missed: [f64; 2]) -> [f64; 2] {
        let Some([left, right]) = self.levers(self.radius) else { return missed };
        if !matches!(stance.load, Some(Load::Loaded { .. })) || stance.roll.is_some() {
            return missed;
        }
        let contacts = self.wheels().flat_map(SolvedWheel::contacts);
        let lateral = contacts.flat_map(|one| {
            let error = one.force_error.unwrap_or_default();
            let level = one.tilt().axes()[1][1];
            [error.lateral * level, one.load_error * one.tilt().axes()[2][1]]
        });
        let moved = self.radius * norm(lateral) / (right - left).abs();
        missed.map(|missed| missed.hypot(moved))
    }
}

fn norm(parts: impl IntoIterator<Item = f64>) -> f64 {
    parts.into_iter().map(|part| part * part).sum::<f64>().sqrt()
}

fn place(side: Side) -> usize {
    usize::from(side == Side::Right)
}

/// Error bars of wheels and their contacts; wheels miss so much of their loads (N).
fn propagate(
    wheels: &mut [&mut SolvedWheel],
    target: &Target,
    (travel, radius): (&WheelsetVelocity, f64),
    missed: [f64; 2],
) {
    let of_wheel: Vec<usize> =
        wheels.iter().enumerate().flat_map(|(k, wheel)| vec![k; wheel.contacts().len()]).collect();
    let sides: Vec<usize> = of_wheel.iter().map(|&wheel| place(wheels[wheel].side)).collect();
    let contacts: Vec<&SolvedContact> = wheels.iter().flat_map(|wheel| wheel.contacts()).collect();
    let has_bars = contacts.iter().all(|one| one.force_error.is_some());
    // Contacts that carry a load together: of both wheels, or of each.
    let together = matches!(target, Target::Together(_));
    let group = |k: usize| if together { 0 } else { sides[k] };
    let mut stiffness = [0.0; 2];
    for (k, contact) in contacts.iter().enumerate() {
        stiffness[group(k)] += contact.vertical_stiffness();
    }
    let levers: Vec<[f64; 4]> = of_wheel
        .iter()
        .zip(&contacts)
        .map(|(&wheel, contact)| contact.levers(travel.drive, wheels[wheel].position, radius))
        .collect();
    // Where a load is given, the height makes up for what changes add to it, but for `missed` (N).
    let balance_loads = |changes: &mut [Change], missed: [f64; 2]| {
        for of in 0..2 {
            let own = (0..contacts.len()).filter(|k| group(*k) == of);
            let vertical: f64 = own.clone().map(|k| changes[k].force[2]).sum();
            if *target == Target::Nothing || stiffness[of] <= 0.0 {
                continue;
            }
            let depth = (missed[of] - vertical) / stiffness[of];
            own.for_each(|k| changes[k].add(&contacts[k].lowered(depth)));
        }
    };

    // Each source changes all contacts; bars are sums of squares over the sources.
    let mut bars = vec![[0.0; 3]; contacts.len()];
    let mut on_rails = vec![[0.0; 3]; wheels.len()];
    let mut add = |source: Option<(usize, &Source)>, missed: [f64; 2], unbalanced: f64| {
        let mut changes = vec![Change::default(); contacts.len()];
        if let Some((of, source)) = source {
            changes[of] = contacts[of].direct(source);
        }
        for _ in 0..PASSES {
            balance_pitch((&mut changes, unbalanced), (&contacts, &levers), &sides, travel.pitch);
            balance_loads(&mut changes, missed);
        }
        let mut forces = vec![[0.0; 3]; wheels.len()];
        for ((bar, change), &wheel) in bars.iter_mut().zip(&changes).zip(&of_wheel) {
            let [longitudinal, lateral, _] = change.friction;
            accumulate(bar, [change.load, longitudinal, lateral], |part| part * part);
            if let Some(sum) = forces.get_mut(wheel) {
                accumulate(sum, change.force, |part| part);
            }
        }
        for (square, force) in on_rails.iter_mut().zip(forces) {
            accumulate(square, force, |part| part * part);
        }
    };
    for (of, contact) in contacts.iter().enumerate() {
        for source in contact.sources() {
            add(Some((of, &source)), [0.0; 2], 0.0);
        }
    }
    let missed = if together { [missed[0] + missed[1], 0.0] } else { missed };
    for (of, missed) in missed.into_iter().enumerate() {
        let own = (0..contacts.len()).filter(|k| group(*k) == of);
        let load: f64 = own.map(|k| contacts[k].load()).sum();
        let mut all = [0.0; 2];
        all[of] = missed.hypot(ROUNDING * load);
        add(None, all, 0.0);
    }
    add(None, [0.0; 2], BALANCED);

    let mut bars = bars.into_iter().map(|bar| bar.map(f64::sqrt));
    for (wheel, square) in wheels.iter_mut().zip(on_rails) {
        wheel.force_error = has_bars.then(|| square.map(f64::sqrt));
        for (contact, [load, longitudinal, lateral]) in
            wheel.contacts_mut().iter_mut().zip(&mut bars)
        {
            let part = load / contact.load();
            let turned = part * contact.force.moment;
            contact.load_error = load;
            if let Some(error) = &mut contact.force_error {
                (error.longitudinal, error.lateral) = (longitudinal, lateral);
                error.moment = error.moment.hypot(turned);
            }
        }
    }
}

impl Change {
    fn add(&mut self, other: &Self) {
        self.load += other.load;
        accumulate(&mut self.friction, other.friction, |part| part);
        accumulate(&mut self.force, other.force, |part| part);
    }
}

/// Takes off what changes add to the moment about the axle, or to the longitudinal force where that is given, of contacts
/// that turn together, where their pitch rate is found; and what is left unbalanced (in parts of all their friction).
fn balance_pitch(
    (changes, unbalanced): (&mut [Change], f64),
    (contacts, levers): (&[&SolvedContact], &[[f64; 4]]),
    sides: &[usize],
    pitch: PitchRate,
) {
    let (found, turns): (Vec<bool>, fn(usize) -> usize) = match pitch {
        PitchRate::Rigid(rate) => (vec![rate.is_none()], |_| 0),
        PitchRate::Independent(rates) => (rates.map(|rate| rate.is_none()).to_vec(), |side| side),
    };
    let moment = |k: usize, [longitudinal, lateral, moment]: [f64; 3], load: f64| -> f64 {
        let parts = [longitudinal, lateral, moment, load];
        levers[k].iter().zip(parts).map(|(lever, part)| lever * part).sum()
    };
    for group in (0..found.len()).filter(|group| found[*group]) {
        let own: Vec<usize> = (0..contacts.len()).filter(|k| turns(sides[*k]) == group).collect();
        let slopes: Vec<[f64; 3]> = own.iter().map(|k| contacts[*k].by_longitudinal()).collect();
        let stiffness: f64 =
            own.iter().zip(&slopes).map(|(k, slopes)| moment(*k, *slopes, 0.0)).sum();
        if stiffness == 0.0 {
            continue;
        }
        let most: f64 =
            own.iter().map(|k| moment(*k, [contacts[*k].scaling.force, 0.0, 0.0], 0.0)).sum();
        let added: f64 =
            own.iter().map(|k| moment(*k, changes[*k].friction, changes[*k].load)).sum();
        let over = added + unbalanced * most;
        for (k, slopes) in own.into_iter().zip(slopes) {
            let friction = slopes.map(|slope| -over / stiffness * slope);
            changes[k].add(&contacts[k].direct(&Source { load: 0.0, friction }));
        }
    }
}

fn accumulate(sum: &mut [f64; 3], parts: [f64; 3], of: impl Fn(f64) -> f64) {
    sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += of(part));
}

impl SolvedContact {
    /// What may be off where it stands, from its pressure and from its friction.
    fn sources(&self) -> [Source; 4] {
        let error = self.force_error.unwrap_or_default();
        let friction = |friction| Source { load: 0.0, friction };
        [
            Source { load: self.load_error, friction: [0.0; 3] },
            friction([error.longitudinal, 0.0, 0.0]),
            friction([0.0, error.lateral, 0.0]),
            friction([0.0, 0.0, error.moment]),
        ]
    }

    /// A source where it arises: friction goes with the load.
    fn direct(&self, source: &Source) -> Change {
        let [lateral, longitudinal] = share(self);
        let turning = self.force.moment / self.load();
        let mut friction = source.friction;
        accumulate(&mut friction, [longitudinal, lateral, turning], |part| part * source.load);
        let [x, s, normal] = self.tilt().axes();
        let force = [0, 1, 2]
            .map(|k: usize| friction[0] * x[k] + friction[1] * s[k] + source.load * normal[k]);
        Change { load: source.load, friction, force }
    }

    /// What its longitudinal and lateral force, its moment and its load add to what the pitch rate is found by: friction's
    /// moment about the axle, or the longitudinal force on the rails.
    fn levers(&self, drive: Drive, position: Position, radius: f64) -> [f64; 4] {
        if let Drive::Force(_) = drive {
            let [along, across, normal] = self.tilt().axes();
            return [along[0], across[0], 0.0, normal[0]];
        }
        let (axle, centre) = (axle(position), [0.0, position.y, position.z - radius]);
        let units = [0, 1, 2].map(|part: usize| [0, 1, 2].map(|k| f64::from(u8::from(k == part))));
        let [longitudinal, lateral, moment] = units.map(|[longitudinal, lateral, moment]| {
            let force = SiForce { longitudinal, lateral, moment };
            let acting = ContactForces::new(force, 0.0, [0.0; 2]);
            let (_, about) = acting.about(self.reference, self.tilt(), centre);
            about.iter().zip(axle).map(|(part, along)| part * along).sum()
        });
        [longitudinal, lateral, moment, 0.0]
    }

    /// What it carries more or less where the wheelset goes down by `depth` (m).
    fn lowered(&self, depth: f64) -> Change {
        let load = self.normal.stiffness() * self.tilt().down()[2] * depth;
        self.direct(&Source { load, friction: [0.0; 3] })
    }

    /// Slopes of the longitudinal and the lateral force by longitudinal creepage (N), but for one factor of all contacts;
    /// that of the moment is left out.
    ///
    /// As of Carter's law along the direction of the force: `f = 1 - (1 - u)^2` has the slope `2 sqrt(1 - f)`, and
    /// the force turns with the creepage by `f / u = 1 + sqrt(1 - f)`.
    fn by_longitudinal(&self) -> [f64; 3] {
        let Force { fx, fy, .. } = self.solution.force;
        let size = fx.hypot(fy);
        let adheres = (1.0 - size).max(0.0).sqrt();
        let [x, y] = if size > 0.0 { [fx / size, fy / size] } else { [1.0, 0.0] };
        let [along, across] = [adheres, 0.5 * (1.0 + adheres)];
        let linear = self.scaling.force / self.scaling.slip;
        [x * x * along + y * y * across, x * y * (along - across), 0.0].map(|slope| linear * slope)
    }

    /// Change of its vertical force as the wheelset goes down (N/m).
    fn vertical_stiffness(&self) -> f64 {
        let tilt = self.tilt();
        self.normal.stiffness() * tilt.down()[2] * tilt.vertical_ratio(share(self))
    }
}
