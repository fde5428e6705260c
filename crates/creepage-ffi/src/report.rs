//! C function of any quantity of a report, by its key.

use std::ffi::c_char;
use std::slice;

use creepage::TheorySpec;
use creepage_study::{
    AnyCaseFile, BearingCaseError, BearingFile, BearingReport, LineFile, LineTheory, Report,
    StaticsError, StaticsFile, StaticsReport, WheelsetFile, WheelsetFileError,
};

use crate::failure::{Failure, guard};
use crate::input::{array_mut, file, optional, optional_text, text};
use crate::status::status as status_of;
use crate::wheelset::status_of as status_of_wheelset;

/// Solves a case of any contact, a line contact, a wheelset, a bearing or a problem without rolling, and gives
/// quantities of its report.
///
/// path: the file in TOML, files of points and profiles beside it; or the text of one, if it has a line break.
/// theory: the name of a theory in place of the file's; NULL for the file's own, as for a bearing and without rolling.
/// count: number of quantities.
/// keys: their keys, with the section before a point, such as contact.peak_pressure_pa or lower_body.lateral_n: those of
///   report.json, which the guide lists with their units; of a wheelset left.force.lateral_n or left.patches.0.area_m2,
///   0 being the most loaded contact, of a bearing balls.0.inner.heat_w, without rolling found.shift_x_m. An unknown
///   key is CREEPAGE_TEXT.
/// values: room for count numbers, NaN for a quantity that is unknown.
/// errors: room for count numbers, their error bars, zero for what was given, NaN where nothing is known; or NULL.
/// status: room for one number, CREEPAGE_SOLVED and so on; or NULL.
///
/// CREEPAGE_NOT_REACHABLE where no creepage gives the wanted forces; CREEPAGE_INVALID where the bodies
/// have no contact area.
///
/// # Safety
/// path, theory and each of the keys end with a zero byte; arrays and message point to as much room as said.
#[allow(clippy::doc_markdown)] // the words are for C
#[unsafe(no_mangle)]
pub unsafe extern "C" fn creepage_report(
    path: *const c_char,
    theory: *const c_char,
    count: usize,
    keys: *const *const c_char,
    values: *mut f64,
    errors: *mut f64,
    status: *mut i32,
    message: *mut c_char,
    message_size: usize,
) -> i32 {
    let work = || {
        // SAFETY: the caller's promise of the function's documentation, here and below.
        let path = unsafe { text("path", path) }?;
        // SAFETY: as before.
        let theory = unsafe { optional_text("theory", theory) }?;
        // SAFETY: as before.
        let values: &mut [[f64; 1]] = unsafe { array_mut("values", values, count) }?;
        // SAFETY: as before.
        let mut errors: Option<&mut [[f64; 1]]> = unsafe { optional(errors, count) }?;
        // SAFETY: as before.
        let status: Option<&mut [[i32; 1]]> = unsafe { optional(status, 1) }?;
        if keys.is_null() {
            return Err(Failure::Null("keys"));
        }
        // SAFETY: not NULL, of a size that values have too, and the caller promises the rest.
        let keys = unsafe { slice::from_raw_parts(keys, count) };
        let (report, found) = solved(path, theory)?;
        for (k, (&key, place)) in keys.iter().zip(values).enumerate() {
            // SAFETY: as before.
            let [value, error] = quantity(&report, unsafe { text("keys", key) }?)?;
            *place = [value];
            if let Some(place) = errors.as_deref_mut().and_then(|all| all.get_mut(k)) {
                *place = [error];
            }
        }
        if let Some([place]) = status {
            *place = [found];
        }
        Ok(())
    };
    // SAFETY: as before.
    unsafe { guard(message, message_size, work) }
}

/// The report of a file of any kind, and how far it may be trusted.
fn solved(path: &str, theory: Option<&str>) -> Result<(Report, i32), Failure> {
    let (text, directory) = file(path)?;
    if WheelsetFile::is_one(&text) {
        let file = WheelsetFile::read(&text).map_err(WheelsetFileError::from)?;
        let mut case = file.case(directory)?;
        if let Some(name) = theory {
            case.theory = TheorySpec::named(name)?;
        }
        let solved = case.solve()?;
        return Ok((solved.report(), status_of_wheelset(&solved)));
    }
    if BearingFile::is_one(&text) {
        if theory.is_some() {
            return Err(Failure::BearingTheory);
        }
        let case = BearingFile::read(&text).and_then(|file| file.case());
        let solved = BearingReport::solve(case.map_err(BearingCaseError::from)?)?;
        return Ok((solved.report(), status_of(&solved.cautions())));
    }
    if StaticsFile::is_one(&text) {
        if theory.is_some() {
            return Err(Failure::StaticsTheory);
        }
        let wrong = |error: StaticsError| Failure::Statics(Box::new(error));
        let file = StaticsFile::read(&text).map_err(StaticsError::from);
        let case = file.and_then(|file| file.solve()).map_err(wrong)?;
        let report = StaticsReport::new(&case).map_err(wrong)?.report();
        return Ok((report, status_of(&case.cautions)));
    }
    if LineFile::is_one(&text) {
        let mut case = LineFile::read(&text).and_then(|file| file.case())?;
        if let Some(name) = theory {
            let named = LineTheory::named(name);
            case = case.by(named.ok_or_else(|| Failure::LineTheory { name: name.into() })?)?;
        }
        let solved = case.solve()?;
        return Ok((solved.report(), status_of(&solved.cautions)));
    }
    let case = AnyCaseFile::read(&text)?.case(directory)?;
    let other = theory.map(TheorySpec::named).transpose()?;
    let solved = case.solve(other.as_ref())?;
    Ok((solved.report(), status_of(&solved.cautions)))
}

/// Value and error bar of a quantity.
fn quantity(report: &Report, key: &str) -> Result<[f64; 2], Failure> {
    let found = report.find(key).ok_or_else(|| Failure::Key { key: key.into() })?;
    Ok([found.value, found.error].map(|number| number.unwrap_or(f64::NAN)))
}
