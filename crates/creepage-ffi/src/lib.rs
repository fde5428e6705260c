//! The C interface of creepage: for C, C++, Fortran, MATLAB and whatever else calls C.
//!
//! The header is `include/creepage.h`, made by cbindgen from this crate and checked by its tests;
//! `install.sh` builds the libraries and puts them, the header and a file for pkg-config in place.
//! Handles are opaque and may be shared between threads; nothing is global; no panic gets out.

mod bulk;
mod case;
mod failure;
mod gap;
mod half_space;
mod hertz;
mod input;
mod map;
mod report;
mod rolling;
mod status;
mod table;
mod theory;
mod wheel_steps;
mod wheelset;

use std::ffi::c_char;

pub use bulk::{CreepageCase, creepage_case_force, creepage_case_free, creepage_case_new};
pub use case::creepage_case_solve;
pub use failure::{
    CREEPAGE_COUNT, CREEPAGE_DEFECT, CREEPAGE_FILE, CREEPAGE_INVALID, CREEPAGE_NOT_REACHABLE,
    CREEPAGE_NULL, CREEPAGE_OK, CREEPAGE_ROOM, CREEPAGE_TEXT, CREEPAGE_UNSUPPORTED,
};
pub use gap::creepage_gap_force;
pub use half_space::{
    CREEPAGE_SINGULAR, CREEPAGE_VANISHING, creepage_half_space_displacement,
    creepage_half_space_traction, creepage_statics,
};
pub use hertz::{
    CREEPAGE_ADHESION, CREEPAGE_LOWER, CREEPAGE_OUTSIDE, CREEPAGE_SLIP, CREEPAGE_UPPER,
    creepage_case_below, creepage_case_field, creepage_hertz,
};
pub use map::{CreepageMap, creepage_map_free, creepage_map_load, creepage_map_solve};
pub use report::creepage_report;
pub use rolling::{
    CreepageRolling, creepage_rolling_free, creepage_rolling_new, creepage_rolling_restore,
    creepage_rolling_save, creepage_rolling_step,
};
pub use status::{
    CREEPAGE_ACCURACY_NOT_REACHED, CREEPAGE_CHECK_UNITS, CREEPAGE_CREEPAGE_TOO_SMALL,
    CREEPAGE_DOUBTFUL, CREEPAGE_NO_CASE, CREEPAGE_NO_CONTACT, CREEPAGE_NOT_CONVERGED,
    CREEPAGE_SEVERAL_SOLUTIONS, CREEPAGE_SOLVED, CREEPAGE_SPIN_TOO_LARGE, CREEPAGE_UNLIKE_BODIES,
};
pub use table::{
    CreepageTable, creepage_table_build, creepage_table_error, creepage_table_force,
    creepage_table_free, creepage_table_read, creepage_table_write,
};
pub use theory::{
    CreepageTheory, creepage_theory_force, creepage_theory_free, creepage_theory_new,
};
pub use wheel_steps::creepage_wheelset_roll;
pub use wheelset::{
    CreepageWheelset, CreepageWheelsetState, creepage_wheelset_free, creepage_wheelset_new,
    creepage_wheelset_solve, creepage_wheelset_solve_many, creepage_wheelset_state_free,
};

#[allow(clippy::doc_markdown)] // the words are for C
/// The version of this header: major, minor, patch. That of the library is creepage_version().
pub const CREEPAGE_VERSION_MAJOR: i32 = 0;
/// See CREEPAGE_VERSION_MAJOR.
#[allow(clippy::doc_markdown)] // the words are for C
pub const CREEPAGE_VERSION_MINOR: i32 = 1;
/// See CREEPAGE_VERSION_MAJOR.
#[allow(clippy::doc_markdown)] // the words are for C
pub const CREEPAGE_VERSION_PATCH: i32 = 0;

/// The version of the library, as "0.1.0"; the text is the library's own.
#[unsafe(no_mangle)]
pub extern "C" fn creepage_version() -> *const c_char {
    const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
    VERSION.as_ptr().cast()
}
