//! Rolling that is not steady.

#![allow(clippy::unwrap_used)]

mod area;
mod cases;
mod fastsim;
mod friction;
mod layer;
mod line;
mod load;
mod order;
mod physics;
mod random;
mod reference;
mod support;
mod wave;
