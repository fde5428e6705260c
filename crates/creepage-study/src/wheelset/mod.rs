//! A wheelset in its track: the case file, its conicity; profiles and what was done to them.
//!
//! Lengths in metres, angles in radians, forces in newtons; `x` forward, `y` to the right, `z`
//! down.

mod case;
mod conicity;
mod error;
mod file;
mod free;
mod position;
mod profile;
mod profile_picture;
mod sections;

pub use case::{Load, Stance, Travel, WheelsetCase};
pub use conicity::{ConicityTable, conicity, radius_difference_csv};
pub use error::WheelsetError;
pub use file::{WheelsetFile, wheelset_json_schema};
pub use profile::ProfileNote;
pub use profile_picture::profile_pictures;
