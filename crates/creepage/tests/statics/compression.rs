//! Compression of unlike bodies with friction.

use creepage::statics::Compression;
use creepage::{Hertz, Radii, Region, Solid, SolidPair, Status};

/// Spence's sphere with `nu = 0` against a rigid plane, `mu = 0.2986`: adhesion over half the radius.
#[test]
fn spence() {
    let pair = SolidPair::new(Solid::new(0.5e6, 0.0).unwrap(), Solid::new(1e14, 0.0).unwrap());
    let mut sphere = Compression::new(pair, 0.1215, 0.2986, 3.5e-3, 60).unwrap();
    let full = 3.5e-3_f64.powi(2) / 0.1215;
    let (mut sum, mut count) = (0.0, 0.0);
    for step in 1..=60 {
        sphere.press(full * (f64::from(step) / 60.0).powi(2)).unwrap();
        assert_eq!(sphere.status(), Status::Solved, "{step}");
        if step > 40 {
            sum += sphere.stick_radius() / sphere.contact_radius();
            count += 1.0;
        }
    }
    // A ring is a sixtieth of the radius, and a step one of the load's; both change by turns.
    assert!((sum / count - 0.5).abs() < 0.015, "{}", sum / count);
}

fn spences_pair() -> SolidPair {
    SolidPair::new(Solid::new(0.5e6, 0.0).unwrap(), Solid::new(1e11, 0.0).unwrap())
}

/// The same under loads, against the stored output of the program CONTACT (its example in 35 stages, v25.2):
/// approaches, peak pressures at 0.4705 and 0.07527 N. Its squares are a seventeenth and a tenth of the radius.
#[test]
fn under_a_load_it_is_spences_too() {
    for (load, approach, peak, uncertainty) in
        [(0.4705, 98.74e-6, 23_920.0, 0.01), (0.075_27, 29.08e-6, 12_890.0, 0.015)]
    {
        let ball = Compression::under_load(spences_pair(), 0.121_477, 0.2986, load, 60).unwrap();
        assert_eq!(ball.status(), Status::Solved);
        assert!((ball.load() / load - 1.0).abs() < 1e-12, "{}", ball.load());
        assert!((ball.approach() / approach - 1.0).abs() < uncertainty, "{}", ball.approach());
        let [centre, _] = ball.at(0.0);
        assert!((centre / peak - 1.0).abs() < uncertainty, "{centre}");
        let ratio = ball.stick_radius() / ball.contact_radius();
        // A ring of sixty.
        assert!((ratio - 0.5).abs() < 0.017, "{ratio}");
    }
}

/// A load grows in proportion: what was scaled is what goes on being pressed.
#[test]
fn a_scaled_contact_goes_on_as_one_pressed_there() {
    let pair = spences_pair();
    let mut scaled = Compression::under_load(pair, 0.1, 0.3, 1e-3, 20).unwrap();
    let approach = scaled.approach();
    // Twenty rings of a contact of this radius, and three to spare.
    let ring = (0.1 * approach).sqrt() / 20.0;
    let mut pressed = Compression::new(pair, 0.1, 0.3, 23.0 * ring, 23).unwrap();
    (1..=20).for_each(|k| pressed.press(approach * f64::from(k * k) / 400.0).unwrap());
    for further in [1.0, 1.05] {
        scaled.press(further * approach).unwrap();
        pressed.press(further * approach).unwrap();
        // Rounding, through some hundred solutions of 20 rings.
        assert!((scaled.load() / pressed.load() - 1.0).abs() < 1e-7);
        for ((_, here, region), (_, there, other)) in scaled.rings().zip(pressed.rings()) {
            assert_eq!(region, other);
            let largest = scaled.at(0.0)[0];
            assert!((here[0] - there[0]).abs() < 1e-7 * largest, "{here:?} {there:?}");
            assert!((here[1] - there[1]).abs() < 1e-7 * largest, "{here:?} {there:?}");
        }
    }
}

#[test]
fn loads_and_rings_out_of_range_are_refused() {
    let refused = |load, rings| {
        Compression::under_load(spences_pair(), 0.1, 0.3, load, rings).unwrap_err().quantity
    };
    assert_eq!(refused(0.0, 20), "normal_force");
    assert_eq!(refused(f64::NAN, 20), "normal_force");
    assert_eq!(refused(1.0, 3), "rings");
    assert_eq!(refused(1.0, 301), "rings");
}

#[test]
fn without_unlikeness_it_is_hertz() {
    let solid = Solid::new(1e6, 0.3).unwrap();
    let pair = SolidPair::new(solid, solid);
    let mut sphere = Compression::new(pair, 0.1, 0.5, 5e-3, 80).unwrap();
    sphere.press(2e-4).unwrap();
    let radius = |rolling| Radii { rolling, lateral: rolling };
    let hertz = Hertz::new(pair, radius(0.1), radius(f64::INFINITY), 0.0, sphere.load()).unwrap();
    // Rings of a ninetieth of the radius.
    assert!((hertz.approach() / 2e-4 - 1.0).abs() < 2e-3, "{}", hertz.approach());
    assert!(sphere.rings().all(|(_, [_, q], _)| q.abs() < 1e-9));
}

/// Proposition I: between symmetric bodies the field depends on the history of the loads only where
/// friction acts; pressing alone does none, so two ways to one approach end alike. Unlike bodies
/// remember: pressed further and let back, they differ.
#[test]
fn proposition_i() {
    let two_ways = |lower: Solid| {
        let upper = Solid::new(1e6, 0.3).unwrap();
        let new = || Compression::new(SolidPair::new(upper, lower), 0.1, 0.2, 6e-3, 40).unwrap();
        let (mut direct, mut around) = (new(), new());
        (1..=20).for_each(|k| direct.press(1e-5 * f64::from(k)).unwrap());
        (1..=30).chain((20..30).rev()).for_each(|k| around.press(1e-5 * f64::from(k)).unwrap());
        let largest = direct.rings().map(|(_, [p, _], _)| p).fold(0.0, f64::max);
        let pairs = direct.rings().zip(around.rings());
        let apart = pairs.map(|((_, [p, q], _), (_, [r, s], _))| (p - r).abs().max((q - s).abs()));
        apart.fold(0.0, f64::max) / largest
    };
    assert!(two_ways(Solid::new(1e6, 0.3).unwrap()) < 1e-9);
    let unlike = two_ways(Solid::new(1e9, 0.3).unwrap());
    assert!(unlike > 0.01, "{unlike}");
}

#[test]
fn let_go_nothing_is_left() {
    let pair = SolidPair::new(Solid::new(1e6, 0.1).unwrap(), Solid::new(1e9, 0.3).unwrap());
    let mut sphere = Compression::new(pair, 0.1, 0.2, 6e-3, 40).unwrap();
    (1..=20).chain((0..20).rev()).for_each(|k| sphere.press(1e-5 * f64::from(k)).unwrap());
    sphere.press(-1e-6).unwrap();
    assert!(sphere.load() == 0.0 && sphere.rings().all(|(_, _, region)| region == Region::Outside));
}
