//! A wheelset by its handle: the library's own forces, and codes for what is wrong.

use std::ffi::{CString, c_char};
use std::ptr::{null, null_mut};

use creepage_ffi::*;
use creepage_study::{WheelStepsRun, WheelTable, WheelsetCase, WheelsetFile};

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
const NAN: f64 = f64::NAN;

fn made(text: &str) -> (i32, *mut CreepageWheelset) {
    let (text, mut made) = (CString::new(text).unwrap(), null_mut());
    // SAFETY: all point to what they should.
    let code = unsafe { creepage_wheelset_new(text.as_ptr(), &raw mut made, null_mut(), 0) };
    (code, made)
}

/// Lateral position and yaw; all else is the file's.
fn at(y: f64, yaw: f64) -> [f64; 12] {
    [y, NAN, NAN, yaw, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN]
}

/// The code, the answers, and the state, which stays the caller's.
fn solved(
    made: *const CreepageWheelset,
    asked: [f64; 12],
    start: *const CreepageWheelsetState,
) -> (i32, [f64; 22], *mut CreepageWheelsetState) {
    let (mut answers, mut status, mut state) = ([0.0; 22], -1, null_mut());
    let mut message = [0 as c_char; 200];
    // SAFETY: all point to what they should, or to nothing.
    let code = unsafe {
        creepage_wheelset_solve(
            made,
            asked.as_ptr(),
            start,
            answers.as_mut_ptr(),
            null_mut(),
            null_mut(),
            &raw mut status,
            &raw mut state,
            message.as_mut_ptr(),
            message.len(),
        )
    };
    if code == CREEPAGE_OK {
        assert!(answers.iter().all(|value| value.is_finite()));
        assert_eq!(status, CREEPAGE_SOLVED);
    }
    (code, answers, state)
}

fn case(from: &str, to: &str) -> WheelsetCase {
    let text = TEXT.replace(from, to);
    WheelsetFile::read(&text).unwrap().case(std::path::Path::new("")).unwrap()
}

#[test]
fn forces_are_the_library_s() {
    let (code, made) = made(TEXT);
    assert_eq!(code, CREEPAGE_OK);
    let (code, first, state) = solved(made, at(1e-3, 0.0), null());
    assert_eq!(code, CREEPAGE_OK);
    assert_eq!(first, case("y = 0.0,", "y = 1e-3,").solve().unwrap().answers());
    // Whatever was asked before, the same bits.
    let (_, _, away) = solved(made, at(2e-3, 1e-3), null());
    let (_, again, third) = solved(made, at(1e-3, 0.0), null());
    assert_eq!(first, again);
    // From the state, again and again, the same bits; and what is found from nothing, in parts of mu N.
    let (_, followed, one) = solved(made, at(1.01e-3, 0.0), state);
    let (_, repeated, other) = solved(made, at(1.01e-3, 0.0), state);
    assert_eq!(followed, repeated);
    let (_, alone, last) = solved(made, at(1.01e-3, 0.0), null());
    for (found, right) in followed.iter().zip(alone).take(3) {
        assert!((found - right).abs() < 1e-3 * 0.3 * 100e3, "{found} {right}");
    }
    for state in [state, away, third, one, other, last] {
        // SAFETY: it is not used again.
        unsafe { creepage_wheelset_state_free(state) };
    }
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(made) };
}

#[test]
fn many_have_the_bits_of_one() {
    let (_, made) = made(TEXT);
    let asked = [at(1e-3, 0.0), at(0.5, 0.0), at(2e-3, 1e-3)];
    let (mut answers, mut statuses) = ([[0.0; 22]; 3], [-1; 3]);
    // SAFETY: all point to what they should, or to nothing.
    let code = unsafe {
        creepage_wheelset_solve_many(
            made,
            3,
            asked.as_flattened().as_ptr(),
            answers.as_flattened_mut().as_mut_ptr(),
            statuses.as_mut_ptr(),
            null_mut(),
            0,
        )
    };
    assert_eq!(code, CREEPAGE_OK);
    assert_eq!(statuses, [CREEPAGE_SOLVED, CREEPAGE_NOT_CONVERGED, CREEPAGE_SOLVED]);
    assert!(answers[1].iter().all(|value| value.is_nan()));
    for k in [0, 2] {
        let (_, one, state) = solved(made, asked[k], null());
        assert_eq!(answers[k], one);
        // SAFETY: it is not used again.
        unsafe { creepage_wheelset_state_free(state) };
    }
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(made) };
}

#[test]
fn derivatives_are_the_library_s() {
    let (_, wheelset) = made(TEXT);
    let (mut found, mut errors) = ([0.0; 96], [0.0; 96]);
    let (asked, mut answers, mut status) = (at(1e-3, 0.0), [0.0; 22], -1);
    // SAFETY: all point to what they should, or to nothing.
    let code = unsafe {
        creepage_wheelset_solve(
            wheelset,
            asked.as_ptr(),
            null(),
            answers.as_mut_ptr(),
            found.as_mut_ptr(),
            errors.as_mut_ptr(),
            &raw mut status,
            null_mut(),
            null_mut(),
            0,
        )
    };
    assert_eq!((code, status), (CREEPAGE_OK, CREEPAGE_SOLVED));
    let case = case("y = 0.0,", "y = 1e-3,");
    let right = case.derivatives(&case.solve().unwrap()).unwrap();
    let same = |found: &[f64], right: [[[f64; 8]; 6]; 2]| {
        let right = right.as_flattened().as_flattened();
        found.iter().zip(right).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan())
    };
    assert!(same(&found, right.values()) && same(&errors, right.errors()), "{found:?}");
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
    let mut rest = at(0.0, 0.0);
    rest[6] = 0.0;
    // Off the track, infinitely far, at rest, pressed twice.
    let mut twice = at(0.0, 0.0);
    (twice[1], twice[4]) = (0.0, 1e5);
    for asked in [at(0.5, 0.0), at(f64::INFINITY, 0.0), rest, twice] {
        assert_eq!(solved(wheelset, asked, null()).0, CREEPAGE_INVALID);
    }
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(wheelset) };
}

/// Rolls in steps by columns: the code, the numbers of all rows, their statuses.
fn rolled(
    made: *const CreepageWheelset,
    start: i32,
    names: &[&str],
    values: &[f64],
) -> (i32, Vec<[f64; 19]>, Vec<i32>) {
    let names: Vec<CString> = names.iter().map(|name| CString::new(*name).unwrap()).collect();
    let pointers: Vec<*const c_char> = names.iter().map(|name| name.as_ptr()).collect();
    let rows = values.len() / names.len();
    let (mut found, mut statuses) = (vec![[NAN; 19]; rows], vec![-1; rows]);
    // SAFETY: all point to what they should, or to nothing.
    let code = unsafe {
        creepage_wheelset_roll(
            made,
            start,
            names.len(),
            pointers.as_ptr(),
            rows,
            values.as_ptr(),
            found.as_flattened_mut().as_mut_ptr(),
            statuses.as_mut_ptr(),
            null_mut(),
            0,
        )
    };
    (code, found, statuses)
}

/// What the library itself rolls; begun from steady rolling it is so in the first row, and a row that cannot be solved
/// leaves those before it.
#[test]
fn wheels_roll_in_steps_as_by_the_library() {
    let text = TEXT.replace("pitch_rate = 'free'", "pitch_rate = 65.25");
    let (_, wheelset) = made(&text);
    let names = ["distance", "y", "yaw"];
    let values = [1e-3, 1e-3, NAN, 2e-3, 1e-3, NAN, 4e-3, 1.2e-3, 1e-4];
    let (code, found, statuses) = rolled(wheelset, -1, &names, &values);
    assert_eq!(code, CREEPAGE_OK);
    assert!(statuses.iter().all(|status| [CREEPAGE_SOLVED, CREEPAGE_DOUBTFUL].contains(status)));
    let case = case("pitch_rate = 'free'", "pitch_rate = 65.25");
    let columns = [0, 1, 2].map(|k| [0, 1, 2].map(|row| values[3 * row + k]));
    let given = [0, 1, 2].map(|k| (names[k], &columns[k][..]));
    let table = WheelTable::from_columns(&given).unwrap();
    let mut run = WheelStepsRun::new(&case, &table).unwrap();
    for row in &found {
        let (distance, stepped) = run.next_row().unwrap().unwrap();
        assert_eq!(*row, WheelStepsRun::numbers(distance, &stepped));
    }
    // Tractions build up; from steady rolling they are there.
    let [first, last] = [found[0][1].abs(), found[2][1].abs()];
    assert!(first < 0.7 * last, "{found:?}");
    let (code, steady, _) = rolled(wheelset, 1, &names[..2], &[1e-3, 1e-3]);
    assert_eq!(code, CREEPAGE_OK);
    assert!(steady[0][1].abs() > last, "{steady:?}");
    let (code, found, _) = rolled(wheelset, 0, &names[..2], &[1e-3, 1e-3, 2e-3, 0.5]);
    assert_eq!(code, CREEPAGE_INVALID);
    assert!(found[0][1].is_finite() && found[1][1].is_nan());
    let wrong: [(i32, &[&str], i32); 4] = [
        (0, &["distance", "hight"], CREEPAGE_TEXT),
        (0, &["y", "yaw"], CREEPAGE_TEXT),
        (0, &["distance", "distance"], CREEPAGE_TEXT),
        (2, &["distance", "y"], CREEPAGE_INVALID),
    ];
    for (start, names, expected) in wrong {
        assert_eq!(rolled(wheelset, start, names, &[1e-3, 0.0]).0, expected, "{names:?}");
    }
    assert_eq!(rolled(wheelset, 0, &names[..2], &[-1.0, 0.0]).0, CREEPAGE_INVALID);
    // SAFETY: it is not used again.
    unsafe { creepage_wheelset_free(wheelset) };
}
