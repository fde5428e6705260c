//! The sample files: read, and run on each other.

#![allow(clippy::unwrap_used, clippy::panic)]

use creepage_rail::file::{Action, Format, ReadOptions, Reading, read};
use creepage_rail::{
    Place, Position, Profile, Side, Smoothing, Standard, Track, Wheelset, WheelsetOnTrack,
};

const SAMPLES: [(&str, &[u8], Format); 9] = [
    ("s1002.prw", include_bytes!("../samples/s1002.prw"), Format::Simpack),
    ("s1002.whe", include_bytes!("../samples/s1002.whe"), Format::Vampire),
    ("s1002.wheel", include_bytes!("../samples/s1002.wheel"), Format::Gensys),
    ("s1002.txt", include_bytes!("../samples/s1002.txt"), Format::Columns),
    ("uic60.prr", include_bytes!("../samples/uic60.prr"), Format::Simpack),
    ("uic60.rai", include_bytes!("../samples/uic60.rai"), Format::Vampire),
    ("uic60.rail", include_bytes!("../samples/uic60.rail"), Format::Gensys),
    ("worn_wheel.whl", include_bytes!("../samples/worn_wheel.whl"), Format::MiniProf),
    ("worn_rail.ban", include_bytes!("../samples/worn_rail.ban"), Format::MiniProf),
];

fn sample(name: &str, smoothing: Option<f64>) -> Reading {
    let (_, content, format) = SAMPLES.iter().find(|(known, ..)| *known == name).unwrap();
    let standard = if name.starts_with("s1002") { Standard::S1002 } else { Standard::Uic60 };
    let role = (!name.starts_with("worn")).then_some(standard.role());
    let smoothing = smoothing.map(Smoothing::Wavelength);
    let wanted = ReadOptions { role, side: Some(Side::Right), smoothing, ..ReadOptions::default() };
    let found = read(name, content, &wanted).unwrap();
    assert_eq!(found.format, *format);
    found
}

fn running(wheel: &Profile, rail: &Profile) -> WheelsetOnTrack {
    let track = Track::new(rail, 0.025f64.atan(), Place::gauge(1.435, 0.014)).unwrap();
    Wheelset::like(wheel, 0.46, 1.36).unwrap().on(track)
}

#[test]
fn samples_of_standards_are_these() {
    for (name, ..) in SAMPLES.iter().filter(|(name, ..)| !name.starts_with("worn")) {
        let found = sample(name, None).profile;
        let standard = if name.starts_with("s1002") { Standard::S1002 } else { Standard::Uic60 };
        let exact = standard.profile();
        let off = |y: f64| (found.at_y(y).unwrap().z - exact.at_y(y).unwrap().z).abs();
        let worst = (-320..=320).map(|i| off(f64::from(i) * 1e-4)).fold(0.0, f64::max);
        // A fortieth of the jump of curvature (1/13 - 1/80 per mm) times .5 mm squared.
        assert!(worst < 0.42e-6, "{name} {worst}");
    }
}

/// Contact of the sampled standards is that of the formulas: half a micrometre in height.
#[test]
fn sampled_and_exact_profiles_roll_alike() {
    let exact = running(&Standard::S1002.profile(), &Standard::Uic60.profile());
    let sampled = running(&sample("s1002.prw", None).profile, &sample("uic60.prr", None).profile);
    for i in 0..=14 {
        let y = f64::from(i) * 5e-4;
        let [a, b] =
            [&exact, &sampled].map(|running| running.touch(Side::Right, y, 0.0, 0.0).unwrap());
        assert!((a.z - b.z).abs() < 0.5e-6, "{y} {a:?} {b:?}");
    }
}

#[test]
fn worn_profiles_meet() {
    let rail = sample("worn_rail.ban", Some(3e-3));
    let has = |wanted: fn(&Action) -> bool| rail.actions.iter().any(wanted);
    assert!(has(|a| matches!(a, Action::Repeated { .. })));
    assert!(has(|a| matches!(a, Action::ZigZag { .. })));
    let wheel = sample("worn_wheel.whl", Some(3e-3)).profile;
    let running = running(&wheel, &rail.profile);
    let mut steepest = 0.0f64;
    for i in -40..=40 {
        let rest = running.resting(f64::from(i) * 2e-4, 0.003, None).unwrap();
        let contacts = running.contacts(&Position { z: rest.z + 60e-6, ..rest }).unwrap();
        let sides = [Side::Left, Side::Right];
        assert!(sides.iter().all(|side| contacts.iter().any(|contact| contact.side == *side)));
        for contact in &contacts {
            steepest = steepest.max(contact.angle.abs());
            let lowest = contact.section(200, 0.0).iter().map(|a| a.gap).fold(1.0, f64::min);
            assert!((0.0..1e-6).contains(&(lowest + 1e-12)), "{lowest}");
        }
    }
    assert!(steepest > 0.5, "{steepest}");
    // Hollow wheels steer more than new ones on the same rail.
    let new = self::running(&Standard::S1002.profile(), &rail.profile);
    let conicity = |running: &WheelsetOnTrack| {
        running.radius_differences(0.006, Some(0.0)).unwrap().conicity(0.003).unwrap()
    };
    let (worn, new) = (conicity(&running), conicity(&new));
    assert!(worn > 1.5 * new, "{worn} {new}");
}
