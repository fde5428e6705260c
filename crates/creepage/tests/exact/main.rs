//! The full theory against reference cases, its limits, and the laws it must obey.
// Tests may fail by unwrapping and by panicking.
#![allow(clippy::panic, clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
mod cost;
mod curve;
mod derivative;
mod error_bar;
mod friction;
mod limits;
mod power;
mod reference;
mod robust;
mod support;
mod unlike;
