//! The engine of the guide's explorer: the library in a browser.
//!
//! For `wasm32-unknown-unknown`, with no imports and no bindings: arguments are numbers, and answers
//! lie in the module's memory, where [`numbers`], [`numbers_len`], [`words`] and [`words_len`] say,
//! until the next call. A page has one engine, used by one thread.

mod cells;
mod engine;

use std::cell::RefCell;

use engine::{Bodies, Engine};

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

/// Words: a line for each theory, in the order of their numbers: name, what it assumes, where to use
/// it, with tabs between.
#[unsafe(no_mangle)]
pub extern "C" fn theories() {
    with(Engine::theories);
}

/// A dimensionless contact of like bodies. Numbers: those of [`bodies`]. False, with the reason in
/// words, for numbers out of range.
#[unsafe(no_mangle)]
pub extern "C" fn ellipse(a_over_b: f64, poisson: f64) -> bool {
    with(|engine| engine.ellipse(a_over_b, poisson))
}

/// The contact of two bodies in SI units: of the upper, then the lower, shear modulus, Poisson's
/// ratio and the radii along and across, infinite where flat; load and friction.
///
/// Numbers: semi-axes `a` and `b` (m), units of length, slip, force and traction, combined Poisson's
/// ratio, `kappa/mu`. False, with the reason in words, for numbers out of range.
#[allow(clippy::too_many_arguments)] // no structures across this border
#[unsafe(no_mangle)]
pub extern "C" fn bodies(
    upper_modulus: f64,
    upper_poisson: f64,
    upper_rolling: f64,
    upper_lateral: f64,
    lower_modulus: f64,
    lower_poisson: f64,
    lower_rolling: f64,
    lower_lateral: f64,
    load: f64,
    friction: f64,
) -> bool {
    let bodies = Bodies {
        modulus: [upper_modulus, lower_modulus],
        poisson: [upper_poisson, lower_poisson],
        rolling: [upper_rolling, lower_rolling],
        lateral: [upper_lateral, lower_lateral],
        load,
        friction,
    };
    with(|engine| engine.bodies(&bodies))
}

/// Numbers: `fx`, `fy`, `mz`, their error bars (NaN for a theory without), and the frictional power
/// over `mu N mu c V / rho`. Words: the status. `resolution`, of the theory `exact`: 0 fast,
/// 1 standard, 2 fine. False, with the reason in words, for a contact or a creepage out of the
/// theory's range.
#[unsafe(no_mangle)]
pub extern "C" fn solve(theory: usize, resolution: u32, xi: f64, eta: f64, chi: f64) -> bool {
    with(|engine| engine.solve([theory, resolution as usize], [xi, eta, chi]))
}

/// As [`solve`], and the contact cell by cell: for each, corners `x`, `y` all around (8 numbers, in
/// units of `c`), traction (2, over its largest bound), slip (2), and 1 where it slips, else 0.
#[unsafe(no_mangle)]
pub extern "C" fn show(theory: usize, resolution: u32, xi: f64, eta: f64, chi: f64) -> bool {
    with(|engine| engine.show([theory, resolution as usize], [xi, eta, chi]))
}
