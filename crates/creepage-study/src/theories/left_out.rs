//! What theories leave out between unlike bodies (6.4), and when it matters.

use std::fmt;

use crate::theories::registry::Entry;

/// The slip by the pressure between unlike bodies, left out by a theory though it matters.
///
/// ```
/// let [exact, fastsim] = ["exact", "fastsim"].map(|name| creepage_study::find(name).unwrap());
/// assert!(exact.leaves_out(0.3).is_none());
/// assert!(fastsim.leaves_out(0.3).is_some());
/// assert!(fastsim.leaves_out(0.001).is_none());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// The theory.
    pub theory: &'static str,
    /// How unlike the bodies are.
    pub kappa_over_mu: f64,
}

impl LeftOut {
    /// `|kappa/mu|` from which it matters: the force may be off by a hundredth of `mu N` then, about
    /// the median error of the best of the theories that leave it out.
    pub const MATTERS: f64 = 0.01;

    /// By how much the force may be off, in parts of `mu N`, roughly: `|kappa/mu|`.
    ///
    /// The pressure's slip changes the force most where there is no creepage. On a circle with
    /// Poisson's ratio 0.28 it is 1.0 times `kappa/mu` there; 0.4 to 2.1 times over `a/b` from 20
    /// to 0.05 and Poisson's ratios from 0.1 to 0.45.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.kappa_over_mu.abs().min(1.0)
    }
}

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (theory, kappa_over_mu, percent) =
            (self.theory, self.kappa_over_mu, 100.0 * self.error());
        write!(
            f,
            "{theory} takes the bodies for like ones (kappa/mu = {kappa_over_mu:.3}): for that the \
             force may be off by some {percent:.0} % of mu N; exact counts it"
        )
    }
}

impl Entry {
    /// What the theory leaves out between bodies that are so unlike, if that matters.
    #[must_use]
    pub fn leaves_out(&self, kappa_over_mu: f64) -> Option<LeftOut> {
        let matters = !self.unlike_bodies && kappa_over_mu.abs() >= LeftOut::MATTERS;
        matters.then_some(LeftOut { theory: self.name, kappa_over_mu })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::find;
    use creepage::rolling::Creepage;
    use creepage::rolling::exact::{Exact, Resolution};

    /// Change of the force by `kappa/mu`, over it.
    fn change(like: &Exact, kappa_over_mu: f64, creepage: Creepage) -> f64 {
        let unlike = like.clone().with_unlikeness(kappa_over_mu).unwrap();
        let [one, two] = [like, &unlike]
            .map(|theory| theory.solve_with(creepage, &mut theory.workspace()).force);
        (two.fx - one.fx).hypot(two.fy - one.fy) / kappa_over_mu
    }

    #[test]
    fn the_force_may_be_off_by_about_kappa_over_mu() {
        let circle = Exact::new(1.0, 0.28, Resolution::STANDARD).unwrap();
        let at_rest = change(&circle, LeftOut::MATTERS, Creepage::default());
        assert!((at_rest - 1.0).abs() < 0.05, "{at_rest}");
        // The ends of the range that is claimed: slender one way and the other.
        for (ratio, poisson) in [(0.05, 0.1), (0.05, 0.45), (1.0, 0.45), (20.0, 0.1), (20.0, 0.45)]
        {
            let like = Exact::new(ratio, poisson, Resolution::FAST).unwrap();
            let at_rest = change(&like, LeftOut::MATTERS, Creepage::default());
            assert!((0.35..2.2).contains(&at_rest), "{ratio} {poisson}: {at_rest}");
            for [xi, eta, chi] in [
                [0.0, 0.0, 0.0],
                [0.2, 0.0, 0.0],
                [-0.2, 0.3, 0.1],
                [0.0, 0.5, 0.5],
                [1.0, 0.0, 0.0],
                [-0.5, 0.0, 2.0],
            ] {
                for kappa_over_mu in [LeftOut::MATTERS, 0.3] {
                    let change = change(&like, kappa_over_mu, Creepage { xi, eta, chi });
                    // Nowhere more than where all adheres; 5 % for the coarse elements.
                    assert!(change < 1.05 * at_rest, "{ratio} {poisson} {xi}: {change} {at_rest}");
                }
            }
        }
    }

    #[test]
    fn what_matters_is_told_by_all_but_the_full_theory() {
        for entry in crate::ENTRIES {
            for kappa_over_mu in [-5.0, -0.01, 0.01, 0.4] {
                let told = entry.leaves_out(kappa_over_mu);
                assert_eq!(told.is_some(), entry.name != "exact", "{}", entry.name);
            }
            assert!(entry.leaves_out(0.009).is_none() && entry.leaves_out(-0.009).is_none());
        }
        let words = find("polach").unwrap().leaves_out(-0.37).unwrap().to_string();
        assert!(words.contains("kappa/mu = -0.370") && words.contains("37 % of mu N"), "{words}");
    }
}
