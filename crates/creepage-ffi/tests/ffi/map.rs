//! A contact map by its handle: the library's own answers, and codes for what is wrong.

use std::ffi::CString;
use std::ptr::{null, null_mut};

use creepage_ffi::*;
use creepage_map::ContactMap;

use crate::caller::Message;
use crate::made_up;

/// NaN is the map's own.
const OWN: [f64; 12] = [f64::NAN; 12];

fn loaded(path: &std::path::Path) -> (i32, *mut CreepageMap, String) {
    let path = CString::new(path.to_str().unwrap()).unwrap();
    let (mut map, mut message) = (null_mut(), Message::new());
    // SAFETY: all point to what they should.
    let code =
        unsafe { creepage_map_load(path.as_ptr(), &raw mut map, message.0.as_mut_ptr(), 256) };
    (code, map, message.text())
}

fn kept() -> (tempfile::TempDir, ContactMap) {
    let place = tempfile::tempdir().unwrap();
    let map = made_up::map();
    std::fs::write(place.path().join("map.nc"), map.to_bytes().unwrap()).unwrap();
    (place, map)
}

#[test]
fn answers_are_the_library_s() {
    let (place, map) = kept();
    let (code, handle, words) = loaded(&place.path().join("map.nc"));
    assert_eq!((code, &words[..]), (CREEPAGE_OK, ""));
    let mut states = [OWN; 2];
    // Yaw, for at the map's own height a wheel leaves its rail some micrometres aside.
    states[1][3] = 2e-4;
    let (mut answers, mut errors, mut by) = ([[0.0; 21]; 2], [[0.0; 4]; 2], [[0.0; 96]; 2]);
    let mut message = Message::new();
    // SAFETY: all point to what they should.
    let code = unsafe {
        creepage_map_solve(
            handle,
            2,
            states.as_ptr().cast(),
            answers.as_mut_ptr().cast(),
            errors.as_mut_ptr().cast(),
            by.as_mut_ptr().cast(),
            message.0.as_mut_ptr(),
            256,
        )
    };
    assert_eq!((code, &message.text()[..]), (CREEPAGE_OK, ""));
    for k in 0..2 {
        let state = map.head().own.with(&states[k]);
        let (answer, derivatives) = map.solve_with_derivatives(&state).unwrap();
        assert_eq!(answers[k], answer.numbers());
        assert_eq!(errors[k][2], answer.right.error.tangential);
        assert_eq!(by[k], derivatives.as_flattened().as_flattened());
    }
    // SAFETY: it is not used again.
    unsafe { creepage_map_free(handle) };
}

#[test]
fn what_is_wrong_has_a_code_and_words() {
    let (place, _) = kept();
    let (code, none, words) = loaded(&place.path().join("none.nc"));
    assert_eq!((code, none.is_null()), (CREEPAGE_FILE, true));
    assert!(words.contains("none.nc"), "{words}");
    std::fs::write(place.path().join("wrong.nc"), "no map").unwrap();
    let (code, _, words) = loaded(&place.path().join("wrong.nc"));
    assert!(code == CREEPAGE_FILE && words.contains("no contact map"), "{words}");
    let (_, handle, _) = loaded(&place.path().join("map.nc"));
    let solve = |state: &[f64; 12], answers: *mut f64| {
        let mut message = Message::new();
        // SAFETY: all point to what they should, or are NULL.
        let code = unsafe {
            creepage_map_solve(
                handle,
                1,
                state.as_ptr(),
                answers,
                null_mut(),
                null_mut(),
                message.0.as_mut_ptr(),
                256,
            )
        };
        (code, message.text())
    };
    let mut outside = OWN;
    outside[0] = 0.05;
    let mut answer = [0.0; 21];
    let (code, words) = solve(&outside, answer.as_mut_ptr());
    assert_eq!(code, CREEPAGE_INVALID);
    assert!(words.contains("state 0") && words.contains("outside the map"), "{words}");
    assert_eq!(answer, [0.0; 21]);
    assert_eq!(solve(&OWN, null_mut()).0, CREEPAGE_NULL);
    // SAFETY: NULL is seen to; the handle is not used again.
    unsafe {
        let code = creepage_map_solve(
            null(),
            1,
            OWN.as_ptr(),
            answer.as_mut_ptr(),
            null_mut(),
            null_mut(),
            null_mut(),
            0,
        );
        assert_eq!(code, CREEPAGE_NULL);
        creepage_map_free(handle);
        creepage_map_free(null_mut());
    }
}
