//! Unlike bodies, coupled both ways.
#![allow(clippy::unwrap_used)] // Tests may fail by unwrapping.

mod bearing;
mod cylinders;
mod free;
mod physics;
mod reference;
mod sliding;
mod support;
