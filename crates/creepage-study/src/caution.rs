//! What is to be held against a solution.

use std::fmt;

use creepage::{Contact, Solution, Status, TheorySpec};

/// What is to be held against a solution; in words by [`Display`](fmt::Display). Text, JSON,
/// `batch`, Python and C all show it.
///
/// ```
/// use creepage::{Contact, Creepage, Ellipse, TheorySpec};
/// use creepage_study::Caution;
/// let unlike = Contact::new(Ellipse::from_ratio(1.0)?, 0.3)?.with_kappa_over_mu(0.3)?;
/// for (name, count) in [("exact", 0), ("fastsim", 1)] {
///     let theory = TheorySpec::named(name)?;
///     let solution = theory.prepare(&unlike)?.solve(Creepage::new(0.5, 0.0, 0.0)?);
///     assert_eq!(Caution::all(&theory, &unlike, &solution).len(), count);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Caution {
    /// The theory did not solve the case, or does not hold in it.
    Status(Status),
    /// The theory neglects the slip by the pressure between dissimilar bodies, though it matters.
    Dissimilar {
        /// The theory.
        theory: &'static str,
        /// How dissimilar the bodies are.
        kappa_over_mu: f64,
    },
    /// The error bars are above the prescribed accuracy at the finest resolution.
    Accuracy {
        /// The prescribed accuracy of the forces, in parts of `mu N`.
        prescribed: f64,
        /// The larger error bar of both forces.
        reached: f64,
    },
}

impl Caution {
    /// `|kappa/mu|` from which neglecting it matters: the force may be off by a hundredth of `mu N`
    /// then, about the median error of the best of the theories that neglect it.
    pub const DISSIMILAR: f64 = 0.01;

    /// All that is to be held against a solution of `theory` for `contact`.
    #[must_use]
    pub fn all(theory: &TheorySpec, contact: &Contact, solution: &Solution) -> Vec<Self> {
        let status = (solution.status != Status::Solved).then_some(Self::Status(solution.status));
        let dissimilar = Self::dissimilar(theory, contact.kappa_over_mu());
        let accuracy =
            theory.prescribed_accuracy().zip(solution.error).map(|(prescribed, error)| {
                Self::Accuracy { prescribed, reached: error.fx.max(error.fy) }
            });
        let accuracy = accuracy.filter(|caution| {
            matches!(caution, Self::Accuracy { prescribed, reached } if reached > prescribed)
        });
        [status, dissimilar, accuracy].into_iter().flatten().collect()
    }

    /// What a theory neglects between bodies that are so dissimilar, if that matters.
    #[must_use]
    pub fn dissimilar(theory: &TheorySpec, kappa_over_mu: f64) -> Option<Self> {
        let facts = theory.facts();
        let matters = !facts.dissimilar_bodies && kappa_over_mu.abs() >= Self::DISSIMILAR;
        matters.then_some(Self::Dissimilar { theory: facts.name, kappa_over_mu })
    }

    /// All of them in words, one after the other.
    #[must_use]
    pub fn words(cautions: &[Self]) -> String {
        cautions.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    }
}

impl fmt::Display for Caution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Status(Status::NotConverged) => {
                f.write_str("did not converge: the force is that of the last iterate")
            }
            Self::Status(Status::CreepageTooSmall) => {
                f.write_str("the creepage is too small for the theory's resolution")
            }
            Self::Status(Status::SpinTooLarge) => {
                f.write_str("the spin is beyond the bound up to which the theory holds")
            }
            Self::Status(other) => f.write_str(other.name()),
            // The pressure's slip changes the force most where there is no creepage. On a circle
            // with Poisson's ratio 0.28 the change is 1.0 times kappa/mu there; 0.4 to 2.1 times
            // over a/b from 20 to 0.05 and Poisson's ratios from 0.1 to 0.45.
            Self::Dissimilar { theory, kappa_over_mu } => write!(
                f,
                "{theory} takes the bodies for like ones (kappa/mu = {kappa_over_mu:.3}): for \
                 that the force may be off by some {:.0} % of mu N; exact counts it",
                100.0 * kappa_over_mu.abs().min(1.0)
            ),
            Self::Accuracy { prescribed, reached } => write!(
                f,
                "at the finest resolution the error bars reach {reached:.2e} of mu N, above the \
                 prescribed accuracy of {prescribed:e}"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use creepage::coulomb::{Exact, Resolution};
    use creepage::{Creepage, Ellipse, Theory};

    use super::*;

    fn contact(ratio: f64, poisson: f64, kappa_over_mu: f64) -> Contact {
        let like = Contact::new(Ellipse::from_ratio(ratio).unwrap(), poisson).unwrap();
        like.with_kappa_over_mu(kappa_over_mu).unwrap()
    }

    #[test]
    fn the_force_may_be_off_by_about_kappa_over_mu() {
        // The ends of the range that is claimed: slender one way and the other.
        for (ratio, poisson, resolution, range) in [
            (1.0, 0.28, Resolution::STANDARD, 0.95..1.05),
            (0.05, 0.1, Resolution::FAST, 0.35..2.2),
            (0.05, 0.45, Resolution::FAST, 0.35..2.2),
            (20.0, 0.1, Resolution::FAST, 0.35..2.2),
            (20.0, 0.45, Resolution::FAST, 0.35..2.2),
        ] {
            let change = |kappa_over_mu: f64, creepage| {
                let [like, unlike] = [0.0, kappa_over_mu].map(|kappa| {
                    let contact = contact(ratio, poisson, kappa);
                    Exact::new(&contact, resolution).unwrap().solve(creepage).force
                });
                (unlike.fx - like.fx).hypot(unlike.fy - like.fy) / kappa_over_mu
            };
            let at_rest = change(Caution::DISSIMILAR, Creepage::default());
            assert!(range.contains(&at_rest), "{ratio} {poisson}: {at_rest}");
            for [xi, eta, chi] in [[0.2, 0.0, 0.0], [0.0, 0.5, 0.5], [-0.5, 0.0, 2.0]] {
                let creepage = Creepage::new(xi, eta, chi).unwrap();
                // Nowhere more than where all adheres; 5 % for the coarse elements.
                assert!(change(0.3, creepage) < 1.05 * at_rest, "{ratio} {poisson} {xi}");
            }
        }
    }

    #[test]
    fn what_matters_is_a_caution_for_all_but_the_full_theory() {
        for theory in TheorySpec::all() {
            for kappa_over_mu in [-5.0, -0.01, 0.01, 0.4] {
                let caution = Caution::dissimilar(&theory, kappa_over_mu);
                assert_eq!(caution.is_some(), theory.facts().name != "exact");
            }
            assert_eq!(Caution::dissimilar(&theory, -0.009), None);
        }
        let polach = TheorySpec::named("polach").unwrap();
        let words = Caution::dissimilar(&polach, -0.37).unwrap().to_string();
        assert!(words.contains("kappa/mu = -0.370") && words.contains("37 % of mu N"), "{words}");
    }

    #[test]
    fn an_accuracy_out_of_reach_is_a_caution() {
        let auto = crate::theory_spec("exact", &["resolution=auto", "accuracy=1e-9"]).unwrap();
        let contact = contact(1.0, 0.3, 0.0);
        let solution = Solution {
            force: creepage::Force::default(),
            error: Some(creepage::Force { fx: 1e-4, fy: 0.0, mz: 0.0 }),
            status: Status::NotConverged,
            statistics: creepage::Statistics::default(),
        };
        let cautions = Caution::all(&auto, &contact, &solution);
        assert_eq!(cautions.len(), 2);
        assert!(Caution::words(&cautions).contains("1.00e-4 of mu N"));
    }
}
