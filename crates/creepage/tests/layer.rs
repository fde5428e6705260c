//! Rolling with a layer between the bodies: limits, closed forms, one theory against another.
// Tests may fail by unwrapping.
#![allow(clippy::float_cmp, clippy::unwrap_used)]

use std::f64::consts::PI;

use creepage::approximate::fastsim::{Fastsim, Flexibility, Settings};
use creepage::coulomb::{Exact, Resolution};
use creepage::{Contact, Creepage, Ellipse, Force, Hertz, Layer, Plasticity, Solid, SolidPair};
use creepage::{Scaling, Theory};

fn hertz() -> Hertz {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(6e-3, 4e-3).unwrap();
    Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 60e3).unwrap()
}

fn contact(layer: Layer) -> Contact {
    hertz().with_friction(0.3).unwrap().with_layer(layer)
}

fn exact(contact: &Contact, [xi, eta, chi]: [f64; 3]) -> Force {
    let creepage = Creepage::new(xi, eta, chi).unwrap();
    Exact::new(contact, Resolution::STANDARD).unwrap().solve(creepage).force
}

fn fastsim(contact: &Contact, [xi, eta, chi]: [f64; 3]) -> Force {
    let creepage = Creepage::new(xi, eta, chi).unwrap();
    Fastsim::new(contact, Settings::default()).unwrap().solve(creepage).force
}

/// The largest difference of two forces' components.
fn apart(one: Force, two: Force) -> f64 {
    let pairs = one.components().into_iter().zip(two.components());
    pairs.fold(0.0, |most, (one, two)| most.max((one - two).abs()))
}

/// The flexibility in the units of the contact.
fn flexibility(layer: &Layer, scaling: Scaling) -> f64 {
    layer.flexibility() * scaling.traction / (scaling.slip * scaling.length)
}

const CASES: [[f64; 3]; 3] = [[0.6, 0.0, 0.0], [0.4, -0.7, 0.5], [0.2, 0.1, 1.5]];

#[test]
fn a_layer_that_gets_thinner_vanishes() {
    let bare = hertz().with_friction(0.3).unwrap();
    for case in CASES {
        let gone = contact(Layer::elastic(0.0, 1e9).unwrap());
        assert_eq!(exact(&gone, case), exact(&bare, case));
        assert_eq!(fastsim(&gone, case), fastsim(&bare, case));
        for theory in [exact, fastsim] {
            let change = |thickness: f64| {
                let thin = contact(Layer::elastic(thickness, 10e9).unwrap());
                apart(theory(&thin, case), theory(&bare, case))
            };
            let [thick, thin] = [1e-6, 0.5e-6].map(change);
            // Proportional to the thickness, but for its square and elements that change sides.
            assert!(thin > 0.0 && (thick / thin - 2.0).abs() < 0.2, "{thick} {thin}");
        }
    }
}

/// A stiff layer changes nothing: forces differ by its flexibility, here a millionth of the bodies' own, and by where
/// iterations end.
#[test]
fn a_stiff_layer_is_none() {
    let bare = hertz().with_friction(0.3).unwrap();
    for case in CASES {
        let stiff = contact(Layer::elastic(1e-4, 1e19).unwrap());
        for theory in [exact, fastsim] {
            let apart = apart(theory(&stiff, case), theory(&bare, case));
            assert!(apart < 1e-5, "{apart}");
        }
    }
}

/// A layer much softer than the bodies is a bed of springs: nothing but its own law is left.
fn soft() -> Layer {
    Layer::elastic(1e-3, 1e6).unwrap()
}

/// In adhesion the traction grows as the distance from the leading edge: `fx = 4 a xi/(pi L)`.
#[test]
fn a_soft_layer_has_its_own_slope() {
    let contact = contact(soft());
    let (l, a) = (flexibility(&soft(), contact.scaling()), contact.ellipse().a());
    let xi = 1e-3 * l;
    let expected = 4.0 * a / (PI * l) * xi;
    for (theory, tolerance) in [(exact as fn(&Contact, [f64; 3]) -> Force, 2e-3), (fastsim, 2e-3)] {
        let found = theory(&contact, [xi, 0.0, 0.0]).fx;
        // Elements, and the slip area at the trailing edge.
        assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
    }
}

/// The full theory on a soft layer is FASTSIM, which on a bed of springs is exact but for its cells.
#[test]
fn on_a_soft_layer_the_full_theory_is_fastsim() {
    let contact = contact(soft());
    let l = flexibility(&soft(), contact.scaling());
    for case in
        [[0.2, 0.0, 0.0], [0.8, 0.0, 0.0], [0.3, -0.4, 0.3], [0.1, 0.1, 0.8], [1.0, 2.0, 0.0]]
    {
        let case = case.map(|part| part * l);
        let (full, springs) = (exact(&contact, case), fastsim(&contact, case));
        assert!(apart(full, springs) < 0.01, "{case:?}: {full:?} {springs:?}");
    }
}

/// A layer adds its flexibility to that of the bodies: at small creepage the slope falls as FASTSIM's
/// `L/(L + h/G)` or more. In the full theory the traction of adhesion grows without bound towards the
/// trailing edge, where the layer takes most: a stiff one more by a logarithm of its thickness, a soft one,
/// which levels the traction, as much as in FASTSIM.
#[test]
fn a_layer_adds_its_flexibility() {
    let settings = Settings { flexibility: Flexibility::Three, ..Settings::default() };
    let slopes = |contact: &Contact| {
        let still = Creepage::new(1e-4, 0.0, 0.0).unwrap();
        let exact = Exact::new(contact, Resolution::STANDARD).unwrap();
        let fastsim = Fastsim::new(contact, settings).unwrap();
        [exact.solve(still).force.fx, fastsim.solve(still).force.fx]
    };
    let bare = slopes(&hertz().with_friction(0.3).unwrap());
    let more = [1e-7, 1e-6, 1e-5, 1e-4, 1e-2].map(|thickness| {
        let found = slopes(&contact(Layer::elastic(thickness, 0.5e9).unwrap()));
        let [full, springs] = [0, 1].map(|k| 1.0 - found[k] / bare[k]);
        full / springs
    });
    assert!(more.windows(2).all(|pair| pair[1] < pair[0]) && more[0] < 2.5, "{more:?}");
    assert!((more[4] - 1.0).abs() < 0.01, "{more:?}");
}

fn yielding(yield_stress: f64, slope: f64) -> Contact {
    let layer = Layer::elastic(20e-6, 100e6).unwrap();
    contact(layer.with_plasticity(Plasticity { yield_stress, slope }).unwrap())
}

#[test]
fn a_layer_that_is_strong_enough_does_not_yield() {
    let elastic = contact(Layer::elastic(20e-6, 100e6).unwrap());
    let strong = yielding(1.01 * elastic.scaling().traction, 0.0);
    for case in CASES {
        assert!(apart(exact(&strong, case), exact(&elastic, case)) < 1e-12);
        assert!(apart(fastsim(&strong, case), fastsim(&elastic, case)) < 1e-4);
    }
}

/// At large creepage every place bears the smaller of friction and the yield stress: with `t` the yield
/// stress over the largest bound, `fx = (3 t - t^3)/2`.
#[test]
fn a_perfectly_plastic_layer_bounds_the_force() {
    for t in [0.3, 0.7] {
        let contact = yielding(t * hertz().with_friction(0.3).unwrap().scaling().traction, 0.0);
        let expected = 0.5 * t * (3.0 - t * t);
        for force in [exact(&contact, [60.0, 0.0, 0.0]), fastsim(&contact, [60.0, 0.0, 0.0])] {
            // Elements: friction and yield meet within them.
            assert!((force.fx - expected).abs() < 5e-3, "{t}: {force:?} {expected}");
        }
    }
}

/// With hardening and with softening, on a layer so soft that the bodies do not matter.
#[test]
fn plastic_layers_by_both_theories() {
    let traction = hertz().with_friction(0.3).unwrap().scaling().traction;
    let soft = soft();
    for slope in [0.5, 2.0, -0.3] {
        let slope = slope / soft.flexibility();
        let plasticity = Plasticity { yield_stress: 0.4 * traction, slope };
        let contact = contact(soft.with_plasticity(plasticity).unwrap());
        let l = flexibility(&soft, contact.scaling());
        for case in [[0.3, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.5, 0.0]] {
            let case = case.map(|part| part * l);
            let (full, springs) = (exact(&contact, case), fastsim(&contact, case));
            assert!(apart(full, springs) < 0.015, "{slope:e} {case:?}: {full:?} {springs:?}");
        }
    }
}

#[test]
fn nonsense_is_an_error_that_names_the_quantity() {
    assert_eq!(Layer::elastic(-1e-6, 1e9).unwrap_err().quantity, "thickness");
    assert_eq!(Layer::elastic(1e-6, 0.0).unwrap_err().quantity, "shear_modulus");
    let layer = Layer::elastic(1e-3, 1e9).unwrap();
    let plastic = |yield_stress, slope| layer.with_plasticity(Plasticity { yield_stress, slope });
    assert_eq!(plastic(0.0, 0.0).unwrap_err().quantity, "yield_stress");
    assert_eq!(plastic(1e8, -1.1e12).unwrap_err().quantity, "slope");
}
