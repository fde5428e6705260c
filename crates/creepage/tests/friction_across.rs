//! Friction that differs across the contact: full sliding, symmetry, limits, one mesh against another.
// Tests may fail by unwrapping.
#![allow(clippy::unwrap_used)]

use creepage::approximate::fastsim::{Fastsim, Settings};
use creepage::coulomb::{Exact, NonHertzian, Resolution};
use creepage::friction_law::{FrictionAcross, RollingFriction};
use creepage::gap::{Gap, Term};
use creepage::normal::{self, NormalContact};
use creepage::{Contact, Creepage, Ellipse, Force, Hertz, Radii, Solid, SolidPair, Theory};

const SEMI_AXES: [f64; 2] = [6e-3, 4e-3];

fn hertz() -> Hertz {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(SEMI_AXES[0], SEMI_AXES[1]).unwrap();
    Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 80e3).unwrap()
}

fn across(points: &[[f64; 2]]) -> RollingFriction {
    RollingFriction::across(FrictionAcross::new(points).unwrap()).unwrap()
}

fn contact(points: &[[f64; 2]]) -> Contact {
    hertz().with_friction_law(across(points)).unwrap()
}

fn creepage(xi: f64, eta: f64, chi: f64) -> Creepage {
    Creepage::new(xi, eta, chi).unwrap()
}

fn both(contact: &Contact) -> [Box<dyn Theory>; 2] {
    [
        Box::new(Exact::new(contact, Resolution::STANDARD).unwrap()),
        Box::new(Fastsim::new(contact, Settings::default()).unwrap()),
    ]
}

fn assert_near(found: Force, right: Force, tolerance: f64, why: &str) {
    for (found, right) in found.components().into_iter().zip(right.components()) {
        assert!((found - right).abs() < tolerance, "{why}: {found} {right}");
    }
}

/// In full sliding the force is the mean of friction by the pressure, its moment that of the pressure's
/// second moment `b^2/5`. Strips take friction at their middle: an error of second order.
#[test]
fn full_sliding_is_the_pressure_s_mean() {
    let contact = contact(&[[-4e-3, 0.1], [4e-3, 0.4]]);
    let b = contact.ellipse().b() / contact.ellipse().c();
    let right = Force { fx: 0.25 / 0.4, fy: 0.0, mz: -(0.15 / 0.4) * b / 5.0 };
    for theory in both(&contact) {
        let force = theory.solve(creepage(50.0, 0.0, 0.0)).force;
        assert_near(force, right, 2e-3, "full sliding");
    }
}

/// The same friction everywhere is Coulomb's, to what the solver leaves.
#[test]
fn equal_friction_is_coulomb_s() {
    let (varied, plain) =
        (contact(&[[0.0, 0.3], [1e-3, 0.3]]), hertz().with_friction(0.3).unwrap());
    for (varied, plain) in both(&varied).into_iter().zip(both(&plain)) {
        for [xi, eta, chi] in [[0.8, 0.3, 0.5], [-0.4, 0.2, -1.5], [0.0, 0.0, 3.0]] {
            let [one, two] = [&varied, &plain].map(|t| t.solve(creepage(xi, eta, chi)).force);
            assert_near(one, two, 1e-6, "constant");
        }
    }
}

/// Seen in a mirror along the rolling direction.
#[test]
fn the_mirror_image_has_the_mirror_force() {
    let points = [[-2e-3, 0.1], [1e-3, 0.35], [3e-3, 0.3]];
    let mirrored: Vec<_> = points.iter().rev().map(|[y, mu]| [-y, *mu]).collect();
    for (one, other) in both(&contact(&points)).into_iter().zip(both(&contact(&mirrored))) {
        let force = one.solve(creepage(0.6, 0.4, 0.9)).force;
        let image = other.solve(creepage(0.6, -0.4, -0.9)).force;
        let right = Force { fx: image.fx, fy: -image.fy, mz: -image.mz };
        assert_near(force, right, 1e-6, "mirror");
        assert!(force.mz.abs() > 0.01);
    }
}

/// Where all adheres friction does not matter: at a thousandth of full creepage slip is a thin rim.
#[test]
fn adhesion_does_not_know_it() {
    let (varied, plain) =
        (contact(&[[-4e-3, 0.2], [4e-3, 0.4]]), hertz().with_friction(0.4).unwrap());
    for (varied, plain) in both(&varied).into_iter().zip(both(&plain)) {
        let [one, two] = [&varied, &plain].map(|t| t.solve(creepage(1e-3, 0.0, 0.0)).force);
        assert_near(one, two, 1e-6, "adhesion");
    }
}

/// Greased on one side: the full theory's force lies between those with either friction everywhere, and
/// FASTSIM's near it, within a tenth.
#[test]
fn half_of_the_contact_greased() {
    let greased = contact(&[[-1e-6, 0.1], [1e-6, 0.4]]);
    let low = Exact::new(&hertz().with_friction(0.1).unwrap(), Resolution::STANDARD).unwrap();
    let [exact, fastsim] = both(&greased).map(|theory| theory.solve(creepage(0.8, 0.0, 0.0)).force);
    let plain = Exact::new(&hertz().with_friction(0.4).unwrap(), Resolution::STANDARD).unwrap();
    let most = plain.solve(creepage(0.8, 0.0, 0.0)).force.fx;
    let least = 0.25 * low.solve(creepage(3.2, 0.0, 0.0)).force.fx;
    assert!(exact.fx < most && exact.fx > least, "{least} {exact:?} {most}");
    assert_near(exact, fastsim, 0.1, "fastsim");
}

/// The same ellipse as a gap, its friction in the gap's own coordinates.
#[test]
fn a_contact_of_any_shape_follows_it_too() {
    let (points, shifted) = ([[-3e-3, 0.1], [3e-3, 0.4]], 1e-3);
    let [upper, lower] = [[0.4, f64::INFINITY], [f64::INFINITY, 0.3]]
        .map(|[rolling, lateral]| Radii { rolling, lateral });
    let hertz = Hertz::new(hertz().pair(), upper, lower, 0.0, 80e3).unwrap();
    let exact = hertz.with_friction_law(across(&points)).unwrap();
    let exact = Exact::new(&exact, Resolution::STANDARD).unwrap();
    let [along, side] = [0.5 / 0.4, 0.5 / 0.3];
    let terms = [
        (2, 0, along),
        (0, 2, side),
        (0, 1, -2.0 * side * shifted),
        (0, 0, side * shifted * shifted),
    ]
    .map(|(x, y, coefficient)| Term { x, y, coefficient });
    let gap = Gap::polynomial(&terms).unwrap();
    let fine = normal::Resolution::FINE;
    let normal = NormalContact::under_load(&gap, hertz.pair(), 80e3, fine).unwrap();
    let moved = across(&points.map(|[y, mu]| [y + shifted, mu]));
    let theory = NonHertzian::new(&normal, 0.4, Resolution::STANDARD).unwrap();
    let theory = theory.with_resistance(Some(moved), None);
    let [own, other] = [theory.scaling(), exact.contact().scaling()];
    let at = creepage(0.7, 0.0, 0.0);
    let solved = theory.solve(own.creepage(other.si_creepage(at)).unwrap());
    let force = own.si_force(solved.force_about([0.0, shifted / own.length]));
    let expected = other.si_force(exact.solve(at).force);
    // One part in two hundred of what friction bears: both meshes take friction strip by strip.
    for (found, right, unit) in [
        (force.longitudinal, expected.longitudinal, other.force),
        (force.lateral, expected.lateral, other.force),
        (force.moment, expected.moment, other.force * other.length),
    ] {
        assert!((found - right).abs() < 5e-3 * unit, "{found} {right}");
    }
}
