//! Derivatives of the forces on the rails for programs.

use creepage_wheelset::{ForceDerivative, StateVariable, WheelsetDerivatives};
use std::collections::BTreeMap;

use creepage_rail::Side;
use serde::Serialize;

/// Derivatives of the force on one rail by the key of [`StateVariable`], per unit of that key; `null` by what
/// is found and not given.
pub type DerivativesJson = BTreeMap<&'static str, Option<ForceDerivativeJson>>;

/// The derivative of a force on a rail in track axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ForceDerivativeJson {
    /// Of the force along `x` (N per unit).
    pub longitudinal_n: f64,
    /// Error of the differences, here and below.
    pub longitudinal_error_n: f64,
    /// Along `y`.
    pub lateral_n: f64,
    /// Its error.
    pub lateral_error_n: f64,
    /// Along `z`.
    pub vertical_n: f64,
    /// Its error.
    pub vertical_error_n: f64,
    /// Of the moment about `x` through the origin of the rail's profile (N m per unit).
    pub moment_x_n_m: f64,
    /// Its error.
    pub moment_x_error_n_m: f64,
    /// About `y`.
    pub moment_y_n_m: f64,
    /// Its error.
    pub moment_y_error_n_m: f64,
    /// About `z`.
    pub moment_z_n_m: f64,
    /// Its error.
    pub moment_z_error_n_m: f64,
}

/// Derivatives of the force on one rail, ready for `serde_json`.
pub(super) fn derivatives_json(derivatives: &WheelsetDerivatives, side: Side) -> DerivativesJson {
    let one = |by: StateVariable| {
        (by.key(), derivatives.of(side, by).as_ref().map(ForceDerivativeJson::new))
    };
    StateVariable::ALL.into_iter().map(one).collect()
}

impl ForceDerivativeJson {
    fn new(derivative: &ForceDerivative) -> Self {
        let ForceDerivative { force, force_error, moment, moment_error } = *derivative;
        Self {
            longitudinal_n: force[0],
            longitudinal_error_n: force_error[0],
            lateral_n: force[1],
            lateral_error_n: force_error[1],
            vertical_n: force[2],
            vertical_error_n: force_error[2],
            moment_x_n_m: moment[0],
            moment_x_error_n_m: moment_error[0],
            moment_y_n_m: moment[1],
            moment_y_error_n_m: moment_error[1],
            moment_z_n_m: moment[2],
            moment_z_error_n_m: moment_error[2],
        }
    }
}
