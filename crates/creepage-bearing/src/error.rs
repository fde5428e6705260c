//! Errors of the bearing solver.

use creepage::normal::NormalError;
use creepage::{HertzError, InvalidValue};

/// Error of the bearing solver.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BearingError {
    /// A number out of its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// A ball and a race that do not touch as they should.
    #[error("{race} race: {source}")]
    Hertz {
        /// `inner` or `outer`.
        race: &'static str,
        /// Why.
        source: HertzError,
    },
    /// A contact that could not be pressed for the full theory.
    #[error("{race} race: {source}")]
    Pressure {
        /// `inner` or `outer`.
        race: &'static str,
        /// Why.
        source: NormalError,
    },
    /// No displacement of the rings carries the load.
    #[error("no displacement of the rings was found at which the balls carry the load")]
    LoadNotFound,
    /// A contact wider than the ball, of which no motion was found.
    #[error(
        "ball at {azimuth:.4} rad: its contact has a semi-axis of {half_width:.3} m, more than its radius of {radius:.3} m: \
         check the units of moduli, lengths and loads (Pa, m, N)"
    )]
    LargeContact {
        /// Its place (rad).
        azimuth: f64,
        /// Half the width of the wider contact (m).
        half_width: f64,
        /// Radius of the ball (m).
        radius: f64,
    },
    /// No motion of a ball at which friction balances it.
    #[error(
        "ball at {azimuth:.4} rad: no motion was found at which friction balances its gyroscopic moment of \
         {gyroscopic:.4e} N m: friction can carry {most:.4e} N m at most, so the ball slides about its yaw axis"
    )]
    BallSlides {
        /// Its place (rad).
        azimuth: f64,
        /// Its gyroscopic moment (N m).
        gyroscopic: f64,
        /// What friction of both contacts can carry (N m).
        most: f64,
    },
    /// No motion of a ball at which its moments balance.
    #[error(
        "ball at {azimuth:.4} rad: Newton's method stagnates on its motion, residual {residual:.2e} of friction"
    )]
    MotionNotFound {
        /// Its place (rad).
        azimuth: f64,
        /// What is left, in parts of friction.
        residual: f64,
    },
}
