//! C functions of case files.

use std::ffi::c_char;
use std::fs;
use std::path::Path;

use creepage_study::{CaseFile, SolvedCase, solve};

use crate::failure::{Failure, guard};
use crate::input::{array_mut, optional, optional_text, text};
use crate::status::status;

/// Solves a case file: creepages to forces, or with a section `wanted` forces to creepages.
///
/// path: the file, in TOML; `creepage init` writes an example.
/// theory: the theory to use, with its usual options unless it is the file's own; NULL for the
///   file's own.
/// creepage: room for 3 numbers, those of the upper body relative to the lower, given or found:
///   longitudinal creepage, lateral creepage, spin (rad/m); or NULL.
/// force: room for 3 numbers, those of the upper body on the lower: longitudinal force (N),
///   lateral force (N), moment (N m).
/// status: room for one number, CREEPAGE_SOLVED and so on; or NULL. CREEPAGE_UNLIKE_BODIES where
///   the theory takes bodies for alike whose difference matters, CREEPAGE_ACCURACY_NOT_REACHED
///   where no resolution has error bars within the accuracy of the file.
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
        // SAFETY: as before.
        let theory = unsafe { optional_text("theory", theory) }?;
        // SAFETY: as before.
        let creepage = unsafe { optional(creepage, 1) }?;
        // SAFETY: as before.
        let force = unsafe { array_mut("force", force, 1) }?;
        // SAFETY: as before.
        let status = unsafe { optional(status, 1) }?;
        let solved = solve_file(path, theory)?;
        if let Some(creepage) = creepage {
            let found = solved.scaling().si_creepage(solved.creepage());
            creepage[0] = [found.longitudinal, found.lateral, found.spin];
        }
        let found = solved.scaling().si_force(solved.solution().force);
        force[0] = [found.longitudinal, found.lateral, found.moment];
        if let Some(status) = status {
            status[0] = [self::status(&solved.cautions)];
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// The case of a file by its own theory, or by the one of that name.
fn solve_file(path: &Path, theory: Option<&str>) -> Result<SolvedCase, Failure> {
    let text =
        fs::read_to_string(path).map_err(|source| Failure::Read { path: path.into(), source })?;
    let directory = path.parent().unwrap_or(Path::new(""));
    let case = CaseFile::read(&text).and_then(|file| file.case_in(directory));
    let case = case.map_err(|source| Failure::CaseFile { path: path.into(), source })?;
    let theory = theory.map(|name| case.theory_named(name)).transpose()?;
    solve(&case, theory.as_ref()).map_err(|source| Failure::Solve { path: path.into(), source })
}
