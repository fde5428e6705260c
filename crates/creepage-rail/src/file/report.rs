//! What was found, assumed and done while reading.

use std::fmt;

/// One thing that was found, assumed or done.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Action {
    /// Points that the file itself marks as not to be used.
    Skipped {
        /// How many.
        count: usize,
    },
    /// Something in the file that has no effect here.
    Ignored {
        /// Line.
        line: usize,
        /// What it is.
        what: &'static str,
    },
    /// Something that the file asks to be done to its points.
    Applied {
        /// What it is.
        what: &'static str,
    },
    /// The unit of length, found by the profile's size.
    UnitFound {
        /// Its length (m).
        metres: f64,
    },
    /// A convention that neither the file nor its shape shows.
    Assumed {
        /// What was assumed.
        what: &'static str,
    },
    /// `z` pointed up.
    TurnedOver,
    /// `y` grew to the track side.
    Mirrored,
    /// The points ran the other way.
    Reversed,
    /// A point that repeated the one before was dropped.
    Repeated {
        /// Line.
        line: usize,
    },
    /// Two points that went back and forth were replaced by their mean.
    ZigZag {
        /// Line of the first.
        line: usize,
    },
    /// A point at which a scan went back was dropped.
    TurnedBack {
        /// Line.
        line: usize,
    },
    /// A true corner, kept.
    Corner {
        /// Line.
        line: usize,
        /// Turn (rad), positive where the material's corner is convex.
        turn: f64,
    },
    /// A sharp turn amid others: roughness, drawn through.
    Rough {
        /// Line.
        line: usize,
        /// Turn (rad).
        turn: f64,
    },
    /// A gap between points, bridged by a straight line.
    Bridged {
        /// Line after the gap.
        line: usize,
        /// Its length (m).
        length: f64,
    },
    /// The points were smoothed.
    Smoothed {
        /// Waves of this length (m) keep half of their amplitude.
        wavelength: f64,
    },
}

impl fmt::Display for Action {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Skipped { count } => {
                write!(formatter, "{count} points marked as unused, skipped")
            }
            Self::Ignored { line, what } => write!(formatter, "line {line}: {what} ignored"),
            Self::Applied { what } => write!(formatter, "{what} of the file applied"),
            Self::UnitFound { metres } => {
                write!(formatter, "unit found by the profile's size: {metres} m")
            }
            Self::Assumed { what } => write!(formatter, "assumed: {what}"),
            Self::TurnedOver => write!(formatter, "z points up in the file: turned over"),
            Self::Mirrored => write!(formatter, "y grows to the track side in the file: mirrored"),
            Self::Reversed => write!(formatter, "order of points reversed"),
            Self::Repeated { line } => write!(formatter, "line {line}: repeated point dropped"),
            Self::ZigZag { line } => {
                write!(formatter, "line {line}: zig-zag of two points, replaced by their mean")
            }
            Self::TurnedBack { line } => {
                write!(formatter, "line {line}: the scan goes back, point dropped")
            }
            Self::Corner { line, turn } => {
                write!(formatter, "line {line}: corner of {:.1} degrees kept", turn.to_degrees())
            }
            Self::Rough { line, turn } => {
                write!(formatter, "line {line}: rough, turns by {:.1} degrees", turn.to_degrees())
            }
            Self::Bridged { line, length } => {
                write!(formatter, "line {line}: gap of {:.1} mm bridged", 1e3 * length)
            }
            Self::Smoothed { wavelength } => {
                write!(formatter, "smoothed: waves of {:.2} mm halved", 1e3 * wavelength)
            }
        }
    }
}
