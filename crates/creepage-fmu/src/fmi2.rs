//! C functions of FMI 2.0.
// Names and arguments are those of the standard.
#![allow(non_snake_case, clippy::too_many_arguments, clippy::fn_params_excessive_bools)]

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use crate::host::{
    self, Component, DISCARD, ERROR, Log, OK, Status, functions_of_both, slice, slice_mut, with,
};
use crate::instance::{Inputs, STATE_BYTES};

/// The host's function for messages.
pub(crate) type Logger =
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
        let log = match callbacks {
            Some(Callbacks { logger: Some(logger), environment, .. }) => {
                Log::Two(*logger, name, *environment)
            }
            _ => Log::None,
        };
        let (Some(guid), Some(resources)) = (text(guid), text(resources)) else {
            log.say(ERROR, "guid and resource location are needed");
            return ptr::null_mut();
        };
        Component::open(log, &path_of(&resources.to_string_lossy()), &guid.to_string_lossy())
    };
    catch_unwind(AssertUnwindSafe(make)).unwrap_or(ptr::null_mut())
}

functions_of_both! {
    fmi2FreeInstance, fmi2Reset, fmi2SetTime, fmi2GetFMUstate, fmi2SetFMUstate, fmi2FreeFMUstate,
    fmi2SerializedFMUstateSize, fmi2SerializeFMUstate, fmi2DeSerializeFMUstate
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
    let work = |component: &mut Component| component.get_reals((references, values), None, "Real");
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
    let work = |component: &mut Component| component.set_reals(references, values);
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
    let work = |component: &mut Component| component.get_switches(references, values);
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
    let work = |component: &mut Component| component.set_switches(references, values);
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
        component.directional_derivative([unknowns, knowns], seed, found)
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

/// Does a step: outputs follow from the inputs at once; a state without an answer is discarded.
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
            component.answered()
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
