//! A case file says what a profile's file does not show, and how it is smoothed.

#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;
use std::fs;

use creepage_rail::file::{Format, ReadOptions, read, write};
use creepage_rail::{Role, Side};
use creepage_study::{CaseError, SolvedWheel, WheelsetFile, WheelsetFileError};

/// A cone of 1:20 from flange back's side to the field side, heights upwards or downwards.
fn cone(upwards: f64) -> String {
    (0..=130).fold(String::new(), |mut text, step| {
        let y = f64::from(step) - 60.0;
        writeln!(text, "{y} {}", -upwards * y / 20.0).unwrap();
        text
    })
}

/// One wheel of `profile` at rest on UIC60; further lines of `[wheel]`.
fn wheel(profile: &str, lines: &str) -> String {
    format!(
        "[wheel]\nprofile = \"{profile}\"\nradius = 0.46\n{lines}\n\
         [rail]\nprofile = \"UIC60\"\ncant = 0.025\n\
         [track]\ngauge = 1.435\ngauge_height = 0.014\n\
         [wheelset]\nside = \"right\"\nback_to_back = 1.36\nroll = 0.0\nwheel_load = 80e3\n\
         [motion]\nspeed = 20.0\npitch_rate = 43.5\n\
         [materials]\nshear_modulus = 82e9\npoisson = 0.28\n\
         [contact]\nfriction = 0.3\n[solve]\ntheory = \"linear\"\n"
    )
}

/// Peak pressure (Pa) and the contact's place on the wheel (m), with this file as `wheel.txt`.
fn contact(file: &str, case: &str) -> Result<[f64; 2], WheelsetFileError> {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("wheel.txt"), file).unwrap();
    let solved = WheelsetFile::read(case)?.case(directory.path())?.solve().unwrap();
    let mut contacts = solved.wheels().flat_map(SolvedWheel::contacts);
    let first = contacts.next().unwrap();
    Ok([first.normal.peak_pressure().value, first.y_wheel])
}

#[test]
fn what_the_file_does_not_show_can_be_said() {
    let refused = contact(&cone(1.0), &wheel("wheel.txt", "")).unwrap_err().to_string();
    assert!(refused.contains("[wheel]") && refused.contains("z = \"down\""), "{refused}");
    let [down, up] = [(-1.0, "down"), (1.0, "up")].map(|(sense, word)| {
        let said = format!("reading = {{ z = \"{word}\", y = \"field-side\" }}");
        contact(&cone(sense), &wheel("wheel.txt", &said)).unwrap()
    });
    assert_eq!(down.map(f64::to_bits), up.map(f64::to_bits));
    let inches = cone(1.0).lines().fold(String::new(), |mut text, line| {
        let mut numbers = line.split(' ').map(|number| number.parse::<f64>().unwrap() / 25.4);
        let [y, z] = [(); 2].map(|()| numbers.next().unwrap());
        writeln!(text, "{y} {z}").unwrap();
        text
    });
    let said = "reading = { z = \"up\", y = \"field-side\", unit = 0.0254 }";
    let inches = contact(&inches, &wheel("wheel.txt", said)).unwrap();
    // The last bits of dividing by 25.4 and multiplying again.
    assert!((inches[0] / up[0] - 1.0).abs() < 1e-6, "{inches:?} {up:?}");
}

#[test]
fn a_file_is_smoothed_as_if_it_had_been_before() {
    let wavy = (0..=1300).fold(String::new(), |mut text, step| {
        let y = f64::from(step) / 10.0 - 60.0;
        let wave = 2e-3 * (std::f64::consts::TAU * y / 2.0).sin();
        writeln!(text, "{y} {}", -y / 20.0 + wave).unwrap();
        text
    });
    let said = "reading = { z = \"up\", y = \"field-side\", smooth = 0.01 }";
    let here = contact(&wavy, &wheel("wheel.txt", said)).unwrap();
    let wanted = ReadOptions {
        role: Some(Role::Wheel),
        side: Some(Side::Right),
        field_side: Some(true),
        down: Some(false),
        smoothing: Some(creepage_rail::Smoothing::Wavelength(0.01)),
        ..ReadOptions::default()
    };
    let smooth = read("wheel.txt", wavy.as_bytes(), &wanted).unwrap().profile;
    let before = write(&smooth, Format::Simpack, 1e-4);
    let before = contact(&before, &wheel("wheel.txt", "")).unwrap();
    // The converted file has points of nanometres.
    assert!((here[0] / before[0] - 1.0).abs() < 1e-3, "{here:?} {before:?}");
    let rough = contact(&wavy, &wheel("wheel.txt", &said.replace(", smooth = 0.01", ""))).unwrap();
    assert!(rough[0] > 1.02 * here[0], "{rough:?} {here:?}");
}

#[test]
fn a_profile_by_name_has_nothing_to_be_read() {
    let case = wheel("cone-1:20", "reading = { smooth = 0.005 }");
    let refused = contact("", &case).unwrap_err();
    assert!(matches!(refused, WheelsetFileError::NoFile { section: "wheel", .. }), "{refused}");
    let unknown = WheelsetFile::read(&wheel("wheel.txt", "reading = { sense = 1 }"));
    assert!(matches!(unknown, Err(CaseError::Toml(_))), "{unknown:?}");
}

/// Angles of corners in degrees, and a reach in millimetres, are refused by their range.
#[test]
fn corners_are_in_radians_and_metres() {
    for wrong in ["turn = 30, rest = 0.1, reach = 2e-3", "turn = 0.5, rest = 6", "reach = 2"] {
        let said = format!("reading = {{ corners = {{ {wrong} }} }}");
        let refused = contact(&cone(1.0), &wheel("wheel.txt", &said)).unwrap_err().to_string();
        assert!(refused.contains("reading.corners") && refused.contains("rad"), "{refused}");
    }
}
