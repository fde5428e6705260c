//! Common part of FMI 2.0 and 3.0: an instance as the host has it, statuses, arrays of the host, kept states, and the
//! functions that differ by their names alone.

use std::ffi::{CString, c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::ptr;

use crate::contacts::{AnswerError, Contacts, ContactsError};
use crate::fmi2::Logger;
use crate::fmi3::LogMessage;
use crate::instance::{Inputs, Instance, STATE_BYTES};
use crate::resources::Resources;
use crate::variables::{INPUTS, real, switch};

pub(crate) type Status = c_int;
pub(crate) const OK: Status = 0;
pub(crate) const WARNING: Status = 1;
pub(crate) const DISCARD: Status = 2;
pub(crate) const ERROR: Status = 3;

/// The host's function for messages, with what it gave us for it.
#[derive(Debug)]
pub(crate) enum Log {
    /// The host listens to none.
    None,
    /// That of version 2 with the instance's name.
    Two(Logger, CString, *mut c_void),
    /// That of version 3.
    Three(LogMessage, *mut c_void),
}

impl Log {
    pub(crate) fn say(&self, status: Status, words: &str) {
        let category = c"logStatusError".as_ptr();
        match self {
            Self::None => {}
            Self::Two(logger, name, environment) => {
                // A message goes as a format.
                let words = CString::new(words.replace('%', "%%")).unwrap_or_default();
                // SAFETY: the host's own function, with what it gave us; texts end with a zero.
                unsafe { logger(*environment, name.as_ptr(), status, category, words.as_ptr()) };
            }
            Self::Three(log, environment) => {
                let words = CString::new(words).unwrap_or_default();
                // SAFETY: as before.
                unsafe { log(*environment, status, category, words.as_ptr()) };
            }
        }
    }
}

/// An instance, and how it speaks to its host.
#[derive(Debug)]
pub struct Component {
    pub(crate) instance: Instance,
    log: Log,
}

impl Component {
    /// One of what lies in a directory of resources; else NULL, and the host hears why.
    pub(crate) fn open(log: Log, resources: &str, token: &str) -> *mut Self {
        match opened(resources, token) {
            Ok(instance) => Box::into_raw(Box::new(Self { instance, log })),
            Err(error) => {
                log.say(ERROR, &error.to_string());
                ptr::null_mut()
            }
        }
    }

    pub(crate) fn wrong(&self, words: &str) -> Status {
        self.log.say(ERROR, words);
        ERROR
    }

    /// What comes of a failure of the map or the solver.
    pub(crate) fn discard(&self, error: &AnswerError) -> Status {
        self.log.say(DISCARD, &error.to_string());
        DISCARD
    }

    /// What comes of an answer: its caution is told once.
    pub(crate) fn answered(&mut self) -> Status {
        let caution = self.instance.take_caution();
        self.told(caution)
    }

    /// Tells a caution.
    pub(crate) fn told(&self, caution: Option<String>) -> Status {
        match caution {
            Some(words) => {
                self.log.say(WARNING, &words);
                WARNING
            }
            None => OK,
        }
    }

    /// Numbers by their references, `time` being that of the time if there is one; `kind` is what the version calls them.
    pub(crate) fn get_reals(
        &mut self,
        (references, values): (&[u32], &mut [f64]),
        time: Option<u32>,
        kind: &str,
    ) -> Status {
        for (value, reference) in values.iter_mut().zip(references) {
            if time == Some(*reference) {
                *value = self.instance.inputs.time;
                continue;
            }
            let Some(place) = real(*reference) else {
                return self.wrong(&format!("no {kind} has the reference {reference}"));
            };
            match self.instance.real(place) {
                Ok(found) => *value = found,
                Err(error) => return self.discard(&error),
            }
        }
        self.answered()
    }

    pub(crate) fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Status {
        for (value, reference) in values.iter().zip(references) {
            let is_set =
                real(*reference).is_some_and(|place| self.instance.set_real(place, *value));
            if !is_set {
                return self.wrong(&format!("no input has the reference {reference}"));
            }
        }
        OK
    }

    pub(crate) fn get_switches<T: From<bool>>(
        &mut self,
        references: &[u32],
        values: &mut [T],
    ) -> Status {
        for (value, reference) in values.iter_mut().zip(references) {
            let Some(place) = switch(*reference) else {
                return self.wrong(&format!("no Boolean has the reference {reference}"));
            };
            *value = self.instance.inputs.switches[place].into();
        }
        OK
    }

    /// Zero is false, all else is true.
    pub(crate) fn set_switches<T: Default + PartialEq>(
        &mut self,
        references: &[u32],
        values: &[T],
    ) -> Status {
        for (value, reference) in values.iter().zip(references) {
            let Some(place) = switch(*reference) else {
                return self.wrong(&format!("no Boolean has the reference {reference}"));
            };
            self.instance.set_switch(place, *value != T::default());
        }
        OK
    }

    /// Change of outputs with a direction of the inputs.
    pub(crate) fn directional_derivative(
        &self,
        [unknowns, knowns]: [&[u32]; 2],
        seed: &[f64],
        found: &mut [f64],
    ) -> Status {
        let Some((outputs, inputs)) = places(unknowns, knowns) else {
            return self.wrong(NO_DERIVATIVE);
        };
        let direction: Vec<_> = inputs.into_iter().zip(seed.iter().copied()).collect();
        match self.instance.derivative(&outputs, &direction) {
            Ok((change, caution)) => {
                found.iter_mut().zip(change).for_each(|(to, from)| *to = from);
                self.told(caution)
            }
            Err(error) => self.discard(&error),
        }
    }
}

fn opened(folder: &str, expected: &str) -> Result<Instance, ContactsError> {
    let resources = Resources::read(Path::new(folder))?;
    let found = resources.token();
    if found != expected {
        return Err(ContactsError::Token { found, expected: expected.into() });
    }
    Ok(Instance::new(Contacts::open(&resources)?))
}

pub(crate) const NO_DERIVATIVE: &str = "derivatives are those of outputs by inputs";

/// Does something with an instance; a NULL is an error, and nothing unwinds into the host.
///
/// # Safety
/// `component` is NULL or of this library and not freed.
pub(crate) unsafe fn with(
    component: *mut Component,
    work: impl FnOnce(&mut Component) -> Status,
) -> Status {
    // SAFETY: the host's promise.
    let Some(component) = (unsafe { component.as_mut() }) else { return ERROR };
    catch_unwind(AssertUnwindSafe(|| work(component))).unwrap_or(ERROR)
}

/// The functions of a version that another has by other names.
macro_rules! functions_of_both {
    (
        $free_instance:ident, $reset:ident, $set_time:ident, $get_state:ident, $set_state:ident, $free_state:ident,
        $state_size:ident, $write_state:ident, $read_state:ident
    ) => {
        /// Frees an instance.
        ///
        /// # Safety
        /// It is of this library or NULL, and not used again.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $free_instance(component: *mut Component) {
            if !component.is_null() {
                // SAFETY: the host gives it up.
                drop(unsafe { Box::from_raw(component) });
            }
        }

        /// As new.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $reset(component: *mut Component) -> Status {
            let work = |component: &mut Component| {
                component.instance.reset();
                OK
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }

        /// Sets the time, on which nothing depends.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set_time(component: *mut Component, time: f64) -> Status {
            let work = |component: &mut Component| {
                component.instance.inputs.time = time;
                OK
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }

        /// Keeps what an instance remembers.
        ///
        /// # Safety
        /// The instance is alive; `state` points to NULL or to a state of this function.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get_state(
            component: *mut Component,
            state: *mut *mut Inputs,
        ) -> Status {
            let work = |component: &mut Component| {
                // SAFETY: the host's promise, here and below.
                unsafe { host::keep(component.instance.inputs, state) }
            };
            // SAFETY: as before.
            unsafe { with(component, work) }
        }

        /// Goes back to what was kept.
        ///
        /// # Safety
        /// The instance is alive, `state` is one that was kept.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set_state(
            component: *mut Component,
            state: *mut Inputs,
        ) -> Status {
            // SAFETY: the host's promise, here and below.
            let Some(state) = (unsafe { state.as_ref() }) else { return ERROR };
            let work = |component: &mut Component| {
                component.instance.set_inputs(*state);
                OK
            };
            // SAFETY: as before.
            unsafe { with(component, work) }
        }

        /// Frees what was kept.
        ///
        /// # Safety
        /// `state` points to NULL or to a state, which is not used again.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $free_state(
            component: *mut Component,
            state: *mut *mut Inputs,
        ) -> Status {
            // SAFETY: the host's promise, here and below.
            unsafe { with(component, |_| host::free(state)) }
        }

        /// Bytes of a kept state.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $state_size(
            component: *mut Component,
            _state: *mut Inputs,
            size: *mut usize,
        ) -> Status {
            let work = |_: &mut Component| {
                // SAFETY: the host's promise.
                let Some(size) = (unsafe { size.as_mut() }) else { return ERROR };
                *size = STATE_BYTES;
                OK
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }

        /// Writes a kept state as bytes.
        ///
        /// # Safety
        /// The instance is alive, `state` is a state, `bytes` has room for `size`.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $write_state(
            component: *mut Component,
            state: *mut Inputs,
            bytes: *mut u8,
            size: usize,
        ) -> Status {
            let work = |component: &mut Component| {
                // SAFETY: the host's promise.
                let written = unsafe { host::written(state, bytes, size) };
                written.map_or_else(|| component.wrong("there is no room for the state"), |()| OK)
            };
            // SAFETY: as before.
            unsafe { with(component, work) }
        }

        /// Reads a kept state from bytes.
        ///
        /// # Safety
        /// The instance is alive, there are `size` bytes; `state` points to NULL or to a state.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $read_state(
            component: *mut Component,
            bytes: *const u8,
            size: usize,
            state: *mut *mut Inputs,
        ) -> Status {
            let work = |component: &mut Component| {
                // SAFETY: the host's promise.
                let read = unsafe { host::read(bytes, size, state) };
                read.map_or_else(|| component.wrong("these are no bytes of a state"), |()| OK)
            };
            // SAFETY: as before.
            unsafe { with(component, work) }
        }
    };
}

pub(crate) use functions_of_both;

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
