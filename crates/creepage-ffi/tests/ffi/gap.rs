//! Contacts of any shape: the library's own forces from a file and from flat arrays, and codes.

use std::ffi::{CStr, CString, c_char};
use std::path::Path;
use std::ptr::null;

use creepage_ffi::*;
use creepage_study::{GapFile, solve_gap};

const TEXT: &str = "
upper = { shear_modulus = 82e9, poisson = 0.28 }
lower = { shear_modulus = 82e9, poisson = 0.28 }
gap = { polynomial = [[2, 0, 1.0869565217391304], [0, 2, 1.6666666666666667]] }
contact = { normal_force = 80e3, friction = 0.3 }
creepage = { longitudinal = 1e-3, lateral = 5e-4, spin = 0.1 }
solve = { theory = 'exact', resolution = 'fast' }
";

#[derive(Debug, Default)]
struct Answer {
    code: i32,
    force: [f64; 3],
    error: [f64; 3],
    contact: [f64; 8],
    status: i32,
    message: String,
}

fn solved(text: &str, points: &[[f64; 3]], creepage: Option<[f64; 3]>) -> Answer {
    let (text, mut answer) =
        (CString::new(text).unwrap(), Answer { status: -1, ..Answer::default() });
    let mut message = [0 as c_char; 300];
    // SAFETY: all point to what they should.
    unsafe {
        answer.code = creepage_gap_force(
            text.as_ptr(),
            if points.is_empty() { null() } else { points.as_ptr().cast() },
            points.len(),
            creepage.as_ref().map_or(null(), |three| three.as_ptr()),
            answer.force.as_mut_ptr(),
            answer.error.as_mut_ptr(),
            answer.contact.as_mut_ptr(),
            &raw mut answer.status,
            message.as_mut_ptr(),
            message.len(),
        );
        answer.message = CStr::from_ptr(message.as_ptr()).to_str().unwrap().into();
    }
    answer
}

#[test]
fn a_file_gives_the_library_s_numbers() {
    let answer = solved(TEXT, &[], None);
    assert_eq!((answer.code, answer.status), (CREEPAGE_OK, CREEPAGE_SOLVED), "{}", answer.message);
    let case = GapFile::read(TEXT).unwrap().case(Path::new("")).unwrap();
    let own = solve_gap(&case).unwrap();
    let force = own.force();
    assert_eq!(answer.force, [force.longitudinal, force.lateral, force.moment]);
    assert_eq!(
        answer.contact[..4],
        [own.load().value, own.approach().value, own.area().value, own.peak_pressure().value]
    );
    assert!(answer.error.iter().all(|bar| *bar > 0.0));
}

/// The polynomial's values on a grid are nearly that gap; another creepage takes the file's place.
#[test]
fn flat_arrays_take_the_place_of_the_file_s() {
    let places = (-20..=20).flat_map(|i| (-20..=20).map(move |k| (i, k)));
    let point = |(i, k): (i32, i32)| {
        let (x, y) = (0.6e-3 * f64::from(i), 0.5e-3 * f64::from(k));
        [x, y, x * x / 0.92 + y * y / 0.6]
    };
    let points: Vec<_> = places.map(point).collect();
    let creepage = Some([2e-3, 0.0, 0.0]);
    let (by_points, by_polynomial) = (solved(TEXT, &points, creepage), solved(TEXT, &[], creepage));
    assert_eq!(by_points.code, CREEPAGE_OK, "{}", by_points.message);
    // A parabola is its own cubic; what is left is within the bars of both.
    let bars = by_points.error[0] + by_polynomial.error[0];
    assert!((by_points.force[0] - by_polynomial.force[0]).abs() < bars);
    assert!(by_points.force[0] > 1.2 * solved(TEXT, &[], None).force[0]);
}

#[test]
fn what_is_wrong_has_its_code() {
    let nan = Some([f64::NAN, 0.0, 0.0]);
    for (text, points, creepage, code, words) in [
        ("none.toml", &[][..], None, CREEPAGE_FILE, "cannot read none.toml"),
        (TEXT, &[[0.0; 3]][..], None, CREEPAGE_INVALID, "[gap] grid"),
        (TEXT, &[][..], nan, CREEPAGE_INVALID, "[creepage] longitudinal = NaN"),
        (&TEXT.replace("80e3", "-1.0"), &[][..], None, CREEPAGE_INVALID, "normal_force = -1"),
        (
            &TEXT
                .replace(", spin = 0.1", "")
                .replace("contact =", "wanted = { moment = 120.0 }\ncontact ="),
            &[][..],
            None,
            CREEPAGE_NOT_REACHABLE,
            "",
        ),
    ] {
        let answer = solved(text, points, creepage);
        assert_eq!(answer.code, code, "{}", answer.message);
        assert!(answer.message.contains(words), "{}", answer.message);
    }
}
