//! From C's pointers to Rust's references.

use std::ffi::{CStr, c_char};
use std::{ptr, slice};

use creepage::rolling::Creepage;

use crate::failure::Failure;

/// A text.
///
/// # Safety
/// `text` is NULL or points to bytes that end with a zero, and stay as they are while it is used.
pub(crate) unsafe fn text<'a>(name: &'static str, text: *const c_char) -> Result<&'a str, Failure> {
    if text.is_null() {
        return Err(Failure::Null(name));
    }
    // SAFETY: not NULL, and the caller promises the rest.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map_err(|_| Failure::Text(name))
}

/// What a handle holds.
///
/// # Safety
/// `handle` is NULL or was made by this library and not freed.
pub(crate) unsafe fn handle<'a, T>(name: &'static str, handle: *const T) -> Result<&'a T, Failure> {
    // SAFETY: NULL is seen to, and the caller promises the rest.
    unsafe { handle.as_ref() }.ok_or(Failure::Null(name))
}

/// Where a new handle goes: NULL until there is one.
///
/// # Safety
/// `place` is NULL or has room for a handle.
pub(crate) unsafe fn place<'a, T>(
    name: &'static str,
    place: *mut *mut T,
) -> Result<&'a mut *mut T, Failure> {
    // SAFETY: NULL is seen to, and the caller promises the rest.
    let place = unsafe { place.as_mut() }.ok_or(Failure::Null(name))?;
    *place = ptr::null_mut();
    Ok(place)
}

/// Drops what a handle holds. NULL is left alone.
///
/// # Safety
/// `handle` is NULL, or of `Box::into_raw`, and not used again.
pub(crate) unsafe fn release<T>(handle: *mut T) {
    if !handle.is_null() {
        // SAFETY: the caller's promise is ours.
        drop(unsafe { Box::from_raw(handle) });
    }
}

/// An array of `per_case` numbers a case.
///
/// # Safety
/// `array` is NULL or holds `count * per_case` numbers that stay as they are while it is used.
unsafe fn array<'a>(
    name: &'static str,
    array: *const f64,
    count: usize,
    per_case: usize,
) -> Result<&'a [f64], Failure> {
    if array.is_null() {
        return Err(Failure::Null(name));
    }
    let length = length::<f64>(count, per_case)?;
    // SAFETY: not NULL, of a size that can be, and the caller promises the rest.
    Ok(unsafe { slice::from_raw_parts(array, length) })
}

/// An array to write to, of `per_case` numbers a case.
///
/// # Safety
/// `array` is NULL or has room for `count * per_case` numbers that nobody else uses meanwhile.
pub(crate) unsafe fn array_mut<'a, T>(
    name: &'static str,
    array: *mut T,
    count: usize,
    per_case: usize,
) -> Result<&'a mut [T], Failure> {
    // SAFETY: the caller's promise is ours.
    unsafe { optional(array, count, per_case) }?.ok_or(Failure::Null(name))
}

/// An array to write to that may be NULL.
///
/// # Safety
/// As of [`array_mut`].
pub(crate) unsafe fn optional<'a, T>(
    array: *mut T,
    count: usize,
    per_case: usize,
) -> Result<Option<&'a mut [T]>, Failure> {
    let length = length::<T>(count, per_case)?;
    if array.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL, of a size that can be, and the caller promises the rest.
    Ok(Some(unsafe { slice::from_raw_parts_mut(array, length) }))
}

/// Number of elements, if so many can be.
fn length<T>(count: usize, per_case: usize) -> Result<usize, Failure> {
    let length = count.checked_mul(per_case);
    length
        .filter(|length| *length <= isize::MAX.unsigned_abs() / size_of::<T>())
        .ok_or(Failure::Count(count))
}

/// The creepage of every case, and where its force goes.
///
/// # Safety
/// `creepages` and `forces` are NULL or hold three numbers a case, as of [`array`] and
/// [`array_mut`].
pub(crate) unsafe fn cases<'a>(
    count: usize,
    creepages: *const f64,
    forces: *mut f64,
) -> Result<impl Iterator<Item = (Creepage, &'a mut [f64; 3])>, Failure> {
    // SAFETY: the caller's promise is ours, here and below.
    let asked = self::creepages(unsafe { array("creepages", creepages, count, 3) }?)?;
    // SAFETY: as before.
    let forces = unsafe { array_mut("forces", forces, count, 3) }?;
    Ok(asked.zip(forces.as_chunks_mut().0))
}

/// The creepage of every case, all checked before any is solved. Nothing is allocated, which for
/// huge arrays might fail.
fn creepages(flat: &[f64]) -> Result<impl Iterator<Item = Creepage>, Failure> {
    let cases = flat.as_chunks::<3>().0;
    for (index, &[xi, eta, chi]) in cases.iter().enumerate() {
        Creepage::new(xi, eta, chi).map_err(|source| Failure::Case { index, source })?;
    }
    Ok(cases.iter().map(|&[xi, eta, chi]| Creepage { xi, eta, chi }))
}
