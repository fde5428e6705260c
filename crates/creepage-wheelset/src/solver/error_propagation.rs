//! What error bars owe to the position that was sought: where a load is given, a wheel whose friction
//! or pressure errs stands higher or lower, and all of its contacts carry more or less.

use super::predictor::share;
use crate::solved::{SolvedContact, SolvedWheel, SolvedWheelset};
use crate::tilt::Placed;

impl SolvedWheelset {
    /// Widens error bars of wheels that carry a given load: each its own, or `together`.
    pub(crate) fn widen_bars(&mut self, together: bool) {
        let wheels = self.left.iter_mut().chain(&mut self.right).map(SolvedWheel::contacts_mut);
        if together {
            widen(&mut wheels.flatten().collect::<Vec<_>>());
        } else {
            wheels.for_each(|contacts| widen(&mut contacts.iter_mut().collect::<Vec<_>>()));
        }
    }
}

/// The same for contacts that carry a load together, on a flange as much by friction as by pressure.
fn widen(contacts: &mut [&mut SolvedContact]) {
    let sum = |of: fn(&SolvedContact) -> f64| contacts.iter().map(|one| of(one)).sum::<f64>();
    let stiffness = sum(SolvedContact::vertical_stiffness);
    let pressing = sum(SolvedContact::error_by_pressure);
    let friction = sum(SolvedContact::error_by_friction);
    if stiffness > 0.0 {
        for contact in contacts {
            // Its own pressure's error changes the height, not its load, if it carries the wheel alone.
            let others = pressing - contact.error_by_pressure();
            contact.widen((others + friction) / stiffness);
        }
    }
}

impl SolvedContact {
    /// How far its vertical force may be off where the wheel stands (N), by its pressure.
    fn error_by_pressure(&self) -> f64 {
        self.normal.load().error * self.tilt().down()[2].abs()
    }

    /// The same by its friction; none by a theory without error bars.
    fn error_by_friction(&self) -> f64 {
        let [along, across, _] = self.tilt().down();
        self.force_error
            .map_or(0.0, |error| error.lateral * across.abs() + error.longitudinal * along.abs())
    }

    /// Change of its vertical force as the wheelset goes down (N/m).
    fn vertical_stiffness(&self) -> f64 {
        let tilt = self.tilt();
        self.normal.stiffness() * tilt.down()[2] * tilt.vertical_ratio(share(self))
    }

    /// Widens its error bars by what changes when it stands `depth` (m) lower.
    fn widen(&mut self, depth: f64) {
        let more = self.normal.stiffness() * self.tilt().down()[2] * depth;
        self.load_error += more;
        let part = more / self.load();
        if let Some(error) = &mut self.force_error {
            error.longitudinal += part * self.force.longitudinal.abs();
            error.lateral += part * self.force.lateral.abs();
            error.moment += part * self.force.moment.abs();
        }
    }
}
