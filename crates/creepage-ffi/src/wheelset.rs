//! A wheelset on its rails, prepared once and asked position by position.

use std::ffi::c_char;
use std::sync::{Mutex, PoisonError};

use creepage::Status;
use creepage_study::{
    SolvedWheel, SolvedWheelset, Stance, Travel, WheelsetCase, WheelsetError, WheelsetFile,
};

use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, file, handle, optional, place, release, text};
use crate::status::{CREEPAGE_DOUBTFUL, CREEPAGE_NOT_CONVERGED, CREEPAGE_SOLVED};

/// A wheelset file, read and checked, and the position solved last.
// Never inside out: only pointers to it leave the library.
#[allow(missing_debug_implementations)]
pub struct CreepageWheelset {
    case: WheelsetCase,
    last: Mutex<Option<SolvedWheelset>>,
}

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

/// Forces on the rails where the wheelset stands and as it moves. Each call starts from the position
/// that the handle solved last: a near one is quicker. By the full theory one within 20 um and 0.2 mrad is solved
/// on a coarse grid, corrected by what a fine one added before: mostly within a tenth of that one's error bars. Where
/// the correction is too old for that, the fine grid is solved again.
///
/// position: 2 numbers, y (m, positive right) and yaw (rad, positive turns the axle's right end back);
///   what presses the wheelset on its rails is the file's.
/// motion: 4 numbers, speed (m/s), pitch rate (rad/s; NaN where it is free of torque), lateral velocity
///   (m/s), yaw rate (rad/s).
/// forces: room for 12 numbers in track axes, x forward, y right, z down: force (N) and moment about the
///   origin of the rail's profile (N m) on the left rail, then on the right; NaN for a side that is not
///   solved.
/// found: room for 3 numbers, height z (m), roll (rad), pitch rate (rad/s); or NULL.
/// statuses: room for one number, CREEPAGE_SOLVED and so on; or NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_force(
    made: *const CreepageWheelset,
    position: *const f64,
    motion: *const f64,
    forces: *mut f64,
    found: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let wheelset = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let position = unsafe { array("position", position, 1, 2) }?;
        // SAFETY: as before.
        let motion = unsafe { array("motion", motion, 1, 4) }?;
        // SAFETY: as before.
        let forces: &mut [[f64; 12]] = unsafe { array_mut("forces", forces, 1) }?;
        // SAFETY: as before.
        let found: Option<&mut [[f64; 3]]> = unsafe { optional(found, 1) }?;
        // SAFETY: as before.
        let statuses: Option<&mut [[i32; 1]]> = unsafe { optional(statuses, 1) }?;
        let (stance, travel) = wheelset.asked(position, motion)?;
        let solved = wheelset.solve(&stance, &travel)?;
        forces.as_flattened_mut().copy_from_slice(&on_rails(&solved));
        if let Some([place]) = found {
            let at = solved.position();
            *place = [at.z, at.roll, solved.motion.pitch_rate];
        }
        if let Some([place]) = statuses {
            *place = [status(&solved)];
        }
        wheelset.keep(solved);
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Forces on the rails and their derivatives. Total ones: what the file leaves free (height and roll
/// under a load, the pitch rate where it is NaN) follows what changes. By the position they are
/// differences over some micrometres, by the motion the theory's exact derivatives.
///
/// position, motion, forces: as of creepage_wheelset_force; forces may be NULL.
/// derivatives: room for 96 numbers, those of the first force by y, z (m), roll, yaw (rad), speed (m/s),
///   pitch rate (rad/s), lateral velocity (m/s), yaw rate (rad/s), then of the second, and so on; NaN by
///   what is free, and for a side that is not solved.
/// errors: room for as many, what the differences may have made of each; or NULL.
/// statuses: room for one number, CREEPAGE_SOLVED and so on; or NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_derivatives(
    made: *const CreepageWheelset,
    position: *const f64,
    motion: *const f64,
    forces: *mut f64,
    derivatives: *mut f64,
    errors: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let wheelset = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let position = unsafe { array("position", position, 1, 2) }?;
        // SAFETY: as before.
        let motion = unsafe { array("motion", motion, 1, 4) }?;
        // SAFETY: as before.
        let forces: Option<&mut [[f64; 12]]> = unsafe { optional(forces, 1) }?;
        // SAFETY: as before.
        let derivatives: &mut [[f64; 96]] = unsafe { array_mut("derivatives", derivatives, 1) }?;
        // SAFETY: as before.
        let errors: Option<&mut [[f64; 96]]> = unsafe { optional(errors, 1) }?;
        // SAFETY: as before.
        let statuses: Option<&mut [[i32; 1]]> = unsafe { optional(statuses, 1) }?;
        let (stance, travel) = wheelset.asked(position, motion)?;
        let solved = wheelset.solve(&stance, &travel)?;
        let wrong = |source| Failure::Wheelset(Box::new(source));
        let solver = wheelset.case.solver().map_err(wrong)?;
        let found = solver.derivatives(&solved, &stance, &travel).map_err(wrong)?;
        derivatives
            .as_flattened_mut()
            .copy_from_slice(found.values().as_flattened().as_flattened());
        if let Some(place) = errors {
            place.as_flattened_mut().copy_from_slice(found.errors().as_flattened().as_flattened());
        }
        if let Some([place]) = forces {
            *place = on_rails(&solved);
        }
        if let Some([place]) = statuses {
            *place = [status(&solved)];
        }
        wheelset.keep(solved);
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

impl CreepageWheelset {
    fn read(path: &str) -> Result<Self, Failure> {
        let wrong = |source: WheelsetError| Failure::Wheelset(Box::new(source));
        let (text, directory) = file(path)?;
        let wheelset = WheelsetFile::read(&text).map_err(|error| wrong(error.into()))?;
        let case = wheelset.case(directory).map_err(wrong)?;
        case.solver().map_err(wrong)?;
        Ok(Self { case, last: Mutex::default() })
    }

    fn asked(&self, position: &[f64], motion: &[f64]) -> Result<(Stance, Travel), Failure> {
        let (&[y, yaw], &[speed, pitch_rate, lateral_velocity, yaw_rate]) = (position, motion)
        else {
            return Err(Failure::Count(1));
        };
        let stance = Stance { y, yaw, ..self.case.stance };
        let pitch_rate = (!pitch_rate.is_nan()).then_some(pitch_rate);
        Ok((stance, Travel { speed, pitch_rate, lateral_velocity, yaw_rate, ..Travel::default() }))
    }

    fn solve(&self, stance: &Stance, travel: &Travel) -> Result<SolvedWheelset, Failure> {
        let last = self.last.lock().unwrap_or_else(PoisonError::into_inner).take();
        let wrong = |source| Failure::Wheelset(Box::new(source));
        let solver = self.case.solver().map_err(wrong)?;
        let near = last.as_ref().and_then(|last| solver.follow(last, stance, travel).ok());
        near.map_or_else(|| solver.solve(stance, travel).map_err(wrong), Ok)
    }

    fn keep(&self, solved: SolvedWheelset) {
        *self.last.lock().unwrap_or_else(PoisonError::into_inner) = Some(solved);
    }
}

/// On the left and on the right rail; NaN for a wheel that is not solved.
fn on_rails(solved: &SolvedWheelset) -> [f64; 12] {
    let mut all = [f64::NAN; 12];
    for (place, wheel) in all.chunks_exact_mut(6).zip([&solved.left, &solved.right]) {
        if let Some(on_rail) = wheel.as_ref().map(SolvedWheel::on_rail) {
            place.copy_from_slice([on_rail.force, on_rail.moment].as_flattened());
        }
    }
    all
}

fn status(solved: &SolvedWheelset) -> i32 {
    match solved.status() {
        Status::NotConverged => CREEPAGE_NOT_CONVERGED,
        Status::Solved if solved.cautions().is_empty() => CREEPAGE_SOLVED,
        _ => CREEPAGE_DOUBTFUL,
    }
}
