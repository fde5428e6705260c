//! Constraints of an inverse problem, and the errors of those that have no answer.

use crate::check::InvalidValue;
use crate::creepage::{Creepage, Force};

/// Prescribed components of creepage and force; exactly three are `Some`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Constraints {
    /// Longitudinal creepage.
    pub xi: Option<f64>,
    /// Lateral creepage.
    pub eta: Option<f64>,
    /// Spin.
    pub chi: Option<f64>,
    /// Longitudinal force.
    pub fx: Option<f64>,
    /// Lateral force.
    pub fy: Option<f64>,
    /// Moment.
    pub mz: Option<f64>,
}

/// Error of an inverse problem without an answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InverseError {
    /// Three quantities determine the other three; more contradict, fewer leave them open.
    #[error("{given} of the six quantities are given: exactly three must be")]
    NotThree {
        /// How many are given.
        given: usize,
    },
    /// A given quantity is not a finite number.
    #[error(transparent)]
    InvalidValue(#[from] InvalidValue),
    /// No creepage gives the prescribed force.
    #[error(
        "the force is not reachable: at most fx = {}, fy = {}, mz = {} was reached, at xi = {}, \
         eta = {}, chi = {}", .nearest.fx, .nearest.fy, .nearest.mz, .at.xi, .at.eta, .at.chi
    )]
    NotReachable {
        /// The force that came nearest.
        nearest: Force,
        /// Its creepage.
        at: Creepage,
    },
}
