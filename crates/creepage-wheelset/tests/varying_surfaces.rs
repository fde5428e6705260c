//! Wheels and rails that vary along rolling: flats, polygons, corrugation, slices.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::sync::Arc as Shared;

use creepage::theory::{AreaTheory, ExactOptions, NamedResolution, ResolutionSpec};
use creepage::{Solid, SolidPair};
use creepage_rail::curve::{Arc, Line};
use creepage_rail::{
    Corrugation, Curve, Flat, Place, Profile, RailVariation, Role, Side, Slice, SliceSurface,
    Standard, Track, Waviness, Wheel, WheelVariation, Wheelset, WheelsetOnTrack,
};
use creepage_wheelset::{
    Load, RailFriction, SolvedContact, SolvedWheelset, WheelsetError, WheelsetPose, WheelsetSolver,
    WheelsetVelocity,
};

const MM: f64 = 1e-3;

/// A rail's head of one arc of 300 mm.
fn crown() -> Profile {
    let half = 0.05f64;
    let depth = 0.3 - (0.09 - half * half).sqrt();
    let head = Arc::between([0.0, 0.3], 0.3, [-half, depth], [half, depth]);
    Profile::new(Role::Rail, Curve::new([head]).unwrap()).unwrap()
}

fn tread() -> Profile {
    let tread = Line::between([0.03, 0.0], [-0.03, 0.0]);
    Profile::new(Role::Wheel, Curve::new([tread]).unwrap()).unwrap()
}

/// A cylinder of a radius on a crown of 300 mm, each with what it has beside.
fn cylinder_of(
    radius: f64,
    (wheel_varies, rail_varies): (WheelVariation, RailVariation),
    place: [f64; 2],
) -> WheelsetOnTrack {
    let wheel = Wheel::new(&tread(), radius).unwrap().with_flange_back(0.0).unwrap();
    let wheel = wheel.with_variation(wheel_varies).unwrap();
    let track = Track::new(&crown(), 0.0, Place::At([0.75, 0.0])).unwrap();
    let [left, right] =
        [track.left, track.right].map(|rail| rail.with_variation(rail_varies.clone()).unwrap());
    let wheelset = Wheelset::new(wheel.clone(), wheel, 1.5).unwrap();
    wheelset.on(Track { left, right }).at(place[0], place[1]).unwrap()
}

fn cylinder(variation: WheelVariation, pitch: f64) -> WheelsetOnTrack {
    cylinder_of(0.45, (variation, RailVariation::default()), [0.0, pitch])
}

fn on_rail(variation: RailVariation, s: f64) -> WheelsetOnTrack {
    cylinder_of(0.45, (WheelVariation::default(), variation), [s, 0.0])
}

fn solver(running: &WheelsetOnTrack, resolution: NamedResolution) -> WheelsetSolver<'_> {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
    let resolution = ResolutionSpec::Named(resolution);
    let theory = AreaTheory::Exact(ExactOptions { resolution, ..ExactOptions::default() });
    WheelsetSolver::new(running, SolidPair::new(steel, steel), friction, theory).unwrap()
}

fn pose(load: f64) -> WheelsetPose {
    let load = Some(Load::Wheel(load));
    WheelsetPose { side: Some(Side::Right), y: 0.0, yaw: 0.0, roll: Some(0.0), load }
}

const SPEED: WheelsetVelocity = WheelsetVelocity {
    speed: 2.0,
    pitch: creepage_wheelset::PitchRate::Rigid(None),
    drive: creepage_wheelset::Drive::Torque(0.0),
    lateral_velocity: 0.0,
    vertical_velocity: 0.0,
    roll_rate: 0.0,
    yaw_rate: 0.0,
    curvature: 0.0,
    rails: [creepage_rail::RailMotion {
        lateral_velocity: 0.0,
        vertical_velocity: 0.0,
        roll_rate: 0.0,
    }; 2],
};

fn solved(running: &WheelsetOnTrack, load: f64) -> SolvedWheelset {
    solver(running, NamedResolution::Standard).solve(&pose(load), &SPEED).unwrap()
}

fn only(solved: &SolvedWheelset) -> &SolvedContact {
    let contacts = solved.right.as_ref().unwrap().contacts();
    assert_eq!(contacts.len(), 1);
    &contacts[0]
}

fn peak(solved: &SolvedWheelset) -> f64 {
    only(solved).normal.peak_pressure().value
}

/// A worn flat: numbers of an independent program (square elements, FFT) on the exact gap, good to .1 % in the peak
/// pressure and 1e-5 mm in height. Ours are finer by a tenth of that (elements take the mean pressure of their area).
#[test]
fn a_haversine_flat_presses_as_computed_elsewhere() {
    // Pitch (degrees, forward rolling makes it fall there), MPa, approach, height, and x of the pressure (mm).
    let known = [
        [-7.0, 573.0, 0.02271, 0.0227, 0.0],
        [-5.0, 686.3, 0.02495, 0.0822, 4.726],
        [-3.0, 643.3, 0.02417, 0.3554, 10.630],
        [-1.0, 524.8, 0.02153, 0.7752, 11.953],
        [0.0, 372.7, 0.01667, 0.9167, 0.0],
    ];
    for [theta, peak, approach, height, x] in known {
        let flat = Flat::haversine(100.1808 * MM, 0.9 * MM, 0.0, 0.45).unwrap();
        let variation = WheelVariation { flats: vec![flat], ..WheelVariation::default() };
        let running = cylinder(variation, -f64::to_radians(theta));
        let fine = solver(&running, NamedResolution::Fine);
        let solved = fine.solve(&pose(10e3), &SPEED).unwrap();
        let (wheel, contact) = (solved.right.as_ref().unwrap(), only(&solved));
        let found = contact.normal.peak_pressure();
        let centre = contact.in_track(contact.centre_of_pressure());
        assert!((found.value * 1e-6 / peak - 1.0).abs() < 1.3e-3, "{theta} {found:?}");
        let gone = contact.normal.approach().value / MM;
        assert!((gone - approach).abs() < 2e-5, "{theta} {gone}");
        // Printed with four digits behind the point.
        assert!((wheel.position.z / MM - height).abs() < 1e-4, "{theta} {}", wheel.position.z);
        assert!((centre[0] / MM - x).abs() < 2e-3, "{theta} {}", centre[0]);
        // Free rolling: friction balances the pressure, whose line passes the axle at x.
        let moment = 10e3 * centre[0] / (0.45 - wheel.position.z);
        assert!((contact.force.longitudinal - moment).abs() < 0.01 * moment.abs() + 0.1, "{theta}");
    }
}

/// What is of no depth changes nothing, to the last bit.
#[test]
fn a_flat_without_depth_is_none() {
    let flat = Flat::haversine(0.1, 0.0, 0.0, 0.45).unwrap();
    let wave = Waviness { order: 7, amplitude: 0.0, phase: 1.0 };
    let variation =
        WheelVariation { flats: vec![flat], waviness: vec![wave], ..WheelVariation::default() };
    assert_eq!(cylinder(variation, 0.0), cylinder(WheelVariation::default(), 0.0));
    let flat = Corrugation { wavelength: 0.1, amplitude: 0.0, phase: 0.0 };
    let variation = RailVariation { corrugation: vec![flat], ..RailVariation::default() };
    assert!(!on_rail(variation, 0.0).varies());
}

/// A wheelset of S1002 wheels on UIC 60 rails, yawed on both rails.
fn standard(wheels: WheelVariation, rails: &RailVariation) -> WheelsetOnTrack {
    let wheel = Wheel::new(&Standard::S1002.profile(), 0.46).unwrap();
    let wheel = wheel.with_variation(wheels).unwrap();
    let profile = Standard::Uic60.profile();
    let track = Track::new(&profile, 0.025f64.atan(), Place::gauge(1.435, 0.014)).unwrap();
    let [left, right] =
        [track.left, track.right].map(|rail| rail.with_variation(rails.clone()).unwrap());
    Wheelset::new(wheel.clone(), wheel, 1.36).unwrap().on(Track { left, right })
}

/// The same numbers by one profile, by a wheel out of round by less than an atom, and by slices that are all alike:
/// loads, peak pressures, forces, places; within what the strips of both scatter, a third of their error bars, and
/// for slices what their paths .25 mm apart round off where arcs meet.
#[test]
fn surfaces_that_are_alike_along_have_the_numbers_of_one_profile() {
    let slices = |role: Role, profile: &Profile, step: f64, count: u32| {
        let slice = |k: u32| Slice {
            u: (f64::from(k) - 0.5 * f64::from(count)) * step,
            profile: profile.clone(),
            shift: [0.0; 2],
            features: Vec::new(),
            kink: false,
        };
        let all: Vec<Slice> = (0..=count).map(slice).collect();
        Some(Shared::new(SliceSurface::new(role, &all, &[]).unwrap()))
    };
    let wave = Waviness { order: 3, amplitude: 1e-13, phase: 0.0 };
    let round = WheelVariation { waviness: vec![wave], ..WheelVariation::default() };
    let of_wheel = slices(Role::Wheel, &Standard::S1002.profile(), 0.05, 10);
    let sliced = WheelVariation { slices: of_wheel, ..WheelVariation::default() };
    let of_rail = slices(Role::Rail, &Standard::Uic60.profile(), 0.05, 8);
    let sliced_rail = RailVariation { slices: of_rail, ..RailVariation::default() };
    let none = RailVariation::default;
    let plain = standard(WheelVariation::default(), &none());
    let load = Some(Load::Axle(160e3));
    let pose = WheelsetPose { side: None, y: 0.003, yaw: 2e-3, roll: None, load };
    let motion = WheelsetVelocity { speed: 30.0, ..WheelsetVelocity::default() };
    let solve = |running: &WheelsetOnTrack| {
        solver(running, NamedResolution::Standard).solve(&pose, &motion)
    };
    let known = solve(&plain).unwrap();
    for (name, running, part) in [
        ("round", standard(round, &none()), 1e-3),
        ("slices", standard(sliced, &sliced_rail), 2e-3),
    ] {
        let found = solve(&running).unwrap();
        for (one, other) in known.wheels().zip(found.wheels()) {
            assert!((one.position.z - other.position.z).abs() < 1e-7, "{name}");
            assert_eq!(one.contacts().len(), other.contacts().len(), "{name}");
            for (a, b) in one.contacts().iter().zip(other.contacts()) {
                let close = |a: f64, b: f64, of: f64| {
                    assert!((a - b).abs() < part * of, "{name} {a} {b}");
                };
                let bound = 0.3 * a.load();
                close(a.load(), b.load(), a.load());
                let [p, q] = [a, b].map(|one| one.normal.peak_pressure().value);
                // Bars of half a per cent.
                assert!((p / q - 1.0).abs() < 3e-3, "{name} {p} {q}");
                close(a.force.longitudinal, b.force.longitudinal, bound);
                close(a.force.lateral, b.force.lateral, bound);
                assert!((a.angle - b.angle).abs() < 2e-4 && b.slope.abs() < 1e-6, "{name}");
                assert!((a.reference[1] - b.reference[1]).abs() < 2e-5, "{name}");
                assert!((a.reference[0] - b.reference[0]).abs() < 2e-5, "{name}");
                let ends = b.varying.unwrap();
                assert!(!ends.is_cut && !ends.is_beyond, "{name}");
            }
        }
    }
}

/// A rail that rises by 1:10 turns all by its slope: the wheel touches at R sin(atan .1) ahead, and the pressure pushes
/// the rail forward by a tenth of its vertical part.
#[test]
fn on_a_ramp_the_normal_leans_forward() {
    let slice = |k: i32| Slice {
        u: f64::from(k) * 0.02,
        profile: crown(),
        shift: [0.0, -0.002 * f64::from(k)],
        features: Vec::new(),
        kink: false,
    };
    let slices: Vec<Slice> = (-8..=8).map(slice).collect();
    let surface = SliceSurface::new(Role::Rail, &slices, &[]).unwrap();
    let rising = RailVariation { slices: Some(Shared::new(surface)), ..RailVariation::default() };
    let running = on_rail(rising, 0.01);
    let contact_of = solved(&running, 10e3);
    let contact = only(&contact_of);
    let slope = 0.1f64.atan();
    let x = 0.45 * slope.sin();
    assert!((contact.reference[0] - x).abs() < 2e-5, "{}", contact.reference[0]);
    assert!((contact.slope + slope).abs() < 1e-5, "{}", contact.slope);
    // Free rolling: the pressure passes the axle and nothing drives, so friction is next to none.
    let force = contact_of.right.as_ref().unwrap().on_rail().force;
    assert!((force[0] / force[2] - 0.1).abs() < 1e-3, "{force:?}");
    assert!((contact.load() * slope.cos() - 10e3).abs() < 10.0, "{}", contact.load());
    let level = peak(&solved(&on_rail(RailVariation::default(), 0.0), contact.load()));
    assert!((peak(&contact_of) / level - 1.0).abs() < 2e-3);
}

/// On the crest and in the trough of a long wave the rail's curvature adds to that of the wheel.
#[test]
fn corrugation_curves_the_rail_along() {
    let (wavelength, amplitude) = (0.5, 0.5 * MM);
    let rate = std::f64::consts::TAU / wavelength;
    for (s, sign) in [(0.375, 1.0), (0.125, -1.0)] {
        let wave = Corrugation { wavelength, amplitude, phase: 0.0 };
        let variation = RailVariation { corrugation: vec![wave], ..RailVariation::default() };
        let wavy = solved(&on_rail(variation, s), 10e3);
        let radius = 1.0 / (1.0 / 0.45 + sign * amplitude * rate * rate);
        let none = (WheelVariation::default(), RailVariation::default());
        let known = solved(&cylinder_of(radius, none, [0.0; 2]), 10e3);
        // Beside the wave's own fourth order, 1e-4 of the gap, what strips leave.
        assert!((peak(&wavy) / peak(&known) - 1.0).abs() < 2e-3, "{s}");
        let [wavy, known] = [wavy, known].map(|one| one.right.unwrap().position.z);
        assert!((wavy - known + sign * amplitude).abs() < 1e-8, "{s}: {wavy} {known}");
    }
}

/// A rail that begins under the wheel: the area is cut and says so.
#[test]
fn a_part_that_begins_cuts_the_area() {
    let slice = |k: u32| Slice {
        u: f64::from(k) * 0.02,
        profile: crown(),
        shift: [0.0; 2],
        // It is there from the fifth slice on.
        features: if k < 4 { vec![None, None] } else { vec![Some(0.0), Some(0.2)] },
        kink: false,
    };
    let slices: Vec<Slice> = (0..=10).map(slice).collect();
    let surface = SliceSurface::new(Role::Rail, &slices, &[]).unwrap();
    let part = RailVariation { slices: Some(Shared::new(surface)), ..RailVariation::default() };
    let beside = solved(&on_rail(part.clone(), 0.1), 10e3);
    assert!(!only(&beside).varying.unwrap().is_cut);
    let cut = solved(&on_rail(part, 0.0795), 10e3);
    let contact = only(&cut);
    assert!(contact.varying.unwrap().is_cut);
    // It begins half a millimetre ahead.
    let [[back, _], _] = contact.extent();
    let begins = contact.in_track([back, 0.0])[0];
    assert!(begins > 0.4 * MM, "{begins}");
    assert!((contact.load() * contact.slope.cos() - 10e3).abs() < 20.0);
    assert!(peak(&cut) > 1.1 * peak(&beside));
}

/// What is not known of surfaces that vary is refused by cause.
#[test]
fn what_needs_round_wheels_is_refused() {
    let wave = Waviness { order: 20, amplitude: 1e-5, phase: 0.0 };
    let variation = WheelVariation { waviness: vec![wave], ..WheelVariation::default() };
    let running = cylinder(variation, 0.3);
    let solver = solver(&running, NamedResolution::Fast);
    let found = solver.solve(&pose(10e3), &SPEED).unwrap();
    let back = WheelsetVelocity { speed: -2.0, ..SPEED };
    let refused = solver.solve(&pose(10e3), &back).unwrap_err();
    assert!(matches!(refused, WheelsetError::Varies { .. }), "{refused}");
    let refused = solver.derivatives(&found, &pose(10e3), &SPEED).unwrap_err();
    assert!(matches!(refused, WheelsetError::Varies { .. }), "{refused}");
}
