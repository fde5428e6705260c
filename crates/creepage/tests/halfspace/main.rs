//! The half-space theory of chapters 2 and 3, against other ways to the same numbers.
// Tests may fail by unwrapping; degrees and counts are small.
#![allow(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]

mod coefficients;
mod equations;
mod oracle;
mod robust;
mod support;
mod unlike;
