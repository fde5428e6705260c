//! Report of a reading: what was found, assumed and done.

use std::fmt;

use crate::{Role, Smoothing};

/// Finding, assumption or repair while a file was read.
#[derive(Debug, Clone, PartialEq)]
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
    /// The text is in UTF-16.
    Utf16,
    /// Commas stand for decimal points.
    DecimalCommas,
    /// A key that is not known, and has no effect.
    UnknownKey {
        /// Line.
        line: usize,
        /// The key.
        key: String,
    },
    /// A role that only the shape shows.
    RoleFound {
        /// The role.
        role: Role,
    },
    /// A role as asked for, which the file's content or name contradicts.
    RoleAsked {
        /// The role.
        role: Role,
    },
    /// The shape shows another sense than the format has.
    AgainstFormat {
        /// The axis.
        what: &'static str,
    },
    /// The running surface lies far from the profile's origin.
    FarOrigin {
        /// Wheel or rail.
        role: Role,
        /// The wheel's end on the track side, the middle of the rail (m).
        y: f64,
        /// Level of the running surface (m).
        z: f64,
    },
    /// The head was taken from the outline of a whole rail.
    Outline {
        /// Points left out.
        count: usize,
    },
    /// Points made from arcs and lines.
    Segments {
        /// How many arcs and lines.
        count: usize,
    },
    /// A point without a number was dropped.
    Unmeasured {
        /// Line.
        line: usize,
    },
    /// A point that stands out alone was dropped.
    Spike {
        /// Line.
        line: usize,
        /// Number of the point, from 1.
        point: usize,
        /// How far it stands out, in the file's unit.
        height: f64,
    },
    /// A point far from all others, as where a scanner writes a number for "nothing measured", was dropped.
    Outlier {
        /// Line.
        line: usize,
        /// Its place in the file's unit.
        at: [f64; 2],
    },
    /// The file holds more points than it says.
    MorePoints {
        /// As it says.
        said: usize,
        /// As there are.
        found: usize,
    },
    /// Points of a part that was measured again were dropped.
    Overlap {
        /// Line of the first.
        line: usize,
        /// How many.
        count: usize,
        /// Greatest distance from the first pass (m).
        apart: f64,
    },
    /// Two passes were in the other order than the profile has them.
    PassesSwapped {
        /// Line at which that begins which now comes first.
        line: usize,
    },
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
        /// How strongly.
        smoothing: Smoothing,
    },
}

impl fmt::Display for Action {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
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
            Self::Smoothed { smoothing: Smoothing::Wavelength(wavelength) } => {
                write!(formatter, "smoothed: waves of {:.2} mm halved", 1e3 * wavelength)
            }
            Self::Smoothed { smoothing: Smoothing::Weight(weight) } => {
                write!(formatter, "smoothed by a weight of {:.4} mm3", 1e9 * weight)
            }
            found => found.words_on_the_file(formatter),
        }
    }
}

impl Action {
    /// What was found in the text, in the shape and in the scans; nothing of the others.
    fn words_on_the_file(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Utf16 => write!(formatter, "text in UTF-16"),
            Self::DecimalCommas => write!(formatter, "decimal commas, read as points"),
            Self::UnknownKey { line, key } => {
                write!(formatter, "line {line}: {key} is not known, no effect")
            }
            Self::RoleFound { role } => write!(formatter, "found by its shape: a {role}"),
            Self::RoleAsked { role } => {
                write!(formatter, "read as a {role}, as asked; the file says otherwise")
            }
            Self::AgainstFormat { what } => {
                write!(formatter, "{what} by the shape, against the format")
            }
            Self::FarOrigin { role, y, z } => far_words(formatter, *role, *y, *z),
            Self::Outline { count } => {
                write!(formatter, "outline of a whole rail: head taken, {count} points left out")
            }
            Self::Segments { count } => write!(formatter, "points made from {count} segments"),
            Self::Unmeasured { line } => {
                write!(formatter, "line {line}: a value that is no number, point dropped")
            }
            Self::Spike { line, point, height } => {
                write!(
                    formatter,
                    "line {line}: spike at point {point}, {height:.3} high in the file's unit, dropped"
                )
            }
            Self::Outlier { line, at: [y, z] } => {
                write!(formatter, "line {line}: ({y}, {z}) lies far from all other points, dropped")
            }
            Self::MorePoints { said, found } => {
                write!(formatter, "{found} points, though the file says {said}: all of them taken")
            }
            Self::PassesSwapped { line } => {
                write!(formatter, "line {line}: the pass that begins here comes first")
            }
            Self::Overlap { line, count, apart } => {
                let apart = 1e6 * apart;
                write!(
                    formatter,
                    "line {line}: overlapping scans, {count} points measured again dropped, up to \
                     {apart:.0} um from the first pass"
                )
            }
            _ => Ok(()),
        }
    }
}

fn far_words(formatter: &mut fmt::Formatter<'_>, role: Role, y: f64, z: f64) -> fmt::Result {
    let [y, z] = [1e3 * y, 1e3 * z];
    match role {
        Role::Wheel => write!(
            formatter,
            "far from its origin: the tread lies at z = {z:.1} mm, the flange's back at y = {y:.1} mm; the \
             radius is that at z = 0, and flange_back -70 mm unless given"
        ),
        Role::Rail => write!(
            formatter,
            "far from its origin: the head lies at y = {y:.1} mm, z = {z:.1} mm; rail_position is that of \
             y = 0, a gauge that of the head"
        ),
    }
}
