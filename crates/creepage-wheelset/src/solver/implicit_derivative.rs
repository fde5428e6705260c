//! Implicit derivatives: how the free variables of an equilibrium follow the given ones.

use nalgebra::{DMatrix, DVector};

use super::pose_derivative::{AXLE, LONGITUDINAL, LoadJacobian, ROLLING, VERTICAL};
use crate::pose::{Drive, PitchRate};
use crate::{Load, StateVariable, WheelsetError, WheelsetPose, WheelsetVelocity};

/// Both wheels, left and right; zeros for one that is not there.
pub(crate) type WheelJacobians = [LoadJacobian; 2];

/// Weights of the left and the right wheel.
type WheelWeights = [f64; 2];
const BOTH: WheelWeights = [1.0, 1.0];
const LEFT: WheelWeights = [1.0, 0.0];
const RIGHT: WheelWeights = [0.0, 1.0];

/// Free variables of an equilibrium, and the sums that it keeps.
pub(crate) struct FreeVariables {
    /// Each with the wheels that it moves.
    unknowns: Vec<(StateVariable, WheelWeights)>,
    kept: Vec<Kept>,
}

/// A sum over both wheels of something that they do.
struct Kept {
    /// Its place among [`WheelLoads`](super::pose_derivative::WheelLoads).
    what: usize,
    share: WheelWeights,
}

impl FreeVariables {
    /// A wheel that touches nothing (`hangs`: the left, the right one) has no pitch rate to be found.
    pub(crate) fn of(
        stance: &WheelsetPose,
        travel: &WheelsetVelocity,
        hangs: [bool; 2],
    ) -> Result<Self, WheelsetError> {
        let load = stance.load.ok_or(WheelsetError::NoLoad)?;
        let mut found = match (stance.side, stance.roll, load) {
            (Some(_), _, Load::Height(_)) | (None, Some(_), Load::Height(_)) => {
                Self { unknowns: Vec::new(), kept: Vec::new() }
            }
            (Some(_), _, _) | (None, Some(_), Load::Axle(_) | Load::Loaded { .. }) => Self {
                unknowns: vec![(StateVariable::Z, BOTH)],
                kept: vec![Kept { what: VERTICAL, share: BOTH }],
            },
            (None, Some(_), Load::Wheel(_) | Load::Wheels(_)) => Self {
                unknowns: vec![(StateVariable::Z, LEFT), (StateVariable::Z, RIGHT)],
                kept: vec![
                    Kept { what: VERTICAL, share: LEFT },
                    Kept { what: VERTICAL, share: RIGHT },
                ],
            },
            (None, None, Load::Height(_)) => Self {
                unknowns: vec![(StateVariable::Roll, BOTH)],
                kept: vec![Kept { what: VERTICAL, share: [-1.0, 1.0] }],
            },
            (None, None, Load::Loaded { .. }) => Self {
                unknowns: vec![(StateVariable::Z, BOTH), (StateVariable::Roll, BOTH)],
                kept: vec![
                    Kept { what: VERTICAL, share: BOTH },
                    Kept { what: ROLLING, share: BOTH },
                ],
            },
            (None, None, Load::Axle(_) | Load::Wheel(_) | Load::Wheels(_)) => Self {
                unknowns: vec![(StateVariable::Z, BOTH), (StateVariable::Roll, BOTH)],
                kept: vec![
                    Kept { what: VERTICAL, share: LEFT },
                    Kept { what: VERTICAL, share: RIGHT },
                ],
            },
        };
        let what = match travel.drive {
            Drive::Torque(_) => AXLE,
            Drive::Force(_) => LONGITUDINAL,
        };
        let mut turns = |share: WheelWeights| {
            found.unknowns.push((StateVariable::PitchRate, share));
            found.kept.push(Kept { what, share });
        };
        match travel.pitch {
            PitchRate::Rigid(Some(_)) => (),
            PitchRate::Rigid(None) => turns(BOTH),
            PitchRate::Independent(rates) => {
                for ((rate, share), hangs) in rates.into_iter().zip([LEFT, RIGHT]).zip(hangs) {
                    if rate.is_none() && !hangs {
                        turns(share);
                    }
                }
            }
        }
        Ok(found)
    }

    pub(crate) fn has(&self, by: StateVariable) -> bool {
        self.unknowns.iter().any(|(own, _)| *own == by)
    }

    /// The derivatives when the unknowns follow.
    pub(crate) fn total(&self, partial: &WheelJacobians) -> Result<WheelJacobians, WheelsetError> {
        if self.unknowns.is_empty() {
            return Ok(*partial);
        }
        let by_unknowns = DMatrix::from_fn(self.kept.len(), self.unknowns.len(), |i, j| {
            let (by, whose) = self.unknowns[j];
            self.kept[i].change(partial, by, whose)
        });
        let by_unknowns = by_unknowns.lu();
        let mut total = *partial;
        for by in StateVariable::ALL {
            let by_given = self.kept.iter().map(|kept| -kept.change(partial, by, [1.0; 2]));
            let by_given = DVector::from_iterator(self.kept.len(), by_given);
            let follow = by_unknowns.solve(&by_given).ok_or(WheelsetError::NotDifferentiable)?;
            for (&(own, whose), follow) in self.unknowns.iter().zip(&follow) {
                for (k, total) in total.iter_mut().enumerate() {
                    let mut sum = total.column_mut(by.index());
                    sum += partial[k].column(own.index()) * (whose[k] * follow);
                }
            }
        }
        Ok(total)
    }
}

impl Kept {
    /// How it changes by a number of some wheels.
    fn change(&self, partial: &WheelJacobians, by: StateVariable, whose: WheelWeights) -> f64 {
        let of = |k: usize| self.share[k] * whose[k] * partial[k][(self.what, by.index())];
        of(0) + of(1)
    }
}
