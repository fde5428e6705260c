//! The command, run as its users run it.
// Helpers of tests fail like tests: by panicking.
#![allow(clippy::unwrap_used, clippy::panic)]

mod bad_input;
mod batch;
mod commands;
mod conicity;
mod curve;
mod examples;
mod gap;
#[cfg(unix)]
mod guide;
mod inverse;
mod place;
mod reproduce;
mod statics;
mod stresses;
mod sweep;
mod table;
mod theories;
