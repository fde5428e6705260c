//! What few elements lack of the friction on a contact, from one position to others nearby.
//!
//! It changes slowly as a wheelset moves, mostly by a thirtieth of what friction changes by: so it is carried along
//! until that makes friction unsure.

use std::sync::Arc;

use creepage::coulomb::NearTractions;
use creepage::{Force, Solution};

/// What few elements lack changes by no more than such parts of the changes of their friction and of its error
/// bar, or a twentieth of that by all, in 93 to 98 of 100 pairs of positions up to 0.1 mm apart (20,000 of both
/// examples, at three yaws).
const OF_CHANGE: [f64; 2] = [0.05, 0.5];
/// By which part of themselves error bars may grow by that.
const UNSURE: f64 = 0.5;

/// What few elements lack of the friction on a contact, in its units.
#[derive(Debug, Clone)]
pub(super) struct Lack {
    /// Shift (m) and yaw (rad) where all elements were solved.
    pub(super) at: [f64; 2],
    /// How many are few.
    pub(super) elements: usize,
    /// Friction there by few elements, and how much more it is by all.
    pub(super) few: Solution,
    pub(super) more: Force,
    pub(super) more_power: f64,
    /// Error bars by all elements, and their tractions.
    pub(super) error: Force,
    pub(super) tractions: Arc<NearTractions>,
}

impl Lack {
    /// Friction and its power by few elements, with what these lack; no more than `mu N`.
    pub(super) fn made_up(&self, few: Solution, power: Option<f64>) -> (Solution, Option<f64>) {
        let Force { fx, fy, mz } = sum(few.force, self.more);
        let over = fx.hypot(fy).max(1.0);
        let force = Force { fx: fx / over, fy: fy / over, mz };
        let more = self.unsure(&few);
        let error = sum(self.error, Force { fx: more, fy: more, mz: more });
        let power = power.map(|power| (power + self.more_power).max(0.0));
        (Solution { force, error: Some(error), ..few }, power)
    }

    /// What friction may be off by that few elements have changed to this.
    fn unsure(&self, few: &Solution) -> f64 {
        let bars = few.error.zip(self.few.error);
        let changes = [
            difference(few.force, self.few.force),
            bars.map_or(Force::default(), |(here, there)| difference(here, there)),
        ];
        changes.iter().zip(OF_CHANGE).map(|(change, part)| part * change.fx.hypot(change.fy)).sum()
    }

    /// Whether the error bars of friction that was made up are small enough, or would be if they had grown so many
    /// times as much.
    pub(super) fn is_sure(&self, made_up: &Solution, times: f64) -> bool {
        let Force { fx, fy, .. } = self.error;
        let grown = made_up.error.map_or(f64::INFINITY, |error| error.fx - fx);
        times * grown <= UNSURE * fx.max(fy)
    }

    /// How many times as far as one position another is from where all elements were solved, in shift and yaw over
    /// `units`; as far where the one is there.
    pub(super) fn times(&self, from: [f64; 2], to: [f64; 2], units: [f64; 2]) -> f64 {
        let far = |there: [f64; 2]| {
            let [shift, yaw] = [0, 1].map(|k: usize| (there[k] - self.at[k]) / units[k]);
            shift.hypot(yaw)
        };
        if far(from) > 0.0 { far(to) / far(from) } else { 1.0 }
    }
}

fn sum(a: Force, b: Force) -> Force {
    Force { fx: a.fx + b.fx, fy: a.fy + b.fy, mz: a.mz + b.mz }
}

pub(super) fn difference(a: Force, b: Force) -> Force {
    Force { fx: a.fx - b.fx, fy: a.fy - b.fy, mz: a.mz - b.mz }
}
