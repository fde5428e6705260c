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

#[cfg(test)]
mod tests {
    use super::*;
    use creepage::rolling::exact::{Exact, Resolution};
    use creepage::rolling::{Creepage, Force};

    #[test]
    fn explore() {
        let mut all: f64 = 0.0;
        for ratio in [0.05, 0.2, 0.5, 1.0, 2.0, 5.0, 20.0] {
            for poisson in [0.1, 0.28, 0.45] {
                let like = Exact::new(ratio, poisson, Resolution::FAST).unwrap();
                for kappa_over_mu in [0.01, 0.1, 0.3, 1.0] {
                    let unlike = like.clone().with_unlikeness(kappa_over_mu).unwrap();
                    let (mut worst, mut at) = (0.0, Creepage::default());
                    let mut sum = 0.0;
                    let mut count = 0;
                    for creepage in creepages() {
                        let [one, two] = [&like, &unlike]
                            .map(|theory| theory.solve_with(creepage, &mut theory.workspace()));
                        let Force { fx, fy, .. } = one.force;
                        let change = (two.force.fx - fx).hypot(two.force.fy - fy) / kappa_over_mu;
                        sum += change * change;
                        count += 1;
                        if change > worst {
                            (worst, at) = (change, creepage);
                        }
                    }
                    all = all.max(worst);
                    println!(
                        "{ratio} {poisson} {kappa_over_mu}: rms {:.3} worst {worst:.3} at {at:?}",
                        (sum / f64::from(count)).sqrt()
                    );
                }
            }
        }
        println!("{all}");
    }

    fn creepages() -> impl Iterator<Item = Creepage> {
        let sizes = [0.0, 0.1, 0.3, 0.6, 1.0, 2.0];
        let spins = [0.0, 0.3, 1.0, 3.0];
        sizes.into_iter().flat_map(move |size| {
            (0..8).flat_map(move |k| {
                let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos();
                spins.map(|chi| Creepage { xi: size * cos, eta: size * sin, chi })
            })
        })
    }
}
