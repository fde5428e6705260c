//! The sheet that every picture is drawn on: its inks, width and margins.

use crate::scene::Point;

/// Ink for text and outlines.
pub(crate) const DARK: &str = "#17212b";
/// Ink for what should stand back.
pub(crate) const GREY: &str = "#5d6a76";
/// Hairlines.
pub(crate) const PALE: &str = "#c9d1d9";
/// The adhesion area: clearly darker than the slip area in grey print too.
pub(crate) const ADHESION: &str = "#9cc3e6";
/// The slip area, under its hatching.
pub(crate) const SLIP: &str = "#fdf3e1";
/// Hatching of the slip area.
pub(crate) const HATCHING: &str = "#efc48b";
/// Traction.
pub(crate) const TRACTION: &str = "#10243a";
/// The spin pole, and what must not be overlooked.
pub(crate) const RED: &str = "#b3261e";

/// Width of the sheet.
pub(crate) const WIDTH: f64 = 1000.0;
/// White left and right.
pub(crate) const MARGIN: f64 = 44.0;

/// A part of the sheet: where it starts and ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Area {
    pub(crate) from: Point,
    pub(crate) to: Point,
}
