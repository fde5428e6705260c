//! The functions as a caller from C sees them: right answers, and codes for all that is wrong.

use std::ffi::{CStr, CString, c_char};
use std::ptr::{null, null_mut};
use std::thread;

use creepage::approximate::polach::Polach;
use creepage::coulomb::{Automatic, Exact, Resolution};
use creepage::table::{Axis, Intervals, Provenance, Spec, build};
use creepage::theory::Solved as _;
use creepage::{Contact, Creepage, Ellipse, InvalidValue, Theory, TheorySpec};
use creepage_ffi::*;

/// Room for a message, and what was written to it.
struct Message([c_char; 256]);

impl Message {
    fn new() -> Self {
        Self([0x55; 256])
    }

    fn text(&self) -> String {
        assert!(self.0.contains(&0));
        // SAFETY: there is a zero.
        unsafe { CStr::from_ptr(self.0.as_ptr()) }.to_str().unwrap().into()
    }
}

/// The contact of most tests.
fn contact() -> Contact {
    Contact::new(Ellipse::from_ratio(1.5).unwrap(), 0.28).unwrap()
}

/// The creepages of an array.
fn creepages(cases: &[f64]) -> impl Iterator<Item = Creepage> {
    cases.as_chunks().0.iter().map(|&[xi, eta, chi]| Creepage::new(xi, eta, chi).unwrap())
}

fn new(name: &str, options: &str, a_over_b: f64) -> (i32, *mut CreepageTheory, String) {
    between(name, options, a_over_b, 0.0)
}

fn between(
    name: &str,
    options: &str,
    a_over_b: f64,
    kappa_over_mu: f64,
) -> (i32, *mut CreepageTheory, String) {
    let (name, options) = (CString::new(name).unwrap(), CString::new(options).unwrap());
    let (mut theory, mut message) = (null_mut(), Message::new());
    // SAFETY: all point to what they should.
    let code = unsafe {
        let (name, options) = (name.as_ptr(), options.as_ptr());
        creepage_theory_new(
            name,
            options,
            a_over_b,
            0.28,
            kappa_over_mu,
            &raw mut theory,
            message.0.as_mut_ptr(),
            256,
        )
    };
    (code, theory, message.text())
}

/// A theory that frees itself.
struct Owned(*mut CreepageTheory);

// SAFETY: the interface says that a handle may be used by many threads.
unsafe impl Sync for Owned {}

impl Owned {
    fn new(name: &str, options: &str) -> Self {
        Self::between(name, options, 0.0)
    }

    fn between(name: &str, options: &str, kappa_over_mu: f64) -> Self {
        let (code, theory, message) = between(name, options, 1.5, kappa_over_mu);
        assert_eq!((code, &message[..]), (CREEPAGE_OK, ""));
        assert!(!theory.is_null());
        Self(theory)
    }

    fn force(&self, creepages: &[f64]) -> (i32, Vec<f64>, Vec<i32>, String) {
        let count = creepages.len() / 3;
        let (mut forces, mut statuses) = (vec![9.0; 3 * count], vec![9; count]);
        let mut message = Message::new();
        // SAFETY: all point to what they should.
        let code = unsafe {
            creepage_theory_force(
                self.0,
                count,
                creepages.as_ptr(),
                forces.as_mut_ptr(),
                null_mut(),
                null_mut(),
                statuses.as_mut_ptr(),
                message.0.as_mut_ptr(),
                256,
            )
        };
        (code, forces, statuses, message.text())
    }
}

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: made by the library, and not used again.
        unsafe { creepage_theory_free(self.0) }
    }
}

const CASES: [f64; 9] = [0.5, 0.2, 0.1, -3.0, 1.0, 4.0, 0.0, 0.0, 0.0];

#[test]
fn many_cases_get_the_forces_of_the_library() {
    for name in ["exact", "fastrip", "fastsim", "polach", "shen-hedrick-elkins"] {
        let (code, forces, statuses, _) = Owned::new(name, "").force(&CASES);
        assert_eq!(code, CREEPAGE_OK);
        assert_eq!(statuses, [CREEPAGE_SOLVED; 3], "{name}");
        assert!(forces.iter().all(|f| f.abs() <= 1.01), "{name} {forces:?}");
        assert_eq!(forces[6..], [0.0; 3], "{name}");
    }
    let theory = Exact::new(&contact(), Resolution::FAST).unwrap();
    let (_, forces, ..) = Owned::new("exact", "resolution = 'fast'").force(&CASES);
    for (creepage, found) in creepages(&CASES).zip(forces.as_chunks::<3>().0) {
        assert_eq!(theory.solve(creepage).force.components(), *found);
    }
    for name in ["variational", "strip", "linear", "saturated", "vermeulen-johnson"] {
        assert_eq!(Owned::new(name, "").force(&CASES).0, CREEPAGE_OK, "{name}");
    }
    let doubts = Owned::new("vermeulen-johnson", "").force(&CASES).2;
    assert_eq!(doubts, [CREEPAGE_SPIN_TOO_LARGE, CREEPAGE_SPIN_TOO_LARGE, CREEPAGE_SOLVED]);
}

/// Forces of [`CASES`], error bars and derivatives.
type Full = ([f64; 9], [f64; 9], [f64; 27]);

/// All that a theory can be asked; error bars and derivatives where they are wanted.
fn ask(theory: &Owned, bars: bool, slopes: bool) -> (i32, Full) {
    let (mut forces, mut errors, mut derivatives) = ([0.0; 9], [0.0; 9], [0.0; 27]);
    let (out, cases) = (forces.as_mut_ptr(), CASES.as_ptr());
    let bars = if bars { errors.as_mut_ptr() } else { null_mut() };
    let slopes = if slopes { derivatives.as_mut_ptr() } else { null_mut() };
    // SAFETY: all point to what they should, or to nothing where that is allowed.
    let code = unsafe {
        creepage_theory_force(theory.0, 3, cases, out, bars, slopes, null_mut(), null_mut(), 0)
    };
    (code, (forces, errors, derivatives))
}

#[test]
fn the_full_theory_gives_errors_and_derivatives() {
    let theory = Owned::new("exact", "");
    let (code, (forces, errors, derivatives)) = ask(&theory, true, true);
    assert_eq!(code, CREEPAGE_OK);
    let library = Exact::new(&contact(), Resolution::STANDARD).unwrap();
    let mut right = library.solve_contact(Creepage::new(0.5, 0.2, 0.1).unwrap());
    assert_eq!(forces[..3], right.solution().force.components());
    assert_eq!(errors[..3], right.solution().error.unwrap().components());
    assert_eq!(&derivatives[..9], right.jacobian().unwrap().as_flattened());
    assert_eq!(ask(&theory, false, false), (CREEPAGE_OK, (forces, [0.0; 9], [0.0; 27])));
}

#[test]
fn every_theory_gives_the_derivative_that_it_has() {
    for spec in TheorySpec::all() {
        let (facts, library) = (spec.facts(), spec.prepare(&contact()).unwrap());
        let theory = Owned::new(facts.name, "");
        let code = |has| if has { CREEPAGE_OK } else { CREEPAGE_UNSUPPORTED };
        assert_eq!(ask(&theory, true, false).0, code(facts.error_bars), "{}", facts.name);
        let (found, (forces, _, derivatives)) = ask(&theory, false, true);
        assert_eq!(found, code(facts.derivative), "{}", facts.name);
        for (k, creepage) in creepages(&CASES).enumerate().filter(|_| facts.derivative) {
            assert_eq!(forces[3 * k..3 * k + 3], library.solve(creepage).force.components());
            let slope = library.jacobian(creepage).unwrap();
            assert_eq!(&derivatives[9 * k..9 * k + 9], slope.as_flattened(), "{}", facts.name);
        }
    }
}

#[test]
fn the_full_theory_refines_by_itself() {
    let theory = Owned::new("exact", "resolution = 'auto'\naccuracy = 0.004");
    let (code, (forces, errors, derivatives)) = ask(&theory, true, true);
    assert_eq!((code, theory.force(&CASES).2), (CREEPAGE_OK, vec![CREEPAGE_SOLVED; 3]));
    let library = Automatic::new(&contact(), 0.004).unwrap();
    for (k, creepage) in creepages(&CASES).enumerate() {
        let mut right = library.solved(creepage);
        assert_eq!(forces[3 * k..3 * k + 3], right.solution().force.components());
        assert_eq!(errors[3 * k..3 * k + 3], right.solution().error.unwrap().components());
        assert_eq!(&derivatives[9 * k..9 * k + 9], right.jacobian().unwrap().as_flattened());
    }
    assert!(errors[..2].iter().all(|bar| *bar <= 0.004), "{errors:?}");
    // No resolution has such error bars.
    let theory = Owned::new("exact", "resolution = 'auto'\naccuracy = 1e-9");
    assert_eq!(theory.force(&CASES[..3]).2, [CREEPAGE_ACCURACY_NOT_REACHED]);
}

#[test]
fn the_full_theory_counts_dissimilar_bodies_and_others_say_that_they_do_not() {
    let exact = |kappa| Owned::between("exact", "resolution = 'fast'", kappa).force(&CASES);
    let contact = contact().with_kappa_over_mu(-0.3).unwrap();
    let library = Exact::new(&contact, Resolution::FAST).unwrap();
    let (_, forces, statuses, _) = exact(-0.3);
    assert_eq!(statuses, [CREEPAGE_SOLVED; 3]);
    assert_ne!(forces, exact(0.0).1);
    for (creepage, force) in creepages(&CASES).zip(forces.as_chunks::<3>().0) {
        assert_eq!(library.solve(creepage).force.components(), *force);
    }
    let polach = |kappa| Owned::between("polach", "", kappa).force(&CASES);
    assert_eq!(polach(-0.3).1, polach(0.0).1);
    assert_eq!(polach(-0.3).2, [CREEPAGE_UNLIKE_BODIES; 3]);
    assert_eq!(polach(1e-3).2, [CREEPAGE_SOLVED; 3]);
    let (code, theory, message) = between("exact", "", 1.5, f64::NAN);
    assert!(code == CREEPAGE_INVALID && theory.is_null() && message.starts_with("kappa_over_mu"));
}

const WHEEL: &str = r#"
[upper]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = 0.46
radius_lateral = "flat"
[lower]
shear_modulus = 82e9
poisson = 0.28
radius_rolling = "flat"
radius_lateral = 0.3
[contact]
normal_force = 80e3
friction = 0.3
"#;

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
    let case = format!("{WHEEL}[creepage]\nxi = 0.5\n[solve]\nresolution = 'fast'\n");
    let unlike = case.replacen("82e9", "27e9", 1);
    for (text, theory, told) in [
        (&case, Some("polach"), CREEPAGE_SOLVED),
        (&unlike, Some("polach"), CREEPAGE_UNLIKE_BODIES),
        (&unlike, None, CREEPAGE_SOLVED),
    ] {
        let (code, _, _, status, message) = solve_case(text, theory);
        assert_eq!((code, status), (CREEPAGE_OK, told), "{message}");
    }
    let forces = [&case, &unlike].map(|text| solve_case(text, None).2);
    // kappa/mu = -0.37 takes part in the force.
    assert!((forces[0][0] - forces[1][0]).abs() > 0.05 * 24e3, "{forces:?}");
}

#[test]
fn one_handle_serves_many_threads() {
    let theory = Owned::new("exact", "resolution = 'fast'");
    let right = theory.force(&CASES).1;
    thread::scope(|scope| {
        let threads: Vec<_> = (0..4)
            .map(|_| scope.spawn(|| (0..5).map(|_| theory.force(&CASES).1).collect::<Vec<_>>()))
            .collect();
        for thread in threads {
            assert!(thread.join().unwrap().iter().all(|forces| *forces == right));
        }
    });
}

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
fn a_table_gives_what_it_gives_in_rust() {
    let spec = Spec {
        a_over_b: Axis { low: 0.5, high: 2.0, nodes: 3 },
        poisson: Axis::fixed(0.28),
        intervals: Intervals { theta: 4, phi: 4, t: 6 },
        places: 20,
        provenance: Provenance::default(),
    };
    let prepare = |contact: &Contact| -> Result<Box<dyn Theory>, InvalidValue> {
        Ok(Box::new(Polach::new(contact)?))
    };
    let right = build(&spec, prepare, &|| {}).unwrap();
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("table.nc");
    std::fs::write(&path, right.to_bytes().unwrap()).unwrap();
    let path = CString::new(path.to_str().unwrap()).unwrap();
    let (mut table, mut message) = (null_mut(), Message::new());
    let (mut forces, mut derivatives, mut errors) = ([0.0; 9], [0.0; 27], [0.0; 2]);
    // SAFETY: all point to what they should.
    unsafe {
        let words = message.0.as_mut_ptr();
        assert_eq!(creepage_table_read(path.as_ptr(), &raw mut table, words, 256), CREEPAGE_OK);
        let (cases, out, slopes) = (CASES.as_ptr(), forces.as_mut_ptr(), derivatives.as_mut_ptr());
        let ask = |ratio, kappa, slopes| {
            let mut told = 9;
            let status = &raw mut told;
            let code = creepage_table_force(
                table, ratio, 0.28, kappa, 3, cases, out, slopes, status, words, 256,
            );
            (code, told)
        };
        assert_eq!(ask(3.0, 0.0, null_mut()).0, CREEPAGE_INVALID);
        assert!(message.text().starts_with("a_over_b = 3"));
        assert_eq!(ask(1.3, f64::NAN, null_mut()).0, CREEPAGE_INVALID);
        assert!(message.text().starts_with("kappa_over_mu = NaN"));
        assert_eq!(ask(1.3, 0.3, null_mut()), (CREEPAGE_OK, CREEPAGE_UNLIKE_BODIES));
        assert_eq!(ask(1.3, 0.0, slopes), (CREEPAGE_OK, CREEPAGE_SOLVED));
        assert_eq!(creepage_table_error(table, errors.as_mut_ptr(), words, 256), CREEPAGE_OK);
        creepage_table_free(table);
    }
    let slice = right.at(1.3, 0.28).unwrap();
    for (k, creepage) in creepages(&CASES).enumerate() {
        let (force, derivative) = slice.force_and_derivative(creepage);
        assert_eq!(forces[3 * k..3 * k + 3], force.components());
        assert_eq!(&derivatives[9 * k..9 * k + 9], derivative.as_flattened());
    }
    assert_eq!(errors, [right.accuracy().force.worst, right.accuracy().moment.worst]);
}
