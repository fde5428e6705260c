//! Colours of all pictures, and the margin around them.

/// Text and outlines.
pub const DARK: &str = "#17212b";
/// What should stand back.
pub const GREY: &str = "#5d6a76";
/// Hairlines.
pub(crate) const PALE: &str = "#c9d1d9";
/// An area to be told apart: clearly darker than [`FAINT`] in grey print too.
pub(crate) const FULL: &str = "#9cc3e6";
/// The area around it, under its hatching.
pub(crate) const FAINT: &str = "#fdf3e1";
/// Hatching of the latter.
pub(crate) const HATCHING: &str = "#efc48b";
/// Arrows of a field.
pub const ARROW: &str = "#10243a";
/// What must not be overlooked.
pub const RED: &str = "#b3261e";

/// White left and right.
pub(crate) const MARGIN: f64 = 44.0;
