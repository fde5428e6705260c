//! A wheelset by its handle: the library's own forces, and codes for what is wrong.

use std::ffi::{CString, c_char};
use std::ptr::null_mut;

use creepage_ffi::*;
use creepage_study::WheelsetFile;

const TEXT: &str = "
wheel = { profile = 'S1002', radius = 0.46 }
rail = { profile = 'UIC60', cant = 0.02499479 }
track = { gauge = 1.435, gauge_height = 0.014 }
wheelset = { back_to_back = 1.360, y = 0.0, yaw = 0.0, roll = 'free', axle_load = 200e3 }
motion = { speed = 30.0, pitch_rate = 'free' }
contact = { friction = 0.3 }
materials = { shear_modulus = 82e9, poisson = 0.28 }
solve = { theory = 'exact', resolution = 'fast' }
";
const FREE: [f64; 4] = [30.0, f64::NAN, 0.0, 0.0];

fn made(text: &str) -> (i32, *mut CreepageWheelset) {
    let (text, mut made) = (CString::new(text).unwrap(), null_mut());
    // SAFETY: all point to what they should.
    let code = unsafe { creepage_wheelset_new(text.as_ptr(), &raw mut made, null_mut(), 0) };
    (code, made)
}

fn forces(made: *const CreepageWheelset, position: [f64; 2], motion: [f64; 4]) -> (i32, [f64; 12]) {
    let (mut forces, mut found, mut status) = ([0.0; 12], [0.0; 3], -1);
    let mut message = [0 as c_char; 200];
    // SAFETY: all point to what they should.
    let code = unsafe {
        creepage_wheelset_force(
            made,
            position.as_ptr(),
            motion.as_ptr(),
            forces.as_mut_ptr(),
            found.as_mut_ptr(),
            &raw mut status,
            message.as_mut_ptr(),
            message.len(),
        )
    };
    if code == CREEPAGE_OK {
        assert!(found.iter().all(|value| value.is_finite()));
        assert_eq!(status, CREEPAGE_SOLVED);
    }
    (code, forces)
}

#[test]
fn forces_are_the_library_s() {
    let (code, made) = made(TEXT);
    assert_eq!(code, CREEPAGE_OK);
    let (code, first) = forces(made, [1e-3, 0.0], FREE);
    assert_eq!(code, CREEPAGE_OK);
    let text = TEXT.replace("y = 0.0,", "y = 1e-3,");
    let case = WheelsetFile::read(&text).unwrap().case(std::path::Path::new("")).unwrap();
    let solved = case.solve().unwrap();
    for (wheel, found) in solved.wheels().zip(first.chunks_exact(6)) {
        let right = wheel.on_rail();
        assert_eq!(found[..3], right.force);
        assert_eq!(found[3..], right.moment);
    }
    // From far away: to the balance's end, in parts of mu N.
    let (_, away) = forces(made, [2e-3, 1e-3], FREE);
    let (_, back) = forces(made, [1e-3, 0.0], FREE);
    assert!(away[1].to_bits() != back[1].to_bits());
    for k in [0, 1, 2, 6, 7, 8] {
        assert!((back[k] - first[k]).abs() < 1e-3 * 0.3 * 100e3, "{k} {back:?} {first:?}");
    }
    let near = TEXT.replace("y = 0.0,", "y = 1.01e-3,");
    let case = WheelsetFile::read(&near).unwrap().case(std::path::Path::new("")).unwrap();
    let (solved, (_, followed)) = (case.solve().unwrap(), forces(made, [1.01e-3, 0.0], FREE));
    for (wheel, found) in solved.wheels().zip(followed.chunks_exact(6)) {
        for (found, right) in found.iter().zip(wheel.on_rail().force) {
            assert!((found - right).abs() < 1e-3 * 0.3 * 100e3, "{found} {right}");
        }
    }
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(made) };
}

#[test]
fn derivatives_are_the_library_s() {
    let (_, wheelset) = made(TEXT);
    let (mut found, mut errors) = ([0.0; 96], [0.0; 96]);
    let (position, mut forces, mut status) = ([1e-3, 0.0], [0.0; 12], -1);
    // SAFETY: all point to what they should, or to nothing.
    let code = unsafe {
        creepage_wheelset_derivatives(
            wheelset,
            position.as_ptr(),
            FREE.as_ptr(),
            forces.as_mut_ptr(),
            found.as_mut_ptr(),
            errors.as_mut_ptr(),
            &raw mut status,
            null_mut(),
            0,
        )
    };
    assert_eq!((code, status), (CREEPAGE_OK, CREEPAGE_SOLVED));
    let text = TEXT.replace("y = 0.0,", "y = 1e-3,");
    let case = WheelsetFile::read(&text).unwrap().case(std::path::Path::new("")).unwrap();
    let solved = case.solve().unwrap();
    let right = case.derivatives(&solved).unwrap();
    let same = |found: &[f64], right: [[[f64; 8]; 6]; 2]| {
        let right = right.as_flattened().as_flattened();
        found.iter().zip(right).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan())
    };
    assert!(same(&found, right.values()) && same(&errors, right.errors()), "{found:?}");
    assert_eq!(forces[..3], solved.left.unwrap().on_rail().force);
    // Free of height, roll and torque: no derivative by those, and one by the rest.
    let is_free = |k: usize| [1, 2, 5].contains(&k);
    assert!(found.iter().enumerate().all(|(i, value)| value.is_nan() == is_free(i % 8)));
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(wheelset) };
}

#[test]
fn what_is_wrong_has_a_code() {
    assert_eq!(made(&TEXT.replace("S1002", "S1003")).0, CREEPAGE_INVALID);
    assert_eq!(made("no/such/file.toml").0, CREEPAGE_FILE);
    let (_, wheelset) = made(TEXT);
    // Off the track, a wheel of NaN, and backwards through its own contact.
    assert_eq!(forces(wheelset, [0.5, 0.0], FREE).0, CREEPAGE_INVALID);
    assert_eq!(forces(wheelset, [f64::NAN, 0.0], FREE).0, CREEPAGE_INVALID);
    assert_eq!(forces(wheelset, [0.0, 0.0], [f64::NAN, f64::NAN, 0.0, 0.0]).0, CREEPAGE_INVALID);
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(wheelset) };
}
