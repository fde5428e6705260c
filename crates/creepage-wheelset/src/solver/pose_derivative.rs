//! Partial derivatives of one wheel's loads by its position and motion, by central differences of two steps.

use creepage::SiForce;
use creepage_rail::{Motion, Position};
use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;

use super::normal_contact::{PatchWarmStart, PressedContact, PressedWheel};
use super::tangential::{Method, Rolling};
use super::{WheelsetSolver, motion_derivative};
use crate::resultant::ContactForces;
use crate::solved::SolvedWheel;
use crate::tilt::Placed;
use crate::{StateVariable, WheelsetError};

/// Force (N) and moment (N m) on the rail, the moment of friction about the axle (N m),
/// the moment about `x` through the wheelset's centre (N m).
pub(crate) type WheelLoads = SVector<f64, 8>;
/// Where they have the force along the track.
pub(crate) const LONGITUDINAL: usize = 0;
/// Where they have the vertical force.
pub(crate) const VERTICAL: usize = 2;
/// Where they have the moment about the axle.
pub(crate) const AXLE: usize = 6;
/// Where they have the moment about `x` through the wheelset's centre.
pub(crate) const ROLLING: usize = 7;

/// Derivatives of the wheel's loads by [`StateVariable::ALL`].
pub(crate) type LoadJacobian = SMatrix<f64, 8, 8>;

/// A part of the position that is moved, and by how much to either side (m, rad): less, and the
/// pressures' scatter shows; more, and so do the kinks of the profiles' curvature.
const DIFFERENCE_STEPS: [(StateVariable, f64); 4] = [
    (StateVariable::Y, 5e-7),
    (StateVariable::Z, 5e-7),
    (StateVariable::Roll, 7.5e-7),
    (StateVariable::Yaw, 5e-6),
];
/// Of those steps: the second tells how far to believe the first.
const TIMES: [f64; 2] = [1.0, 2.0];

/// One wheel where it stands, as it moves.
pub(crate) struct PoseDerivative<'s, 'a> {
    pub(crate) solver: &'s WheelsetSolver<'a>,
    pub(crate) wheel: &'s SolvedWheel,
    pub(crate) known: &'s [PatchWarmStart],
    pub(crate) motion: Motion,
    pub(crate) method: Method,
}

impl<'a> PoseDerivative<'_, 'a> {
    /// Its derivatives with the step, and with twice the step.
    pub(crate) fn partials(&self) -> Result<[LoadJacobian; 2], WheelsetError> {
        let all: Vec<_> =
            TIMES.iter().flat_map(|by| DIFFERENCE_STEPS.iter().map(move |to| (by, to))).collect();
        let differences = all.into_par_iter().map(|(times, &(by, step))| {
            let difference = self.difference(by, times * step)?;
            Ok((by, difference))
        });
        let differences = differences.collect::<Result<Vec<_>, WheelsetError>>()?;
        let mut partials = [self.motion_derivative()?; 2];
        for (partial, differences) in
            partials.iter_mut().zip(differences.chunks(DIFFERENCE_STEPS.len()))
        {
            for (by, difference) in differences {
                partial.set_column(by.index(), difference);
            }
        }
        Ok(partials)
    }

    fn difference(&self, by: StateVariable, step: f64) -> Result<WheelLoads, WheelsetError> {
        let [ahead, behind] =
            [step, -step].map(|step| self.acts(moved(self.wheel.position, by, step)));
        Ok((ahead? - behind?) / (2.0 * step))
    }

    /// What it does in a position.
    fn acts(&self, position: Position) -> Result<WheelLoads, WheelsetError> {
        let wheels = self.pressed(position)?;
        let mut sum = WheelLoads::zeros();
        for rolling in self.rollings(&wheels)? {
            let friction = rolling.roll(&self.motion, None)?.force;
            sum += self.acting(&rolling, friction, rolling.pressed.load());
        }
        Ok(sum)
    }

    fn motion_derivative(&self) -> Result<LoadJacobian, WheelsetError> {
        let wheels = self.pressed(self.wheel.position)?;
        let mut sum = LoadJacobian::zeros();
        for rolling in self.rollings(&wheels)? {
            for (by, friction) in motion_derivative::friction(&rolling, self.motion)? {
                let mut column = sum.column_mut(by.index());
                column += self.acting(&rolling, friction, 0.0);
            }
        }
        Ok(sum)
    }

    /// The pressed wheel, solved twice: a single warm-started solution keeps a bias of some 1 % of the change.
    fn pressed(&self, position: Position) -> Result<[PressedWheel<'a>; 1], WheelsetError> {
        let first = self.solver.press.wheel(self.wheel.side, position, self.known)?;
        Ok([self.solver.press.wheel(self.wheel.side, position, &PatchWarmStart::of(&[first]))?])
    }

    fn rollings<'w>(
        &self,
        wheels: &'w [PressedWheel<'a>],
    ) -> Result<Vec<Rolling<'w, 'a>>, WheelsetError> {
        Rolling::all(wheels, self.solver, self.motion.speed, (self.method, &[]))
    }

    /// Friction and a load at a contact.
    fn acting(&self, rolling: &Rolling<'_, '_>, friction: SiForce, load: f64) -> WheelLoads {
        let PressedContact { contact, normal } = rolling.pressed;
        let acting = ContactForces::new(friction, load, normal.centroid());
        let origin = self.wheel.rail_origin;
        let ([x, y, z], [mx, my, mz]) = acting.about(contact.reference, contact.tilt(), origin);
        let (_, [about, ..]) = acting.about(contact.reference, contact.tilt(), rolling.centre());
        WheelLoads::from([x, y, z, mx, my, mz, rolling.axle_moment(friction), about])
    }
}

fn moved(position: Position, by: StateVariable, step: f64) -> Position {
    let Position { y, z, roll, yaw } = position;
    match by {
        StateVariable::Y => Position { y: y + step, ..position },
        StateVariable::Z => Position { z: z + step, ..position },
        StateVariable::Roll => Position { roll: roll + step, ..position },
        StateVariable::Yaw => Position { yaw: yaw + step, ..position },
        StateVariable::Speed
        | StateVariable::PitchRate
        | StateVariable::LateralVelocity
        | StateVariable::YawRate => position,
    }
}
