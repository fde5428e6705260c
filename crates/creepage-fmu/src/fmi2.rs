//! The functions of FMI 2.0.
// Names and arguments are those of the standard.
#![allow(non_snake_case, clippy::too_many_arguments, clippy::fn_params_excessive_bools)]

use std::ffi::{CStr, CString, c_char, c_int, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use creepage_map::MapError;

use crate::host::{self, DISCARD, ERROR, OK, Status, places, slice, slice_mut};
use crate::instance::{Inputs, Instance, STATE_BYTES};
use crate::variables::{real, switch};

type Logger =
    unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// What the host gives.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Callbacks {
    logger: Option<Logger>,
    allocate: *const c_void,
    free: *const c_void,
    step_finished: *const c_void,
    environment: *mut c_void,
}

/// What an instance is to the host.
#[derive(Debug)]
pub struct Component {
    instance: Instance,
    name: CString,
    logger: Option<Logger>,
    environment: *mut c_void,
}

impl Component {
    fn say(&self, status: Status, words: &str) {
        let Some(logger) = self.logger else { return };
        // A message goes as an argument: it may hold signs of a format.
        let words = CString::new(words.replace('%', "%%")).unwrap_or_default();
        // SAFETY: the host's own function, with what it gave us; texts end with a zero.
        unsafe {
            logger(
                self.environment,
                self.name.as_ptr(),
                status,
                c"logStatusError".as_ptr(),
                words.as_ptr(),
            );
        }
    }

    /// What comes of a failure of the map.
    fn discard(&self, error: &MapError) -> Status {
        self.say(DISCARD, &error.to_string());
        DISCARD
    }

    fn wrong(&self, words: &str) -> Status {
        self.say(ERROR, words);
        ERROR
    }
}

/// Does something with an instance; a NULL is an error, and nothing unwinds into the host.
///
/// # Safety
/// `component` is NULL or of [`fmi2Instantiate`] and not freed.
unsafe fn with(component: *mut Component, work: impl FnOnce(&mut Component) -> Status) -> Status {
    // SAFETY: the host's promise.
    let Some(component) = (unsafe { component.as_mut() }) else { return ERROR };
    catch_unwind(AssertUnwindSafe(|| work(component))).unwrap_or(ERROR)
}

/// The path of a `file:` URI, its signs decoded.
fn path_of(uri: &str) -> String {
    let rest = uri.strip_prefix("file:").unwrap_or(uri);
    let rest = match rest.strip_prefix("//") {
        // The host's name, mostly none, goes before the path.
        Some(rest) => rest.find('/').map_or(rest, |at| &rest[at..]),
        None => rest,
    };
    let (mut bytes, mut all) = (rest.bytes(), Vec::new());
    while let Some(byte) = bytes.next() {
        let digits = if byte == b'%' { bytes.as_slice_of_two() } else { None };
        match digits {
            Some(value) => {
                all.push(value);
                let _ = (bytes.next(), bytes.next());
            }
            None => all.push(byte),
        }
    }
    let path = String::from_utf8_lossy(&all).into_owned();
    // `/C:/...` of Windows.
    let is_drive = path.len() > 2 && path.as_bytes()[2] == b':' && path.starts_with('/');
    if is_drive { path[1..].to_owned() } else { path }
}

/// Two hexadecimal digits that come next.
trait Hexadecimal {
    fn as_slice_of_two(&self) -> Option<u8>;
}

impl Hexadecimal for std::str::Bytes<'_> {
    fn as_slice_of_two(&self) -> Option<u8> {
        let mut ahead = self.clone();
        let digit = |byte: Option<u8>| (byte? as char).to_digit(16);
        let (high, low) = (digit(ahead.next())?, digit(ahead.next())?);
        u8::try_from(16 * high + low).ok()
    }
}

/// Platform of the types.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// Version of the interface.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// Makes an instance from the map among the resources.
///
/// # Safety
/// Texts end with a zero; `callbacks` lives as long as the instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    _kind: c_int,
    guid: *const c_char,
    resources: *const c_char,
    callbacks: *const Callbacks,
    _visible: c_int,
    _logging: c_int,
) -> *mut Component {
    let make = || {
        // SAFETY: the host's promise, here and below.
        let callbacks = unsafe { callbacks.as_ref() };
        let text = |text: *const c_char| {
            // SAFETY: as before.
            (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) })
        };
        let name = text(name).map(CStr::to_owned).unwrap_or_default();
        let logger = callbacks.and_then(|callbacks| callbacks.logger);
        let environment = callbacks.map_or(ptr::null_mut(), |callbacks| callbacks.environment);
        let say = |words: &str| {
            let words = CString::new(words.replace('%', "%%")).unwrap_or_default();
            if let Some(logger) = logger {
                let (name, words) = (name.as_ptr(), words.as_ptr());
                // SAFETY: as of `Component::say`.
                unsafe { logger(environment, name, ERROR, c"logStatusError".as_ptr(), words) };
            }
        };
        let (Some(guid), Some(resources)) = (text(guid), text(resources)) else {
            say("guid and resource location are needed");
            return ptr::null_mut();
        };
        let directory = path_of(&resources.to_string_lossy());
        let path = format!("{}/wheelset.nc", directory.trim_end_matches('/'));
        match Instance::open(&path, &guid.to_string_lossy()) {
            Ok(instance) => {
                Box::into_raw(Box::new(Component { instance, name, logger, environment }))
            }
            Err(error) => {
                say(&error.to_string());
                ptr::null_mut()
            }
        }
    };
    catch_unwind(AssertUnwindSafe(make)).unwrap_or(ptr::null_mut())
}

/// Frees an instance.
///
/// # Safety
/// It is of [`fmi2Instantiate`] or NULL, and not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut Component) {
    if !component.is_null() {
        // SAFETY: the host gives it up.
        drop(unsafe { Box::from_raw(component) });
    }
}

/// Functions that take an instance and have nothing to do.
macro_rules! nothing_to_do {
    ($($(#[$doc:meta])* $name:ident($($argument:ident: $kind:ty),*);)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(component: *mut Component, $($argument: $kind),*) -> Status {
            let _ = ($($argument,)*);
            // SAFETY: the host's promise.
            unsafe { with(component, |_| OK) }
        }
    )*};
}

nothing_to_do! {
    /// Messages are few: all go to the host.
    fmi2SetDebugLogging(_on: c_int, _count: usize, _categories: *const *const c_char);
    /// There is nothing to initialise.
    fmi2EnterInitializationMode();
    /// As before.
    fmi2ExitInitializationMode();
    /// As before.
    fmi2Terminate();
    /// There are no events.
    fmi2EnterEventMode();
    /// As before.
    fmi2EnterContinuousTimeMode();
    /// There are no continuous states.
    fmi2SetContinuousStates(_x: *const f64, _count: usize);
    /// As before.
    fmi2GetDerivatives(_dx: *mut f64, _count: usize);
    /// As before.
    fmi2GetEventIndicators(_z: *mut f64, _count: usize);
    /// As before.
    fmi2GetContinuousStates(_x: *mut f64, _count: usize);
    /// As before.
    fmi2GetNominalsOfContinuousStates(_x: *mut f64, _count: usize);
}

/// Where time starts.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut Component,
    _has_tolerance: c_int,
    _tolerance: f64,
    start: f64,
    _has_stop: c_int,
    _stop: f64,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { fmi2SetTime(component, start) }
}

/// As new.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: *mut Component) -> Status {
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
pub unsafe extern "C" fn fmi2SetTime(component: *mut Component, time: f64) -> Status {
    let work = |component: &mut Component| {
        component.instance.inputs.time = time;
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

/// Numbers by their references.
///
/// # Safety
/// The instance is alive; arrays have `count` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut Component,
    references: *const c_uint,
    count: usize,
    values: *mut f64,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) = unsafe { (slice(references, count), slice_mut(values, count)) };
    let work = |component: &mut Component| {
        for (value, reference) in values.iter_mut().zip(references) {
            let Some(place) = real(*reference) else {
                return component.wrong(&format!("no Real has the reference {reference}"));
            };
            match component.instance.real(place) {
                Ok(found) => *value = found,
                Err(error) => return component.discard(&error),
            }
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Sets inputs.
///
/// # Safety
/// As of [`fmi2GetReal`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut Component,
    references: *const c_uint,
    count: usize,
    values: *const f64,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) = unsafe { (slice(references, count), slice(values, count)) };
    let work = |component: &mut Component| {
        for (value, reference) in values.iter().zip(references) {
            let is_set =
                real(*reference).is_some_and(|place| component.instance.set_real(place, *value));
            if !is_set {
                return component.wrong(&format!("no input has the reference {reference}"));
            }
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Switches by their references.
///
/// # Safety
/// As of [`fmi2GetReal`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: *mut Component,
    references: *const c_uint,
    count: usize,
    values: *mut c_int,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) = unsafe { (slice(references, count), slice_mut(values, count)) };
    let work = |component: &mut Component| {
        for (value, reference) in values.iter_mut().zip(references) {
            let Some(place) = switch(*reference) else {
                return component.wrong(&format!("no Boolean has the reference {reference}"));
            };
            *value = c_int::from(component.instance.inputs.switches[place]);
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Sets switches.
///
/// # Safety
/// As of [`fmi2GetReal`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: *mut Component,
    references: *const c_uint,
    count: usize,
    values: *const c_int,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) = unsafe { (slice(references, count), slice(values, count)) };
    let work = |component: &mut Component| {
        for (value, reference) in values.iter().zip(references) {
            let Some(place) = switch(*reference) else {
                return component.wrong(&format!("no Boolean has the reference {reference}"));
            };
            component.instance.set_switch(place, *value != 0);
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Kinds of variables that the FMU has none of.
macro_rules! none_of_kind {
    ($($name:ident: $pointer:ty, $kind:literal;)*) => {$(
        #[doc = concat!("There is no variable of the kind ", $kind, ".")]
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut Component,
            _references: *const c_uint,
            count: usize,
            _values: $pointer,
        ) -> Status {
            let work = |component: &mut Component| {
                if count == 0 { OK } else { component.wrong(concat!("there is no ", $kind)) }
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }
    )*};
}

none_of_kind! {
    fmi2GetInteger: *mut c_int, "Integer";
    fmi2SetInteger: *const c_int, "Integer";
    fmi2GetString: *mut *const c_char, "String";
    fmi2SetString: *const *const c_char, "String";
}

/// Keeps what an instance remembers.
///
/// # Safety
/// The instance is alive; `state` points to NULL or to a state of this function.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(
    component: *mut Component,
    state: *mut *mut Inputs,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let work = |component: &mut Component| unsafe { host::keep(component.instance.inputs, state) };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Goes back to what was kept.
///
/// # Safety
/// The instance is alive, `state` is of [`fmi2GetFMUstate`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut Component, state: *mut Inputs) -> Status {
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
pub unsafe extern "C" fn fmi2FreeFMUstate(
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
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
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
pub unsafe extern "C" fn fmi2SerializeFMUstate(
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
/// As of [`fmi2SerializeFMUstate`]; `state` points to NULL or to a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
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

/// Change of outputs with inputs.
///
/// # Safety
/// The instance is alive; arrays have as many elements as said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    component: *mut Component,
    unknowns: *const c_uint,
    unknown_count: usize,
    knowns: *const c_uint,
    known_count: usize,
    seed: *const f64,
    sensitivity: *mut f64,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (unknowns, knowns) =
        unsafe { (slice(unknowns, unknown_count), slice(knowns, known_count)) };
    // SAFETY: as before.
    let (seed, found) =
        unsafe { (slice(seed, known_count), slice_mut(sensitivity, unknown_count)) };
    let work = |component: &mut Component| {
        let Some((outputs, inputs)) = places(unknowns, knowns) else {
            return component.wrong("derivatives are those of outputs by inputs");
        };
        let inputs: Vec<_> = inputs.into_iter().zip(seed.iter().copied()).collect();
        match component.instance.derivative(&outputs, &inputs) {
            Ok(change) => {
                found.copy_from_slice(&change);
                OK
            }
            Err(error) => component.discard(&error),
        }
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// What a discrete update found.
#[repr(C)]
#[derive(Debug)]
pub struct EventInfo {
    new_discrete_states_needed: c_int,
    terminate: c_int,
    nominals_changed: c_int,
    values_changed: c_int,
    next_event_defined: c_int,
    next_event: f64,
}

/// There are no discrete states.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2NewDiscreteStates(
    component: *mut Component,
    info: *mut EventInfo,
) -> Status {
    let work = |_: &mut Component| {
        // SAFETY: the host's promise.
        let Some(info) = (unsafe { info.as_mut() }) else { return ERROR };
        *info = EventInfo {
            new_discrete_states_needed: 0,
            terminate: 0,
            nominals_changed: 0,
            values_changed: 0,
            next_event_defined: 0,
            next_event: 0.0,
        };
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

/// There are no step events.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CompletedIntegratorStep(
    component: *mut Component,
    _no_set_before: c_int,
    enter_event_mode: *mut c_int,
    terminate: *mut c_int,
) -> Status {
    let work = |_: &mut Component| {
        for place in [enter_event_mode, terminate] {
            // SAFETY: the host's promise.
            if let Some(place) = unsafe { place.as_mut() } {
                *place = 0;
            }
        }
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

/// Goes on: outputs are those of the inputs. Outside the map it discards the step.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    component: *mut Component,
    current: f64,
    step: f64,
    _no_set_before: c_int,
) -> Status {
    let work = |component: &mut Component| match component.instance.outputs() {
        Ok(_) => {
            component.instance.inputs.time = current + step;
            OK
        }
        Err(error) => component.discard(&error),
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

/// Steps are done at once.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CancelStep(component: *mut Component) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(component, |component| component.wrong("no step is pending")) }
}

/// Functions for derivatives over time, which the FMU does not have.
macro_rules! no_time_derivatives {
    ($($name:ident: $pointer:ty;)*) => {$(
        /// Inputs are not interpolated, and outputs have no derivatives by time.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut Component,
            _references: *const c_uint,
            _count: usize,
            _order: *const c_int,
            _values: $pointer,
        ) -> Status {
            let work = |component: &mut Component| component.wrong("no derivatives by time");
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }
    )*};
}

no_time_derivatives! {
    fmi2SetRealInputDerivatives: *const f64;
    fmi2GetRealOutputDerivatives: *mut f64;
}

/// Questions on steps, which are done at once.
macro_rules! step_status {
    ($($name:ident: $pointer:ty;)*) => {$(
        /// Steps are done at once: only the time of the last one is known.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut Component,
            _kind: c_int,
            _value: $pointer,
        ) -> Status {
            // SAFETY: the host's promise.
            unsafe { with(component, |_| DISCARD) }
        }
    )*};
}

step_status! {
    fmi2GetStatus: *mut Status;
    fmi2GetIntegerStatus: *mut c_int;
    fmi2GetBooleanStatus: *mut c_int;
    fmi2GetStringStatus: *mut *const c_char;
}

/// The time of the last step that was done.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(
    component: *mut Component,
    _kind: c_int,
    value: *mut f64,
) -> Status {
    let work = |component: &mut Component| {
        // SAFETY: the host's promise.
        let Some(value) = (unsafe { value.as_mut() }) else { return ERROR };
        *value = component.instance.inputs.time;
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

#[cfg(test)]
mod tests {
    use super::path_of;

    #[test]
    fn a_uri_is_a_path() {
        assert_eq!(path_of("file:///tmp/a%20b/resources"), "/tmp/a b/resources");
        assert_eq!(path_of("file:/tmp/x"), "/tmp/x");
        assert_eq!(path_of("file://host/tmp/x"), "/tmp/x");
        assert_eq!(path_of("file:///C:/x%C3%A4"), "C:/x\u{e4}");
        assert_eq!(path_of("/tmp/100%"), "/tmp/100%");
    }
}
