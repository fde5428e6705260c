//! C functions of a wheelset on its rails, prepared once and solved position by position.

use std::ffi::c_char;

use creepage::Status;
use creepage_study::{
    ANSWERS, ASKED, SolvedWheelset, WheelsetCase, WheelsetDerivatives, WheelsetFile,
    WheelsetFileError, wheelset_cautions,
};
use rayon::prelude::*;

use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, file, handle, optional, place, release, text};
use crate::status::{CREEPAGE_DOUBTFUL, CREEPAGE_NOT_CONVERGED, CREEPAGE_SOLVED};

/// A wheelset file, read and checked.
// Never inside out: only pointers to it leave the library.
#[allow(missing_debug_implementations)]
pub struct CreepageWheelset {
    pub(crate) case: WheelsetCase,
}

/// A position of a wheelset, solved: from where a call may start.
#[allow(missing_debug_implementations)]
pub struct CreepageWheelsetState {
    solved: SolvedWheelset,
}

/// Numbers that a wheelset is asked by.
const ASK: usize = ASKED.len();

/// Reads a wheelset file and keeps it.
///
/// path: the file, in TOML, its profiles beside it; or the text of one, if it has a line break.
/// made: becomes the handle, to be freed with creepage_wheelset_free; NULL if the call fails.
///
/// # Safety
/// path ends with a zero byte; made and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_new(
    path: *const c_char,
    made: *mut *mut CreepageWheelset,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let place = unsafe { place("made", made) }?;
        // SAFETY: as before.
        let path = unsafe { text("path", path) }?;
        *place = Box::into_raw(Box::new(CreepageWheelset::read(path)?));
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a wheelset. NULL is left alone.
///
/// # Safety
/// made is NULL, or of creepage_wheelset_new, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_free(made: *mut CreepageWheelset) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(made) };
}

/// Solves a position and a motion of a wheelset. The same answer to the same question: without a start the
/// same bits whatever was asked before; with one, found from there, several times quicker where it is near (tenths of
/// a millimetre and of a milliradian), the same within the error bars.
///
/// asked: 12 numbers, NaN where the file's own holds: y (m, positive right), z (m, down), roll (rad), yaw
///   (rad, positive turns the axle's right end back), axle load (N), roll moment (N m, about x with which it
///   presses on the track under its axle load), speed (m/s), pitch rate (rad/s), lateral velocity, vertical
///   velocity (m/s), roll rate, yaw rate (rad/s). z or the axle load presses it.
/// start: a state that an earlier call gave, or NULL. It is not changed.
/// answers: room for 22 numbers in track axes, x forward, y right, z down: force (N) and moment about the
///   origin of the rail's profile (N m) on the left rail, then on the right; force and moment of the
///   rails on the wheelset about its centre; z (m), roll (rad), pitch rates of the left and of the right wheel
///   (rad/s). NaN for a side that is not solved.
/// derivatives: room for 96 numbers, or NULL: those of the first force by y, z (m), roll, yaw (rad), speed
///   (m/s), pitch rate (rad/s), lateral velocity (m/s), yaw rate (rad/s), then of the second of the 12 forces on the
///   rails, and so on. Total ones: what is free follows; NaN by what is free.
/// errors: room for as many, what differences may have made of each; or NULL.
/// status: room for one number, CREEPAGE_SOLVED and so on; or NULL.
/// state: becomes a state, to be freed with creepage_wheelset_state_free; or NULL. A state can be kept as long
///   as wanted, and asked from again, as after a step that was rejected.
///
/// # Safety
/// The handles are alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown, clippy::too_many_arguments)] // the words and places are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_solve(
    made: *const CreepageWheelset,
    asked: *const f64,
    start: *const CreepageWheelsetState,
    answers: *mut f64,
    derivatives: *mut f64,
    errors: *mut f64,
    status: *mut i32,
    state: *mut *mut CreepageWheelsetState,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let wheelset = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let asked = unsafe { array("asked", asked, 1, ASK) }?;
        // SAFETY: as before.
        let start = if start.is_null() { None } else { Some(unsafe { handle("start", start) }?) };
        // SAFETY: as before.
        let answers: &mut [[f64; ANSWERS.len()]] = unsafe { array_mut("answers", answers, 1) }?;
        // SAFETY: as before.
        let derivatives: Option<&mut [[f64; 96]]> = unsafe { optional(derivatives, 1) }?;
        // SAFETY: as before.
        let errors: Option<&mut [[f64; 96]]> = unsafe { optional(errors, 1) }?;
        // SAFETY: as before.
        let status: Option<&mut [[i32; 1]]> = unsafe { optional(status, 1) }?;
        let is_wanted = derivatives.is_some() || errors.is_some();
        let question = asked.first_chunk().ok_or(Failure::Count(1))?;
        let (solved, found) = wheelset.solve(question, start, is_wanted)?;
        answers.fill(solved.answers());
        if let (Some(place), Some(found)) = (derivatives, &found) {
            place.as_flattened_mut().copy_from_slice(found.values().as_flattened().as_flattened());
        }
        if let (Some(place), Some(found)) = (errors, &found) {
            place.as_flattened_mut().copy_from_slice(found.errors().as_flattened().as_flattened());
        }
        if let Some(place) = status {
            place.fill([status_of(&solved)]);
        }
        if !state.is_null() {
            // SAFETY: as before.
            let place = unsafe { place("state", state) }?;
            *place = Box::into_raw(Box::new(CreepageWheelsetState { solved }));
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a state. NULL is left alone.
///
/// # Safety
/// state is NULL, or of creepage_wheelset_solve, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_state_free(state: *mut CreepageWheelsetState) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(state) };
}

/// Solves many positions and motions on all cores, each by itself with the bits of creepage_wheelset_solve
/// without a start.
///
/// n: how many.
/// asked: n times 12 numbers, as of creepage_wheelset_solve.
/// answers: room for n times 22 numbers; NaN for one that cannot be solved.
/// statuses: room for n numbers, CREEPAGE_SOLVED and so on; CREEPAGE_NOT_CONVERGED for one that cannot be
///   solved.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_solve_many(
    made: *const CreepageWheelset,
    n: usize,
    asked: *const f64,
    answers: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let wheelset = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let asked = unsafe { array("asked", asked, n, ASK) }?;
        // SAFETY: as before.
        let answers: &mut [[f64; ANSWERS.len()]] = unsafe { array_mut("answers", answers, n) }?;
        // SAFETY: as before.
        let statuses: &mut [[i32; 1]] = unsafe { array_mut("statuses", statuses, n) }?;
        let places = answers.par_iter_mut().zip(statuses);
        asked.as_chunks().0.par_iter().zip(places).for_each(|(question, (answers, status))| {
            (*answers, *status) = match wheelset.solve(question, None, false) {
                Ok((solved, _)) => (solved.answers(), [status_of(&solved)]),
                Err(_) => ([f64::NAN; ANSWERS.len()], [CREEPAGE_NOT_CONVERGED]),
            };
        });
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

impl CreepageWheelset {
    fn read(path: &str) -> Result<Self, Failure> {
        let (text, directory) = file(path)?;
        let case = WheelsetFile::read(&text).map_err(WheelsetFileError::from)?.case(directory)?;
        case.solver()?;
        Ok(Self { case })
    }

    fn solve(
        &self,
        asked: &[f64; ASK],
        start: Option<&CreepageWheelsetState>,
        differentiates: bool,
    ) -> Result<(SolvedWheelset, Option<WheelsetDerivatives>), Failure> {
        let (stance, travel) = self.case.asked(asked)?;
        let solver = self.case.solver()?;
        let solved = match start {
            Some(start) => solver.follow(&start.solved, &stance, &travel),
            None => solver.solve(&stance, &travel),
        };
        let solved = solved.map_err(WheelsetFileError::from)?;
        let found = differentiates.then(|| solver.derivatives(&solved, &stance, &travel));
        let found = found.transpose().map_err(WheelsetFileError::from)?;
        Ok((solved, found))
    }
}

pub(crate) fn status_of(solved: &SolvedWheelset) -> i32 {
    match solved.status() {
        Status::NotConverged => CREEPAGE_NOT_CONVERGED,
        Status::Solved if wheelset_cautions(solved).is_empty() => CREEPAGE_SOLVED,
        _ => CREEPAGE_DOUBTFUL,
    }
}
