//! The load-displacement equations both ways, and problems without rolling.

use std::ffi::{CStr, CString, c_char};
use std::ptr::null_mut;

use creepage_ffi::*;

use crate::caller::Message;

const AXES: [f64; 2] = [1.0, 1.0];

fn caused(edge: i32, traction: &[f64], room: usize) -> (i32, Vec<f64>, String) {
    let (mut found, mut message) = (vec![0.0; 3 * room], Message::new());
    // SAFETY: all point to what they should.
    let code = unsafe {
        creepage_half_space_displacement(
            AXES.as_ptr(),
            0.28,
            edge,
            traction.len() / 3,
            traction.as_ptr(),
            room,
            found.as_mut_ptr(),
            message.0.as_mut_ptr(),
            message.0.len(),
        )
    };
    (code, found, message.text())
}

fn causing(edge: i32, displacement: &[f64]) -> (i32, Vec<f64>) {
    let (mut found, mut message) = (vec![0.0; displacement.len()], Message::new());
    // SAFETY: as before.
    let code = unsafe {
        creepage_half_space_traction(
            AXES.as_ptr(),
            0.28,
            edge,
            displacement.len() / 3,
            displacement.as_ptr(),
            found.as_mut_ptr(),
            message.0.as_mut_ptr(),
            message.0.len(),
        )
    };
    (code, found)
}

#[test]
fn hertz_s_pressure_makes_a_paraboloid_and_back() {
    let (code, found, message) = caused(CREEPAGE_VANISHING, &[0.0, 0.0, 0.1], 6);
    assert_eq!((code, message.as_str()), (CREEPAGE_OK, ""));
    let approach = 0.72 * 0.1 * std::f64::consts::FRAC_PI_2;
    let w = [approach, 0.0, 0.0, -approach / 2.0, 0.0, -approach / 2.0];
    assert!(found[12..].iter().zip(w).all(|(found, w)| (found - w).abs() < 1e-15), "{found:?}");
    let (code, back) = causing(CREEPAGE_VANISHING, &found);
    assert_eq!(code, CREEPAGE_OK);
    // Rounding of blocks of a condition of some ten.
    let miss = back.iter().enumerate().map(|(k, z)| (z - if k == 12 { 0.1 } else { 0.0 }).abs());
    assert!(miss.fold(0.0, f64::max) < 1e-13, "{back:?}");
}

#[test]
fn what_cannot_be_has_its_code() {
    assert_eq!(caused(CREEPAGE_VANISHING, &[0.0, 0.0, 0.1], 3).0, CREEPAGE_ROOM);
    assert_eq!(caused(7, &[0.0, 0.0, 0.1], 6).0, CREEPAGE_INVALID);
    assert_eq!(caused(CREEPAGE_SINGULAR, &[0.0; 6], 6).0, CREEPAGE_INVALID);
    assert_eq!(caused(CREEPAGE_SINGULAR, &[f64::NAN, 0.0, 0.0], 6).0, CREEPAGE_INVALID);
    assert_eq!(causing(CREEPAGE_VANISHING, &[1.0, 0.0, 0.0]).0, CREEPAGE_NOT_REACHABLE);
    assert_eq!(causing(CREEPAGE_SINGULAR, &[1.0, 0.0, 0.0]).0, CREEPAGE_OK);
}

fn statics(text: &str, room: usize) -> (i32, usize, String, String) {
    let text = CString::new(text).unwrap();
    let (mut report, mut needed, mut message) = (vec![1 as c_char; room], 0, Message::new());
    let place = if room == 0 { null_mut() } else { report.as_mut_ptr() };
    // SAFETY: as before.
    let code = unsafe {
        creepage_statics(
            text.as_ptr(),
            place,
            room,
            &raw mut needed,
            message.0.as_mut_ptr(),
            message.0.len(),
        )
    };
    let is_written = code == CREEPAGE_OK && room > 0;
    // SAFETY: there is a zero where it is written.
    let words = is_written.then(|| unsafe { CStr::from_ptr(report.as_ptr()) });
    (code, needed, words.map_or_else(String::new, |w| w.to_str().unwrap().into()), message.text())
}

#[test]
fn problems_without_rolling_are_those_of_the_command() {
    let path =
        concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/statics/anchor-plate-shift.toml");
    let (code, needed, _, message) = statics(path, 0);
    assert_eq!((code, message.as_str()), (CREEPAGE_OK, ""));
    assert_eq!(statics(path, needed - 1).0, CREEPAGE_ROOM);
    let (code, _, report, _) = statics(path, needed);
    assert_eq!(code, CREEPAGE_OK);
    let text = std::fs::read_to_string(path).unwrap();
    let case = creepage_study::StaticsFile::read(&text).unwrap().solve().unwrap();
    let own = creepage_study::StaticsReport::new(&case).unwrap().json().to_string();
    assert_eq!(report, own);
    assert_eq!(statics(&text, needed).2, own);
    assert_eq!(statics("no = case\n", 0).0, CREEPAGE_INVALID);
    assert_eq!(statics("no-such-file.toml", 0).0, CREEPAGE_FILE);
}

#[test]
fn inside_the_bodies_of_a_case() {
    let text = CString::new(
        "upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
        lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
        contact = { normal_force = 80e3, friction = 0.3 }
        creepage = { longitudinal = 0.1 }
        solve = { theory = 'saturated' }\n",
    )
    .unwrap();
    let (mut made, mut message) = (null_mut(), Message::new());
    let (points, mut stresses, mut moved, mut settled) = ([0.0; 6], [0.0; 12], [0.0; 6], f64::NAN);
    // SAFETY: all point to what they should.
    let codes = unsafe {
        let new = creepage_case_new(
            text.as_ptr(),
            std::ptr::null(),
            &raw mut made,
            message.0.as_mut_ptr(),
            message.0.len(),
        );
        let mut below = |body: i32, points: &[f64; 6]| {
            creepage_case_below(
                made,
                body,
                2,
                points.as_ptr(),
                stresses.as_mut_ptr(),
                moved.as_mut_ptr(),
                &raw mut settled,
                message.0.as_mut_ptr(),
                message.0.len(),
            )
        };
        let above = below(CREEPAGE_UPPER, &[0.0, 0.0, -1.0, 0.0, 0.0, 0.0]);
        let (none, fine) = (below(2, &points), below(CREEPAGE_LOWER, &points));
        creepage_case_free(made);
        [new, above, none, fine]
    };
    assert_eq!(codes, [CREEPAGE_OK, CREEPAGE_INVALID, CREEPAGE_INVALID, CREEPAGE_OK]);
    let case = creepage_study::CaseFile::read(text.to_str().unwrap()).unwrap();
    let hertz = case.hertz().unwrap();
    // Like bodies: half of Hertz's approach, below his peak pressure; both in closed form.
    assert!((moved[2] / (0.5 * hertz.approach()) - 1.0).abs() < 1e-9, "{moved:?}");
    assert!((stresses[2] / hertz.peak_pressure() + 1.0).abs() < 1e-9 && settled == 0.0);
    assert!(moved[0] > 0.0 && moved[3..] == moved[..3]);
}
