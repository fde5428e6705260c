//! The contact map of a wheelset: forces of the full theory by look-up, in microseconds.
//!
//! At a given place of wheel on rail the tangential forces of the full theory over all creepages are those
//! of **two ellipses** with nine fitted numbers: sizes, shapes, offset and share. A [`ContactMap`] holds these
//! at nodes along the wheel's lateral place and its load, with heights, angles and reference points, and
//! blends the *forces* of neighbouring nodes by their values and slopes, which keeps `|T| <= mu N` and a continuous
//! first derivative.
//! It knows its own error, measured on fresh states against the full theory when it was built.
//!
//! Asked outside its range a map gives an error that names the bound; it does not extrapolate. An answer is a
//! pure function of the state, without allocation; a map may be shared between threads.
//!
//! ```no_run
//! use creepage_map::{ContactMap, HeightOrLoad, State};
//! let map = ContactMap::from_bytes(std::fs::read("wheelset.nc")?)?;
//! let state = State {
//!     y: 0.003,
//!     yaw: 0.001,
//!     roll: None,
//!     pressed: HeightOrLoad::AxleLoad(100e3),
//!     speed: 30.0,
//!     pitch_rate: None,
//!     lateral_velocity: 0.0,
//!     vertical_velocity: 0.0,
//!     roll_rate: 0.0,
//!     yaw_rate: 0.0,
//!     friction: 0.3,
//! };
//! let answer = map.solve(&state)?;
//! println!("{:?} N, within {:.1e} mu N", answer.right.force, answer.right.error.tangential);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod blend;
mod equilibrium;
mod error;
mod file;
mod fit;
mod map;
mod normal;
mod patch;
mod scalar;
mod slopes;
mod wheel;

pub use answer::{Answer, HeightOrLoad, PatchAnswer, State, WheelAnswer};
pub use blend::interpolated;
pub use error::{MapError, Quantity};
pub use fit::{Contour, Fit, Sample, fit};
pub use map::{ContactMap, Derivatives, Head, MapAccuracy, Spread, VARIABLES};
pub use normal::{HEIGHTS, HeightNode, Heights, PLACE, ROLLS, TURNS, Turned, YAWS};
pub use patch::{Ellipse, EllipseSlopes, Patch, Sloped};
pub use slopes::slopes;
pub use wheel::{CellError, PLACES, RollingNode, WheelMap};

/// A side of the track, seen in the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// `y < 0`.
    Left,
    /// `y > 0`.
    Right,
}
