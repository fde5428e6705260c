//! How the errors of contacts add up where a wheelset stands: linear propagation of independent errors.
//!
//! Each contact has three sources of error: its load at the given approach, and its two tangential forces. Where a
//! load is given, what a source adds to it is taken off again, for the wheelset stands so much higher; so the load
//! of a contact that carries its wheel alone is nearly without error. Sources are independent: squares add up.

use creepage_rail::Side;

use super::predictor::share;
use super::vertical_load::Target;
use crate::Load;
use crate::pose::WheelsetPose;
use crate::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::tilt::Placed;

/// Of a load: so much is met by chance only.
const ROUNDING: f64 = 1e-6;

/// An error of one contact, in track axes where it stands.
struct Source {
    /// Load (N).
    load: f64,
    /// Longitudinal and lateral force (N), besides what follows from the load.
    friction: [f64; 2],
}

/// What a source, and the height that makes up for it, change of one contact.
struct Change {
    load: f64,
    friction: [f64; 2],
    /// Force on the rail in track axes (N).
    force: [f64; 3],
}

impl SolvedWheelset {
    /// Error bars of contacts and wheels, from each contact's own, and from how much of their loads (N) the left
    /// and the right wheel miss.
    pub(crate) fn propagate_errors(
        &mut self,
        target: &Target,
        stance: &WheelsetPose,
        missed: [f64; 2],
    ) {
        let missed = self.with_transfer(stance, missed);
        let mut wheels: Vec<&mut SolvedWheel> =
            self.left.iter_mut().chain(&mut self.right).collect();
        if matches!(target, Target::Together(_)) {
            propagate(&mut wheels, target, missed[0] + missed[1]);
        } else {
            for wheel in &mut wheels {
                let missed = missed[usize::from(wheel.side == Side::Right)];
                propagate(&mut [wheel], target, missed);
            }
        }
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

/// Error bars of wheels whose contacts carry a load together.
fn propagate(wheels: &mut [&mut SolvedWheel], target: &Target, missed: f64) {
    let of_wheel: Vec<usize> =
        wheels.iter().enumerate().flat_map(|(k, wheel)| vec![k; wheel.contacts().len()]).collect();
    let contacts: Vec<&SolvedContact> = wheels.iter().flat_map(|wheel| wheel.contacts()).collect();
    let has_bars = contacts.iter().all(|one| one.force_error.is_some());
    let stiffness: f64 = contacts.iter().map(|one| one.vertical_stiffness()).sum();
    let yields = *target != Target::Nothing && stiffness > 0.0;

    // Each source changes all contacts; bars are sums of squares over the sources.
    let mut bars = vec![[0.0; 3]; contacts.len()];
    let mut on_rails = vec![[0.0; 3]; wheels.len()];
    let mut add = |changes: Vec<Change>| {
        let mut forces = vec![[0.0; 3]; wheels.len()];
        for ((bar, change), &wheel) in bars.iter_mut().zip(&changes).zip(&of_wheel) {
            let [longitudinal, lateral] = change.friction;
            accumulate(bar, [change.load, longitudinal, lateral], |part| part * part);
            if let Some(sum) = forces.get_mut(wheel) {
                accumulate(sum, change.force, |part| part);
            }
        }
        for (square, force) in on_rails.iter_mut().zip(forces) {
            accumulate(square, force, |part| part * part);
        }
    };
    let lowered = |vertical: f64| if yields { -vertical / stiffness } else { 0.0 };
    for (of, contact) in contacts.iter().enumerate() {
        for source in contact.sources() {
            let depth = lowered(contact.direct(&source).force[2]);
            let change = |(k, one): (usize, &&SolvedContact)| {
                one.lowered(depth, (k == of).then(|| one.direct(&source)))
            };
            add(contacts.iter().enumerate().map(change).collect());
        }
    }
    if yields {
        let load: f64 = contacts.iter().map(|one| one.load()).sum();
        let depth = lowered(-missed.hypot(ROUNDING * load));
        add(contacts.iter().map(|one| one.lowered(depth, None)).collect());
    }

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

fn accumulate(sum: &mut [f64; 3], parts: [f64; 3], of: impl Fn(f64) -> f64) {
    sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += of(part));
}

impl SolvedContact {
    /// What may be off where it stands, from its pressure and from its friction.
    fn sources(&self) -> [Source; 3] {
        let error = self.force_error.unwrap_or_default();
        let [along, across] = [[error.longitudinal, 0.0], [0.0, error.lateral]];
        let friction = |friction| Source { load: 0.0, friction };
        [Source { load: self.load_error, friction: [0.0; 2] }, friction(along), friction(across)]
    }

    /// A source where it arises: friction goes with the load.
    fn direct(&self, source: &Source) -> Change {
        let [lateral, longitudinal] = share(self);
        let [along, across] = source.friction;
        let friction = [along + longitudinal * source.load, across + lateral * source.load];
        let [x, s, normal] = self.tilt().axes();
        let force = [0, 1, 2]
            .map(|k: usize| friction[0] * x[k] + friction[1] * s[k] + source.load * normal[k]);
        Change { load: source.load, friction, force }
    }

    /// What it carries more or less where the wheelset goes down by `depth` (m), besides `own`.
    fn lowered(&self, depth: f64, own: Option<Change>) -> Change {
        let load = self.normal.stiffness() * self.tilt().down()[2] * depth;
        let mut change = self.direct(&Source { load, friction: [0.0; 2] });
        if let Some(own) = own {
            change.load += own.load;
            change.friction = [0, 1].map(|k: usize| change.friction[k] + own.friction[k]);
            accumulate(&mut change.force, own.force, |part| part);
        }
        change
    }

    /// Change of its vertical force as the wheelset goes down (N/m).
    fn vertical_stiffness(&self) -> f64 {
        let tilt = self.tilt();
        self.normal.stiffness() * tilt.down()[2] * tilt.vertical_ratio(share(self))
    }
}
