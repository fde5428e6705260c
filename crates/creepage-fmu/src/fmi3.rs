//! The functions of FMI 3.0: those of version 2 by their new names, and what is new.
// Names and arguments are those of the standard.
#![allow(non_snake_case, clippy::too_many_arguments, clippy::fn_params_excessive_bools)]

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr;

use crate::host::{self, DISCARD, ERROR, OK, Status, places, slice, slice_mut};
use crate::instance::{Inputs, Instance, STATE_BYTES};
use crate::variables::{real, switch};

type LogMessage = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);

/// What an instance of version 3 is to the host.
#[derive(Debug)]
pub struct Instance3 {
    instance: Instance,
    log: Option<LogMessage>,
    environment: *mut c_void,
}

impl Instance3 {
    fn say(&self, status: Status, words: &str) -> Status {
        say(self.log, self.environment, status, words);
        status
    }

    fn wrong(&self, words: &str) -> Status {
        self.say(ERROR, words)
    }
}

fn say(log: Option<LogMessage>, environment: *mut c_void, status: Status, words: &str) {
    let words = CString::new(words).unwrap_or_default();
    if let Some(log) = log {
        // SAFETY: the host's own function with what it gave us; texts end with a zero.
        unsafe { log(environment, status, c"logStatusError".as_ptr(), words.as_ptr()) };
    }
}

/// Does something with an instance; a NULL is an error, and nothing unwinds into the host.
///
/// # Safety
/// `instance` is NULL or of this library and not freed.
unsafe fn with(instance: *mut Instance3, work: impl FnOnce(&mut Instance3) -> Status) -> Status {
    // SAFETY: the host's promise.
    let Some(instance) = (unsafe { instance.as_mut() }) else { return ERROR };
    catch_unwind(AssertUnwindSafe(|| work(instance))).unwrap_or(ERROR)
}

/// Version of the interface.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
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
) -> *mut Instance3 {
    let make = || {
        let text = |text: *const c_char| {
            // SAFETY: the caller's promise.
            (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) }.to_string_lossy())
        };
        let (Some(token), Some(resources)) = (text(token), text(resources)) else {
            say(log, environment, ERROR, "instantiation token and resource path are needed");
            return ptr::null_mut();
        };
        let path = format!("{}/wheelset.nc", resources.trim_end_matches(['/', '\\']));
        match Instance::open(&path, &token) {
            Ok(instance) => Box::into_raw(Box::new(Instance3 { instance, log, environment })),
            Err(error) => {
                say(log, environment, ERROR, &error.to_string());
                ptr::null_mut()
            }
        }
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
) -> *mut Instance3 {
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
) -> *mut Instance3 {
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
) -> *mut Instance3 {
    say(log, environment, ERROR, "there is no Scheduled Execution");
    ptr::null_mut()
}

/// Frees an instance.
///
/// # Safety
/// It is of this library or NULL, and not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: *mut Instance3) {
    if !instance.is_null() {
        // SAFETY: the host gives it up.
        drop(unsafe { Box::from_raw(instance) });
    }
}

/// Functions that take an instance and have nothing to do.
macro_rules! nothing_to_do {
    ($($name:ident($($argument:ident: $kind:ty),*);)*) => {$(
        /// Nothing is to be done: there are no states, events, clocks and modes.
        ///
        /// # Safety
        /// The instance is alive.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(instance: *mut Instance3, $($argument: $kind),*) -> Status {
            let _ = ($($argument,)*);
            // SAFETY: the host's promise.
            unsafe { with(instance, |_| OK) }
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
    instance: *mut Instance3,
    _has_tolerance: bool,
    _tolerance: f64,
    start: f64,
    _has_stop: bool,
    _stop: f64,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { fmi3SetTime(instance, start) }
}

/// As new.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(instance: *mut Instance3) -> Status {
    let work = |instance: &mut Instance3| {
        instance.instance.reset();
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(instance, work) }
}

/// Sets the time, on which nothing depends.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetTime(instance: *mut Instance3, time: f64) -> Status {
    let work = |instance: &mut Instance3| {
        instance.instance.inputs.time = time;
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(instance, work) }
}

/// Numbers by their references; that of time is 0.
///
/// # Safety
/// The instance is alive; arrays have as many elements as said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    instance: *mut Instance3,
    references: *const u32,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) =
        unsafe { (slice(references, count), slice_mut(values, value_count)) };
    let work = |instance: &mut Instance3| {
        for (value, reference) in values.iter_mut().zip(references) {
            if *reference == 0 {
                *value = instance.instance.inputs.time;
                continue;
            }
            let Some(place) = real(*reference) else {
                return instance.wrong(&format!("no Float64 has the reference {reference}"));
            };
            match instance.instance.real(place) {
                Ok(found) => *value = found,
                Err(error) => return instance.say(DISCARD, &error.to_string()),
            }
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Sets inputs.
///
/// # Safety
/// As of [`fmi3GetFloat64`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    instance: *mut Instance3,
    references: *const u32,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) = unsafe { (slice(references, count), slice(values, value_count)) };
    let work = |instance: &mut Instance3| {
        for (value, reference) in values.iter().zip(references) {
            let is_set =
                real(*reference).is_some_and(|place| instance.instance.set_real(place, *value));
            if !is_set {
                return instance.wrong(&format!("no input has the reference {reference}"));
            }
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Switches by their references.
///
/// # Safety
/// As of [`fmi3GetFloat64`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBoolean(
    instance: *mut Instance3,
    references: *const u32,
    count: usize,
    values: *mut bool,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let (references, values) =
        unsafe { (slice(references, count), slice_mut(values, value_count)) };
    let work = |instance: &mut Instance3| {
        for (value, reference) in values.iter_mut().zip(references) {
            let Some(place) = switch(*reference) else {
                return instance.wrong(&format!("no Boolean has the reference {reference}"));
            };
            *value = instance.instance.inputs.switches[place];
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Sets switches.
///
/// # Safety
/// As of [`fmi3GetFloat64`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBoolean(
    instance: *mut Instance3,
    references: *const u32,
    count: usize,
    values: *const u8,
    value_count: usize,
) -> Status {
    // SAFETY: the host's promise, here and below; any byte but zero is true.
    let (references, values) = unsafe { (slice(references, count), slice(values, value_count)) };
    let work = |instance: &mut Instance3| {
        for (value, reference) in values.iter().zip(references) {
            let Some(place) = switch(*reference) else {
                return instance.wrong(&format!("no Boolean has the reference {reference}"));
            };
            instance.instance.set_switch(place, *value != 0);
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
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
            instance: *mut Instance3,
            _references: *const u32,
            count: usize,
            _values: $pointer,
            _value_count: usize,
        ) -> Status {
            let work = |instance: &mut Instance3| {
                if count == 0 { OK } else { instance.wrong("there is no variable of this kind") }
            };
            // SAFETY: the host's promise.
            unsafe { with(instance, work) }
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
            instance: *mut Instance3,
            _references: *const u32,
            count: usize,
            $($argument: $kind),*
        ) -> Status {
            let _ = ($($argument,)*);
            let work = |instance: &mut Instance3| {
                if count == 0 { OK } else { instance.wrong("there is no variable of this kind") }
            };
            // SAFETY: the host's promise.
            unsafe { with(instance, work) }
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
            instance: *mut Instance3,
            $($argument: $kind,)*
            number: *mut usize,
        ) -> Status {
            let _ = ($($argument,)*);
            let work = |_: &mut Instance3| {
                // SAFETY: the host's promise.
                let Some(number) = (unsafe { number.as_mut() }) else { return ERROR };
                *number = 0;
                OK
            };
            // SAFETY: the host's promise.
            unsafe { with(instance, work) }
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
    instance: *mut Instance3,
    _dependent: u32,
    _dependent_elements: *mut usize,
    _independents: *mut u32,
    _independent_elements: *mut usize,
    _kinds: *mut c_int,
    _count: usize,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(instance, |_| OK) }
}

/// Keeps what an instance remembers.
///
/// # Safety
/// The instance is alive; `state` points to NULL or to a state of this function.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(
    instance: *mut Instance3,
    state: *mut *mut Inputs,
) -> Status {
    // SAFETY: the host's promise, here and below.
    let work = |instance: &mut Instance3| unsafe { host::keep(instance.instance.inputs, state) };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Goes back to what was kept.
///
/// # Safety
/// The instance is alive, `state` is of [`fmi3GetFMUState`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(instance: *mut Instance3, state: *mut Inputs) -> Status {
    // SAFETY: the host's promise, here and below.
    let Some(state) = (unsafe { state.as_ref() }) else { return ERROR };
    let work = |instance: &mut Instance3| {
        instance.instance.set_inputs(*state);
        OK
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Frees what was kept.
///
/// # Safety
/// `state` points to NULL or to a state, which is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(
    instance: *mut Instance3,
    state: *mut *mut Inputs,
) -> Status {
    // SAFETY: the host's promise, here and below.
    unsafe { with(instance, |_| host::free(state)) }
}

/// Bytes of a kept state.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: *mut Instance3,
    _state: *mut Inputs,
    size: *mut usize,
) -> Status {
    let work = |_: &mut Instance3| {
        // SAFETY: the host's promise.
        let Some(size) = (unsafe { size.as_mut() }) else { return ERROR };
        *size = STATE_BYTES;
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(instance, work) }
}

/// Writes a kept state as bytes.
///
/// # Safety
/// The instance is alive, `state` is a state, `bytes` has room for `size`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: *mut Instance3,
    state: *mut Inputs,
    bytes: *mut u8,
    size: usize,
) -> Status {
    let work = |instance: &mut Instance3| {
        // SAFETY: the host's promise.
        let written = unsafe { host::written(state, bytes, size) };
        written.map_or_else(|| instance.wrong("there is no room for the state"), |()| OK)
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Reads a kept state from bytes.
///
/// # Safety
/// As of [`fmi3SerializeFMUState`]; `state` points to NULL or to a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: *mut Instance3,
    bytes: *const u8,
    size: usize,
    state: *mut *mut Inputs,
) -> Status {
    let work = |instance: &mut Instance3| {
        // SAFETY: the host's promise.
        let read = unsafe { host::read(bytes, size, state) };
        read.map_or_else(|| instance.wrong("these are no bytes of a state"), |()| OK)
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// Change of outputs with inputs.
///
/// # Safety
/// The instance is alive; arrays have as many elements as said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetDirectionalDerivative(
    instance: *mut Instance3,
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
    let work = |instance: &mut Instance3| {
        let Some((outputs, inputs)) = places(unknowns, knowns) else {
            return instance.wrong("derivatives are those of outputs by inputs");
        };
        let direction: Vec<_> = inputs.into_iter().zip(seed.iter().copied()).collect();
        match instance.instance.derivative(&outputs, &direction) {
            Ok(change) => {
                found.iter_mut().zip(change).for_each(|(to, from)| *to = from);
                OK
            }
            Err(error) => instance.say(DISCARD, &error.to_string()),
        }
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// The transposed change: of a weighted sum of outputs by each input.
///
/// # Safety
/// As of [`fmi3GetDirectionalDerivative`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetAdjointDerivative(
    instance: *mut Instance3,
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
    let work = |instance: &mut Instance3| {
        let Some((outputs, inputs)) = places(unknowns, knowns) else {
            return instance.wrong("derivatives are those of outputs by inputs");
        };
        for (found, input) in found.iter_mut().zip(inputs) {
            match instance.instance.derivative(&outputs, &[(input, 1.0)]) {
                Ok(change) => *found = change.iter().zip(seed).map(|(one, by)| one * by).sum(),
                Err(error) => return instance.say(DISCARD, &error.to_string()),
            }
        }
        OK
    };
    // SAFETY: as before.
    unsafe { with(instance, work) }
}

/// There are no discrete states.
///
/// # Safety
/// The instance is alive, and places are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    instance: *mut Instance3,
    needed: *mut bool,
    terminate: *mut bool,
    nominals: *mut bool,
    values: *mut bool,
    is_defined: *mut bool,
    next: *mut f64,
) -> Status {
    let work = |_: &mut Instance3| {
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
    unsafe { with(instance, work) }
}

/// There are no step events.
///
/// # Safety
/// The instance is alive, and places are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3CompletedIntegratorStep(
    instance: *mut Instance3,
    _no_set_before: bool,
    enter_event_mode: *mut bool,
    terminate: *mut bool,
) -> Status {
    let work = |_: &mut Instance3| {
        for place in [enter_event_mode, terminate] {
            // SAFETY: the host's promise.
            if let Some(place) = unsafe { place.as_mut() } {
                *place = false;
            }
        }
        OK
    };
    // SAFETY: the host's promise.
    unsafe { with(instance, work) }
}

/// Outputs have no derivatives by time.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetOutputDerivatives(
    instance: *mut Instance3,
    _references: *const u32,
    _count: usize,
    _orders: *const i32,
    _values: *mut f64,
    _value_count: usize,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(instance, |instance| instance.wrong("no derivatives by time")) }
}

/// Goes on: outputs are those of the inputs. Outside the map it discards the step.
///
/// # Safety
/// The instance is alive, and places are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: *mut Instance3,
    current: f64,
    step: f64,
    _no_set_before: bool,
    event: *mut bool,
    terminate: *mut bool,
    early: *mut bool,
    last: *mut f64,
) -> Status {
    let work = |instance: &mut Instance3| {
        for place in [event, terminate, early] {
            // SAFETY: the host's promise, here and below.
            if let Some(place) = unsafe { place.as_mut() } {
                *place = false;
            }
        }
        let outcome = instance.instance.outputs();
        let time = if outcome.is_ok() { current + step } else { current };
        instance.instance.inputs.time = time;
        // SAFETY: as before.
        if let Some(last) = unsafe { last.as_mut() } {
            *last = time;
        }
        match outcome {
            Ok(_) => OK,
            Err(error) => instance.say(DISCARD, &error.to_string()),
        }
    };
    // SAFETY: the host's promise.
    unsafe { with(instance, work) }
}

/// There are no partitions.
///
/// # Safety
/// The instance is alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ActivateModelPartition(
    instance: *mut Instance3,
    _clock: u32,
    _time: f64,
) -> Status {
    // SAFETY: the host's promise.
    unsafe { with(instance, |instance| instance.wrong("there are no partitions")) }
}
