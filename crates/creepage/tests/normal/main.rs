//! Normal contact of bodies of any shape.
#![allow(missing_docs)]

mod bad_input;
mod hertz;
mod physics;
mod random;
mod shapes;
mod support;
