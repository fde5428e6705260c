//! Layout of a sheet with one ellipse, a legend, and a table at the foot.

use crate::clip::Frame;
use crate::legend::Legend;
use crate::scene::Point;
use crate::theme::MARGIN;

/// Width of the sheet.
pub(crate) const WIDTH: f64 = 1000.0;
/// Ellipses longer than this, along over across, have the legend below instead of beside.
const WIDE: f64 = 1.7;
/// Ratio of axes up to which the ellipse is drawn to scale; beyond, its short axis is widened
/// so that areas and arrows stay readable, and the picture says so.
const LARGEST_RATIO: f64 = 6.0;
/// Room around the ellipse for axes, rolling direction and scale.
const ROOM: f64 = 66.0;
/// White above a legend below the ellipse.
const GAP: f64 = 26.0;

/// Semi-axes on the sheet of an ellipse with semi-axes `a` and `b`.
pub(crate) fn drawn(a_over_b: f64) -> [f64; 2] {
    let ratio = a_over_b.clamp(1.0 / LARGEST_RATIO, LARGEST_RATIO);
    let semi_x = if ratio > WIDE {
        f64::min(370.0, 190.0 * ratio)
    } else {
        let tallest = 210.0 + 60.0 * (1.0 - ratio).max(0.0);
        f64::min(250.0, tallest * ratio)
    };
    [semi_x, semi_x / ratio]
}

/// Where the parts are.
pub(crate) struct Layout {
    pub(crate) centre: Point,
    pub(crate) plot: Frame,
    /// Corner and width of the legend.
    pub(crate) legend: (Point, f64),
    pub(crate) table: f64,
}

impl Layout {
    /// For an ellipse with these semi-axes on the sheet, below `top`.
    pub(crate) fn new([semi_x, semi_y]: [f64; 2], top: f64, legend: &Legend) -> Self {
        let height = 2.0 * (semi_y + ROOM);
        let is_wide = semi_x > WIDE * semi_y;
        let (right, room) =
            if is_wide { (WIDTH - MARGIN, WIDTH - 2.0 * MARGIN) } else { (690.0, 234.0) };
        let tall = legend.height(room);
        let height = if is_wide { height } else { height.max(tall) };
        let plot = Frame { from: [MARGIN, top], to: [right, top + height] };
        let centre = plot.centre();
        let (corner, bottom) = if is_wide {
            ([MARGIN, plot.to[1] + GAP], plot.to[1] + GAP + tall)
        } else {
            ([right + 32.0, centre[1] - 0.5 * tall], plot.to[1])
        };
        Self { centre, plot, legend: (corner, room), table: bottom + 8.0 }
    }
}
