//! Rectangles sheared to and fro: closed forms, limits, and stored numbers of another program.

use creepage::statics::{ShearError, ShearedRectangle, Shearing, ShiftAxis};
use creepage::{Layer, Plasticity, Solid, SolidPair};
use proptest::prelude::*;

fn steel() -> SolidPair {
    let steel = Solid::new(82e9, 0.28).unwrap();
    SolidPair::new(steel, steel)
}

/// A square of 1 mm under 900 N with friction .7.
fn square(layer: Option<Layer>) -> ShearedRectangle {
    ShearedRectangle::new(steel(), [0.5e-3; 2], 900.0, 0.7, layer, ShiftAxis::X).unwrap()
}

/// Shear modulus (Pa), yield stress (Pa), slope (Pa/m) of a layer of 20 um.
fn layer(modulus: f64, yield_stress: f64, slope: f64) -> Layer {
    let layer = Layer::elastic(20e-6, modulus).unwrap();
    layer.with_plasticity(Plasticity { yield_stress, slope }).unwrap()
}

/// Stored numbers of CONTACT 25.2 (Apache-2.0), its example of third-body layers: one element, ways (um) one after
/// the other, and the forces (N), of which it prints four digits.
#[test]
fn four_materials_as_that_program_has_them() {
    let [magnetite, clay, sand, lubricant] = [
        layer(176.63e6, 560e6, 0.0),
        layer(106.25e6, 200e6, 435e9),
        layer(176.63e6, 400e6, -195e9),
        layer(20.238e6, 20e6, 20.4e9),
    ];
    let cases: [(Option<Layer>, &[[f64; 2]]); 5] = [
        (None, &[[1.0, 84.97]]),
        (Some(magnetite), &[[35.0, 280.0], [35.0, 560.0], [30.0, 560.0], [50.0, 560.0]]),
        (
            Some(clay),
            &[
                [40.0, 200.0],
                [40.0, 216.0],
                [40.0, 232.0],
                [40.0, 248.0],
                [36.0, 262.4],
                [0.0, 262.4],
                [-36.0, 82.43],
                [0.0, 82.43],
                [46.0, 266.4],
                [44.0, 284.0],
                [50.0, 304.0],
                [50.0, 324.1],
            ],
        ),
        (Some(sand), &[[25.0, 200.0], [25.0, 400.0], [50.0, 390.0], [50.0, 380.0], [50.0, 370.0]]),
        (Some(lubricant), &[[20.0, 20.0], [40.0, 20.8], [40.0, 21.6], [50.0, 22.6]]),
    ];
    for (layer, path) in cases {
        let (mut test, mut shift) = (square(layer), 0.0);
        for [way, force] in path {
            shift += way * 1e-6;
            test.to_shift(shift).unwrap();
            // Half of the last digit printed, and as much again where it is rounded twice.
            let digit = if *force < 100.0 { 0.01 } else { 0.1 };
            assert!((test.force() - force).abs() <= digit, "{shift}: {} {force}", test.force());
        }
    }
    // Approach of the same element, 8.868e-3 mm.
    assert!((square(None).approach() / 8.868e-6 - 1.0).abs() < 1e-4);
}

/// A square by integrals: `1/r` gives `8 a asinh 1`, half of it `x^2/r^3`.
#[test]
fn a_square_is_as_soft_as_cerruti_says() {
    let integral = 8.0 * 0.5e-3 * 1.0_f64.asinh();
    let right = (0.72 + 0.14) * integral / (std::f64::consts::PI * 82e9);
    let found = square(None).compliance() * 1e-6;
    assert!((found / right - 1.0).abs() < 1e-14, "{found:e} {right:e}");
    // Along a long rectangle, and across a wide one: the same rectangle.
    let along = ShearedRectangle::new(steel(), [3e-3, 1e-3], 9.0, 0.3, None, ShiftAxis::X).unwrap();
    let across =
        ShearedRectangle::new(steel(), [1e-3, 3e-3], 9.0, 0.3, None, ShiftAxis::Y).unwrap();
    assert!((along.compliance() / across.compliance() - 1.0).abs() < 1e-14);
}

/// What vanishes: no thickness, a yield stress that is never reached.
#[test]
fn a_layer_that_vanishes_or_never_yields_changes_nothing() {
    let thin = layer(1e20, 1e12, 0.0);
    for shift in [0.5e-6, -3e-6, 9e-6, 2e-6] {
        let [mut bare, mut with] = [square(None), square(Some(thin))];
        bare.to_shift(shift).unwrap();
        with.to_shift(shift).unwrap();
        assert!((bare.force() - with.force()).abs() < 1e-9 * 630.0);
        assert_eq!(bare.state(), with.state());
    }
}

/// Friction, the yield, and hardening that reaches friction.
#[test]
fn the_smaller_of_friction_and_yield_bounds_it() {
    let mut bare = square(None);
    bare.to_shift(20e-6).unwrap();
    assert_eq!((bare.force(), bare.state()), (630.0, Shearing::Slides));
    let elastic = bare.compliance() * 630.0;
    assert!((bare.sliding_way() - (20e-6 - elastic)).abs() < 1e-18);
    assert!((bare.dissipated() - 630.0 * bare.sliding_way()).abs() < 1e-12);

    let mut hard = square(Some(layer(106.25e6, 600e6, 435e9)));
    hard.to_shift(-1e-3).unwrap();
    assert_eq!(hard.state(), Shearing::Slides);
    assert!((hard.plastic_displacement() / (30e6 / 435e9) - 1.0).abs() < 1e-12);
    assert!((hard.force() + 630.0).abs() < 1e-9);

    let mut soft = square(Some(layer(106.25e6, 100e6, -50e9)));
    soft.to_shift(5e-3).unwrap();
    assert_eq!((soft.force(), soft.state()), (0.0, Shearing::Yields));
    // Work of a yield stress that falls to nothing: half of it times the way, 2 mm.
    assert!((soft.dissipated() / (0.5 * 100.0 * 2e-3) - 1.0).abs() < 1e-12);
}

#[test]
fn forces_are_reached_elastically_or_by_hardening() {
    let mut clay = square(Some(layer(106.25e6, 200e6, 435e9)));
    clay.to_force(-300.0).unwrap();
    assert!((clay.force() + 300.0).abs() < 1e-12 * 300.0);
    let right = -(300.0 * clay.compliance() + 100e6 / 435e9);
    assert!((clay.shift() / right - 1.0).abs() < 1e-12, "{} {right}", clay.shift());
    let before = clay.clone();
    assert_eq!(clay.to_force(631.0), Err(ShearError::Beyond { force: 631.0, most: 630.0 }));
    assert_eq!(clay, before);
    let mut perfect = square(Some(layer(106.25e6, 200e6, 0.0)));
    assert!(
        matches!(perfect.to_force(201.0), Err(ShearError::Beyond { most, .. }) if most < 200.1)
    );
}

#[test]
fn nonsense_is_an_error_that_names_the_quantity() {
    let new = |half, force, friction, layer| {
        ShearedRectangle::new(steel(), half, force, friction, layer, ShiftAxis::Y).unwrap_err()
    };
    assert_eq!(new([0.0, 1.0], 1.0, 0.3, None).quantity, "half-length along x");
    assert_eq!(new([1.0, -1.0], 1.0, 0.3, None).quantity, "half-length along y");
    assert_eq!(new([1.0, 1.0], f64::NAN, 0.3, None).quantity, "normal_force");
    assert_eq!(new([1.0, 1.0], 1.0, 0.0, None).quantity, "friction");
    // Without elastic shear it may soften as fast as it will, but for the bodies.
    let rigid = Layer::elastic(0.0, 1e9).unwrap();
    let snaps = rigid.with_plasticity(Plasticity { yield_stress: 1e8, slope: -1e15 }).unwrap();
    assert_eq!(new([1e-3, 1e-3], 1.0, 0.3, Some(snaps)).quantity, "slope");
    assert!(matches!(square(None).to_shift(f64::NAN), Err(ShearError::Invalid(_))));
}

proptest! {
    /// However it is sheared: the traction is within its bounds, the work done is kept or turned to heat, and in
    /// several steps the same way ends the same.
    #[test]
    fn paths_balance(
        slope in prop_oneof![Just(0.0), -190e9..500e9],
        ends in prop::collection::vec(-200e-6..200e-6, 1..6),
    ) {
        let mut test = square(Some(layer(176.63e6, 300e6, slope)));
        let mut in_parts = test.clone();
        let mut work = 0.0;
        for end in ends {
            let from = test.shift();
            test.to_shift(end).unwrap();
            for k in 1..=2000 {
                let (force, at) = (in_parts.force(), in_parts.shift());
                in_parts.to_shift(from + (end - from) * f64::from(k) / 2000.0).unwrap();
                work += 0.5 * (force + in_parts.force()) * (in_parts.shift() - at);
            }
            prop_assert!((test.force() - in_parts.force()).abs() < 1e-6);
            prop_assert!((test.dissipated() - in_parts.dissipated()).abs() < 1e-9);
            prop_assert!(test.force().abs() <= 630.0 + 1e-9);
            prop_assert!(test.force().abs() <= test.yield_stress().unwrap() * 1e-6 + 1e-9);
        }
        let elastic = 0.5 * test.force() * test.force() * test.compliance();
        // Trapezia at the corners of the path: a two-thousandth of a way, twice a step.
        prop_assert!((work - elastic - test.dissipated()).abs() < 2e-4, "{work} {elastic}");
    }
}
