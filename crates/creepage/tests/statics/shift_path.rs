//! Shifts to and fro, against the closed forms of a circle and against the first shift.

use creepage::statics::{PartialSlip, PartialSlipError, ShiftAxis, ShiftPath};
use creepage::{Ellipse, Hertz, Solid, SolidPair};
use proptest::prelude::*;

const LOAD: f64 = 80e3;
const FRICTION: f64 = 0.3;
const LIMIT: f64 = FRICTION * LOAD;

fn contact(a: f64, b: f64) -> Hertz {
    let steel = Solid::new(82e9, 0.28).unwrap();
    Hertz::from_ellipse(SolidPair::new(steel, steel), Ellipse::new(a, b).unwrap(), LOAD).unwrap()
}

fn circle() -> ShiftPath {
    ShiftPath::new(&contact(4e-3, 4e-3), FRICTION, ShiftAxis::X).unwrap()
}

/// `d_s = 3 (2 - sigma) mu N/(8 G a)` of a circle.
#[test]
fn a_circle_slides_at_mindlins_shift() {
    let right = 3.0 * (2.0 - 0.28) * LIMIT / (8.0 * 82e9 * 4e-3);
    assert!((circle().sliding_shift() / right - 1.0).abs() < 1e-13);
}

/// `T*`, shift there, shift back at zero force, energy of a full cycle; and the path of several turns. Closed forms,
/// computed apart from this program in double precision, to seven digits.
#[test]
fn loops_are_mindlins() {
    for (force, shift, back, cycle) in [
        (0.2, 0.138_226_1, 0.002_565_6, 0.001_369_2),
        (0.5, 0.370_039_5, 0.021_003_1, 0.028_173_7),
        (0.8, 0.658_004_8, 0.080_762_1, 0.177_300_0),
        (0.99, 0.953_584_1, 0.221_890_7, 0.653_965_1),
    ] {
        let mut path = circle();
        let unit = path.sliding_shift();
        path.to_force(force * LIMIT).unwrap();
        assert!((path.shift() / unit - shift).abs() < 1e-7);
        path.to_force(0.0).unwrap();
        assert!((path.shift() / unit - back).abs() < 1e-7);
        path.to_force(-force * LIMIT).unwrap();
        assert!((path.shift() / unit + shift).abs() < 1e-7);
        let before = path.dissipated();
        path.to_force(force * LIMIT).unwrap();
        path.to_force(-force * LIMIT).unwrap();
        let energy = (path.dissipated() - before) / (LIMIT * unit);
        assert!((energy - cycle).abs() < 1e-7, "{energy} {cycle}");
    }
    let mut path = circle();
    let forces = [0.8, 0.2, 0.5, 0.2, 0.9];
    let shifts = [0.658_004_8, 0.234_751_8, 0.440_117_6, 0.234_751_8, 0.784_556_5];
    for (force, shift) in forces.into_iter().zip(shifts) {
        path.to_force(force * LIMIT).unwrap();
        assert!((path.shift() / path.sliding_shift() - shift).abs() < 1e-7);
    }
}

/// The first shift is [`PartialSlip`]'s, on either axis.
#[test]
fn the_first_shift_is_cattaneos() {
    let hertz = contact(6e-3, 3e-3);
    for (axis, k) in [(ShiftAxis::X, 0), (ShiftAxis::Y, 1)] {
        let mut force = [0.0; 2];
        force[k] = -15e3;
        let partial = PartialSlip::new(&hertz, FRICTION, force).unwrap();
        let mut path = ShiftPath::new(&hertz, FRICTION, axis).unwrap();
        path.to_force(-15e3).unwrap();
        // The same closed forms in another order.
        assert!((path.shift() / partial.shift()[k] - 1.0).abs() < 1e-13);
        assert!((path.adhesion() * 6e-3 / partial.adhesion().a() - 1.0).abs() < 1e-13);
        for point in [[0.0, 0.0], [3e-3, 1e-3], [5e-3, 1e-3], [0.0, 2.9e-3]] {
            let (one, other) = (path.traction(point), partial.traction(point)[k]);
            assert!((one - other).abs() < 1e-9 * partial.bound([0.0; 2]), "{one} {other}");
        }
    }
}

#[test]
fn sliding_is_refused_and_leaves_the_path() {
    let mut path = circle();
    path.to_force(0.5 * LIMIT).unwrap();
    let before = path.shift();
    for force in [LIMIT, -2.0 * LIMIT] {
        assert!(matches!(path.to_force(force), Err(PartialSlipError::Sliding { .. })));
    }
    assert!(matches!(path.to_shift(-path.sliding_shift()), Err(PartialSlipError::Sliding { .. })));
    assert!(matches!(path.to_force(f64::NAN), Err(PartialSlipError::Invalid(_))));
    assert_eq!(path.shift().to_bits(), before.to_bits());
}

proptest! {
    /// Tractions add up to the force and stay within friction; the same path by its shifts; heat never falls, and in
    /// the end, back and forth between the same forces, each cycle costs the same.
    #[test]
    fn any_path_keeps_friction_and_force(
        forces in prop::collection::vec(-0.98..0.98, 1..12),
        place in 0.0..0.999,
    ) {
        let (mut path, mut by_shift) = (circle(), circle());
        let mut spent = 0.0;
        for force in &forces {
            path.to_force(force * LIMIT).unwrap();
            by_shift.to_shift(path.shift()).unwrap();
            // Powers of 2/3 and 3/2 of numbers that cancel close to sliding.
            prop_assert!((by_shift.force() - path.force()).abs() < 1e-9 * LIMIT);
            prop_assert!(path.dissipated() >= spent - 1e-15);
            spent = path.dissipated();
        }
        let bound = |r: f64| 1.5 * LIMIT / (std::f64::consts::PI * 4e-3_f64.powi(2)) * (1.0 - r * r).max(0.0).sqrt();
        // Rounding of roots close to the edge.
        prop_assert!(path.traction([4e-3 * place, 0.0]).abs() <= bound(place) + 1e-12 * bound(0.0));
        // Midpoint rule in rings; roots at the edge of each area of adhesion.
        let rings = 4000;
        let ring = |k: u32| {
            let r = (f64::from(k) + 0.5) / f64::from(rings);
            std::f64::consts::TAU * r * path.traction([4e-3 * r, 0.0])
        };
        let sum: f64 = (0..rings).map(ring).sum::<f64>() * 4e-3_f64.powi(2) / f64::from(rings);
        prop_assert!((sum - path.force()).abs() < 1e-4 * LIMIT, "{} {}", sum, path.force());
    }
}
