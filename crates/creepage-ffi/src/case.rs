//! Case files.

use std::ffi::c_char;
use std::path::Path;

use crate::failure::guard;
use crate::input::{array_mut, optional, text};
use crate::prepare::solve_case;
use crate::theory::{CREEPAGE_SOLVED, CREEPAGE_UNLIKE_BODIES, number};

/// Solves a case file: creepages to forces, or with a section `wanted` forces to creepages.
///
/// path: the file, in TOML; `creepage init` writes an example.
/// theory: the theory to use, with its usual options; NULL for the file's own.
/// creepage: room for 3 numbers, those of the upper body relative to the lower, given or found:
///   longitudinal creepage, lateral creepage, spin (rad/m); or NULL.
/// force: room for 3 numbers, those of the upper body on the lower: longitudinal force (N),
///   lateral force (N), moment (N m).
/// status: room for one number, CREEPAGE_SOLVED and so on; or NULL. CREEPAGE_UNLIKE_BODIES where
///   the theory takes bodies for alike whose difference matters.
///
/// CREEPAGE_NOT_REACHABLE where no creepage gives the wanted forces; CREEPAGE_UNSUPPORTED where
/// forces are wanted of another theory than "exact".
///
/// # Safety
/// Texts end with a zero byte; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_case_solve(
    path: *const c_char,
    theory: *const c_char,
    creepage: *mut f64,
    force: *mut f64,
    status: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let path = Path::new(unsafe { text("path", path) }?);
        let name = if theory.is_null() {
            None
        } else {
            // SAFETY: as before.
            Some(unsafe { text("theory", theory) }?)
        };
        // SAFETY: as before.
        let creepage = unsafe { optional(creepage, 1, 3) }?;
        // SAFETY: as before.
        let force = unsafe { array_mut("force", force, 1, 3) }?;
        // SAFETY: as before.
        let status = unsafe { optional(status, 1, 1) }?;
        let solved = solve_case(path, name)?;
        if let Some(creepage) = creepage {
            let found = solved.creepage;
            creepage.copy_from_slice(&[found.longitudinal, found.lateral, found.spin]);
        }
        let found = solved.force;
        force.copy_from_slice(&[found.longitudinal, found.lateral, found.moment]);
        if let Some(status) = status {
            status[0] = match number(solved.status) {
                CREEPAGE_SOLVED if solved.left_out => CREEPAGE_UNLIKE_BODIES,
                number => number,
            };
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}
