//! Carter's theory, strip theory, FASTSIM and FaStrip.

// Where the theory's value is exact, so is the comparison.
#![allow(clippy::float_cmp)]
// Helpers of tests fail as tests do.
#![allow(clippy::unwrap_used, clippy::panic)]
// Rows and columns are the plainest names for the entries of a matrix.
#![allow(clippy::needless_range_loop)]

#[path = "../common/mod.rs"]
mod common;

mod carter;
mod cases;
mod derivatives;
mod fastrip;
mod fastsim;
mod plane;
mod properties;
mod reduction;
mod strip;
