//! C functions of transient rolling, step by step; steps can be taken back.

use std::ffi::c_char;
use std::sync::{Mutex, MutexGuard, PoisonError};

use creepage::Status;
use creepage::unsteady::Rolled;
use creepage_study::{RollFile, RollStepper};

use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, file, handle, optional, place, release, text};
use crate::status::{CREEPAGE_DOUBTFUL, CREEPAGE_NOT_CONVERGED, CREEPAGE_SOLVED};

/// A contact and what it remembers.
// Never inside out: only pointers to it leave the library.
#[allow(missing_debug_implementations)]
pub struct CreepageRolling {
    stepper: Mutex<RollStepper>,
}

/// Prepares a contact that rolls, in the state that its case file names.
///
/// path: the file, in TOML, as of the command creepage roll; or the text of one, if it has a line break.
/// made: becomes the handle, to be freed with creepage_rolling_free; NULL if the call fails.
///
/// # Safety
/// path ends with a zero byte; made and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_rolling_new(
    path: *const c_char,
    made: *mut *mut CreepageRolling,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let place = unsafe { place("made", made) }?;
        // SAFETY: as before.
        let path = unsafe { text("path", path) }?;
        *place = Box::into_raw(Box::new(CreepageRolling::read(path)?));
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a contact that rolls. NULL is left alone.
///
/// # Safety
/// made is NULL, or of creepage_rolling_new, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_rolling_free(made: *mut CreepageRolling) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(made) };
}

/// Rolls on. If the call fails, the contact is as it was.
///
/// distance: length of the step (m), positive; finer steps in between are the library's affair.
/// motion: 3 numbers, longitudinal, lateral and spin: each a creepage (spin in rad/m) or the force on the
///   lower body (N; moment N m) that it is to have.
/// held: 3 numbers, not zero where that of motion is a force; or NULL if all are creepages. A line
///   contact has no spin: its number is 0, and a creepage.
/// normal_force: in the step (N), zero where the bodies separate; NaN for that of the case file.
/// forces: room for 3 numbers, longitudinal and lateral force (N) and moment (N m) on the lower body at
///   the end of the step; of a line contact per metre.
/// creepages: room for 3 numbers, those of the end of the step, given or found; or NULL.
/// adhesion: room for one number, the share of the contact area that adheres; or NULL.
/// statuses: room for one number, CREEPAGE_SOLVED and so on; or NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[allow(clippy::too_many_arguments)] // C has no keywords
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_rolling_step(
    made: *const CreepageRolling,
    distance: f64,
    motion: *const f64,
    held: *const i32,
    normal_force: f64,
    forces: *mut f64,
    creepages: *mut f64,
    adhesion: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let rolling = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let motion = unsafe { array("motion", motion, 1, 3) }?;
        // SAFETY: NULL is seen to, and the caller promises the rest.
        let held = unsafe { held.cast::<[i32; 3]>().as_ref() }.copied().unwrap_or_default();
        // SAFETY: as before.
        let forces: &mut [[f64; 3]] = unsafe { array_mut("forces", forces, 1) }?;
        // SAFETY: as before.
        let creepages: Option<&mut [[f64; 3]]> = unsafe { optional(creepages, 1) }?;
        // SAFETY: as before.
        let adhesion: Option<&mut [[f64; 1]]> = unsafe { optional(adhesion, 1) }?;
        // SAFETY: as before.
        let statuses: Option<&mut [[i32; 1]]> = unsafe { optional(statuses, 1) }?;
        let (rolled, force, creepage) = rolling.step(distance, motion, held, normal_force)?;
        forces.copy_from_slice(&[force]);
        if let Some(creepages) = creepages {
            creepages.copy_from_slice(&[creepage]);
        }
        if let Some([place]) = adhesion {
            *place = [rolled.adhesion_share];
        }
        if let Some([place]) = statuses {
            *place = [status(rolled.solution.status)];
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Writes what the contact remembers, to go back to it with creepage_rolling_restore: for a step that is
/// rejected later, or to go on in another run.
///
/// state: room for size bytes; or NULL to ask for needed only.
/// needed: becomes the number of bytes that the state has now; it changes from step to step. If size is
///   smaller, nothing is written to state and CREEPAGE_ROOM is returned.
///
/// # Safety
/// The handle is alive; state, needed and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_rolling_save(
    made: *const CreepageRolling,
    state: *mut u8,
    size: usize,
    needed: *mut usize,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let rolling = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let needed = unsafe { array_mut::<usize, 1>("needed", needed, 1) }?;
        let saved = rolling.lock().save();
        needed.copy_from_slice(&[[saved.len()]]);
        // SAFETY: as before.
        let state: Option<&mut [[u8; 1]]> = unsafe { optional(state, size) }?;
        let Some(state) = state else { return Ok(()) };
        let room = Failure::Room { size, needed: saved.len() };
        let state = state.as_flattened_mut().get_mut(..saved.len()).ok_or(room)?;
        state.copy_from_slice(&saved);
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Goes back, or on, to what creepage_rolling_save wrote: the steps after it are the same to the last
/// bit. If the call fails, the contact is as it was.
///
/// state: the bytes, as many as needed said.
///
/// # Safety
/// The handle is alive; state and message point to as much as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_rolling_restore(
    made: *const CreepageRolling,
    state: *const u8,
    size: usize,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let rolling = unsafe { handle("made", made) }?;
        // SAFETY: as before; nothing is written.
        let state: &mut [[u8; 1]] = unsafe { array_mut("state", state.cast_mut(), size) }?;
        Ok(rolling.lock().restore(state.as_flattened())?)
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

impl CreepageRolling {
    fn read(path: &str) -> Result<Self, Failure> {
        let (text, directory) = file(path)?;
        let case = RollFile::read(&text)?.case(directory)?;
        let stepper = RollStepper::new(case)?;
        Ok(Self { stepper: Mutex::new(stepper) })
    }

    fn lock(&self) -> MutexGuard<'_, RollStepper> {
        self.stepper.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What a step leads to, and its force and creepage in SI units.
    fn step(
        &self,
        distance: f64,
        motion: &[f64],
        held: [i32; 3],
        normal_force: f64,
    ) -> Result<(Rolled, [f64; 3], [f64; 3]), Failure> {
        let mut stepper = self.lock();
        let mut given = vec![("distance", distance)];
        for (k, (value, held)) in motion.iter().zip(held).enumerate() {
            let names = if held == 0 { CREEPAGES } else { FORCES };
            // What is not given is zero creepage; not all that a line contact may be given.
            if held != 0 || *value != 0.0 {
                given.push((names[k], *value));
            }
        }
        if !normal_force.is_nan() {
            given.push(("normal_force", normal_force));
        }
        let rolled = stepper.step(&given)?;
        let units = stepper.case().scaling;
        let (force, creepage) =
            (units.si_force(rolled.solution.force), units.si_creepage(rolled.creepage));
        let force = [force.longitudinal, force.lateral, force.moment];
        Ok((rolled, force, [creepage.longitudinal, creepage.lateral, creepage.spin]))
    }
}

const CREEPAGES: [&str; 3] = ["longitudinal", "lateral", "spin"];
const FORCES: [&str; 3] = ["longitudinal_force", "lateral_force", "moment"];

fn status(status: Status) -> i32 {
    match status {
        Status::Solved => CREEPAGE_SOLVED,
        Status::NotConverged => CREEPAGE_NOT_CONVERGED,
        _ => CREEPAGE_DOUBTFUL,
    }
}
