//! Codes for all that is wrong.

use std::ffi::{CString, c_char};
use std::ptr::{null, null_mut};

use creepage_ffi::*;

use crate::caller::{CASES, Owned, between, new};

#[test]
fn wrong_words_and_numbers_get_their_codes() {
    for (name, options, ratio, code, words) in [
        ("exactly", "", 1.0, CREEPAGE_TEXT, "unknown theory `exactly`"),
        ("fastsim", "grid = 3", 1.0, CREEPAGE_TEXT, "options"),
        ("fastsim", "gird = [3, 3]", 1.0, CREEPAGE_TEXT, "gird"),
        (
            "exact",
            "degree = 3",
            1.0,
            CREEPAGE_TEXT,
            "`degree` is an option of variational, not of exact",
        ),
        ("exact", "theory = 'linear'", 1.0, CREEPAGE_TEXT, "`theory` is not an option"),
        ("exact", "accuracy = 0.01", 1.0, CREEPAGE_TEXT, "`accuracy` needs resolution"),
        ("exact", "", -1.0, CREEPAGE_INVALID, "a_over_b = -1"),
        ("polach", "", f64::NAN, CREEPAGE_INVALID, "NaN"),
        ("fastsim", "grid = [0, 3]", 1.0, CREEPAGE_INVALID, "0"),
    ] {
        let (found, theory, message) = new(name, options, ratio);
        assert!((found, theory.is_null()) == (code, true) && message.contains(words), "{message}");
    }
    let theory = Owned::new("polach", "");
    for wrong in [f64::NAN, f64::INFINITY, 1e200] {
        let (code, forces, _, message) = theory.force(&[0.1, 0.0, 0.0, 0.0, wrong, 0.0]);
        assert_eq!(code, CREEPAGE_INVALID);
        assert!(message.starts_with("case 1: eta"), "{message}");
        // Nothing is written before all is checked.
        assert_eq!(forces, [9.0; 6]);
    }
    assert_eq!(theory.force(&[]).0, CREEPAGE_OK);
}

#[test]
fn nothing_and_too_much_get_their_codes() {
    let name = CString::new("polach").unwrap();
    let bad = [0xff_u8, 0];
    let (mut theory, mut forces) = (null_mut(), [0.0; 3]);
    let made = Owned::new("polach", "");
    let (one, out, none) = (CASES.as_ptr(), forces.as_mut_ptr(), null_mut());
    let (huge, wrap) = (usize::MAX / 9, usize::MAX / 2 + 2);
    // SAFETY: pointers are right, NULL, or seen to be of no use before they are read.
    unsafe {
        let new = |name: *const c_char, options: *const c_char, theory| {
            creepage_theory_new(name, options, 1.0, 0.28, 0.0, theory, null_mut(), 0)
        };
        assert_eq!(new(null(), null(), &raw mut theory), CREEPAGE_NULL);
        assert_eq!(new(name.as_ptr(), null(), null_mut()), CREEPAGE_NULL);
        assert_eq!(new(bad.as_ptr().cast(), null(), &raw mut theory), CREEPAGE_TEXT);
        assert_eq!(new(name.as_ptr(), bad.as_ptr().cast(), &raw mut theory), CREEPAGE_TEXT);
        assert!(theory.is_null());
        let force = |theory: *const CreepageTheory, count, creepages, forces| {
            creepage_theory_force(
                theory,
                count,
                creepages,
                forces,
                null_mut(),
                null_mut(),
                none,
                null_mut(),
                0,
            )
        };
        assert_eq!(force(null(), 1, one, out), CREEPAGE_NULL);
        assert_eq!(force(made.0, 1, null(), out), CREEPAGE_NULL);
        assert_eq!(force(made.0, 1, one, null_mut()), CREEPAGE_NULL);
        assert_eq!(force(made.0, huge, one, out), CREEPAGE_COUNT);
        assert_eq!(force(made.0, wrap, one, out), CREEPAGE_COUNT);
        let mut table = null_mut();
        assert_eq!(creepage_table_read(null(), &raw mut table, null_mut(), 0), CREEPAGE_NULL);
        assert_eq!(creepage_table_read(name.as_ptr(), null_mut(), null_mut(), 0), CREEPAGE_NULL);
        assert_eq!(
            creepage_table_read(name.as_ptr(), &raw mut table, null_mut(), 0),
            CREEPAGE_FILE
        );
        assert!(table.is_null());
        let slopes = null_mut();
        let look =
            creepage_table_force(null(), 1.0, 0.28, 0.0, 1, one, out, slopes, none, null_mut(), 0);
        assert_eq!(look, CREEPAGE_NULL);
        assert_eq!(creepage_table_error(null(), out, null_mut(), 0), CREEPAGE_NULL);
        let slip = null_mut();
        let solve = |path| creepage_case_solve(path, null(), slip, out, none, null_mut(), 0);
        assert_eq!(solve(null()), CREEPAGE_NULL);
        assert_eq!(solve(name.as_ptr()), CREEPAGE_FILE);
        creepage_theory_free(null_mut());
        creepage_table_free(null_mut());
    }
}

#[test]
fn coupled_bodies_are_those_of_a_case() {
    let (code, theory, message) = between("exact", "coupled = true", 1.0, 0.3);
    assert!((code, theory.is_null()) == (CREEPAGE_TEXT, true), "{message}");
    assert!(message.contains("`coupled` needs a case with bodies and friction"), "{message}");
    // Like bodies have nothing to couple.
    assert_eq!(Owned::new("exact", "coupled = true").force(&[]).0, CREEPAGE_OK);
}
