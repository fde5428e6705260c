//! Wheels that roll in steps, by a table.

use std::ffi::c_char;
use std::slice;

use creepage_study::{
    StepsStart, WHEEL_STEP_NUMBERS, WheelStepsRun, WheelTable, WheelsetCase, WheelsetFileError,
};

use crate::failure::{Failure, guard};
use crate::input::{array, array_mut, handle, text};
use crate::wheelset::{CreepageWheelset, status_of};

/// Rolls a wheelset in steps through a table of positions: its contacts remember their tractions. The numbers of
/// `creepage roll` with a wheelset file, to the last bit. The theory is "exact", and the pitch rate given.
///
/// start: 0 without traction, 1 as if the first row's motion had always been, -1 as the file says.
/// count: number of columns.
/// names: their names: distance (m), which is needed and rises from row to row; s (m) and pitch (rad), where surfaces
///   vary along rolling; wheel_load (N) of one wheel; y, z (m), roll, yaw (rad), axle_load (N), roll_moment (N m),
///   speed (m/s), pitch_rate (rad/s), lateral_velocity, vertical_velocity (m/s), roll_rate, yaw_rate (rad/s). An
///   unknown name is CREEPAGE_TEXT. What is left out is the file's own.
/// rows: number of rows. A row's motion acts from the distance of the row before, or zero, to its own.
/// values: rows times count numbers, row by row; NaN where the file's own holds.
/// found: room for rows times 19 numbers: distance (m); of the left wheel the force on its rail in track axes, x
///   forward, y right, z down (N), the sum of normal forces (N), the peak pressure (Pa), the number of contacts and
///   the share of their area that adheres; the same of the right wheel; how many contacts appeared, vanished, split
///   and joined in this row. NaN for a side that is not solved.
/// statuses: room for rows numbers, CREEPAGE_SOLVED and so on.
///
/// Where a row cannot be solved the message names it, and the rows before it are written.
///
/// # Safety
/// The handle is alive; each of the names ends with a zero byte; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown, clippy::too_many_arguments)] // the words and places are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_wheelset_roll(
    made: *const CreepageWheelset,
    start: i32,
    count: usize,
    names: *const *const c_char,
    rows: usize,
    values: *const f64,
    found: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let wheelset = unsafe { handle("made", made) }?;
        // SAFETY: as before.
        let values = unsafe { array("values", values, rows, count) }?;
        // SAFETY: as before.
        let found: &mut [[f64; WHEEL_STEP_NUMBERS]] = unsafe { array_mut("found", found, rows) }?;
        // SAFETY: as before.
        let statuses: &mut [[i32; 1]] = unsafe { array_mut("statuses", statuses, rows) }?;
        if names.is_null() {
            return Err(Failure::Null("names"));
        }
        // SAFETY: not NULL, of a size that values have too, and the caller promises the rest.
        let names = unsafe { slice::from_raw_parts(names, count) };
        let named = names.iter().enumerate().map(|(column, &name)| {
            // SAFETY: as before.
            let name = unsafe { text("names", name) }?;
            let numbers = values.iter().skip(column).step_by(count).copied();
            Ok((name, numbers.collect::<Vec<f64>>()))
        });
        let columns = named.collect::<Result<Vec<_>, Failure>>()?;
        let given: Vec<_> = columns.iter().map(|(name, numbers)| (*name, &numbers[..])).collect();
        let table = WheelTable::from_columns(&given)?;
        let case = started(&wheelset.case, start)?;
        roll(&case, &table, found.iter_mut().zip(statuses))
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

fn started(case: &WheelsetCase, start: i32) -> Result<WheelsetCase, Failure> {
    let start = match start {
        -1 => case.start,
        0 => StepsStart::Pressed,
        1 => StepsStart::Steady,
        other => return Err(Failure::Start(other)),
    };
    Ok(WheelsetCase { start, ..case.clone() })
}

fn roll<'a>(
    case: &WheelsetCase,
    table: &WheelTable,
    places: impl Iterator<Item = (&'a mut [f64; WHEEL_STEP_NUMBERS], &'a mut [i32; 1])>,
) -> Result<(), Failure> {
    let mut run = WheelStepsRun::new(case, table)?;
    for (index, (numbers, status)) in places.enumerate() {
        let of_row =
            |source: WheelsetFileError| Failure::Row { row: index + 1, source: Box::new(source) };
        let Some((distance, stepped)) = run.next_row().map_err(of_row)? else { break };
        *numbers = WheelStepsRun::numbers(distance, &stepped);
        *status = [status_of(&stepped.solved)];
    }
    Ok(())
}
