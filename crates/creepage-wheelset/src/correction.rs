//! Fine-grid correction of a contact's friction, carried from one position to others nearby.
//!
//! It changes slowly as a wheelset moves, mostly by a thirtieth of what friction changes by: so it is carried along
//! until that makes friction uncertain.

use std::sync::Arc;

use creepage::coulomb::TangentialWarmStart;
use creepage::{Force, Solution};

/// The correction changes by no more than such parts of the changes of the coarse grid's friction and of its error
/// bar, or [`SCATTER`] of the fine grid's bar with what its border of adhesion hides, in 93 to 98 of 100 pairs of
/// positions up to 0.1 mm apart (20,000 of both examples, at three yaws).
const OF_CHANGE: [f64; 2] = [0.05, 0.5];
/// See [`OF_CHANGE`]: elements enter the area and leave it, and the border of adhesion goes with them.
const SCATTER: f64 = 0.05;
/// By which part of the larger one the error bars may grow by that.
const GROWTH: f64 = 0.5;

/// The friction on a contact by a fine grid less that by a coarse one, in units of the contact.
#[derive(Debug, Clone)]
pub(crate) struct Correction {
    /// Shift (m) and yaw (rad) where both grids were solved.
    pub(crate) at: [f64; 2],
    /// How many elements the coarse grid has.
    pub(crate) elements: usize,
    /// What the coarse grid found there.
    pub(crate) coarse: Solution,
    pub(crate) force: Force,
    pub(crate) power: f64,
    /// The fine grid's error bars and tractions.
    pub(crate) error: Force,
    /// What these leave out because the border of adhesion is known there, as it is beside that position by nobody.
    pub(crate) hidden: f64,
    pub(crate) tractions: Arc<TangentialWarmStart>,
}

impl Correction {
    /// Friction and its power by the coarse grid, corrected; no more than `mu N`.
    pub(crate) fn corrected(
        &self,
        coarse: Solution,
        power: Option<f64>,
    ) -> (Solution, Option<f64>) {
        let force = sum(coarse.force, self.force);
        let over = force.magnitude().max(1.0);
        let force = Force { fx: force.fx / over, fy: force.fy / over, ..force };
        let more = self.uncertainty(&coarse) + self.hidden;
        let error = sum(self.error, Force { fx: more, fy: more, mz: more });
        let power = power.map(|power| (power + self.power).max(0.0));
        (Solution { force, error: Some(error), ..coarse }, power)
    }

    /// What friction may be off by because the coarse grid finds something else by now.
    fn uncertainty(&self, coarse: &Solution) -> f64 {
        let bars = coarse.error.zip(self.coarse.error);
        let changes = [
            difference(coarse.force, self.coarse.force),
            bars.map_or(Force::default(), |(here, there)| difference(here, there)),
        ];
        changes.iter().zip(OF_CHANGE).map(|(change, part)| part * change.magnitude()).sum()
    }

    /// Whether the corrected error bar grew by less than `GROWTH` of the fine grid's, with what its border of adhesion
    /// hides there; the growth scaled by `times`.
    pub(crate) fn holds(&self, corrected: &Solution, times: f64) -> bool {
        let Force { fx, fy, .. } = self.error;
        let growth = corrected.error.map_or(f64::INFINITY, |error| error.fx - fx - self.hidden);
        let bar = fx.max(fy) + self.hidden;
        times * growth + SCATTER * bar <= GROWTH * bar
    }

    /// How many times as far as one position another is from where both grids were solved, in shift and yaw over
    /// `units`; as far where the one is there.
    pub(crate) fn times(&self, from: [f64; 2], to: [f64; 2], units: [f64; 2]) -> f64 {
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

pub(crate) fn difference(a: Force, b: Force) -> Force {
    Force { fx: a.fx - b.fx, fy: a.fy - b.fy, mz: a.mz - b.mz }
}
