//! Derivatives of a contact's friction by the wheelset's motion, at fixed pressure.

use creepage::theory::Jacobian;
use creepage::{Force, SiForce};
use creepage_rail::Motion;

use super::tangential::{Rolled, Rolling};
use crate::RigidSlip;
use crate::{StateVariable, WheelsetError};

/// By what part of the rolling speed surfaces are made faster to differentiate their creepage.
const OF_SPEED: f64 = 1e-5;
/// By how many units of slip, where friction is solved anew.
const OF_SLIP: f64 = 1e-2;

/// The parts of the motion.
const MOTION: [StateVariable; 4] = [
    StateVariable::Speed,
    StateVariable::PitchRate,
    StateVariable::LateralVelocity,
    StateVariable::YawRate,
];

/// The derivatives of the friction by each part of the motion: by the theory's own derivative; by
/// differences where slip on a curved contact changes by more than its creepage and spin.
pub(crate) fn friction(
    rolling: &Rolling<'_, '_>,
    motion: Motion,
) -> Result<Vec<(StateVariable, SiForce)>, WheelsetError> {
    let mut rolled = rolling.roll(&motion, None)?;
    let jacobian = rolled.solved.jacobian().filter(|_| rolling.slip == RigidSlip::Flat);
    let mut all = Vec::with_capacity(MOTION.len());
    for by in MOTION {
        let change = Change { rolling, motion, by };
        let force;
        if let Some(jacobian) = &jacobian {
            force = change.by_creepage(jacobian)?;
        } else {
            (rolled, force) = change.solved(rolled)?;
        }
        all.push((by, force));
    }
    Ok(all)
}

/// A contact whose wheelset moves by a little more or less of one part of its motion.
#[derive(Debug, Clone, Copy)]
struct Change<'r, 'w, 'a> {
    rolling: &'r Rolling<'w, 'a>,
    motion: Motion,
    by: StateVariable,
}

impl<'r> Change<'r, '_, '_> {
    fn by_creepage(&self, jacobian: &Jacobian) -> Result<SiForce, WheelsetError> {
        let step = self.step(OF_SPEED);
        let [ahead, behind] = [step, -step].map(|step| self.rolling.creepage(&self.moved(step)));
        let (ahead, behind) = (ahead?, behind?);
        let by = |high: f64, low: f64| (high - low) / (2.0 * step);
        let scaling = self.rolling.scaling();
        let creepage = [
            by(ahead.longitudinal, behind.longitudinal) / scaling.slip,
            by(ahead.lateral, behind.lateral) / scaling.slip,
            by(ahead.spin, behind.spin) * scaling.length / scaling.slip,
        ];
        let [fx, fy, mz] =
            jacobian.map(|row| row.iter().zip(creepage).map(|(part, by)| part * by).sum());
        Ok(scaling.si_force(Force { fx, fy, mz }))
    }

    /// From what is rolled nearby, and what that came to last.
    fn solved(&self, before: Rolled<'r>) -> Result<(Rolled<'r>, SiForce), WheelsetError> {
        let step = self.step(OF_SLIP * self.rolling.scaling().slip);
        let ahead = self.rolling.roll(&self.moved(step), Some(before))?;
        let high = ahead.force;
        let behind = self.rolling.roll(&self.moved(-step), Some(ahead))?;
        let by = |high: f64, low: f64| (high - low) / (2.0 * step);
        let low = behind.force;
        let force = SiForce {
            longitudinal: by(high.longitudinal, low.longitudinal),
            lateral: by(high.lateral, low.lateral),
            moment: by(high.moment, low.moment),
        };
        Ok((behind, force))
    }

    /// A change that makes a creepage of about `part` (m/s or rad/s).
    fn step(&self, part: f64) -> f64 {
        let Motion { speed, pitch_rate, .. } = self.motion;
        let speed = part * speed.max(pitch_rate.abs() * self.rolling.wheel.radius);
        match self.by {
            StateVariable::PitchRate | StateVariable::YawRate => speed / self.rolling.wheel.radius,
            _ => speed,
        }
    }

    fn moved(&self, step: f64) -> Motion {
        let Motion { speed, pitch_rate, lateral_velocity, yaw_rate, .. } = self.motion;
        match self.by {
            StateVariable::Speed => Motion { speed: speed + step, ..self.motion },
            StateVariable::PitchRate => Motion { pitch_rate: pitch_rate + step, ..self.motion },
            StateVariable::LateralVelocity => {
                Motion { lateral_velocity: lateral_velocity + step, ..self.motion }
            }
            StateVariable::YawRate => Motion { yaw_rate: yaw_rate + step, ..self.motion },
            StateVariable::Y | StateVariable::Z | StateVariable::Roll | StateVariable::Yaw => {
                self.motion
            }
        }
    }
}
