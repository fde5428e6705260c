//! The classical problems of section 3.2 against closed forms, limits and each other.
#![allow(clippy::unwrap_used)] // Tests may fail by unwrapping.

mod bonded;
mod compression;
mod die;
mod partial_slip;
mod sheared_rectangle;
mod shift_path;
mod support;
