//! The flange of a yawed wheel: a slender contact that lies askew, where the gap along rolling is no parabola.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::print_stdout)]

use creepage::theory::{AreaTheory, ExactOptions};
use creepage::{Solid, SolidPair};
use creepage_rail::{Place, Side, Standard, Track, Wheelset};
use creepage_wheelset::{
    Load, RailFriction, SolvedContact, WheelsetPose, WheelsetSolver, WheelsetVelocity,
};

/// Right wheel of the Manchester benchmark, A-2.2, at y = 6.5 mm and 15.6 mrad, where its flange carries
/// `normal` (N) across its plane.
fn flange(normal: f64) -> SolvedContact {
    let rail = Standard::Uic60.profile();
    let track = Track::new(&rail, 0.025f64.atan(), Place::gauge(1.435, 0.014)).unwrap();
    let running = Wheelset::like(&Standard::S1002.profile(), 0.46, 1.36).unwrap().on(track);
    let steel = Solid::new(82e9, 0.28).unwrap();
    let friction = [RailFriction::Constant(0.3), RailFriction::Constant(0.3)];
    let theory = AreaTheory::Exact(ExactOptions::default());
    let solver =
        WheelsetSolver::new(&running, SolidPair::new(steel, steel), friction, theory).unwrap();
    let velocity = WheelsetVelocity { speed: 2.0, ..WheelsetVelocity::default() };
    let at = |load: f64| {
        let pose = WheelsetPose {
            side: Some(Side::Right),
            y: 6.5e-3,
            yaw: 15.6e-3,
            roll: Some(-0.0044),
            load: Some(Load::Wheel(load)),
        };
        let wheel = solver.solve(&pose, &velocity).unwrap().right.unwrap();
        let [contact] = wheel.contacts() else { panic!("{} contacts", wheel.contacts().len()) };
        contact.clone()
    };
    // The load across the plane goes nearly as that of the wheel.
    let load = 0.67 * normal;
    at(load * normal / at(load).normal.load().value)
}

/// Peak pressure and area of the true distance between the surfaces along the normal, sampled on cells of
/// .05 x .01 mm and pressed by FFT and conjugate gradients, which has nothing in common with strips: to .3 % of
/// the peak and 1 % of the area, as its cells of half the size tell.
#[test]
fn peak_pressure_is_that_of_the_true_gap() {
    for (normal, peak, area) in
        [(15_439.0, 2586.2e6, 9.01e-6), (50_000.0, 3827e6, 19.75e-6), (100_000.0, 4823e6, 31.3e-6)]
    {
        let contact = flange(normal);
        let own = contact.normal.peak_pressure();
        println!(
            "{:.0} N: {:.4e} +- {:.1e}, area {:?}",
            contact.normal.load().value,
            own.value,
            own.error,
            contact.normal.area()
        );
        assert!((own.value - peak).abs() < own.error + 3e-3 * peak, "{own:?} {peak}");
        let own = contact.normal.area();
        assert!((own.value - area).abs() < own.error + 1e-2 * area, "{own:?} {area}");
    }
}

/// The outline is smooth and convex: no shoulders where strips end.
#[test]
fn outline_is_convex() {
    let contact = flange(100e3);
    let [patch] = contact.normal.patches() else { panic!() };
    let [band] = patch.bands() else { panic!() };
    let [from, to] = band.y();
    let row = |i: u32| from + (to - from) * (0.05 + 0.9 * f64::from(i) / 24.0);
    let ends: Vec<[f64; 2]> = (0..=24).map(|i| band.ends(row(i)).unwrap()).collect();
    // Of the largest length, by which an end may lie inside the line through its neighbours.
    let most = 0.01 * ends.iter().map(|[a, b]| b - a).fold(0.0, f64::max);
    for three in ends.windows(3) {
        let trailing = three[1][0] - 0.5 * (three[0][0] + three[2][0]);
        let leading = 0.5 * (three[0][1] + three[2][1]) - three[1][1];
        println!("{:.3e} {:.3e}", trailing / most, leading / most);
        assert!(trailing < most && leading < most, "{trailing} {leading} {most}");
    }
}
