//! Wheels that vary around their axle, against closed forms.

#![allow(clippy::unwrap_used)]

use creepage_rail::curve::{Arc, Line};
use creepage_rail::{
    Curve, Flat, GeometryError, Place, Position, Profile, Role, Side, Slice, SliceError,
    SliceSurface, Track, Waviness, Wheel, WheelVariation, Wheelset, WheelsetOnTrack,
};
use proptest::prelude::*;

const RADIUS: f64 = 0.45;

fn head() -> Profile {
    let half = 0.05f64;
    let depth = 0.3 - (0.09 - half * half).sqrt();
    let head = Arc::between([0.0, 0.3], 0.3, [-half, depth], [half, depth]);
    Profile::new(Role::Rail, Curve::new([head]).unwrap()).unwrap()
}

/// A cylinder with what it has beside on a crown of 300 mm.
fn cylinder(variation: WheelVariation, pitch: f64) -> WheelsetOnTrack {
    let tread = Line::between([0.03, 0.0], [-0.03, 0.0]);
    let tread = Profile::new(Role::Wheel, Curve::new([tread]).unwrap()).unwrap();
    let wheel = Wheel::new(&tread, RADIUS).unwrap().with_flange_back(0.0).unwrap();
    let wheel = wheel.with_variation(variation).unwrap();
    let track = Track::new(&head(), 0.0, Place::Origin(0.75)).unwrap();
    Wheelset::new(wheel.clone(), wheel, 1.5).unwrap().on(track).at(0.0, pitch).unwrap()
}

fn flat(flat: Flat) -> WheelVariation {
    WheelVariation { flats: vec![flat], ..WheelVariation::default() }
}

/// A wheel with a fresh flat turns about the flat's edge: its centre stands `R cos(a - |t|)` high where the middle of
/// the flat is turned by `t`, `a` half of its angle; on the round part `R`.
#[test]
fn a_chord_turns_about_its_edge() {
    let chord = Flat::chord(0.05, 0.2, RADIUS).unwrap();
    let half = (0.025f64 / RADIUS).asin();
    assert!((chord.depth - 0.05f64.powi(2) / (8.0 * RADIUS)).abs() < 1e-6);
    for turn in [-1.5, -0.9, -0.4, 0.0, 0.25, 0.7, 1.2] {
        let turn = turn * half;
        // Rolled forward by 0.2, the middle of the flat is straight down.
        let running = cylinder(flat(chord), 0.2 + turn);
        let touch = running.touch(Side::Right, 0.0, 0.0, 0.0).unwrap();
        let height = RADIUS - touch.z;
        let edge = half - f64::abs(turn);
        let expected = if edge > 0.0 { RADIUS * edge.cos() } else { RADIUS };
        assert!((height - expected).abs() < 1e-9, "{turn}: {height} {expected}");
        if edge > 0.0 && turn != 0.0 {
            // Rolled on, the flat has gone back, and its leading edge is below the axle.
            let x = RADIUS * edge.sin() * f64::signum(turn);
            assert!((touch.place[0] - x).abs() < 1e-6, "{turn}: {} {x}", touch.place[0]);
        }
    }
}

/// In the middle of a fresh flat the slope of the centre's height over the distance jumps by L/R: the closing speed of
/// an impact, over the speed, as long as wheel and rail stay together.
#[test]
fn the_slope_jumps_by_length_over_radius() {
    let (length, step) = (0.05, 1e-4);
    let chord = Flat::chord(length, 0.0, RADIUS).unwrap();
    let height = |turn: f64| {
        let running = cylinder(flat(chord), turn);
        running.touch(Side::Right, 0.0, 0.0, 0.0).unwrap().z
    };
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| height(k * step));
    let jump = ((b - a) - (d - c)) / (step * RADIUS);
    // On either side the slope falls by what the wheel has turned where it is taken, a step and a half.
    let expected = length / RADIUS - 3.0 * step;
    assert!((jump / expected - 1.0).abs() < 1e-4, "{jump} {expected}");
}

/// Below the length `pi sqrt(2 d R)` a worn flat bears at its ends, above it in the middle.
#[test]
fn a_short_worn_flat_bears_at_its_ends() {
    let limit = std::f64::consts::PI * (2.0 * 0.9e-3 * RADIUS).sqrt();
    for (part, contacts) in [(0.8, 2), (1.15, 1)] {
        let worn = Flat::haversine(part * limit, 0.9e-3, 0.0, RADIUS).unwrap();
        let running = cylinder(flat(worn), 0.0);
        let touch = running.touch(Side::Right, 0.0, 0.0, 0.0).unwrap();
        let pressed = Position { z: touch.z + 20e-6, ..Position::default() };
        let found = running.contacts_of(Side::Right, &pressed).unwrap();
        assert_eq!(found.len(), contacts, "{part}");
        if let [back, front] = &found[..] {
            assert!((back.reference[0] + front.reference[0]).abs() < 1e-6);
            assert!((back.approach - front.approach).abs() < 1e-8);
        } else {
            // Of the middle: the depth less.
            assert!((touch.z - 0.9e-3).abs() < 1e-9, "{}", touch.z);
        }
    }
}

#[test]
fn slices_that_make_no_surface_are_refused() {
    let slice = |u: f64, features: Vec<Option<f64>>| Slice {
        u,
        profile: head(),
        shift: [0.0; 2],
        features,
        kink: false,
    };
    let of = |slices: &[Slice]| SliceSurface::new(Role::Rail, slices, &[]).unwrap_err();
    let one = slice(0.0, vec![]);
    assert!(matches!(of(std::slice::from_ref(&one)), SliceError::TooFew { count: 1 }));
    assert!(matches!(of(&[one.clone(), one.clone()]), SliceError::Order { index: 2, .. }));
    let other = slice(1.0, vec![Some(0.0), Some(0.05)]);
    assert!(matches!(of(&[one, other]), SliceError::Features { index: 2, count: 2, .. }));
    let falling = slice(0.0, vec![Some(0.05), Some(0.01)]);
    assert!(matches!(
        of(&[falling, slice(1.0, vec![Some(0.0), Some(0.05)])]),
        SliceError::FeatureOrder { index: 1, .. }
    ));
    let absent = |u: f64| slice(u, vec![None, Some(0.05)]);
    assert!(matches!(of(&[absent(0.0), absent(1.0)]), SliceError::Empty));
    let wheel = SliceSurface::new(Role::Wheel, &[slice(0.0, vec![]), slice(1.0, vec![])], &[]);
    assert!(matches!(wheel.unwrap_err(), SliceError::Role { index: 1, .. }));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    /// Out of round by one harmonic: no contact is lost, and where the wheel touches the height is the lowest place
    /// of its section, found by brute force.
    #[test]
    fn a_polygon_touches_at_its_lowest_place(
        order in 1u32..40,
        amplitude in 1e-6f64..3e-4,
        pitch in -3.0f64..3.0,
    ) {
        let wave = Waviness { order, amplitude, phase: 0.3 };
        let variation = WheelVariation { waviness: vec![wave], ..WheelVariation::default() };
        let running = cylinder(variation, pitch);
        let touch = running.touch(Side::Right, 0.0, 0.0, 0.0).unwrap();
        let lowest = (-30_000i32..=30_000)
            .map(|k| {
                let b = f64::from(k) * 1e-5;
                let r = RADIUS + amplitude * (f64::from(order) * (b + pitch) + 0.3).sin();
                r * b.cos()
            })
            .fold(0.0, f64::max);
        // The brute force steps by 5 um, which is 1e-10 m and less in height.
        prop_assert!((RADIUS - touch.z - lowest).abs() < 1e-9, "{} {}", RADIUS - touch.z, lowest);
        let pressed = Position { z: touch.z + 30e-6, ..Position::default() };
        let contacts = running.contacts_of(Side::Right, &pressed).unwrap();
        prop_assert!(!contacts.is_empty());
        let deepest = contacts.iter().map(|contact| contact.approach).fold(0.0, f64::max);
        prop_assert!((deepest - 30e-6).abs() < 3e-7, "{deepest}");
    }
}

#[test]
fn numbers_out_of_range_are_refused() {
    assert!(matches!(
        Flat::haversine(0.05, 0.02, 0.0, RADIUS),
        Err(GeometryError::Value { name: "flat.depth", .. })
    ));
    assert!(Flat::chord(-1.0, 0.0, RADIUS).is_err() && Flat::chord(f64::NAN, 0.0, RADIUS).is_err());
}
