//! Unlike bodies (6.4): the slip that their pressure causes, and the theories that leave it out.

use std::fmt;

use creepage::{Hertz, InvalidValue};

use crate::registry::Entry;

/// How unlike the bodies of a contact are: kappa of (2.10) over the coefficient of friction.
#[must_use]
pub fn kappa_over_mu(contact: &Hertz, friction: f64) -> f64 {
    contact.pair().kappa() / friction
}

/// The slip by the pressure between unlike bodies, left out by a theory though it matters.
///
/// ```
/// let [exact, fastsim] = ["exact", "fastsim"].map(|name| creepage_theories::find(name).unwrap());
/// assert!(exact.leaves_out(0.3).is_none());
/// assert!(fastsim.leaves_out(0.3).unwrap().error > 0.1);
/// assert!(fastsim.leaves_out(0.001).is_none());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// The theory.
    pub theory: &'static str,
    /// How unlike the bodies are.
    pub kappa_over_mu: f64,
    /// By how much the force may be off for it, in parts of `mu N`.
    pub error: f64,
}

impl LeftOut {
    /// The most by which the force changes with `kappa/mu`, in parts of `mu N`: TODO.
    pub const SLOPE: f64 = 1.0;
    /// TODO
    pub const MATTERS: f64 = 0.01;
}

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { theory, kappa_over_mu, error } = self;
        write!(
            f,
            "{theory} takes the bodies for like ones (kappa/mu = {kappa_over_mu:.3}): for that the \
             force may be off by {:.0} % of mu N; exact counts it",
            100.0 * error
        )
    }
}

impl Entry {
    /// What the theory leaves out between bodies that are so unlike, if that matters.
    #[must_use]
    pub fn leaves_out(&self, kappa_over_mu: f64) -> Option<LeftOut> {
        let error = (LeftOut::SLOPE * kappa_over_mu.abs()).min(2.0);
        let matters = !self.unlike_bodies && error >= LeftOut::MATTERS;
        matters.then_some(LeftOut { theory: self.name, kappa_over_mu, error })
    }
}

/// The range that the full theory takes, for those that leave it out too.
pub(crate) fn check(kappa_over_mu: f64) -> Result<(), InvalidValue> {
    if kappa_over_mu.abs() <= 1e6 {
        return Ok(());
    }
    let valid = "between -1e6 and 1e6";
    Err(InvalidValue { quantity: "kappa_over_mu", value: kappa_over_mu, valid })
}
