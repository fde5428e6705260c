//! Shifts to and fro, against the closed forms of a circle and against the first shift.

use creepage::statics::{PartialSlip, PartialSlipError, ShiftAxis, ShiftEnd, ShiftPath};
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

/// Load and force that grow together below friction: no slip, and the shift of `alpha/mu` times the growth of the
/// approach; pressed first and then shifted, that of the larger load. Closed forms.
#[test]
fn a_load_that_grows_with_the_force_slips_nowhere() {
    for part in [0.2, 0.7, 1.0] {
        let mut path = circle();
        let unit = path.sliding_shift();
        let grown = 2.5;
        path.to(grown * LOAD, ShiftEnd::Force(part * (grown - 1.0) * LIMIT)).unwrap();
        let right = part * (grown.powf(2.0 / 3.0) - 1.0);
        assert!((path.shift() / unit - right).abs() < 1e-13);
        assert_eq!(path.dissipated().to_bits(), 0.0_f64.to_bits());
        assert!((path.normal_force() / LOAD - grown).abs() < 1e-13);
        assert!(part > 0.99 || (path.adhesion() - 1.0).abs() < 1e-15);
    }
    let mut path = circle();
    path.to(2.0 * LOAD, ShiftEnd::Force(0.0)).unwrap();
    path.to_force(0.9 * 2.0 * LIMIT).unwrap();
    let hertz = contact(4e-3 * 2f64.cbrt(), 4e-3 * 2f64.cbrt());
    let hertz = Hertz::from_ellipse(hertz.pair(), hertz.ellipse(), 2.0 * LOAD).unwrap();
    let partial = PartialSlip::new(&hertz, FRICTION, [0.9 * 2.0 * LIMIT, 0.0]).unwrap();
    assert!((path.shift() / partial.shift()[0] - 1.0).abs() < 1e-12);
    for r in [0.0, 3e-3, 4.5e-3, 5e-3] {
        let (one, other) = (path.traction([r, 0.0]), partial.traction([r, 0.0])[0]);
        assert!((one - other).abs() < 1e-9 * partial.bound([0.0; 2]), "{one} {other}");
    }
}

/// A load that falls under a force that stays lets slip go inwards until the bodies slide.
#[test]
fn a_load_that_falls_ends_in_sliding() {
    let mut path = circle();
    path.to_force(0.5 * LIMIT).unwrap();
    let before = (path.adhesion(), path.shift());
    path.to(0.6 * LOAD, ShiftEnd::Force(0.5 * LIMIT)).unwrap();
    assert!(path.adhesion() < before.0 && path.shift() > before.1);
    let slid = path.to(0.5 * LOAD, ShiftEnd::Force(0.5 * LIMIT));
    assert!(matches!(slid, Err(PartialSlipError::Sliding { .. })), "{slid:?}");
    for load in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(path.to(load, ShiftEnd::Force(0.0)), Err(PartialSlipError::Invalid(_))));
    }
}

proptest! {
    /// Under loads that change, too: tractions add up to the force within friction, heat never falls, and a step in parts
    /// is the step. Over a cycle that closes the heat is the work of the force, by trapezoids.
    #[test]
    fn any_path_of_loads_keeps_friction_and_force(
        steps in prop::collection::vec((0.2..3.0, -0.98..0.98, any::<bool>()), 2..8),
        place in 0.0..0.999,
    ) {
        let unit = circle().sliding_shift();
        let ends: Vec<(f64, ShiftEnd)> = steps
            .iter()
            .map(|&(load, share, is_force): &(f64, f64, bool)| {
                let shift = share * load.powf(2.0 / 3.0) * unit;
                let force = share * load * LIMIT;
                (load * LOAD, if is_force { ShiftEnd::Force(force) } else { ShiftEnd::Shift(shift) })
            })
            .collect();
        let mut path = circle();
        let mut spent = 0.0;
        for (load, end) in &ends {
            let (mut parts, before) = (path.clone(), path.clone());
            path.to(*load, *end).unwrap();
            prop_assert!(path.dissipated() >= spent - 1e-18);
            spent = path.dissipated();
            for part in 1..=5 {
                let [from, to] = [before.normal_force(), *load];
                let part = f64::from(part) / 5.0;
                let between = |from: f64, to: f64| from + part * (to - from);
                let went = match *end {
                    ShiftEnd::Force(force) => {
                        parts.to(between(from, to), ShiftEnd::Force(between(before.force(), force)))
                    }
                    ShiftEnd::Shift(shift) => {
                        let approach = between(from.powf(2.0 / 3.0), to.powf(2.0 / 3.0));
                        parts.to(approach.powf(1.5), ShiftEnd::Shift(between(before.shift(), shift)))
                    }
                };
                prop_assert!(went.is_ok());
            }
            // Roots of numbers that cancel close to sliding.
            prop_assert!((parts.force() - path.force()).abs() < 1e-8 * LIMIT);
            prop_assert!((parts.shift() - path.shift()).abs() < 1e-8 * unit);
            prop_assert!((parts.dissipated() - path.dissipated()).abs() < 1e-8 * LIMIT * unit);
        }
        let size = (path.normal_force() / LOAD).cbrt();
        let peak = 1.5 * LIMIT / (std::f64::consts::PI * 4e-3_f64.powi(2));
        let bound = |r: f64| peak * ((size - r) * (size + r)).max(0.0).sqrt();
        let r = place * size;
        prop_assert!(path.traction([4e-3 * r, 0.0]).abs() <= bound(r) + 1e-9 * peak * size);
        // As under one load, over the present one.
        let rings = 4000;
        let ring = |k: u32| {
            let r = size * (f64::from(k) + 0.5) / f64::from(rings);
            std::f64::consts::TAU * r * path.traction([4e-3 * r, 0.0])
        };
        let sum: f64 = (0..rings).map(ring).sum::<f64>() * 4e-3_f64.powi(2) * size / f64::from(rings);
        prop_assert!((sum - path.force()).abs() < 1e-4 * LIMIT * size.powi(3), "{} {}", sum, path.force());
        // Twice around, so that the state is one that comes back.
        for (load, end) in ends.iter().chain(&ends) {
            path.to(*load, *end).unwrap();
        }
        let (mut work, begin) = (0.0, path.dissipated());
        for (load, end) in &ends {
            let before = path.clone();
            for part in 1..=400 {
                let last = path.clone();
                let part = f64::from(part) / 400.0;
                let between = |from: f64, to: f64| from + part * (to - from);
                let [from, to] = [before.normal_force(), *load];
                match *end {
                    ShiftEnd::Force(force) => {
                        path.to(between(from, to), ShiftEnd::Force(between(before.force(), force))).unwrap();
                    }
                    ShiftEnd::Shift(shift) => {
                        let approach = between(from.powf(2.0 / 3.0), to.powf(2.0 / 3.0));
                        path.to(approach.powf(1.5), ShiftEnd::Shift(between(before.shift(), shift))).unwrap();
                    }
                }
                work += 0.5 * (path.force() + last.force()) * (path.shift() - last.shift());
            }
        }
        // Trapezoids over 400 parts of a step err by some 1e-5 of these units.
        let heat = path.dissipated() - begin;
        prop_assert!((heat - work).abs() < 1e-4 * LIMIT * unit, "{} {}", heat, work);
    }
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

/// A load that is given again, and a shift that is reached again, change nothing, though layers of rounded widths add up
/// to them.
#[test]
fn the_same_again_changes_nothing() {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let ellipse = Ellipse::new(4e-3, 4e-3).unwrap();
    let contact = Hertz::from_ellipse(SolidPair::new(steel, steel), ellipse, 500.0).unwrap();
    let mut path = ShiftPath::new(&contact, 0.4, ShiftAxis::X).unwrap();
    let slides = path.sliding_shift();
    for k in 0..400 {
        let (load, part) = (400.0 + 1.7 * f64::from(k), 0.2 + 0.0011 * f64::from(k));
        path = path.fresh();
        path.to_shift(0.1 * slides).unwrap();
        let end = ShiftEnd::Shift(part * path.sliding_shift_under(load));
        path.to(load, end).unwrap();
        let (force, adhesion, heat) = (path.force(), path.adhesion(), path.dissipated());
        for _ in 0..3 {
            path.to(load, end).unwrap();
            // To the rounding of a sum of a few layers.
            assert!(
                (path.force() - force).abs() <= 1e-12 * load,
                "{load}: {} {force}",
                path.force()
            );
            assert!((path.adhesion() - adhesion).abs() < 1e-9, "{load}: {}", path.adhesion());
            assert!((path.dissipated() - heat).abs() <= 1e-12 * heat, "{load}");
        }
        path.to_force(path.force()).unwrap();
        assert!((path.adhesion() - adhesion).abs() < 1e-9, "{load}: {}", path.adhesion());
    }
}
