//! The engine of the guide's wheelset explorer: wheels on rails in a browser.
//!
//! For `wasm32-unknown-unknown`, with no imports and no bindings: arguments are numbers, a file's bytes come in where
//! [`input`] says, and answers lie in the module's memory, where [`numbers`], [`numbers_len`], [`words`] and
//! [`words_len`] say, until the next call. A worker has one engine.

mod engine;

use std::cell::RefCell;

use engine::{Dimensions, Engine, Situation};

thread_local! {
    static ENGINE: RefCell<Engine> = RefCell::new(Engine::default());
}

fn with<T>(ask: impl FnOnce(&mut Engine) -> T) -> T {
    ENGINE.with(|engine| ask(&mut engine.borrow_mut()))
}

/// Where the numbers of the last answer are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    with(|engine| engine.numbers.as_ptr())
}

/// How many they are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers_len() -> usize {
    with(|engine| engine.numbers.len())
}

/// Where the words of the last answer are, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn words() -> *const u8 {
    with(|engine| engine.words.as_ptr())
}

/// How many bytes they are.
#[unsafe(no_mangle)]
pub extern "C" fn words_len() -> usize {
    with(|engine| engine.words.len())
}

/// Room for a file of this many bytes, its name before its content; where it is.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    with(|engine| {
        engine.input.clear();
        engine.input.resize(length, 0);
        engine.input.as_mut_ptr()
    })
}

/// Words: a line for each named profile, `wheel` or `rail` and its name, with a tab between.
#[unsafe(no_mangle)]
pub extern "C" fn profiles() {
    with(Engine::profiles);
}

/// Takes the profile of this number in [`profiles`] for the wheels or the rails.
#[unsafe(no_mangle)]
pub extern "C" fn take_named(number: usize) -> bool {
    with(|engine| engine.take_named(number))
}

/// Takes the profile of the file in [`input`], whose first `name_length` bytes are its name, for the wheels
/// (`is_rail` 0) or the rails. Words: what was found, assumed and done, a line each; or why it cannot be read.
#[unsafe(no_mangle)]
pub extern "C" fn take_file(is_rail: u32, name_length: usize) -> bool {
    with(|engine| engine.take_file(is_rail != 0, name_length))
}

/// Sets the wheelset on its track: nominal radius, distance between the flange backs, rail inclination (rad), gauge,
/// how far below the rails' top it is measured (m). Numbers: the equivalent conicity at 3 mm (NaN where it has
/// none), then pairs of lateral position and difference of rolling radii (m), right less left.
#[unsafe(no_mangle)]
pub extern "C" fn set_on_track(
    radius: f64,
    back_to_back: f64,
    cant: f64,
    gauge: f64,
    gauge_height: f64,
) -> bool {
    with(|engine| {
        engine.set_on_track(&Dimensions { radius, back_to_back, cant, gauge, gauge_height })
    })
}

/// Solves the wheelset where it stands: `resolution` 0 by `fastsim`, 1, 2, 3 by `exact` at fast, standard, fine.
/// `warm_start` not 0: from the solution before, which is quicker; forces are the same within their error bars.
///
/// Numbers: of the wheelset, the wheels and the contacts, as `engine.rs` lists them. Words: the status, then the cautions of the command, a line each.
#[allow(clippy::too_many_arguments)] // no structures across this border
#[unsafe(no_mangle)]
pub extern "C" fn solve(
    resolution: u32,
    warm_start: u32,
    y: f64,
    yaw: f64,
    axle_load: f64,
    speed: f64,
    curvature: f64,
    friction: f64,
) -> bool {
    let situation = Situation { y, yaw, axle_load, speed, curvature, friction };
    with(|engine| engine.solve(resolution, warm_start != 0, &situation))
}

/// What is seen along the track, where the wheelset stands. Numbers: for the left and the right side, the number of
/// points of the wheel's outline and of the rail's, and these points `y`, `z` (m) in track axes.
#[unsafe(no_mangle)]
pub extern "C" fn outlines(spacing: f64) -> bool {
    with(|engine| engine.outlines(spacing))
}
