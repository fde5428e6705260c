//! The force of a contact in the track's axes.

use std::ops::Add;

use super::solved::SolvedContact;

/// A force in track axes with its moment about a point, and error bars of the force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Resultant {
    /// Force along `x`, `y`, `z` (N).
    pub force: [f64; 3],
    /// Its error bars (N).
    pub force_error: [f64; 3],
    /// Moment about `x`, `y`, `z` (N m).
    pub moment: [f64; 3],
}

impl Resultant {
    /// What a contact does to the rail, with the moment about `point`.
    pub(super) fn of(contact: &SolvedContact, point: [f64; 3]) -> Self {
        let (sin, cos) = contact.angle.sin_cos();
        // From the contact's axes x, s, n.
        let track = |[x, s, n]: [f64; 3]| [x, s * cos - n * sin, s * sin + n * cos];
        let load = contact.normal.load();
        let (tangential, error) = (contact.force, contact.force_error);
        let force = track([tangential.longitudinal, tangential.lateral, load.value]);
        // Pressure acts at its centre.
        let [x, s] = contact.normal.centroid();
        let couple = track([s * load.value, -x * load.value, tangential.moment]);
        let arm = [0, 1, 2].map(|i: usize| contact.reference[i] - point[i]);
        let lever = cross(arm, force);
        Self {
            force,
            force_error: [
                error.longitudinal,
                (error.lateral * cos).abs() + (load.error * sin).abs(),
                (error.lateral * sin).abs() + (load.error * cos).abs(),
            ],
            moment: [0, 1, 2].map(|i: usize| lever[i] + couple[i]),
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Add for Resultant {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i: usize| a[i] + b[i]);
        Self {
            force: sum(self.force, other.force),
            force_error: sum(self.force_error, other.force_error),
            moment: sum(self.moment, other.moment),
        }
    }
}
