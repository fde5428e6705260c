//! Colour constants shared by all figures.

use creepage_plot::{Fill, Mark, Pen, Shape};

const DARK: &str = "#10243a";
const RED: &str = "#c62828";

/// The full theory, the reference for the results of 1967.
pub(crate) const FULL: Pen = Pen { colour: RED, dashes: "11 4", width: 2.3 };
/// Its error bars.
pub(crate) const BAND: Fill = Fill::plain("#f3c9c9");
/// The same where it is points.
pub(crate) const FULL_MARK: Mark = Mark::full(Shape::Circle, RED);
/// What was printed in 1967, number by number.
pub(crate) const PRINTED: Mark = Mark::open(Shape::Circle, DARK);
/// The theory of 1967 that the figure is about.
pub(crate) const OF_1967: Pen = Pen { colour: DARK, dashes: "", width: 2.5 };
/// A second and a third of them.
pub(crate) const SECOND: Pen = Pen { colour: "#1565c0", dashes: "2.5 3.5", width: 2.7 };
pub(crate) const THIRD: Pen = Pen { colour: "#2e7d32", dashes: "13 4 2.5 4", width: 2.4 };
/// Around what is small.
pub(crate) const RING: Pen = Pen { colour: "#8e24aa", dashes: "", width: 1.6 };
/// Linear theory, and other tangents.
pub(crate) const TANGENT: Pen = Pen { colour: "#5d6a76", dashes: "7 4", width: 1.4 };
