//! C functions of bulk cases: one case in SI units, solved for many rows.

use std::ffi::c_char;
use std::path::Path;
use std::sync::Arc;

use creepage::TheorySpec;
use creepage_study::{BulkAnswer, BulkCase, CaseFile, SolvedCase, Solver, Varied, solve};

use crate::failure::{Failure, guard, guard_words};
use crate::input::{array, array_mut, file, handle, optional, optional_text, place, release, text};
use crate::status::{CREEPAGE_NO_CASE, status};
use crate::table::CreepageTable;

/// A case file, read and checked.
// Never inside out: only pointers to it leave the library.
#[allow(missing_debug_implementations)]
pub struct CreepageCase {
    file: CaseFile,
    theory: TheorySpec,
    solver: Solver,
}

/// Reads a case file and keeps it.
///
/// path: the file, in TOML; or the text of one, if it has a line break.
/// theory: the theory to use, with its usual options unless it is the file's own; NULL for the
///   file's own.
/// made: becomes the handle, to be freed with creepage_case_free; NULL if the call fails.
///
/// # Safety
/// Texts end with a zero byte; made and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_case_new(
    path: *const c_char,
    theory: *const c_char,
    made: *mut *mut CreepageCase,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let place = unsafe { place("made", made) }?;
        // SAFETY: as before.
        let path = unsafe { text("path", path) }?;
        // SAFETY: as before.
        let theory = unsafe { optional_text("theory", theory) }?;
        *place = Box::into_raw(Box::new(CreepageCase::read(path, theory)?));
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a case. NULL is left alone.
///
/// # Safety
/// made is NULL, or of creepage_case_new, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_case_free(made: *mut CreepageCase) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(made) };
}

/// Forces in SI units of many cases that differ from the one of a file in some quantities, such as
/// a measured history; one after the other.
///
/// table: the table by which to look forces up; NULL for the case's theory.
/// quantities: what differs, by names with commas: longitudinal, lateral, spin (rad/m),
///   normal_force (N), friction, upper_radius_rolling, upper_radius_lateral,
///   lower_radius_rolling, lower_radius_lateral, semi_axis_rolling, semi_axis_lateral (m), speed
///   (m/s). A radius is infinite where the body is flat.
/// count: number of cases.
/// values: count times as many numbers as there are quantities, those of a case together.
/// forces: room for 3 count numbers, those of the upper body on the lower: longitudinal (N), lateral
///   (N), moment (N m).
/// dimensionless: room for 3 count numbers, f_x, f_y, m_z (1); or NULL.
/// errors: room for 3 count numbers, the error bars of f_x, f_y, m_z (1); or NULL.
/// powers: room for 2 count numbers, the energy turned to heat per metre rolled (J/m) and the
///   frictional power (W), which is NaN without a speed; or NULL.
/// statuses: room for count numbers, CREEPAGE_SOLVED and so on; or NULL.
///
/// Values that are no case, such as NaN, have NaN for numbers and the status CREEPAGE_NO_CASE; the
/// others are solved, the call does not fail, and message says what is wrong with the first.
/// CREEPAGE_UNSUPPORTED where errors are not NULL and there are no error bars.
///
/// # Safety
/// Handles are alive; quantities ends with a zero byte; arrays and message point to as much room as
/// said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_case_force(
    made: *const CreepageCase,
    table: *const CreepageTable,
    quantities: *const c_char,
    count: usize,
    values: *const f64,
    forces: *mut f64,
    dimensionless: *mut f64,
    errors: *mut f64,
    powers: *mut f64,
    statuses: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let case = unsafe { handle("made", made) }?;
        // SAFETY: as before; NULL is no table.
        let by_table = unsafe { table.as_ref() }
            .map(|CreepageTable { table }| Solver::of_table(Arc::clone(table)));
        let solver = by_table.as_ref().unwrap_or(&case.solver);
        // SAFETY: as before.
        let varied = quantities_of(unsafe { text("quantities", quantities) }?)?;
        let bulk =
            BulkCase::new(&case.file, varied).map_err(|error| Failure::Bulk(error.into()))?;
        let width = bulk.varied().len();
        // SAFETY: as before.
        let values = unsafe { array("values", values, count, width) }?;
        // SAFETY: as before.
        let mut out = unsafe {
            Out {
                forces: array_mut("forces", forces, count)?,
                dimensionless: optional(dimensionless, count)?,
                errors: optional(errors, count)?,
                powers: optional(powers, count)?,
                statuses: optional(statuses, count)?,
            }
        };
        if out.errors.is_some() && !solver.error_bars() {
            return Err(Failure::NoErrorBars(case.theory.facts().name));
        }
        let mut words = String::new();
        for (row, values) in values.chunks_exact(width.max(1)).enumerate() {
            let answer = bulk.solve_one(solver, values);
            if let (Err(error), true) = (&answer, words.is_empty()) {
                words = format!("case {row}: {error}");
            }
            out.put(row, answer.ok().as_ref());
        }
        Ok(words)
    };
    // SAFETY: as before.
    unsafe { guard_words(message, message_size, work) }
}

/// Where the answers go.
struct Out<'a> {
    forces: &'a mut [[f64; 3]],
    dimensionless: Option<&'a mut [[f64; 3]]>,
    errors: Option<&'a mut [[f64; 3]]>,
    powers: Option<&'a mut [[f64; 2]]>,
    statuses: Option<&'a mut [[i32; 1]]>,
}

impl Out<'_> {
    fn put(&mut self, row: usize, answer: Option<&BulkAnswer>) {
        let nothing = [f64::NAN; 3];
        let solution = answer.map(|answer| answer.reply.solution);
        self.forces[row] = answer.map_or(nothing, |answer| {
            let force = answer.force();
            [force.longitudinal, force.lateral, force.moment]
        });
        if let Some(dimensionless) = &mut self.dimensionless {
            dimensionless[row] = solution.map_or(nothing, |solution| solution.force.components());
        }
        if let Some(errors) = &mut self.errors {
            let error = solution.and_then(|solution| solution.error);
            errors[row] = error.map_or(nothing, |error| error.components());
        }
        if let Some(powers) = &mut self.powers {
            powers[row] = answer.map_or([f64::NAN; 2], |answer| {
                [answer.power_per_metre(), answer.power().unwrap_or(f64::NAN)]
            });
        }
        if let Some(statuses) = &mut self.statuses {
            statuses[row] =
                [answer.map_or(CREEPAGE_NO_CASE, |answer| status(&answer.reply.cautions))];
        }
    }
}

fn quantities_of(names: &str) -> Result<Vec<Varied>, Failure> {
    let named = |name: &str| {
        Varied::named(name.trim()).ok_or_else(|| Failure::Quantity { name: name.trim().into() })
    };
    let varied: Vec<_> = names.split(',').map(named).collect::<Result<_, _>>()?;
    let twice = (1..varied.len()).find(|k| varied[..*k].contains(&varied[*k]));
    match twice {
        Some(k) => Err(Failure::Quantity { name: format!("{} (twice)", varied[k].name()) }),
        None => Ok(varied),
    }
}

impl CreepageCase {
    fn read(path: &str, theory: Option<&str>) -> Result<Self, Failure> {
        let is_text = path.contains('\n');
        let named = Path::new(if is_text { "the text" } else { path });
        let (text, _) = file(path)?;
        let wrong = |source| Failure::CaseFile { path: named.into(), source };
        let case = CaseFile::read(&text).map_err(wrong)?;
        let own = case.theory().map_err(wrong)?;
        let theory = match theory {
            Some(name) if name != own.facts().name => TheorySpec::named(name)?,
            _ => own,
        };
        let solver = Solver::new(theory.clone());
        Ok(Self { file: case, theory, solver })
    }

    /// The one case of the file, by the theory that was chosen.
    pub(crate) fn solve(&self) -> Result<SolvedCase, Failure> {
        let path = || "the case".into();
        let case = self.file.case().map_err(|source| Failure::CaseFile { path: path(), source })?;
        let solved = solve(&case, Some(&self.theory));
        solved.map_err(|source| Failure::Solve { path: path(), source })
    }
}
