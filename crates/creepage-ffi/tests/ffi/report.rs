//! Quantities of a report by their keys: the library's own, of an ellipse and of areas; errors.

use std::ffi::{CStr, CString, c_char};
use std::path::Path;
use std::ptr::null;

use creepage_ffi::*;
use creepage_study::AnyCaseFile;

const BODIES: &str = "
upper = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 0.46, radius_lateral = 'flat' }
lower = { shear_modulus = 82e9, poisson = 0.28, radius_rolling = 'flat', radius_lateral = 0.3 }
contact = { normal_force = 80e3, friction = 0.3 }
creepage = { longitudinal = 1e-3, lateral = 5e-4, spin = 0.1 }
solve = { theory = 'exact', resolution = 'fast' }
";
const AREAS: &str = "
upper = { shear_modulus = 82e9, poisson = 0.28 }
lower = { shear_modulus = 82e9, poisson = 0.28 }
gap = { polynomial = [[2, 0, 1.0869565217391304], [0, 2, 1.6666666666666667]] }
contact = { normal_force = 80e3, friction = 0.3 }
creepage = { longitudinal = 1e-3, lateral = 5e-4, spin = 0.1 }
solve = { theory = 'exact', resolution = 'fast' }
";
const KEYS: [&str; 4] = [
    "contact.peak_pressure_pa",
    "lower_body.lateral_n",
    "frictional_power_per_metre_j_per_m",
    "frictional_power_w",
];

fn asked(text: &str, theory: Option<&str>, keys: &[&str]) -> (i32, Vec<[f64; 2]>, i32, String) {
    let text = CString::new(text).unwrap();
    let theory = theory.map(|name| CString::new(name).unwrap());
    let owned: Vec<_> = keys.iter().map(|key| CString::new(*key).unwrap()).collect();
    let pointers: Vec<_> = owned.iter().map(|key| key.as_ptr()).collect();
    let (mut values, mut errors) = (vec![0.0; keys.len()], vec![0.0; keys.len()]);
    let (mut status, mut message) = (-1, [0 as c_char; 300]);
    // SAFETY: all point to what they should.
    let (code, words) = unsafe {
        let code = creepage_report(
            text.as_ptr(),
            theory.as_ref().map_or(null(), |name| name.as_ptr()),
            keys.len(),
            pointers.as_ptr(),
            values.as_mut_ptr(),
            errors.as_mut_ptr(),
            &raw mut status,
            message.as_mut_ptr(),
            message.len(),
        );
        (code, CStr::from_ptr(message.as_ptr()).to_str().unwrap().to_owned())
    };
    (
        code,
        values.into_iter().zip(errors).map(|(value, error)| [value, error]).collect(),
        status,
        words,
    )
}

/// Wheelsets, line contacts, bearings and problems without rolling are asked by the paths of their reports; the last two
/// are solved by no other theory.
#[test]
fn files_of_every_kind_have_quantities() {
    let example = |name: &str| format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"));
    let (wheelset, line, bearing) = (
        example("wheelset/s1002-on-uic60.toml"),
        example("line/aluminium-on-steel.toml"),
        example("bearing/angular-contact-7208.toml"),
    );
    let keys =
        ["left.patches.0.area_m2", "left.force.vertical_n", "right.patches.0.normal_force_n"];
    let (code, found, _, words) = asked(&wheelset, Some("saturated"), &keys);
    assert_eq!(code, CREEPAGE_OK, "{words}");
    assert!(found.iter().all(|[value, _]| *value > 0.0), "{found:?}");
    // Both wheels carry the axle load of 200 kN together; each contact's area has an error bar.
    assert!(found[0][1] > 0.0 && (found[1][0] - 1e5).abs() < 1e4, "{found:?}");
    let (code, found, _, words) = asked(&line, Some("carter"), &["rho_m", "fx"]);
    assert_eq!(code, CREEPAGE_OK, "{words}");
    assert!(found[0][0] > 0.0 && found[1][0].abs() <= 1.0, "{found:?}");
    assert_eq!(asked(&line, Some("polach"), &["rho_m"]).0, CREEPAGE_TEXT);
    let keys = ["balls.0.inner.heat_w", "heat_w"];
    let (code, found, _, words) = asked(&bearing, None, &keys);
    assert_eq!(code, CREEPAGE_OK, "{words}");
    assert!(found[0][0] > 0.0 && found[1][0] > found[0][0], "{found:?}");
    assert_eq!(asked(&bearing, Some("exact"), &keys).0, CREEPAGE_UNSUPPORTED);
    let plate = example("statics/anchor-plate-shift.toml");
    let keys = ["given.force_x_n", "found.shift_x_m", "found.stiffness_x_n_per_m"];
    let (code, found, _, words) = asked(&plate, None, &keys);
    assert_eq!(code, CREEPAGE_OK, "{words}");
    // Force over stiffness, but for roundings of the two solutions.
    let [force, shift, stiffness] = [0, 1, 2].map(|k: usize| found[k][0]);
    assert!((shift / (force / stiffness) - 1.0).abs() < 1e-12 && force.abs() > 0.0, "{found:?}");
    assert_eq!(asked(&plate, Some("exact"), &keys).0, CREEPAGE_UNSUPPORTED);
}

#[test]
fn quantities_are_those_of_the_library() {
    for text in [BODIES, AREAS] {
        let (code, found, status, words) = asked(text, None, &KEYS);
        assert_eq!((code, status), (CREEPAGE_OK, CREEPAGE_SOLVED), "{words}");
        let case = AnyCaseFile::read(text).unwrap().case(Path::new("")).unwrap();
        let report = case.solve(None).unwrap().report();
        for (key, [value, error]) in KEYS.iter().zip(found) {
            let own = report.find(key).unwrap();
            assert_eq!(value.to_bits(), own.value.unwrap_or(f64::NAN).to_bits(), "{key}");
            assert_eq!(error.to_bits(), own.error.unwrap_or(f64::NAN).to_bits(), "{key}");
        }
        // Rolling velocity is not given.
        assert!(report.find(KEYS[3]).unwrap().value.is_none());
        assert!(report.find(KEYS[1]).unwrap().error.is_some_and(|bar| bar > 0.0));
    }
}

#[test]
fn another_theory_and_what_is_wrong() {
    let force = |theory| asked(BODIES, theory, &KEYS).1[1][0];
    assert_ne!(force(None), force(Some("linear")));
    let (code, .., words) = asked(BODIES, None, &["contact.peak_pressure"]);
    assert!(code == CREEPAGE_TEXT && words.contains("`contact.peak_pressure`"), "{words}");
    let (code, .., words) = asked(BODIES, Some("kalker"), &KEYS);
    assert!(code == CREEPAGE_TEXT && words.contains("kalker"), "{words}");
    let (code, ..) = asked("[upper]\n", None, &KEYS);
    assert_ne!(code, CREEPAGE_OK);
}
