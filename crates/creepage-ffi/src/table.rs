//! C functions of tables of creep force.

use std::ffi::c_char;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

use creepage::table::{Axis, Intervals, Provenance, Spec, Table, build};
use creepage::{Contact, Ellipse};
use creepage_study::{Caution, WholeFile, theory_spec};

use crate::failure::{Failure, guard};
use crate::input::{
    array, array_mut, cases, handle, optional, optional_text, place, release, text,
};
use crate::status::{CREEPAGE_SOLVED, CREEPAGE_UNLIKE_BODIES};

/// A table of creep force, as `creepage table build` makes it.
#[derive(Debug)]
pub struct CreepageTable {
    pub(crate) table: Arc<Table>,
}

/// Reads a table.
///
/// path: the file.
/// table: becomes the handle, to be freed with creepage_table_free; NULL if the call fails.
///
/// # Safety
/// path ends with a zero byte; table and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_table_read(
    path: *const c_char,
    table: *mut *mut CreepageTable,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation.
        let place = unsafe { place("table", table) }?;
        // SAFETY: as before.
        let path = Path::new(unsafe { text("path", path) }?);
        let bytes = fs::read(path).map_err(|source| Failure::Read { path: path.into(), source })?;
        let table = Table::from_bytes(bytes)
            .map_err(|source| Failure::Table { path: path.into(), source })?;
        *place = Box::into_raw(Box::new(CreepageTable { table: Arc::new(table) }));
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Builds a table of a theory, on all cores, and measures its error.
///
/// theory, options: as of creepage_theory_new.
/// a_over_b: 2 numbers, the first and the last ratio of the semi-axes (1); the same for one only.
/// shapes: number of ratios, in equal steps of their logarithm; 1 for one only.
/// poisson: 2 numbers, the first and the last of Poisson's ratios (1).
/// materials: number of Poisson's ratios; 1 for one only.
/// intervals: 3 numbers, along theta, phi (even) and t; NULL for the usual 20, 16, 48.
/// places: at how many random places the error is measured, and at about as many where the force bends
///   most; 500 is usual.
/// table: becomes the handle, to be freed with creepage_table_free; NULL if the call fails.
///
/// # Safety
/// Texts end with a zero byte; arrays, table and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_table_build(
    theory: *const c_char,
    options: *const c_char,
    a_over_b: *const f64,
    shapes: usize,
    poisson: *const f64,
    materials: usize,
    intervals: *const usize,
    places: usize,
    table: *mut *mut CreepageTable,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work =
        || {
            // SAFETY: the caller's promise of the function's documentation, here and below.
            let place = unsafe { place("table", table) }?;
            // SAFETY: as before.
            let name = unsafe { text("theory", theory) }?;
            // SAFETY: as before.
            let options = unsafe { optional_text("options", options) }?.unwrap_or_default();
            // SAFETY: as before.
            let (a_over_b, poisson) =
                unsafe { (array("a_over_b", a_over_b, 1, 2)?, array("poisson", poisson, 1, 2)?) };
            // SAFETY: as before; NULL is seen to.
            let intervals = unsafe { intervals.cast::<[usize; 3]>().as_ref() };
            let intervals = intervals
                .map_or_else(Intervals::default, |&[theta, phi, t]| Intervals { theta, phi, t });
            let theory = theory_spec(name, &[options])?;
            let provenance = Provenance {
                theory: theory.facts().name.into(),
                options: options.into(),
                program: format!("creepage {}", env!("CARGO_PKG_VERSION")),
            };
            let (a_over_b, poisson) = (axis(a_over_b, shapes), axis(poisson, materials));
            let spec = Spec { a_over_b, poisson, intervals, places, provenance };
            let built = build(&spec, |contact| theory.prepare(contact), &|| {});
            let built =
                built.map_err(|source| Failure::Build { theory: theory.facts().name, source })?;
            *place = Box::into_raw(Box::new(CreepageTable { table: Arc::new(built) }));
            Ok(())
        };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// The nodes from the first to the last of two numbers.
fn axis(ends: &[f64], nodes: usize) -> Axis {
    let (low, high) = (ends.first(), ends.last());
    let [low, high] = [low, high].map(|end| end.copied().unwrap_or(f64::NAN));
    Axis { low, high, nodes }
}

/// Writes a table to a file, which appears when it is whole.
///
/// # Safety
/// The handle is alive; path ends with a zero byte; message points to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_table_write(
    table: *const CreepageTable,
    path: *const c_char,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let table = &unsafe { handle("table", table) }?.table;
        // SAFETY: as before.
        let path = Path::new(unsafe { text("path", path) }?);
        let bytes =
            table.to_bytes().map_err(|source| Failure::Table { path: path.into(), source })?;
        let write = || {
            let mut file = WholeFile::create(path)?;
            file.write_all(&bytes)?;
            file.finish()
        };
        write().map_err(|source| Failure::Write { path: path.into(), source })
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Frees a table. NULL is left alone.
///
/// # Safety
/// table is NULL, or of creepage_table_read or creepage_table_build, and not used again.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_table_free(table: *mut CreepageTable) {
    // SAFETY: it was made by `Box::into_raw`, and the caller gives it up.
    unsafe { release(table) };
}

/// The largest error of the table against its theory at random places and where the force bends
/// most, as measured when the table was built.
///
/// errors: room for 2 numbers, of the force in parts of mu N and of the moment in parts of
///   mu N c (1).
///
/// # Safety
/// The handle is alive; errors and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_table_error(
    table: *const CreepageTable,
    errors: *mut f64,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let accuracy = unsafe { handle("table", table) }?.table.accuracy();
        // SAFETY: as before.
        let errors = unsafe { array_mut("errors", errors, 1) }?;
        errors[0] = [accuracy.force.worst, accuracy.moment.worst];
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// Looks many forces up, for one contact.
///
/// a_over_b: semi-axis along over semi-axis across the rolling direction, within the table's
///   range (1).
/// poisson: combined Poisson's ratio, within the table's range (1).
/// kappa_over_mu: how dissimilar the bodies are, as of creepage_theory_new. A table neglects it;
///   status says where it matters.
/// count: number of cases.
/// creepages: 3 count numbers, xi, eta, chi of each case (1).
/// forces: room for 3 count numbers, f_x, f_y, m_z of each case (1).
/// derivatives: room for 9 count numbers; or NULL. Of each case the derivative of f_x by xi, by
///   eta and by chi, then of f_y, then of m_z (1).
/// status: room for one number, that of all cases: CREEPAGE_SOLVED or CREEPAGE_UNLIKE_BODIES; or
///   NULL.
///
/// # Safety
/// The handle is alive; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_table_force(
    table: *const CreepageTable,
    a_over_b: f64,
    poisson: f64,
    kappa_over_mu: f64,
    count: usize,
    creepages: *const f64,
    forces: *mut f64,
    derivatives: *mut f64,
    status: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let slice = unsafe { handle("table", table) }?.table.at(a_over_b, poisson)?;
        let contact = Contact::new(Ellipse::from_ratio(a_over_b)?, poisson)?;
        let contact = contact.with_kappa_over_mu(kappa_over_mu)?;
        // SAFETY: as before.
        let cases = unsafe { cases(count, creepages, forces) }?;
        // SAFETY: as before.
        let mut derivatives = unsafe { optional::<_, 9>(derivatives, count) }?;
        // SAFETY: as before.
        let status = unsafe { optional::<_, 1>(status, 1) }?;
        for (case, (creepage, out)) in cases.enumerate() {
            let force = if let Some(derivatives) = &mut derivatives {
                let (force, derivative) = slice.force_and_derivative(creepage);
                derivatives[case].copy_from_slice(derivative.as_flattened());
                force
            } else {
                slice.force(creepage)
            };
            *out = force.components();
        }
        if let Some(status) = status {
            let matters = contact.kappa_over_mu().abs() >= Caution::DISSIMILAR;
            status[0] = [if matters { CREEPAGE_UNLIKE_BODIES } else { CREEPAGE_SOLVED }];
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}
