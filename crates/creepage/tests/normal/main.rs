//! Normal contact of bodies of any shape.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::print_stdout)]
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]

mod bad_input;
mod bars;
mod hertz;
mod next;
mod patches;
mod physics;
mod random;
mod shapes;
mod support;
