//! Rolling where friction falls with the speed of slip: reference cases, limits, several solutions.
// Tests may fail by unwrapping.
#![allow(clippy::float_cmp, clippy::unwrap_used)]

use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::coulomb::{Constraints, Exact, Resolution};
use creepage::friction_law::{FrictionLaw, FrictionMemory, RollingFriction, Shape, Term};
use creepage::theory::Solved;
use creepage::{
    Contact, Creepage, Ellipse, Hertz, Region, SiCreepage, Solid, SolidPair, Status, Theory,
};
use proptest::prelude::*;

/// Steel on a circle of 5 mm at a peak pressure of 1.025e9 Pa.
fn hertz() -> Hertz {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(5e-3, 5e-3).unwrap();
    Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 53_668.874_5).unwrap()
}

fn falling(shape: Shape, half_speed: f64) -> FrictionLaw {
    FrictionLaw::new(shape, 0.18, &[Term { drop: 0.12, half_speed }]).unwrap()
}

fn contact(law: FrictionLaw, memory: Option<FrictionMemory>) -> Contact {
    hertz().with_friction_law(RollingFriction::new(law, memory, 30.0).unwrap()).unwrap()
}

/// CONTACT v25.2 on grids of 20 to 68 elements across, extrapolated: creepage along and spin (rad/m),
/// force over friction at rest times load, and its uncertainty.
struct Reference {
    shape: Shape,
    memory: Option<[f64; 2]>,
    creepage: [f64; 2],
    force: [f64; 2],
    uncertainty: [f64; 2],
}

const REFERENCE: [Reference; 3] = [
    Reference {
        shape: Shape::Exponential,
        memory: None,
        creepage: [0.002, 0.0],
        force: [0.689_472, 0.0],
        uncertainty: [0.002_251, 0.0005],
    },
    Reference {
        shape: Shape::Exponential,
        memory: Some([2e-5, 1e-3]),
        creepage: [0.002, 0.0],
        force: [0.742_042, 0.0],
        uncertainty: [0.002_011, 0.0005],
    },
    Reference {
        shape: Shape::Rational,
        memory: None,
        creepage: [0.001, 0.3],
        force: [0.378_638, 0.259_771],
        uncertainty: [0.001_033, 0.000_937],
    },
];

#[test]
fn reference_cases() {
    for reference in &REFERENCE {
        let memory = reference.memory.map(|[d, s]| FrictionMemory::new(d, s).unwrap());
        let contact = contact(falling(reference.shape, 0.1), memory);
        let [longitudinal, spin] = reference.creepage;
        let si = SiCreepage { longitudinal, lateral: 0.0, spin };
        let creepage = contact.scaling().creepage(si).unwrap();
        for resolution in [Resolution::FAST, Resolution::STANDARD] {
            let solution = Exact::new(&contact, resolution).unwrap().solve(creepage);
            let found = [solution.force.fx, solution.force.fy];
            for k in 0..2 {
                let apart = (found[k] - reference.force[k]).abs();
                assert!(apart < 0.005 + reference.uncertainty[k], "{resolution:?} {found:?}");
            }
        }
        // A bed of springs, and friction by the rigid slip: some per cent.
        let force = Fastsim::new(&contact, Settings::default()).unwrap().solve(creepage).force;
        let apart = (force.fx - reference.force[0]).hypot(force.fy - reference.force[1]);
        assert!(apart < 0.03, "{force:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// A law without drops is Coulomb's to the last bit; one that falls at a billion metres a second is
    /// Coulomb's to 1e-12.
    #[test]
    fn constant_friction_is_recovered(xi in -2.0..2.0_f64, eta in -2.0..2.0_f64, chi in -2.0..2.0_f64) {
        let creepage = Creepage::new(xi, eta, chi).unwrap();
        let constant = hertz().with_friction(0.3).unwrap();
        let never = FrictionLaw::new(Shape::Rational, 0.3, &[Term { drop: 0.0, half_speed: 0.1 }]);
        let late = falling(Shape::Exponential, 1e13);
        let forces = |contact: &Contact| {
            let exact = Exact::new(contact, Resolution::FAST).unwrap().solve(creepage).force;
            let fastsim = Fastsim::new(contact, Settings::default()).unwrap().solve(creepage).force;
            [exact, fastsim]
        };
        let expected = forces(&constant);
        prop_assert_eq!(forces(&contact(never.unwrap(), None)), expected);
        for (found, expected) in forces(&contact(late, None)).iter().zip(expected) {
            for (found, expected) in found.components().iter().zip(expected.components()) {
                prop_assert!((found - expected).abs() < 1e-12, "{found} {expected}");
            }
        }
    }

    /// The mirror images (4.22)-(4.28) of a solution are solutions.
    #[test]
    fn mirror_images(xi in 0.1..2.0_f64, eta in 0.1..2.0_f64, chi in 0.1..2.0_f64) {
        let contact = contact(falling(Shape::Rational, 0.1), None);
        let exact = Exact::new(&contact, Resolution::FAST).unwrap();
        let force = |signs: [f64; 3]| {
            let [xi, eta, chi] = [signs[0] * xi, signs[1] * eta, signs[2] * chi];
            exact.solve(Creepage::new(xi, eta, chi).unwrap()).force
        };
        let plain = force([1.0; 3]);
        let mirrored = force([-1.0, 1.0, 1.0]);
        prop_assert!((plain.fx + mirrored.fx).abs() < 1e-12 && (plain.fy - mirrored.fy).abs() < 1e-12);
        let mirrored = force([1.0, -1.0, -1.0]);
        prop_assert!((plain.fx - mirrored.fx).abs() < 1e-12 && (plain.fy + mirrored.fy).abs() < 1e-12);
    }
}

/// Where all slides the slip is nearly rigid: friction is that of the rigid slip.
#[test]
fn full_sliding_has_the_friction_of_its_speed() {
    let law = falling(Shape::Exponential, 2.0);
    let contact = contact(law, None);
    for xi in [8.0, 25.0] {
        let creepage = Creepage::new(xi, 0.0, 0.0).unwrap();
        let expected = law.at(30.0 * contact.scaling().slip * xi) / law.at_rest();
        let exact = Exact::new(&contact, Resolution::FAST).unwrap().solve(creepage);
        let fastsim = Fastsim::new(&contact, Settings::default()).unwrap().solve(creepage);
        for force in [exact.force, fastsim.force] {
            // The elastic slip, of order one beside xi, changes friction by its slope; its mean is zero.
            assert!((force.fx - expected).abs() < 2e-3, "{xi} {force:?} {expected}");
        }
    }
}

/// Heat by force and creepage is that by traction and slip.
#[test]
fn both_powers_agree() {
    let contact = contact(falling(Shape::Exponential, 0.1), None);
    let exact = Exact::new(&contact, Resolution::STANDARD).unwrap();
    for [xi, eta, chi] in [[1.5, 0.0, 0.0], [0.8, 1.2, 0.5]] {
        let solved = exact.solve_contact(Creepage::new(xi, eta, chi).unwrap());
        let (power, heat) = (solved.power(), solved.dissipation().unwrap());
        assert!((heat / power - 1.0).abs() < 0.01, "{power} {heat}");
    }
}

/// The force rises to a maximum and falls with the speed of slip; without memory it is found from small
/// slip, and the derivative vanishes there.
#[test]
fn the_force_has_a_maximum() {
    let contact = contact(falling(Shape::Exponential, 0.1), None);
    let exact = Exact::new(&contact, Resolution::FAST).unwrap();
    let at = |xi: f64| exact.solve_contact(Creepage::new(xi, 0.0, 0.0).unwrap());
    let slope = |xi: f64| at(xi).jacobian().unwrap()[0][0];
    let (mut low, mut high) = (0.2, 3.0);
    assert!(slope(low) > 0.0 && slope(high) < 0.0);
    for _ in 0..12 {
        let middle = f64::midpoint(low, high);
        if slope(middle) > 0.0 { low = middle } else { high = middle }
    }
    let top = at(low).solution().force.fx;
    for other in [0.8 * low, 0.95 * low, 1.05 * low, 1.3 * low] {
        assert!(at(other).solution().force.fx < top, "{low} {other}");
    }
}

/// The creepage to a force below the maximum is found.
#[test]
fn the_inverse_problem() {
    let contact = contact(falling(Shape::Rational, 0.1), None);
    let exact = Exact::new(&contact, Resolution::FAST).unwrap();
    let constraints =
        Constraints { eta: Some(0.0), chi: Some(0.2), fx: Some(0.4), ..Constraints::default() };
    let found = exact.find(constraints).unwrap();
    assert!((exact.solve(found.creepage()).force.fx - 0.4).abs() < 1e-6);
}

/// Friction that falls within a thousandth of the rolling velocity: where some slips there are several
/// solutions, and friction at rest leads to one; where all slips or little, there is one.
#[test]
fn steep_laws_have_several_solutions() {
    let creepage = |contact: &Contact, longitudinal: f64| {
        let si = SiCreepage { longitudinal, ..SiCreepage::default() };
        contact.scaling().creepage(si).unwrap()
    };
    let status = |half_speed: f64| {
        let contact = contact(falling(Shape::Exponential, half_speed), None);
        let exact = Exact::new(&contact, Resolution::FAST).unwrap();
        let at = |k: i32| exact.solve(creepage(&contact, 2e-4 * f64::from(k))).status;
        (1..=19).map(at).collect::<Vec<_>>()
    };
    let steep = status(0.012);
    let several = steep.iter().filter(|status| **status == Status::SeveralSolutions).count();
    // On twelve strips of fourteen elements: which of the creepages have them depends on the elements.
    assert!(several >= 4, "{steep:?}");
    assert!(steep.iter().all(|status| *status != Status::NotConverged), "{steep:?}");
    assert_eq!(steep[18], Status::Solved);
    assert!(status(0.1).iter().all(|status| *status == Status::Solved));
}

/// At small creepage nothing slips but the trailing edge: the law does not matter.
#[test]
fn adhesion_knows_nothing_of_the_law() {
    let creepage = Creepage::new(1e-3, 0.0, 1e-3).unwrap();
    let constant = Exact::new(&hertz().with_friction(0.3).unwrap(), Resolution::FAST).unwrap();
    let steep = contact(falling(Shape::Exponential, 0.05), None);
    let falling = Exact::new(&steep, Resolution::FAST).unwrap();
    let sticks = falling.solve_contact(creepage);
    let share = sticks.elements().iter().filter(|e| e.point.region == Region::Slip).count();
    assert!(share < 12, "{share}");
    let (one, two) = (constant.solve(creepage).force, sticks.solution().force);
    assert!((one.fx / two.fx - 1.0).abs() < 1e-3 && (one.fy / two.fy - 1.0).abs() < 1e-3);
}
