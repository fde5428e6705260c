//! The command, run as its users run it.
// Helpers of tests fail like tests: by panicking.
#![allow(clippy::unwrap_used, clippy::panic)]

mod bad_input;
mod batch;
mod bearing;
mod commands;
mod conicity;
mod curve;
mod curved;
mod doors;
mod examples;
#[cfg(unix)]
mod faults;
mod fit;
mod friction_laws;
mod gap;
mod gap_batch;
#[cfg(unix)]
mod guide;
mod heat;
mod history;
mod inverse;
mod line;
mod map;
mod met;
mod no_effect;
mod place;
mod profile;
mod reproduce;
mod roll;
mod slip;
mod sources;
mod statics;
mod stresses;
mod sweep;
mod table;
mod theories;
mod told;
mod wear;
mod wheelset;
