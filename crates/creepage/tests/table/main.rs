//! Tables of cheap theories: order of convergence, symmetry, derivative, smoothness, monotony,
//! files.

// What symmetry gives is exact; statics and a constant theory are fixtures.
#![allow(clippy::float_cmp, clippy::unwrap_used, clippy::unnecessary_wraps)]

mod accuracy;
mod build;
#[path = "../common/mod.rs"]
mod common;
mod file;
mod fixtures;
mod interpolation;
mod ranges;
