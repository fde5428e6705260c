//! C functions of contact maps of wheelsets: read from a file, asked state by state.

use std::ffi::c_char;
use std::fs;
use std::path::Path;

use creepage_map::{Answer, ContactMap, VARIABLES};

use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, handle, optional, place, release, text};

/// A contact map, as `creepage map` makes it.
#[derive(Debug)]
pub struct CreepageMap {
    map: ContactMap,
}

/// Reads a contact map.
///
/// path: the file.
/// map: becomes the handle, to be freed with creepage_map_free; NULL if the call fails.
///
/// # Safety
/// path ends with a zero byte; map and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_map_load(
    path: *const c_char,
    map: *mut *mut CreepageMap,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let place = unsafe { place("map", map) }?;
        // SAFETY: as before.
        let path = Path::new(unsafe { text("path", path) }?);
        let bytes = fs::read(path).map_err(|source| Failure::Read { path: path.into(), source })?;
        let map = ContactMap::from_bytes(bytes)
            .map_err(|source| Failure::Map { path: path.into(), source })?;
        *place = Box::into_raw(Box::new(CreepageMap { map }));
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a map. NULL is left alone.
///
/// # Safety
/// map is NULL, or of creepage_map_load, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_map_free(map: *mut CreepageMap) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(map) };
}

/// Forces on the rails, looked up: some microseconds each, the same bits whatever was asked before, by any
/// number of threads. What lies outside the map is an error (CREEPAGE_INVALID) whose words name the state and the bound;
/// answers of the states before it are written.
///
/// count: number of states.
/// states: 12 count numbers, of each state y (m), z (m, down), roll (rad), yaw (rad), axle load (N), speed
///   (m/s), pitch rate (rad/s), lateral and vertical velocity (m/s), roll rate, yaw rate (rad/s),
///   friction; NaN is the wheelset's own, of z and axle load one presses it.
/// answers: room for 21 count numbers, of each state in track axes, x forward, y right, z down: force (N) and
///   moment about the origin of the rail's profile (N m) on the left rail, then on the right; force and moment
///   of the rails on the wheelset about its centre; z (m), roll (rad), pitch rate (rad/s).
/// errors: room for 4 count numbers, the map's largest measured error at the left wheel, of the tangential
///   force in parts of mu N and of the normal force in parts of N, then at the right wheel; or NULL.
/// derivatives: room for 96 count numbers, of each state those of the first force on the left rail by y, z,
///   roll, yaw, speed, pitch rate, lateral velocity, yaw rate, then of the second force; NaN by what is found;
///   or NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_map_solve(
    map: *const CreepageMap,
    count: usize,
    states: *const f64,
    answers: *mut f64,
    errors: *mut f64,
    derivatives: *mut f64,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let map = &unsafe { handle("map", map) }?.map;
        // SAFETY: as before.
        let states: &[[f64; 12]] = unsafe { array("states", states, count, 12) }?.as_chunks().0;
        // SAFETY: as before.
        let answers: &mut [[f64; 21]] = unsafe { array_mut("answers", answers, count) }?;
        // SAFETY: as before.
        let mut errors: Option<&mut [[f64; 4]]> = unsafe { optional(errors, count) }?;
        // SAFETY: as before.
        let mut derivatives: Option<&mut [[f64; 12 * VARIABLES]]> =
            unsafe { optional(derivatives, count) }?;
        for (index, (row, out)) in states.iter().zip(answers).enumerate() {
            let state = map.head().own.with(row);
            let wrong = |source| Failure::State { index, source };
            let answer = match derivatives.as_deref_mut().and_then(|all| all.get_mut(index)) {
                Some(place) => {
                    let (answer, by) = map.solve_with_derivatives(&state).map_err(wrong)?;
                    place.copy_from_slice(by.as_flattened().as_flattened());
                    answer
                }
                None => map.solve(&state).map_err(wrong)?,
            };
            *out = answer.numbers();
            if let Some(place) = errors.as_deref_mut().and_then(|all| all.get_mut(index)) {
                *place = errors_of(&answer);
            }
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

fn errors_of(answer: &Answer) -> [f64; 4] {
    let [left, right] = [answer.left.error, answer.right.error];
    [left.tangential, left.normal, right.tangential, right.normal]
}
