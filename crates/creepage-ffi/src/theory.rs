//! C functions of prepared theories.

use std::ffi::c_char;

use creepage::{Contact, Ellipse, Theory, TheorySpec};
use creepage_study::{Caution, theory_spec};

use crate::failure::{Failure, guard};
use crate::input::{cases, handle, optional, optional_text, place, release, text};
use crate::status::status;

/// A theory, prepared for one contact.
// Never inside out: only pointers to it leave the library.
#[allow(missing_debug_implementations)]
pub struct CreepageTheory {
    spec: TheorySpec,
    theory: Box<dyn Theory>,
}

/// Prepares a theory.
///
/// name: "exact", "fastsim", and so on, as `creepage theories` lists them.
/// options: its options as in the section `solve` of a case file, for instance
///   "resolution = 'fine'"; NULL or "" for the usual ones.
/// a_over_b: semi-axis along over semi-axis across the rolling direction (1).
/// poisson: combined Poisson's ratio, 0 to 0.5 (1).
/// kappa_over_mu: how dissimilar the bodies are, kappa over the coefficient of friction; 0 for like
///   bodies (1). Theories other than "exact" neglect it, and say so where it matters.
/// theory: becomes the handle, to be freed with creepage_theory_free; NULL if the call fails.
///
/// # Safety
/// Texts end with a zero byte; theory and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_theory_new(
    name: *const c_char,
    options: *const c_char,
    a_over_b: f64,
    poisson: f64,
    kappa_over_mu: f64,
    theory: *mut *mut CreepageTheory,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let place = unsafe { place("theory", theory) }?;
        // SAFETY: as before.
        let name = unsafe { text("name", name) }?;
        // SAFETY: as before.
        let options = unsafe { optional_text("options", options) }?.unwrap_or_default();
        let spec = theory_spec(name, &[options])?;
        let contact = Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)?;
        let contact = contact.with_kappa_over_mu(kappa_over_mu)?;
        let theory = spec.prepare(&contact)?;
        *place = Box::into_raw(Box::new(CreepageTheory { spec, theory }));
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a theory. NULL is left alone.
///
/// # Safety
/// theory is NULL, or of creepage_theory_new, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_theory_free(theory: *mut CreepageTheory) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(theory) };
}

/// Forces of many cases, one after the other.
///
/// count: number of cases.
/// creepages: 3 count numbers, xi, eta, chi of each case (1).
/// forces: room for 3 count numbers, f_x, f_y, m_z of each case (1).
/// errors: room for 3 count numbers, the error bars of f_x, f_y, m_z (1); or NULL.
/// derivatives: room for 9 count numbers; or NULL. Of each case the derivative of f_x by xi, by
///   eta and by chi, then of f_y, then of m_z (1); one-sided where the force has a kink.
/// statuses: room for count numbers, CREEPAGE_SOLVED and so on; or NULL.
///
/// All creepages are checked before any case is solved. CREEPAGE_UNSUPPORTED where errors are not
/// NULL and the theory is not "exact", and where derivatives are not NULL and it is "variational".
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_theory_force(
    theory: *const CreepageTheory,
    count: usize,
    creepages: *const f64,
    forces: *mut f64,
    errors: *mut f64,
    derivatives: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let CreepageTheory { spec, theory } = unsafe { handle("theory", theory) }?;
        // SAFETY: as before.
        let cases = unsafe { cases(count, creepages, forces) }?;
        // SAFETY: as before.
        let mut errors = unsafe { optional::<_, 3>(errors, count) }?;
        // SAFETY: as before.
        let mut derivatives = unsafe { optional::<_, 9>(derivatives, count) }?;
        // SAFETY: as before.
        let mut statuses = unsafe { optional::<_, 1>(statuses, count) }?;
        let facts = spec.facts();
        if errors.is_some() && !facts.error_bars {
            return Err(Failure::NoErrorBars(facts.name));
        }
        if derivatives.is_some() && !facts.derivative {
            return Err(Failure::NoDerivative(facts.name));
        }
        for (case, (creepage, force)) in cases.enumerate() {
            let solution = if let Some(derivatives) = &mut derivatives {
                let mut solved = theory.solved(creepage);
                let derivative = solved.jacobian().ok_or(Failure::NoDerivative(facts.name))?;
                derivatives[case].copy_from_slice(derivative.as_flattened());
                solved.solution()
            } else {
                theory.solve(creepage)
            };
            *force = solution.force.components();
            if let (Some(errors), Some(error)) = (&mut errors, solution.error) {
                errors[case] = error.components();
            }
            if let Some(statuses) = &mut statuses {
                statuses[case] = [status(&Caution::all(spec, theory.contact(), &solution))];
            }
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}
