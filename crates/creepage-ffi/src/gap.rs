//! C functions of contacts of any shape.

use std::ffi::c_char;

use creepage::{SiCreepage, SiForce, Status};
use creepage_study::{GapCase, GapFile, GapSolver, SolvedCase};

use crate::failure::{Failure, guard};
use crate::input::{array_mut, file, optional, optional_array, text};
use crate::status::{CREEPAGE_DOUBTFUL, CREEPAGE_NOT_CONVERGED, CREEPAGE_SOLVED};

thread_local! {
    /// A program asks again and again about the same contact.
    static SOLVER: GapSolver = GapSolver::default();
}

/// Presses two bodies of any shape together and rolls them: contact areas and forces.
///
/// path: the case file with a section gap, in TOML, files of points beside it; or the text of one, if
///   it has a line break.
/// points: 3 numbers a point, x, y and the undeformed distance there (m), of a rectangular grid in any
///   order, in place of the file's gap; NULL for the file's own.
/// point_count: their number.
/// creepage: 3 numbers, longitudinal and lateral creepage and spin (rad/m) at the origin of coordinates, in
///   place of what the file gives or wants; NULL for the file's own.
/// force: room for 3 numbers, those of the upper body on the lower: longitudinal force (N), lateral force
///   (N), moment about the origin (N m).
/// error: room for 3 numbers, the error bars of the force, NaN by a theory without; or NULL.
/// contact: room for 8 numbers, normal force (N), approach (m), area (m^2), largest pressure (Pa), then
///   their error bars; or NULL.
/// status: room for one number, CREEPAGE_SOLVED and so on; or NULL.
///
/// A call whose shape, materials and load or approach are those of one of the thread's last calls takes the
/// contact from there: it is much quicker, and its numbers are the same.
///
/// CREEPAGE_NOT_REACHABLE where no creepage gives the wanted forces; CREEPAGE_INVALID where the bodies
/// have no contact area.
///
/// # Safety
/// path ends with a zero byte; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_gap_force(
    path: *const c_char,
    points: *const f64,
    point_count: usize,
    creepage: *const f64,
    force: *mut f64,
    error: *mut f64,
    contact: *mut f64,
    status: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let path = unsafe { text("path", path) }?;
        // SAFETY: as before.
        let points = unsafe { optional_array("points", points, point_count, 3) }?;
        // SAFETY: as before.
        let creepage = unsafe { optional_array("creepage", creepage, 1, 3) }?;
        // SAFETY: as before.
        let force: &mut [[f64; 3]] = unsafe { array_mut("force", force, 1) }?;
        // SAFETY: as before.
        let error: Option<&mut [[f64; 3]]> = unsafe { optional(error, 1) }?;
        // SAFETY: as before.
        let contact: Option<&mut [[f64; 8]]> = unsafe { optional(contact, 1) }?;
        // SAFETY: as before.
        let status: Option<&mut [[i32; 1]]> = unsafe { optional(status, 1) }?;
        let asked = asked(path, points, creepage)?;
        let solved = SOLVER.with(|solver| solver.solve(&asked))?;
        force[0] = three(solved.force());
        if let Some([place]) = error {
            *place = solved.force_error().map_or([f64::NAN; 3], three);
        }
        if let Some([place]) = contact {
            *place = numbers(&solved);
        }
        if let Some([place]) = status {
            *place = [status_of(&solved)];
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

fn asked(path: &str, points: Option<&[f64]>, creepage: Option<&[f64]>) -> Result<GapCase, Failure> {
    let (text, directory) = file(path)?;
    let mut case = GapFile::read(&text)?.case(directory)?;
    if let Some(points) = points {
        case = case.with_grid(points.as_chunks().0)?;
    }
    if let Some(&[longitudinal, lateral, spin]) = creepage {
        case = case.at(SiCreepage { longitudinal, lateral, spin })?;
    }
    Ok(case)
}

fn numbers(solved: &SolvedCase) -> [f64; 8] {
    let [load, approach, area, peak] =
        [solved.load(), solved.approach(), solved.area(), solved.peak_pressure()];
    [
        load.value,
        approach.value,
        area.value,
        peak.value,
        load.error,
        approach.error,
        area.error,
        peak.error,
    ]
}

fn three(force: SiForce) -> [f64; 3] {
    [force.longitudinal, force.lateral, force.moment]
}

fn status_of(solved: &SolvedCase) -> i32 {
    match solved.solution().status {
        Status::NotConverged => CREEPAGE_NOT_CONVERGED,
        Status::Solved if solved.cautions.is_empty() => CREEPAGE_SOLVED,
        _ => CREEPAGE_DOUBTFUL,
    }
}
