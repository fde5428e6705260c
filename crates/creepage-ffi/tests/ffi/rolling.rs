//! Unsteady rolling by its handle: the library's own numbers, and steps that are taken back.

use std::ffi::{CString, c_char};
use std::ptr::{null, null_mut};

use creepage_ffi::*;
use creepage_study::{RollFile, RollStepper};

const TEXT: &str = "
upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.30 }
contact = { normal_force = 80e3, friction = 0.3 }
solve = { resolution = [8, 8] }
";
const CASE: f64 = f64::NAN;

fn made(text: &str) -> (i32, *mut CreepageRolling) {
    let (text, mut made) = (CString::new(text).unwrap(), null_mut());
    // SAFETY: all point to what they should.
    let code = unsafe { creepage_rolling_new(text.as_ptr(), &raw mut made, null_mut(), 0) };
    (code, made)
}

/// The code, and force, creepage, share of adhesion in a row.
fn step(
    made: *const CreepageRolling,
    distance: f64,
    motion: [f64; 3],
    held: [i32; 3],
    load: f64,
) -> (i32, [u64; 7]) {
    let (mut forces, mut creepages, mut adhesion, mut status) = ([0.0; 3], [0.0; 3], 0.0, -1);
    let mut message = [0 as c_char; 200];
    // SAFETY: all point to what they should.
    let code = unsafe {
        creepage_rolling_step(
            made,
            distance,
            motion.as_ptr(),
            held.as_ptr(),
            load,
            forces.as_mut_ptr(),
            creepages.as_mut_ptr(),
            &raw mut adhesion,
            &raw mut status,
            message.as_mut_ptr(),
            message.len(),
        )
    };
    if code == CREEPAGE_OK {
        assert_eq!(status, CREEPAGE_SOLVED);
    }
    let [fx, fy, mz] = forces;
    let [xi, eta, chi] = creepages;
    (code, [fx, fy, mz, xi, eta, chi, adhesion].map(f64::to_bits))
}

fn save(made: *const CreepageRolling) -> Vec<u8> {
    let mut needed = 0;
    // SAFETY: NULL may be given.
    let code =
        unsafe { creepage_rolling_save(made, null_mut(), 0, &raw mut needed, null_mut(), 0) };
    assert_eq!(code, CREEPAGE_OK);
    let mut state = vec![0; needed];
    // SAFETY: all point to what they should.
    let code = unsafe {
        creepage_rolling_save(made, state.as_mut_ptr(), needed, &raw mut needed, null_mut(), 0)
    };
    assert_eq!((code, needed), (CREEPAGE_OK, state.len()));
    state
}

fn restore(made: *const CreepageRolling, state: &[u8]) -> i32 {
    // SAFETY: all point to what they should.
    unsafe { creepage_rolling_restore(made, state.as_ptr(), state.len(), null_mut(), 0) }
}

fn free(made: *mut CreepageRolling) {
    // SAFETY: it is not used again.
    unsafe { creepage_rolling_free(made) };
}

#[test]
fn steps_are_the_library_s() {
    let (code, made) = made(TEXT);
    assert_eq!(code, CREEPAGE_OK);
    let mut stepper =
        RollStepper::new(RollFile::read(TEXT).unwrap().case(".".as_ref()).unwrap()).unwrap();
    let given = [("distance", 1e-3), ("longitudinal", -1e-3), ("lateral_force", 2e3)];
    let given = [&given[..], &[("spin", 0.1), ("normal_force", 70e3)]].concat();
    for _ in 0..3 {
        let rolled = stepper.step(&given).unwrap();
        let units = stepper.case().scaling;
        let force = units.si_force(rolled.solution.force);
        let creepage = units.si_creepage(rolled.creepage);
        let (code, found) = step(made, 1e-3, [-1e-3, 2e3, 0.1], [0, 1, 0], 70e3);
        assert_eq!(code, CREEPAGE_OK);
        let right = [
            force.longitudinal,
            force.lateral,
            force.moment,
            creepage.longitudinal,
            creepage.lateral,
            creepage.spin,
            rolled.adhesion_share,
        ];
        assert_eq!(found, right.map(f64::to_bits));
    }
    free(made);
}

/// As a multibody code does it whose step is rejected.
#[test]
fn a_step_that_is_taken_back_leaves_no_trace() {
    let (_, made) = made(TEXT);
    for _ in 0..3 {
        let before = save(made);
        step(made, 2e-3, [0.0, 1e-3, 0.3], [0; 3], 60e3);
        assert_ne!(save(made), before);
        assert_eq!(restore(made, &before), CREEPAGE_OK);
        assert_eq!(save(made), before);
        let first = step(made, 5e-4, [-9e3, 0.0, 0.0], [1, 0, 0], CASE);
        let after = save(made);
        assert_eq!(restore(made, &before), CREEPAGE_OK);
        assert_eq!(step(made, 5e-4, [-9e3, 0.0, 0.0], [1, 0, 0], CASE), first);
        assert_eq!(save(made), after);
    }
    // The same from another handle of the same file.
    let (_, other) = self::made(TEXT);
    assert_eq!(restore(other, &save(made)), CREEPAGE_OK);
    let [own, its] = [made, other].map(|one| step(one, 1e-3, [-9e3, 0.0, 0.0], [1, 0, 0], CASE));
    assert_eq!(own, its);
    free(made);
    free(other);
}

#[test]
fn what_is_wrong_has_a_code_and_changes_nothing() {
    assert_eq!(made(&TEXT.replace("0.3 }", "-1.0 }")).0, CREEPAGE_INVALID);
    assert_eq!(made("no/such/file.toml").0, CREEPAGE_FILE);
    assert_eq!(made(&format!("{TEXT}creepage = {{ xi = 1 }}\n")).0, CREEPAGE_INVALID);
    let (_, made) = made(TEXT);
    let before = save(made);
    assert_eq!(step(made, 0.0, [0.0; 3], [0; 3], CASE).0, CREEPAGE_INVALID);
    assert_eq!(step(made, f64::NAN, [0.0; 3], [0; 3], CASE).0, CREEPAGE_INVALID);
    assert_eq!(step(made, 1e-3, [f64::NAN, 0.0, 0.0], [0; 3], CASE).0, CREEPAGE_INVALID);
    assert_eq!(step(made, 1e-3, [0.0; 3], [0; 3], -1.0).0, CREEPAGE_INVALID);
    assert_eq!(step(made, 1e-3, [25e3, 0.0, 0.0], [1, 0, 0], CASE).0, CREEPAGE_NOT_REACHABLE);
    assert_eq!(restore(made, &before[..before.len() - 1]), CREEPAGE_INVALID);
    assert_eq!(restore(made, &[]), CREEPAGE_INVALID);
    assert_eq!(save(made), before);
    let (mut short, mut needed) = ([7_u8; 10], 0);
    // SAFETY: all point to what they should.
    let code = unsafe {
        creepage_rolling_save(made, short.as_mut_ptr(), 10, &raw mut needed, null_mut(), 0)
    };
    assert_eq!((code, needed, short), (CREEPAGE_ROOM, before.len(), [7; 10]));
    // SAFETY: NULL may be given.
    let code = unsafe { creepage_rolling_restore(made, null(), 0, null_mut(), 0) };
    assert_eq!(code, CREEPAGE_NULL);
    free(made);
}

/// A line contact rolls at a force, without spin.
#[test]
fn cylinders_roll() {
    let text = TEXT
        .replace("normal_force = 80e3", "line_load = 1e6")
        .replace("solve = { resolution = [8, 8] }", "");
    let text = text
        .replace(", radius_lateral = 'flat'", "")
        .replace("'flat', radius_lateral = 0.30", "0.5");
    let (code, made) = made(&text);
    assert_eq!(code, CREEPAGE_OK);
    let (code, found) = step(made, 1e-3, [1e5, 0.0, 0.0], [1, 0, 0], CASE);
    assert_eq!(code, CREEPAGE_OK);
    // Forces are met within the solver's tolerance of mu N.
    assert!((f64::from_bits(found[0]) - 1e5).abs() < 1e-6 * 3e5, "{found:?}");
    assert_eq!(step(made, 1e-3, [1e5, 0.0, 0.1], [1, 0, 0], CASE).0, CREEPAGE_INVALID);
    free(made);
}
