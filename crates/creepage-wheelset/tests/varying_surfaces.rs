//! Wheels and rails that vary along rolling: flats, polygons, corrugation, slices.

#![allow(clippy::unwrap_used, clippy::panic)]

use creepage::theory::{AreaTheory, ExactOptions};
use creepage::{Solid, SolidPair};
use creepage_rail::curve::{Arc, Line};
use creepage_rail::{
    Curve, Flat, Place, Profile, Role, Side, Track, Wheel, WheelVariation, Wheelset,
    WheelsetOnTrack,
};
use creepage_wheelset::{
    Load, RailFriction, SolvedWheelset, WheelsetPose, WheelsetSolver, WheelsetVelocity,
};

const MM: f64 = 1e-3;

/// A cylinder of 450 mm, with what it has beside, on a crown of 300 mm.
fn cylinder(variation: WheelVariation, pitch: f64) -> WheelsetOnTrack {
    let tread = Line::between([0.03, 0.0], [-0.03, 0.0]);
    let tread = Profile::new(Role::Wheel, Curve::new([tread]).unwrap()).unwrap();
    let half = 0.05f64;
    let depth = 0.3 - (0.09 - half * half).sqrt();
    let head = Arc::between([0.0, 0.3], 0.3, [-half, depth], [half, depth]);
    let head = Profile::new(Role::Rail, Curve::new([head]).unwrap()).unwrap();
    let wheel = Wheel::new(&tread, 0.45).unwrap().with_flange_back(0.0).unwrap();
    let wheel = wheel.with_variation(variation).unwrap();
    let track = Track::new(&head, 0.0, Place::Origin(0.75)).unwrap();
    let wheelset = Wheelset::new(wheel.clone(), wheel, 1.5).unwrap();
    wheelset.on(track).at(0.0, pitch).unwrap()
}

fn solved(running: &WheelsetOnTrack, load: f64) -> SolvedWheelset {
    let steel = Solid::new(82e9, 0.28).unwrap();
    let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
    let theory = AreaTheory::Exact(ExactOptions {
        resolution: creepage::theory::ResolutionSpec::Named(
            creepage::theory::NamedResolution::Fine,
        ),
        ..ExactOptions::default()
    });
    let solver =
        WheelsetSolver::new(running, SolidPair::new(steel, steel), friction, theory).unwrap();
    let pose = WheelsetPose {
        side: Some(Side::Right),
        y: 0.0,
        yaw: 0.0,
        roll: Some(0.0),
        load: Some(Load::Wheel(load)),
    };
    let velocity = WheelsetVelocity { speed: 2.0, ..WheelsetVelocity::default() };
    solver.solve(&pose, &velocity).unwrap()
}

/// A worn flat: numbers of an independent program (square elements, FFT) on the exact gap, good to .1 % in the peak
/// pressure and 1e-5 mm in height; ours have an error bar of about as much.
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
        let start = std::time::Instant::now();
        let solved = solved(&running, 10e3);
        let wheel = solved.right.as_ref().unwrap();
        let [contact] = wheel.contacts() else { panic!("{theta}: {}", wheel.contacts().len()) };
        let found = contact.normal.peak_pressure();
        let centre = contact.in_track(contact.centre_of_pressure());
        println!(
            "{theta} p {:.2} +- {:.2} ({peak}) approach {:.5} ({approach}) z {:.5} ({height}) x {:.3} ({x}) Fx {:.1} {:?} {:?}",
            found.value * 1e-6,
            found.error * 1e-6,
            contact.normal.approach().value / MM,
            wheel.position.z / MM,
            centre[0] / MM,
            contact.force.longitudinal,
            contact.normal.method(),
            start.elapsed()
        );
        assert!((found.value * 1e-6 / peak - 1.0).abs() < 1.5e-3, "{theta}");
        assert!((contact.normal.approach().value / MM - approach).abs() < 2e-5, "{theta}");
        assert!((wheel.position.z / MM - height).abs() < 1e-4, "{theta}");
        assert!((centre[0] / MM - x).abs() < 0.01, "{theta}");
    }
}
