//! The functions as a caller from C sees them: the answers of the library.

use std::ffi::CString;
use std::ptr::null_mut;
use std::thread;

use creepage::approximate::polach::Polach;
use creepage::coulomb::{Automatic, Exact, Resolution};
use creepage::table::{Axis, Intervals, Provenance, Spec, build};
use creepage::theory::Solved as _;
use creepage::{Contact, Creepage, InvalidValue, Theory, TheorySpec};
use creepage_ffi::*;

use crate::caller::{CASES, Message, Owned, between, contact, creepages};

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
