//! How unlike the bodies are (6.4).

use creepage::Hertz;

/// How unlike the bodies of a contact are: kappa of (2.10) over the coefficient of friction.
#[must_use]
pub fn kappa_over_mu(contact: &Hertz, friction: f64) -> f64 {
    contact.pair().kappa() / friction
}
