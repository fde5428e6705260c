//! Displacement, strain and stress inside the bodies.
// Tests may fail by unwrapping and by panicking.
#![allow(clippy::float_cmp, clippy::panic, clippy::unwrap_used)]

mod beside;
mod elements;
mod equations;
mod far;
mod planes;
mod reference;
mod rolling;
mod spheroidal;
mod support;
mod together;
mod yielding;
