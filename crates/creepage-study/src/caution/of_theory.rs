//! Cautions about a theory: what it neglects in a contact, and where its solution is in doubt.

use std::f64::consts::FRAC_PI_2;

use creepage::normal::{NormalContact, Patch};
use creepage::theory::{ExactOptions, NoOptions};
use creepage::{Contact, Layer, Solution, Status, TheorySpec};

use super::Caution;

impl Caution {
    /// `|kappa/mu|` from which neglecting it matters: the force may be off by a hundredth of `mu N`
    /// then, about the median error of the best of the theories that neglect it.
    pub const DISSIMILAR: f64 = 0.01;

    /// By how much coupling moves a force, in parts of `mu N`, over `|q|`, `q = kappa mu/(1 - sigma)`:
    /// 0.05 to 0.17 in steel on aluminium and on a polymer, friction 0.05 and 0.3, `a/b` 0.5 and 1. Of 94
    /// random cases (0.004 to 0.5) the caution is right in 81, needless in 4, missing in 9.
    const MOVED_BY_COUPLING: f64 = 0.15;

    /// Part by which a layer is stiffer than a thin one from which it is named.
    const THICK: f64 = 0.05;

    /// All warnings about a solution of `theory` for `contact`.
    #[must_use]
    pub fn all(theory: &TheorySpec, contact: &Contact, solution: &Solution) -> Vec<Self> {
        let status = (solution.status != Status::Solved).then_some(Self::Status(solution.status));
        let dissimilar = match contact.areas() {
            Some(_) => Self::like_bodies(contact.kappa_over_mu()),
            None => Self::dissimilar(theory, contact.kappa_over_mu()),
        };
        let one_way = Self::one_way(theory, contact, solution);
        let accuracy =
            theory.prescribed_accuracy().zip(solution.error).map(|(prescribed, error)| {
                Self::Accuracy { prescribed, reached: error.fx.max(error.fy) }
            });
        let accuracy = accuracy.filter(|caution| {
            matches!(caution, Self::Accuracy { prescribed, reached } if reached > prescribed)
        });
        let [friction, layer] = Self::between_surfaces(theory, contact);
        let beyond = Self::beyond_friction(solution.force.fx.hypot(solution.force.fy));
        let large = contact.friction().and_then(Self::large_friction);
        let all = [status, dissimilar, one_way, friction, layer, accuracy, beyond, large];
        let all = all.into_iter().flatten().chain(Self::slip_beyond(contact));
        all.chain(contact.areas().into_iter().flat_map(|areas| Self::of_areas(areas))).collect()
    }

    /// All that a theory neglects in a contact, or is not given of it, whatever it creeps.
    #[must_use]
    pub fn neglected(theory: &TheorySpec, contact: &Contact) -> Vec<Self> {
        let dissimilar = match contact.areas() {
            Some(_) => Self::like_bodies(contact.kappa_over_mu()),
            None => Self::dissimilar(theory, contact.kappa_over_mu()),
        };
        let between = Self::between_surfaces(theory, contact).into_iter().flatten();
        let large = contact.friction().and_then(Self::large_friction);
        let all = dissimilar.into_iter().chain(between).chain(Self::slip_beyond(contact));
        all.chain(large).collect()
    }

    /// Force over `mu N` from which it is beyond friction: rounding and error bars lie below.
    const LARGEST_SHARE: f64 = 1.001;

    /// A force that is larger than friction allows, over `mu N`: of the one theory without slip.
    #[must_use]
    pub fn beyond_friction(share: f64) -> Option<Self> {
        let theory = TheorySpec::Linear(NoOptions {}).facts().name;
        (share > Self::LARGEST_SHARE).then_some(Self::BeyondFriction { theory, share })
    }

    /// What a theory neglects between the surfaces: a law of friction, a layer.
    #[must_use]
    pub fn between_surfaces(theory: &TheorySpec, contact: &Contact) -> [Option<Self>; 2] {
        let facts = theory.facts();
        let theory = facts.name;
        let friction = contact.rolling_friction();
        let on_areas = contact.areas().is_some();
        let follows = facts.friction_laws && (!on_areas || theory == "exact");
        // On areas every row of the simplified theories has the friction of its own place.
        let by_row = on_areas && ["fastsim", "fastrip", "saturated"].contains(&theory);
        let left_out = friction.is_some_and(|law| if by_row { law.falls() } else { law.varies() });
        let friction = left_out.then_some(Self::ConstantFriction { theory });
        let friction = friction.filter(|_| !follows);
        let layer = contact.layer().and_then(|layer| {
            if follows { Self::thick_layer(layer, contact) } else { Some(Self::NoLayer { theory }) }
        });
        [friction, layer]
    }

    /// A layer that is not thin beside the contact of which it is a part.
    fn thick_layer(layer: Layer, contact: &Contact) -> Option<Self> {
        let half_width = match contact.areas() {
            Some(areas) => smallest_half_width(areas),
            None => contact.scaling().length * contact.ellipse().minor() / contact.ellipse().c(),
        };
        Self::thick_beside(layer, half_width)
    }

    /// Part of the contact's length from which its reach beyond the points of an added slip is named.
    const BEYOND: f64 = 0.01;

    /// Where the contact reaches beyond the points of an added slip; one value along an axis holds all along it.
    fn slip_beyond(contact: &Contact) -> impl Iterator<Item = Self> {
        let reach = contact.added_slip().map(|slip| (slip.extent(), contact.extent()));
        reach.into_iter().flat_map(|(points, areas)| {
            let pairs = ["x", "y"].into_iter().zip(points.into_iter().zip(areas));
            pairs.filter_map(|(along, ([first, last], [low, high]))| {
                let beyond = (first - low).max(high - last) / (high - low);
                let named = last > first && beyond > Self::BEYOND;
                named.then_some(Self::SlipBeyond { along, share: beyond })
            })
        })
    }

    /// A layer that is not thin beside a half-width (m).
    ///
    /// Tractions of wavelength `2 pi/k` shear a layer of thickness `h` on a stiff body by `tanh(kh)/(kh)` of what each
    /// place does by itself; those of a contact have a half wave over its width at least.
    pub(crate) fn thick_beside(layer: Layer, half_width: f64) -> Option<Self> {
        let share = layer.thickness() / half_width;
        let phase = FRAC_PI_2 * share;
        let stiffer = phase / phase.tanh() - 1.0;
        (stiffer > Self::THICK).then_some(Self::ThickLayer { share, stiffer })
    }

    /// What a theory neglects between bodies that are so dissimilar, if that matters.
    #[must_use]
    pub fn dissimilar(theory: &TheorySpec, kappa_over_mu: f64) -> Option<Self> {
        let facts = theory.facts();
        if facts.dissimilar_bodies { None } else { Self::dissimilar_for(facts.name, kappa_over_mu) }
    }

    /// The same of anything that neglects the dissimilarity, such as a table.
    #[must_use]
    pub fn dissimilar_for(theory: &'static str, kappa_over_mu: f64) -> Option<Self> {
        // The pressure's slip changes the force most where there is no creepage. On a circle with Poisson's ratio 0.28
        // the change is 1.0 times kappa/mu there; 0.4 to 2.1 times over a/b from 20 to 0.05 and Poisson's ratios from
        // 0.1 to 0.45.
        let share = kappa_over_mu.abs().min(1.0);
        let matters = kappa_over_mu.abs() >= Self::DISSIMILAR;
        matters.then_some(Self::Dissimilar { theory, kappa_over_mu, share })
    }

    /// The same of Carter's theory of line contact.
    pub(crate) fn dissimilar_on_line(kappa_over_mu: f64) -> Self {
        // 1.6 to 1.9 times kappa/mu over creepages of both signs, for kappa/mu up to 0.3; less beyond.
        let share = (1.8 * kappa_over_mu.abs()).min(1.0);
        Self::Dissimilar { theory: "carter", kappa_over_mu, share }
    }

    /// What an unlike pair loses on areas of any shape.
    pub(crate) fn like_bodies(kappa_over_mu: f64) -> Option<Self> {
        let matters = kappa_over_mu.abs() >= Self::DISSIMILAR;
        matters.then_some(Self::LikeBodies { kappa_over_mu })
    }

    /// All that a table neglects in a contact.
    #[must_use]
    pub fn all_of_table(contact: &Contact) -> Vec<Self> {
        let theory = "a table";
        let dissimilar = Self::dissimilar_for(theory, contact.kappa_over_mu());
        let varies = contact.rolling_friction().is_some_and(|friction| friction.varies());
        let friction = varies.then_some(Self::ConstantFriction { theory });
        let layer = contact.layer().map(|_| Self::NoLayer { theory });
        [dissimilar, friction, layer].into_iter().flatten().collect()
    }

    /// Whether coupling would move the force of `exact` by more than its error bars, by a cheap
    /// estimate.
    fn one_way(theory: &TheorySpec, contact: &Contact, solution: &Solution) -> Option<Self> {
        let TheorySpec::Exact(ExactOptions { coupled: false, .. }) = theory else { return None };
        if contact.areas().is_some() {
            return None;
        }
        let (friction, error) = (contact.friction()?, solution.error?);
        let q = contact.kappa_over_mu() * friction * friction / (1.0 - contact.poisson());
        let moved = Self::MOVED_BY_COUPLING * q.abs();
        (moved > error.fx.max(error.fy)).then_some(Self::OneWay { moved })
    }
}

/// The smaller half-width (m) of the area with the largest load.
fn smallest_half_width(areas: &NormalContact) -> f64 {
    let largest = areas.patches().iter().max_by(|a, b| a.load().total_cmp(&b.load()));
    let size = |patch: &Patch| patch.extent().size();
    largest.map_or(f64::NAN, |patch| size(patch).into_iter().fold(f64::INFINITY, f64::min) / 2.0)
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

    /// A layer is thin up to about a quarter of the half-width, on ellipses across as along; theories that leave it out
    /// say that instead.
    #[test]
    fn a_thick_layer_is_a_caution() {
        let exact = TheorySpec::named("exact").unwrap();
        for (ratio, thickness, is_thick) in
            [(1.0, 0.2, false), (1.0, 0.3, true), (0.25, 0.12, false), (4.0, 0.2, true)]
        {
            let layer = Layer::elastic(thickness, 1.0).unwrap();
            let contact = contact(ratio, 0.28, 0.0).with_layer(layer);
            let thick =
                Caution::neglected(&exact, &contact).into_iter().find_map(
                    |caution| match caution {
                        Caution::ThickLayer { share, stiffer } => Some((share, stiffer)),
                        _ => None,
                    },
                );
            assert_eq!(thick.is_some(), is_thick, "{ratio} {thickness}");
            // By the second order of tanh, and less.
            assert!(
                thick.is_none_or(|(share, stiffer)| stiffer < (FRAC_PI_2 * share).powi(2) / 3.0)
            );
            let polach = TheorySpec::named("polach").unwrap();
            let others = Caution::neglected(&polach, &contact);
            assert_eq!(others, [Caution::NoLayer { theory: "polach" }]);
        }
    }

    #[test]
    fn what_matters_is_a_caution_for_all_but_the_full_theory() {
        for theory in TheorySpec::all() {
            for kappa_over_mu in [-5.0, -0.01, 0.01, 0.4] {
                let caution = Caution::dissimilar(&theory, kappa_over_mu);
                let counts = ["exact", "variational"].contains(&theory.facts().name);
                assert_eq!(caution.is_some(), !counts);
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
