//! Errors of the normal solver.

use crate::check::InvalidValue;

/// A side of the rectangle in which the gap is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Least x: the trailing side when the bodies roll in +x.
    LowX,
    /// Greatest x.
    HighX,
    /// Least y.
    LowY,
    /// Greatest y.
    HighY,
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::LowX => "low-x",
            Self::HighX => "high-x",
            Self::LowY => "low-y",
            Self::HighY => "high-y",
        })
    }
}

/// Error of two bodies without a contact area that can be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NormalError {
    /// A number is outside its range.
    #[error(transparent)]
    Invalid(#[from] InvalidValue),
    /// The bodies do not touch.
    #[error("no contact: the approach {approach} m is not above the least gap {least_gap} m")]
    NoContact {
        /// The approach (m).
        approach: f64,
        /// The least value of the gap that was found (m).
        least_gap: f64,
    },
    /// The gap stays below the approach however far one goes.
    #[error(
        "the gap stays below the approach {approach} m along a line or everywhere: no finite \
         contact area follows from it"
    )]
    Unbounded {
        /// The approach (m).
        approach: f64,
    },
    /// The contact area reaches a side of the rectangle in which the gap is known.
    #[error("the contact area reaches the {side} side of the given gap: {}", further(*beyond))]
    ReachesEdge {
        /// The side.
        side: Side,
        /// How much further the gap must be known (m), estimated from its last parabola; infinite where that does
        /// not rise.
        beyond: f64,
    },
    /// The gap is not a number at some place.
    #[error("the gap at x = {x} m, y = {y} m is {value}")]
    NotFinite {
        /// The place along rolling (m).
        x: f64,
        /// The place across (m).
        y: f64,
        /// The gap there.
        value: f64,
    },
    /// No approach was found that carries the load.
    #[error(
        "no approach carries {load} N: between {approach} m and the next one tried the load jumps"
    )]
    LoadNotFound {
        /// The load (N).
        load: f64,
        /// The last approach tried (m).
        approach: f64,
    },
}

/// How far a gap must go on, in words.
fn further(beyond: f64) -> String {
    if beyond.is_finite() {
        format!("it must go on for at least {beyond:.3e} m more there")
    } else {
        "it does not rise there. Give it as far as the bodies go, where it rises above the approach"
            .into()
    }
}
