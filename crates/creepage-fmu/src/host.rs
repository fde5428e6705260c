//! What both versions of the interface share: statuses, arrays of the host, kept states.

use std::ffi::c_int;
use std::ptr;

use crate::instance::{Inputs, STATE_BYTES};
use crate::variables::{INPUTS, real};

pub(crate) type Status = c_int;
pub(crate) const OK: Status = 0;
pub(crate) const DISCARD: Status = 2;
pub(crate) const ERROR: Status = 3;

/// An array of the host; an empty one may be NULL.
///
/// # Safety
/// It has `count` elements.
pub(crate) unsafe fn slice<'a, T>(from: *const T, count: usize) -> &'a [T] {
    if from.is_null() || count == 0 {
        return &[];
    }
    // SAFETY: the host's promise.
    unsafe { std::slice::from_raw_parts(from, count) }
}

/// The same to write to.
///
/// # Safety
/// It has room for `count` elements.
pub(crate) unsafe fn slice_mut<'a, T>(to: *mut T, count: usize) -> &'a mut [T] {
    if to.is_null() || count == 0 {
        return &mut [];
    }
    // SAFETY: the host's promise.
    unsafe { std::slice::from_raw_parts_mut(to, count) }
}

/// Places of outputs and of inputs by their references.
pub(crate) fn places(unknowns: &[u32], knowns: &[u32]) -> Option<(Vec<usize>, Vec<usize>)> {
    let outputs = unknowns.iter().map(|one| real(*one)?.checked_sub(INPUTS)).collect();
    let inputs = knowns.iter().map(|one| real(*one).filter(|place| *place < INPUTS)).collect();
    Option::zip(outputs, inputs)
}

/// Keeps inputs as a state: in one that is there, or in a new one.
///
/// # Safety
/// `state` is NULL, or points to NULL or to a state.
pub(crate) unsafe fn keep(inputs: Inputs, state: *mut *mut Inputs) -> Status {
    // SAFETY: the host's promise, here and below.
    let Some(state) = (unsafe { state.as_mut() }) else { return ERROR };
    // SAFETY: as before.
    match unsafe { state.as_mut() } {
        Some(there) => *there = inputs,
        None => *state = Box::into_raw(Box::new(inputs)),
    }
    OK
}

/// Frees a state. NULL is left alone.
///
/// # Safety
/// `state` is NULL, or points to NULL or to a state that is not used again.
pub(crate) unsafe fn free(state: *mut *mut Inputs) -> Status {
    // SAFETY: the host's promise, here and below.
    if let Some(state) = unsafe { state.as_mut() }
        && !state.is_null()
    {
        // SAFETY: as before.
        drop(unsafe { Box::from_raw(*state) });
        *state = ptr::null_mut();
    }
    OK
}

/// Writes a state as bytes; `None` without a state or room.
///
/// # Safety
/// `state` is NULL or a state, `bytes` has room for `size`.
pub(crate) unsafe fn written(state: *const Inputs, bytes: *mut u8, size: usize) -> Option<()> {
    // SAFETY: the host's promise.
    let (state, bytes) = unsafe { (state.as_ref()?, slice_mut(bytes, size)) };
    bytes.get_mut(..STATE_BYTES)?.copy_from_slice(&state.to_bytes());
    Some(())
}

/// Reads a state from bytes; `None` where they are none.
///
/// # Safety
/// `bytes` are `size`; `state` is NULL, or points to NULL or to a state.
pub(crate) unsafe fn read(bytes: *const u8, size: usize, state: *mut *mut Inputs) -> Option<()> {
    // SAFETY: the host's promise.
    let inputs = Inputs::from_bytes(unsafe { slice(bytes, size) })?;
    // SAFETY: as before.
    (unsafe { keep(inputs, state) } == OK).then_some(())
}
