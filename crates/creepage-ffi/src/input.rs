//! Checked conversion of C pointers to Rust references.

use std::ffi::{CStr, c_char};
use std::path::Path;
use std::{fs, ptr, slice};

use creepage::Creepage;

use crate::failure::Failure;

/// A text.
///
/// # Safety
/// `text` is NULL or points to bytes that end with a zero, and stay as they are while it is used.
pub(crate) unsafe fn text<'a>(name: &'static str, text: *const c_char) -> Result<&'a str, Failure> {
    // SAFETY: the caller's promise is ours.
    unsafe { optional_text(name, text) }?.ok_or(Failure::Null(name))
}

/// A text that may be NULL.
///
/// # Safety
/// As of [`text`].
pub(crate) unsafe fn optional_text<'a>(
    name: &'static str,
    text: *const c_char,
) -> Result<Option<&'a str>, Failure> {
    if text.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL, and the caller promises the rest.
    let text = unsafe { CStr::from_ptr(text) };
    text.to_str().map(Some).map_err(|_| Failure::Text(name))
}

/// The text of a file and its directory; a path with a line break is the text itself.
pub(crate) fn file(path: &str) -> Result<(String, &Path), Failure> {
    if path.contains('\n') {
        return Ok((path.to_owned(), Path::new("")));
    }
    let place = Path::new(path);
    let read = |source| Failure::Read { path: place.into(), source };
    let text = fs::read_to_string(place).map_err(read)?;
    Ok((text, place.parent().unwrap_or(Path::new(""))))
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

/// An array to read from, of `width` numbers a case.
///
/// # Safety
/// `array` is NULL or points to `count * width` numbers that stay as they are while it is used.
pub(crate) unsafe fn array<'a>(
    name: &'static str,
    array: *const f64,
    count: usize,
    width: usize,
) -> Result<&'a [f64], Failure> {
    let length = count.checked_mul(width).ok_or(Failure::Count(count))?;
    fits::<f64>(length).map_err(|_| Failure::Count(count))?;
    if array.is_null() {
        return Err(Failure::Null(name));
    }
    // SAFETY: not NULL, of a size that can be, and the caller promises the rest.
    Ok(unsafe { slice::from_raw_parts(array, length) })
}

/// An array to read from that may be NULL.
///
/// # Safety
/// As of [`array`].
pub(crate) unsafe fn optional_array<'a>(
    name: &'static str,
    numbers: *const f64,
    count: usize,
    width: usize,
) -> Result<Option<&'a [f64]>, Failure> {
    if numbers.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's promise is ours.
    unsafe { array(name, numbers, count, width) }.map(Some)
}

/// An array to write to, of `W` elements a case.
///
/// # Safety
/// `array` is NULL or has room for `count * W` elements that nobody else uses meanwhile.
pub(crate) unsafe fn array_mut<'a, T, const W: usize>(
    name: &'static str,
    array: *mut T,
    count: usize,
) -> Result<&'a mut [[T; W]], Failure> {
    // SAFETY: the caller's promise is ours.
    unsafe { optional(array, count) }?.ok_or(Failure::Null(name))
}

/// An array to write to that may be NULL.
///
/// # Safety
/// As of [`array_mut`].
pub(crate) unsafe fn optional<'a, T, const W: usize>(
    array: *mut T,
    count: usize,
) -> Result<Option<&'a mut [[T; W]]>, Failure> {
    fits::<[T; W]>(count)?;
    if array.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL, of a size that can be, and the caller promises the rest.
    Ok(Some(unsafe { slice::from_raw_parts_mut(array.cast(), count) }))
}

/// Whether so many cases can be.
fn fits<T>(count: usize) -> Result<(), Failure> {
    let most = isize::MAX.unsigned_abs() / size_of::<T>();
    if count <= most { Ok(()) } else { Err(Failure::Count(count)) }
}

/// The creepage of every case, and where its force goes. All are checked before any is solved;
/// nothing is allocated, which for huge arrays might fail.
///
/// # Safety
/// `creepages` and `forces` are NULL or hold three numbers a case; those of `creepages` stay as
/// they are, and those of `forces` are used by nobody else meanwhile.
pub(crate) unsafe fn cases<'a>(
    count: usize,
    creepages: *const f64,
    forces: *mut f64,
) -> Result<impl Iterator<Item = (Creepage, &'a mut [f64; 3])>, Failure> {
    fits::<[f64; 3]>(count)?;
    if creepages.is_null() {
        return Err(Failure::Null("creepages"));
    }
    // SAFETY: not NULL, of a size that can be, and the caller promises the rest.
    let creepages: &[[f64; 3]] = unsafe { slice::from_raw_parts(creepages.cast(), count) };
    // SAFETY: the caller's promise is ours.
    let forces: &mut [[f64; 3]] = unsafe { array_mut("forces", forces, count) }?;
    let checked = |&[xi, eta, chi]: &[f64; 3]| Creepage::new(xi, eta, chi);
    for (index, creepage) in creepages.iter().enumerate() {
        checked(creepage).map_err(|source| Failure::Case { index, source })?;
    }
    Ok(creepages.iter().map(move |one| checked(one).unwrap_or_default()).zip(forces))
}
