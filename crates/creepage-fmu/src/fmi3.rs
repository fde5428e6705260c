//! C functions of FMI 3.0: those of version 2 by their new names, and what is new.
// Names and arguments are those of the standard.
#![allow(non_snake_case, clippy::too_many_arguments, clippy::fn_params_excessive_bools)]

use std::ffi::{CStr, c_char, c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use crate::host::{
    self, Component, ERROR, Log, NO_DERIVATIVE, OK, Status, functions_of_both, places, slice,
    slice_mut, with,
};
use crate::instance::{Inputs, STATE_BYTES};

/// The host's function for messages.
pub(crate) type LogMessage =
    unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

/// Version of the interface.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

fn log_of(log: Option<LogMessage>, environment: *mut c_void) -> Log {
    log.map_or(Log::None, |log| Log::Three(log, environment))
}

/// Makes an instance from the map among the resources.
///
/// # Safety
/// Texts end with a zero.
unsafe fn instantiate(
    token: *const c_char,
    resources: *const c_char,
    environment: *mut c_void,
    log: Option<LogMessage>,
) -> *mut Component {
    let make = || {
        let log = log_of(log, environment);
        let text = |text: *const c_char| {
            // SAFETY: the caller's promise.
            (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) }.to_string_lossy())
        };
        let (Some(token), Some(resources)) = (text(token), text(resources)) else {
            log.say(ERROR, "instantiation token and resource path are needed");
            return ptr::null_mut();
        };
        Component::open(log, &resources, &token)
    };
    catch_unwind(AssertUnwindSafe(make)).unwrap_or(ptr::null_mut())
}

/// An instance for Model Exchange.
///
/// # Safety
/// Texts end with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    _logging: bool,
    environment: *mut c_void,
    log: Option<LogMessage>,
) -> *mut Component {
    // SAFETY: the host's promise.
    unsafe { instantiate(token, resources, environment, log) }
}

/// An instance for Co-Simulation.
///
/// # Safety
/// Texts end with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: bool,
    _logging: bool,
    _event_mode_used: bool,
    _early_return: bool,
    _intermediate: *const u32,
    _count: usize,
    environment: *mut c_void,
    log: Option<LogMessage>,
    _intermediate_update: *const c_void,
) -> *mut Component {
    // SAFETY: the host's promise.
    unsafe { instantiate(token, resources, environment, log) }
}

/// There is no Scheduled Execution.
///
/// # Safety
/// Texts end with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: bool,
    _logging: bool,
    environment: *mut c_void,
    log: Option<LogMessage>,
    _clock_update: *const c_void,
    _lock: *const c_void,
    _unlock: *const c_void,
) -> *mut Component {
    log_of(log, environment).say(ERROR, "there is no Scheduled Execution");
    ptr::null_mut()
}

functions_of_both! {
    fmi3FreeInstance, fmi3Reset, fmi3SetTime, fmi3GetFMUState, fmi3SetFMUState, fmi3FreeFMUState,
    fmi3SerializedFMUStateSize, fmi3SerializeFMUState, fmi3DeserializeFMUState
}

/// Functions that take an instance and have nothing to do.
macro_rules! nothing_to_do {
    ($($name:ident($($argument:ident: $kind:ty),*);)*) => {$(
        /// Nothing is to be done: there are no states, events, clocks and modes.
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
    fmi3SetDebugLogging(_on: bool, _count: usize, _categories: *const *const c_char);
    fmi3ExitInitializationMode();
    fmi3EnterEventMode();
    fmi3Terminate();
    fmi3EnterConfigurationMode();
    fmi3ExitConfigurationMode();
    fmi3EvaluateDiscreteStates();
    fmi3EnterContinuousTimeMode();
    fmi3SetContinuousStates(_x: *const f64, _count: usize);
    fmi3GetContinuousStateDerivatives(_dx: *mut f64, _count: usize);
    fmi3GetEventIndicators(_z: *mut f64, _count: usize);
    fmi3GetContinuousStates(_x: *mut f64, _count: usize);
    fmi3GetNominalsOfContinuousStates(_x: *mut f64, _count: usize);
    fmi3EnterStepMode();
}

/// Where time starts.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    component: *mut Component,
    _has_tolerance: bool,
    _tolerance: f64,
    start: f64,
    _has_stop: bool,
    _stop: f64,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { fmi3SetTime(component, start) }
}

/// Numbers by their references; that of time is 0.
///
/// # Safety
/// The instance is alive; arrays have as many elements as said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) =
        unsafe { (slice(references, count), slice_mut(values, value_count)) };
    let work =
        |component: &mut Component| component.get_reals((references, values), Some(0), "Float64");
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Sets inputs.
///
/// # Safety
/// As of [`fmi3GetFloat64`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) = unsafe { (slice(references, count), slice(values, value_count)) };
    let work = |component: &mut Component| component.set_reals(references, values);
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Switches by their references.
///
/// # Safety
/// As of [`fmi3GetFloat64`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBoolean(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *mut bool,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) =
        unsafe { (slice(references, count), slice_mut(values, value_count)) };
    let work = |component: &mut Component| component.get_switches(references, values);
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Sets switches.
///
/// # Safety
/// As of [`fmi3GetFloat64`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBoolean(
    component: *mut Component,
    references: *const u32,
    count: usize,
    values: *const u8,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below; any byte but zero is true.
    let (references, values) = unsafe { (slice(references, count), slice(values, value_count)) };
    let work = |component: &mut Component| component.set_switches(references, values);
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// Kinds of variables that the FMU has none of.
macro_rules! none_of_kind {
    ($($name:ident: $pointer:ty;)*) => {$(
        /// There is no variable of this kind.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut Component,
            _references: *const u32,
            count: usize,
            _values: $pointer,
            _value_count: usize,
        ) -> Status {
            let work = |component: &mut Component| {
                if count == 0 { OK } else { component.wrong("there is no variable of this kind") }
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }
    )*};
}

none_of_kind! {
    fmi3GetFloat32: *mut f32;
    fmi3GetInt8: *mut i8;
    fmi3GetUInt8: *mut u8;
    fmi3GetInt16: *mut i16;
    fmi3GetUInt16: *mut u16;
    fmi3GetInt32: *mut i32;
    fmi3GetUInt32: *mut u32;
    fmi3GetInt64: *mut i64;
    fmi3GetUInt64: *mut u64;
    fmi3GetString: *mut *const c_char;
    fmi3SetFloat32: *const f32;
    fmi3SetInt8: *const i8;
    fmi3SetUInt8: *const u8;
    fmi3SetInt16: *const i16;
    fmi3SetUInt16: *const u16;
    fmi3SetInt32: *const i32;
    fmi3SetUInt32: *const u32;
    fmi3SetInt64: *const i64;
    fmi3SetUInt64: *const u64;
    fmi3SetString: *const *const c_char;
}

/// The same of binaries, clocks and their times, with arguments of their own.
macro_rules! none_of_clocks {
    ($($name:ident($($argument:ident: $kind:ty),*);)*) => {$(
        /// There is no binary variable and no clock.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut Component,
            _references: *const u32,
            count: usize,
            $($argument: $kind),*
        ) -> Status {
            let _ = ($($argument,)*);
            let work = |component: &mut Component| {
                if count == 0 { OK } else { component.wrong("there is no variable of this kind") }
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }
    )*};
}

none_of_clocks! {
    fmi3GetBinary(_sizes: *mut usize, _values: *mut *const u8, _value_count: usize);
    fmi3SetBinary(_sizes: *const usize, _values: *const *const u8, _value_count: usize);
    fmi3GetClock(_values: *mut bool);
    fmi3SetClock(_values: *const bool);
    fmi3GetIntervalDecimal(_intervals: *mut f64, _qualifiers: *mut c_int);
    fmi3GetIntervalFraction(_counters: *mut u64, _resolutions: *mut u64, _qualifiers: *mut c_int);
    fmi3GetShiftDecimal(_shifts: *mut f64);
    fmi3GetShiftFraction(_counters: *mut u64, _resolutions: *mut u64);
    fmi3SetIntervalDecimal(_intervals: *const f64);
    fmi3SetIntervalFraction(_counters: *const u64, _resolutions: *const u64);
    fmi3SetShiftDecimal(_shifts: *const f64);
    fmi3SetShiftFraction(_counters: *const u64, _resolutions: *const u64);
}

/// Counts that are zero.
macro_rules! numbers_of_nothing {
    ($($name:ident($($argument:ident: $kind:ty),*);)*) => {$(
        /// The count, which is zero.
        ///
        /// # Safety
        /// The instance is alive, and the place for the number.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut Component,
            $($argument: $kind,)*
            number: *mut usize,
        ) -> Status {
            let _ = ($($argument,)*);
            let work = |_: &mut Component| {
                // SAFETY: the host's promise.
                let Some(number) = (unsafe { number.as_mut() }) else { return ERROR };
                *number = 0;
                OK
            };
            // SAFETY: the host's promise.
            unsafe { with(component, work) }
        }
    )*};
}

numbers_of_nothing! {
    fmi3GetNumberOfEventIndicators();
    fmi3GetNumberOfContinuousStates();
    fmi3GetNumberOfVariableDependencies(_reference: u32);
}

/// Dependencies are those of the description: all outputs depend on all inputs.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetVariableDependencies(
    component: *mut Component,
    _dependent: u32,
    _dependent_elements: *mut usize,
    _independents: *mut u32,
    _independent_elements: *mut usize,
    _kinds: *mut c_int,
    _count: usize,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(component, |_| OK) }
}

/// Change of outputs with inputs.
///
/// # Safety
/// The instance is alive; arrays have as many elements as said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetDirectionalDerivative(
    component: *mut Component,
    unknowns: *const u32,
    unknown_count: usize,
    knowns: *const u32,
    known_count: usize,
    seed: *const f64,
    seed_count: usize,
    sensitivity: *mut f64,
    sensitivity_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (unknowns, knowns) =
        unsafe { (slice(unknowns, unknown_count), slice(knowns, known_count)) };
    // SAFETY: as before.
    let (seed, found) =
        unsafe { (slice(seed, seed_count), slice_mut(sensitivity, sensitivity_count)) };
    let work = |component: &mut Component| {
        component.directional_derivative([unknowns, knowns], seed, found)
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// The transposed change: of a weighted sum of outputs by each input.
///
/// # Safety
/// As of [`fmi3GetDirectionalDerivative`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetAdjointDerivative(
    component: *mut Component,
    unknowns: *const u32,
    unknown_count: usize,
    knowns: *const u32,
    known_count: usize,
    seed: *const f64,
    seed_count: usize,
    sensitivity: *mut f64,
    sensitivity_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (unknowns, knowns) =
        unsafe { (slice(unknowns, unknown_count), slice(knowns, known_count)) };
    // SAFETY: as before.
    let (seed, found) =
        unsafe { (slice(seed, seed_count), slice_mut(sensitivity, sensitivity_count)) };
    let work = |component: &mut Component| {
        let Some((outputs, inputs)) = places(unknowns, knowns) else {
            return component.wrong(NO_DERIVATIVE);
        };
        let mut caution = None;
        for (found, input) in found.iter_mut().zip(inputs) {
            match component.instance.derivative(&outputs, &[(input, 1.0)]) {
                Ok((change, words)) => {
                    *found = change.iter().zip(seed).map(|(one, by)| one * by).sum();
                    caution = caution.or(words);
                }
                Err(error) => return component.discard(&error),
            }
        }
        component.told(caution)
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// There are no discrete states.
///
/// # Safety
/// The instance is alive, and places are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    component: *mut Component,
    needed: *mut bool,
    terminate: *mut bool,
    nominals: *mut bool,
    values: *mut bool,
    is_defined: *mut bool,
    next: *mut f64,
) -> Status {
    let work = |_: &mut Component| {
        for place in [needed, terminate, nominals, values, is_defined] {
            // SAFETY: the host's promise, here and below.
            if let Some(place) = unsafe { place.as_mut() } {
                *place = false;
            }
        }
        // SAFETY: as before.
        if let Some(next) = unsafe { next.as_mut() } {
            *next = 0.0;
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(component, work) }
}

/// There are no step events.
///
/// # Safety
/// The instance is alive, and places are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3CompletedIntegratorStep(
    component: *mut Component,
    _no_set_before: bool,
    enter_event_mode: *mut bool,
    terminate: *mut bool,
) -> Status {
    let work = |_: &mut Component| {
        for place in [enter_event_mode, terminate] {
            // SAFETY: the host's promise.
            if let Some(place) = unsafe { place.as_mut() } {
                *place = false;
            }
        }
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

/// Outputs have no derivatives by time.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetOutputDerivatives(
    component: *mut Component,
    _references: *const u32,
    _count: usize,
    _orders: *const i32,
    _values: *mut f64,
    _value_count: usize,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(component, |component| component.wrong("no derivatives by time")) }
}

/// Does a step: outputs follow from the inputs at once; a state without an answer is discarded.
///
/// # Safety
/// The instance is alive, and places are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    component: *mut Component,
    current: f64,
    step: f64,
    _no_set_before: bool,
    event: *mut bool,
    terminate: *mut bool,
    early: *mut bool,
    last: *mut f64,
) -> Status {
    let work = |component: &mut Component| {
        for place in [event, terminate, early] {
            // SAFETY: the host's promise, here and below.
            if let Some(place) = unsafe { place.as_mut() } {
                *place = false;
            }
        }
        let outcome = component.instance.outputs();
        let time = if outcome.is_ok() { current + step } else { current };
        component.instance.inputs.time = time;
        // SAFETY: as before.
        if let Some(last) = unsafe { last.as_mut() } {
            *last = time;
        }
        match outcome {
            Ok(_) => component.answered(),
            Err(error) => component.discard(&error),
        }
    };
    // SAFETY: the host's promise.
    unsafe { with(component, work) }
}

/// There are no partitions.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ActivateModelPartition(
    component: *mut Component,
    _clock: u32,
    _time: f64,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(component, |component| component.wrong("there are no partitions")) }
}
