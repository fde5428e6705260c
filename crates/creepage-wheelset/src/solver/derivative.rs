//! Derivatives of the forces on both rails, with the implicit ones of what the wheelset finds for itself.

use creepage_rail::Side;

use super::WheelsetSolver;
use super::implicit_derivative::{FreeVariables, WheelJacobians};
use super::normal_contact::PatchWarmStart;
use super::pose_derivative::{LoadJacobian, PoseDerivative, WheelLoads};
use super::tangential::Method;
use crate::derivatives::{Row, WheelsetDerivatives};
use crate::solved::SolvedWheelset;
use crate::{ForceDerivative, StateVariable, WheelsetError, WheelsetPose, WheelsetVelocity};

impl WheelsetSolver<'_> {
    /// Derivatives of the forces on the rails where the wheelset was solved, by what `stance` and
    /// `travel` give of its position and motion: those that it was solved with. With
    /// `resolution = "auto"` they are those of the fast one.
    ///
    /// # Errors
    /// [`WheelsetError`] where a position next to it has no contacts that can be solved, or what
    /// is found does not follow what is given.
    pub fn derivatives(
        &self,
        solved: &SolvedWheelset,
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
    ) -> Result<WheelsetDerivatives, WheelsetError> {
        if self.press.running.varies() {
            return Err(WheelsetError::Varies { what: "the derivative of the forces" });
        }
        if travel.is_backward() {
            let (stance, travel) = (stance.fore_and_aft(), travel.fore_and_aft());
            let forward = self.derivatives(&solved.clone().fore_and_aft(), &stance, &travel)?;
            return Ok(forward.fore_and_aft());
        }
        let hangs = [&solved.left, &solved.right]
            .map(|wheel| wheel.as_ref().is_none_or(|wheel| wheel.contacts().is_empty()));
        let found = FreeVariables::of(stance, travel, hangs)?;
        let [near, far] = self.partials(solved)?;
        let [near, far] = [found.total(&near)?, found.total(&far)?];
        let row = |index: usize| -> Row {
            StateVariable::ALL.map(|by| {
                let column =
                    |pair: &WheelJacobians| -> WheelLoads { pair[index].column(by.index()).into() };
                (!found.has(by)).then(|| derivative(column(&near), column(&far)))
            })
        };
        Ok(WheelsetDerivatives {
            left: solved.left.as_ref().map(|_| row(0)),
            right: solved.right.as_ref().map(|_| row(1)),
        })
    }

    /// With all else held, by the step and by twice the step.
    fn partials(&self, solved: &SolvedWheelset) -> Result<[WheelJacobians; 2], WheelsetError> {
        let method = *self.rolling.first().unwrap_or(&Method::STANDARD);
        let known = PatchWarmStart::solved(solved);
        let mut pairs = [[LoadJacobian::zeros(); 2]; 2];
        for wheel in solved.wheels() {
            let pose_derivative = PoseDerivative {
                solver: self,
                wheel,
                known: &known,
                motion: solved.motion_of(wheel),
                method,
            };
            for (pair, partial) in pairs.iter_mut().zip(pose_derivative.partials()?) {
                pair[usize::from(wheel.side == Side::Right)] = partial;
            }
        }
        Ok(pairs)
    }
}

fn derivative(near: WheelLoads, far: WheelLoads) -> ForceDerivative {
    let error = (near - far).abs();
    let three = |from: &WheelLoads, first: usize| [0, 1, 2].map(|i| from[first + i]);
    ForceDerivative {
        force: three(&near, 0),
        force_error: three(&error, 0),
        moment: three(&near, 3),
        moment_error: three(&error, 3),
    }
}
