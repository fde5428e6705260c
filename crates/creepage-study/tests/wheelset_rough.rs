//! A measured profile that is rough where it touches is said to be so; no other is.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};

use creepage_rail::file::{Format, Wanted, read, write};
use creepage_rail::{Role, Side, Standard};
use creepage_study::{GapCaution, SolvedWheel, SolvedWheelset, WheelsetFile};

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/wheelset")
}

fn example(name: &str) -> String {
    fs::read_to_string(examples().join(name)).unwrap()
}

fn solved(text: &str, directory: &Path) -> SolvedWheelset {
    let text = format!("{text}\n[solve]\ntheory = \"fastsim\"\n");
    WheelsetFile::read(&text).unwrap().case(directory).unwrap().solve().unwrap()
}

/// White noise of unit variance (Box and Muller, of a congruential generator).
fn noise(seed: u64) -> impl Iterator<Item = f64> {
    let mut state = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    std::iter::repeat_with(move || {
        let [a, b] = [(); 2].map(|()| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            ((state >> 33) as f64 + 0.5) / f64::from(1u32 << 31)
        });
        (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    })
}

/// S1002 by points 0.25 mm apart, with white noise of the given height (m), smoothed by wavelength.
fn measured(height: f64, seed: u64, smoothing: Option<f64>) -> String {
    let curve = Standard::S1002.profile();
    let stations = curve.curve().stations(2.5e-4);
    let rows = stations.iter().zip(noise(seed)).map(|(s, noise)| {
        let point = curve.curve().at(*s);
        let [y, z] = [0, 1].map(|axis: usize| {
            1e3 * ([point.y, point.z][axis] + height * noise * point.normal()[axis])
        });
        format!("{y:.6} {z:.6}\n")
    });
    let wanted = Wanted {
        role: Some(Role::Wheel),
        unit: Some(1e-3),
        down: Some(true),
        field_side: Some(true),
        smoothing,
        ..Wanted::default()
    };
    let text = rows.collect::<String>();
    let profile = read("measured.txt", text.as_bytes(), &wanted).unwrap().profile;
    write(&profile, Format::Simpack, 5e-5)
}

/// The right wheel alone: quick.
fn on_measured(profile: &str) -> SolvedWheelset {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("measured.prw"), profile).unwrap();
    let text = example("s1002-on-uic60.toml")
        .replace("\"S1002\"", "\"measured.prw\"")
        .replace("roll = \"free\"", "roll = 0.0\nside = \"right\"")
        .replace("axle_load = 200e3", "wheel_load = 100e3")
        .replace("pitch_rate = \"free\"", "pitch_rate = 65.2");
    solved(&text, directory.path())
}

fn rough(solved: &SolvedWheelset) -> Vec<(Side, GapCaution)> {
    let all = solved.cautions().into_iter();
    all.filter(|(_, caution)| matches!(caution, GapCaution::Rough { .. })).collect()
}

fn peak(solved: &SolvedWheelset) -> f64 {
    let contacts = solved.wheels().flat_map(SolvedWheel::contacts);
    contacts.map(|contact| contact.normal.peak_pressure().value).fold(0.0, f64::max)
}

#[test]
fn noise_of_five_micrometres_is_rough_until_it_is_smoothed() {
    let noisy = on_measured(&measured(5e-6, 1, None));
    let found = rough(&noisy);
    let [(Side::Right, GapCaution::Rough { body: Role::Wheel, length, swing, pressure })] =
        found[..]
    else {
        panic!("{found:?}")
    };
    // Noise turns between two and three points on the mean, 0.25 mm apart; where the smaller turns
    // do not count, later.
    assert!(length > 4e-4 && length < 1.2e-3, "{found:?}");
    // Its slopes scatter by sqrt(2) 5 um / 0.25 mm = 28 mrad, from one to the next by sqrt(3) of that.
    assert!(swing > 0.049 && swing < 0.12, "{found:?}");
    // A quarter of E* = 114 GPa for each radian.
    assert!((pressure / (0.25 * 82e9 / 0.72 * swing) - 1.0).abs() < 1e-12, "{found:?}");
    let words = noisy.json().caution.unwrap();
    assert!(words.contains("right wheel: the wheel's profile is rough"), "{words}");
    let smooth = on_measured(&measured(5e-6, 1, Some(6e-3)));
    assert_eq!(rough(&smooth), []);
    assert!(peak(&smooth) < 0.5 * peak(&noisy));
}

#[test]
fn standard_and_worn_profiles_are_not_rough() {
    for name in ["s1002-on-uic60.toml", "curve-with-flange-contact.toml", "worn-wheels.toml"] {
        assert_eq!(rough(&solved(&example(name), &examples())), [], "{name}");
    }
}
