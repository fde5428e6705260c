//! A case file, solved by a caller from C.

use std::ffi::CString;
use std::ptr::null;

use creepage_ffi::*;

use crate::caller::{Message, WHEEL};

/// Code, creepage, force, status and message.
type Solved = (i32, [f64; 3], [f64; 3], i32, String);

/// Solves the text of a case file.
fn solve_case(text: &str, theory: Option<&str>) -> Solved {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("case.toml");
    std::fs::write(&path, text).unwrap();
    let path = CString::new(path.to_str().unwrap()).unwrap();
    let theory = theory.map(|name| CString::new(name).unwrap());
    let (mut creepage, mut force, mut status) = ([9.0; 3], [9.0; 3], 9);
    let mut message = Message::new();
    // SAFETY: all point to what they should, or to nothing where that is allowed.
    let code = unsafe {
        creepage_case_solve(
            path.as_ptr(),
            theory.as_ref().map_or(null(), |name| name.as_ptr()),
            creepage.as_mut_ptr(),
            force.as_mut_ptr(),
            &raw mut status,
            message.0.as_mut_ptr(),
            256,
        )
    };
    (code, creepage, force, status, message.text())
}

#[test]
fn a_case_gives_creepage_and_force_whichever_was_asked_for() {
    for options in ["resolution = 'fast'", "resolution = 'auto'\naccuracy = 0.01"] {
        let case = |question: &str| format!("{WHEEL}{question}\n[solve]\n{options}\n");
        let given = "[creepage]\nlongitudinal = -1e-3\nlateral = 4e-4\nspin = 0.1";
        let (code, creepage, force, status, message) = solve_case(&case(given), None);
        assert_eq!((code, status, &message[..]), (CREEPAGE_OK, CREEPAGE_SOLVED, ""));
        // To the dimensionless creepage and back: rounding.
        for (found, given) in creepage.iter().zip([-1e-3, 4e-4, 0.1]) {
            assert!((found / given - 1.0).abs() < 1e-12, "{found} {given}");
        }
        let wanted = format!(
            "[creepage]\nspin = 0.1\n[wanted]\nlongitudinal_force = {:?}\nlateral_force = {:?}",
            force[0], force[1]
        );
        let (code, found, again, status, _) = solve_case(&case(&wanted), None);
        assert_eq!((code, status), (CREEPAGE_OK, CREEPAGE_SOLVED));
        for k in 0..2 {
            // Forces are found to 1e-7 of mu N, over slopes that make it 1e-4 of these creepages.
            assert!((again[k] - force[k]).abs() < 24e3 * 1e-6, "{again:?} {force:?}");
            assert!((found[k] / creepage[k] - 1.0).abs() < 1e-4, "{found:?} {creepage:?}");
        }
    }
}

#[test]
fn a_wanted_force_that_cannot_be_has_its_codes() {
    let wanted = format!("{WHEEL}[creepage]\nxi = 0\neta = 0\n[wanted]\nmz = 0.9\n");
    // Sliding that turns about the middle gives about 3 pi / 16 of mu N c, and no more.
    let (code, _, force, _, message) = solve_case(&wanted, None);
    assert_eq!(code, CREEPAGE_NOT_REACHABLE, "{message}");
    assert!(message.contains("[wanted] is not reachable: at most moment = "), "{message}");
    assert_eq!(force, [9.0; 3]);
    let (code, .., message) = solve_case(&wanted, Some("fastsim"));
    assert_eq!(code, CREEPAGE_UNSUPPORTED);
    assert!(message.contains("[wanted] needs the theory exact"), "{message}");
    let (code, .., message) = solve_case(&wanted.replace("eta = 0", ""), None);
    assert_eq!(code, CREEPAGE_FILE);
    assert!(message.contains("exactly three are needed"), "{message}");
}

#[test]
fn what_a_theory_leaves_out_between_unlike_bodies_is_told() {
    let case = format!("{WHEEL}[creepage]\nxi = 0.5\n[solve]\nresolution = 'standard'\n");
    let unlike = case.replacen("82e9", "27e9", 1);
    let coupled = format!("{unlike}coupled = true\n");
    for (text, theory, told) in [
        (&case, Some("polach"), CREEPAGE_SOLVED),
        (&unlike, Some("polach"), CREEPAGE_UNLIKE_BODIES),
        // What tractions change about pressure and area is more than the error bar: some 0.7 % of mu N.
        (&unlike, None, CREEPAGE_UNLIKE_BODIES),
        (&coupled, None, CREEPAGE_SOLVED),
    ] {
        let (code, _, _, status, message) = solve_case(text, theory);
        assert_eq!((code, status), (CREEPAGE_OK, told), "{message}");
    }
    let forces = [&case, &unlike].map(|text| solve_case(text, None).2);
    // kappa/mu = -0.37 takes part in the force.
    assert!((forces[0][0] - forces[1][0]).abs() > 0.05 * 24e3, "{forces:?}");
}

#[test]
fn tractions_act_back_on_pressure_where_asked() {
    let ball = "[upper]\nshear_modulus = 82e9\npoisson = 0.28\n\
        [lower]\nshear_modulus = 0.5e9\npoisson = 0.25\n\
        [contact]\nsemi_axis_rolling = 5e-3\nsemi_axis_lateral = 5e-3\n\
        normal_force = 650\nfriction = 0.3\n[creepage]\nxi = 0.5\neta = 0\nchi = 0\n\
        [solve]\nresolution = 'standard'\n";
    let both = [("", CREEPAGE_UNLIKE_BODIES), ("coupled = true\n", CREEPAGE_SOLVED)];
    let [one_way, coupled] = both.map(|(more, expected)| {
        let (code, _, force, status, message) = solve_case(&format!("{ball}{more}"), None);
        assert_eq!((code, status), (CREEPAGE_OK, expected), "{message}");
        force[0] / (0.3 * 650.0)
    });
    // CONTACT moves the force from -0.2174 to -0.2298, each to 0.0034.
    assert!((one_way - coupled - 0.0124).abs() < 0.006, "{one_way} {coupled}");
}
