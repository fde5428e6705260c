//! Resultants: forces and moments in the track's axes.

use std::ops::Add;

use creepage::SiForce;

use crate::tilt::Tilt;

/// A force in track axes with its moment about a point, and error bars of the force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resultant {
    /// Force along `x`, `y`, `z` (N).
    pub force: [f64; 3],
    /// Its error bars (N), where the theory has them.
    pub force_error: Option<[f64; 3]>,
    /// Moment about `x`, `y`, `z` (N m).
    pub moment: [f64; 3],
}

impl Resultant {
    /// No force.
    pub(crate) const NONE: Self =
        Self { force: [0.0; 3], force_error: Some([0.0; 3]), moment: [0.0; 3] };
}

/// A force (N) and its couple (N m) at a contact's reference point, by the contact's axes `x`, `s`
/// and the normal into the rail.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactForces {
    force: [f64; 3],
    couple: [f64; 3],
}

impl ContactForces {
    /// Friction, and a load at the centre of pressure.
    pub(crate) fn new(friction: SiForce, load: f64, [x, s]: [f64; 2]) -> Self {
        Self {
            force: [friction.longitudinal, friction.lateral, load],
            couple: [s * load, -x * load, friction.moment],
        }
    }

    /// Force and moment about `point` in track axes, acting at `reference` where the contact lies
    /// as by `tilt`.
    pub(crate) fn about(
        &self,
        reference: [f64; 3],
        tilt: Tilt,
        point: [f64; 3],
    ) -> ([f64; 3], [f64; 3]) {
        let [along, across, normal] = tilt.axes();
        let track = |[x, s, n]: [f64; 3]| {
            [0, 1, 2].map(|i: usize| x * along[i] + s * across[i] + n * normal[i])
        };
        let (force, couple) = (track(self.force), track(self.couple));
        let arm = [0, 1, 2].map(|i: usize| reference[i] - point[i]);
        let lever = cross(arm, force);
        (force, [0, 1, 2].map(|i: usize| lever[i] + couple[i]))
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
            force_error: self.force_error.zip(other.force_error).map(|(a, b)| sum(a, b)),
            moment: sum(self.moment, other.moment),
        }
    }
}
