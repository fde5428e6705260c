//! Theories.

use std::ffi::c_char;

use creepage::rolling::exact::{Automatic, Exact, ExactSolution, Workspace};
use creepage::rolling::{Creepage, Force, Status, Theory};
use creepage_study::PreparedTheory;

use crate::failure::{Failure, guard};
use crate::input::{cases, handle, optional, place, release, text};
use crate::prepare::Solver;

/// The theory's equations are solved.
pub const CREEPAGE_SOLVED: i32 = 0;
/// The iteration ended before its tolerance was met.
pub const CREEPAGE_NOT_CONVERGED: i32 = 1;
/// Solved, but creepage is too small for the theory's resolution.
pub const CREEPAGE_CREEPAGE_TOO_SMALL: i32 = 2;
/// Solved, but spin is beyond the bound up to which the theory holds.
pub const CREEPAGE_SPIN_TOO_LARGE: i32 = 3;
/// A status that this version of the interface does not know.
pub const CREEPAGE_DOUBTFUL: i32 = 4;
/// Solved, but as if the bodies were alike: their difference matters, and only "exact" counts it.
pub const CREEPAGE_UNLIKE_BODIES: i32 = 5;

/// A theory, prepared for one shape of the contact and one Poisson's ratio.
// Never inside out: only pointers to it leave the library.
#[allow(missing_debug_implementations)]
pub struct CreepageTheory {
    solver: Solver,
}

pub(crate) fn number(status: Status) -> i32 {
    match status {
        Status::Solved => CREEPAGE_SOLVED,
        Status::NotConverged => CREEPAGE_NOT_CONVERGED,
        Status::CreepageTooSmall => CREEPAGE_CREEPAGE_TOO_SMALL,
        Status::SpinTooLarge => CREEPAGE_SPIN_TOO_LARGE,
        _ => CREEPAGE_DOUBTFUL,
    }
}

/// Prepares a theory.
///
/// name: "exact", "fastsim", and so on, as `creepage theories` lists them.
/// options: its options as in the section `solve` of a case file, for instance
///   "resolution = 'fine'"; NULL or "" for the usual ones.
/// a_over_b: semi-axis along over semi-axis across the rolling direction (1).
/// poisson: combined Poisson's ratio, 0 to 0.5 (1).
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
    theory: *mut *mut CreepageTheory,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation.
        let place = unsafe { place("theory", theory) }?;
        // SAFETY: as before.
        let name = unsafe { text("name", name) }?;
        let options = if options.is_null() {
            ""
        } else {
            // SAFETY: as before.
            unsafe { text("options", options) }?
        };
        let solver = Solver::new(name, a_over_b, poisson, &toml::from_str(options)?)?;
        *place = Box::into_raw(Box::new(CreepageTheory { solver }));
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
/// statuses: room for count numbers, CREEPAGE_SOLVED and so on; or NULL.
///
/// All creepages are checked before any case is solved.
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
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let theory = unsafe { handle("theory", theory) }?;
        // SAFETY: as before.
        let cases = unsafe { cases(count, creepages, forces) }?;
        // SAFETY: as before.
        let mut statuses = unsafe { optional(statuses, count, 1) }?;
        for (case, (creepage, force)) in cases.enumerate() {
            let solution = theory.solver.theory.solve(creepage);
            *force = numbers(solution.force);
            if let Some(statuses) = &mut statuses {
                statuses[case] = number(solution.status);
            }
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Forces of many cases by the theory "exact", with error bars and derivatives.
///
/// count: number of cases.
/// creepages: 3 count numbers, xi, eta, chi of each case (1).
/// forces: room for 3 count numbers, f_x, f_y, m_z of each case (1).
/// errors: room for 3 count numbers, the error bars of f_x, f_y, m_z (1); or NULL.
/// derivatives: room for 9 count numbers; or NULL. Of each case the derivative of f_x by xi, by
///   eta and by chi, then of f_y, then of m_z (1); with resolution = "auto", that at the resolution
///   which sufficed for the case.
/// statuses: room for count numbers, CREEPAGE_SOLVED and so on; or NULL.
///
/// All creepages are checked before any case is solved. CREEPAGE_UNSUPPORTED for other theories.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_exact_force(
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
        let solver = &unsafe { handle("theory", theory) }?.solver;
        let mut full = FullTheory::of(solver)?;
        // SAFETY: as before.
        let cases = unsafe { cases(count, creepages, forces) }?;
        // SAFETY: as before.
        let mut errors = unsafe { optional(errors, count, 3) }?;
        // SAFETY: as before.
        let mut derivatives = unsafe { optional(derivatives, count, 9) }?;
        // SAFETY: as before.
        let mut statuses = unsafe { optional(statuses, count, 1) }?;
        for (case, (creepage, force)) in cases.enumerate() {
            let (solution, derivative) = full.solve(creepage, derivatives.is_some());
            *force = numbers(solution.force);
            if let Some(errors) = &mut errors {
                errors[3 * case..3 * case + 3].copy_from_slice(&numbers(solution.error));
            }
            if let (Some(derivatives), Some(derivative)) = (&mut derivatives, derivative) {
                derivatives[9 * case..9 * case + 9].copy_from_slice(derivative.as_flattened());
            }
            if let Some(statuses) = &mut statuses {
                statuses[case] = number(solution.status);
            }
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// The full theory, at one resolution or at that which each case needs.
enum FullTheory<'a> {
    Fixed(&'a Exact, Box<Workspace>),
    Automatic(&'a Automatic),
}

impl<'a> FullTheory<'a> {
    fn of(solver: &'a Solver) -> Result<Self, Failure> {
        match &solver.theory {
            PreparedTheory::Exact(exact) => Ok(Self::Fixed(exact, Box::new(exact.workspace()))),
            PreparedTheory::Automatic(automatic) => Ok(Self::Automatic(automatic)),
            _ => Err(Failure::Unsupported(solver.name)),
        }
    }

    fn solve(&mut self, creepage: Creepage, slopes: bool) -> (ExactSolution, Option<Derivative>) {
        match self {
            Self::Fixed(exact, workspace) => {
                let solution = exact.solve_with(creepage, workspace);
                (solution, slopes.then(|| exact.derivative(workspace)))
            }
            Self::Automatic(automatic) => {
                let (level, solution) = automatic.level(creepage);
                let derivative = || {
                    let mut workspace = level.workspace();
                    level.solve_with(creepage, &mut workspace);
                    level.derivative(&mut workspace)
                };
                (solution, slopes.then(derivative))
            }
        }
    }
}

/// Rows `fx`, `fy`, `mz`; columns `xi`, `eta`, `chi`.
type Derivative = [[f64; 3]; 3];

fn numbers(Force { fx, fy, mz }: Force) -> [f64; 3] {
    [fx, fy, mz]
}
