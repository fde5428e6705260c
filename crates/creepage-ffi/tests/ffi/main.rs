//! The C interface as its callers see it: one program of tests, which is linked once.

// Helpers of tests fail like tests: by panicking. Equal bits are meant where numbers are compared.
// What was not run must be reported.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stderr,
    clippy::float_cmp,
    clippy::cast_precision_loss
)]

mod bulk;
mod caller;
mod case;
mod fuzz;
mod gap;
mod half_space;
mod header;
mod interface;
#[path = "../../../creepage-map/tests/common/mod.rs"]
#[allow(unreachable_pub, missing_docs, dead_code)] // what several tests share
mod made_up;
mod map;
#[cfg(unix)]
mod programs;
mod report;
mod rolling;
mod wheelset;
mod wrong;
