//! What goes where on a sheet with one ellipse, a legend, and a table at the foot.

use crate::clip::Frame;
use crate::orientation;
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
/// White between the legend and the axes.
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
    pub(crate) legend: Point,
    pub(crate) orientation: Point,
    pub(crate) table: f64,
}

impl Layout {
    /// For an ellipse with these semi-axes on the sheet, below `top`, with a legend of that height.
    pub(crate) fn new(semi_axes: [f64; 2], top: f64, legend: f64) -> Self {
        let height = 2.0 * (semi_axes[1] + ROOM);
        if semi_axes[0] > WIDE * semi_axes[1] {
            Self::below(height, top, legend)
        } else {
            Self::beside(height, top, legend)
        }
    }

    fn beside(height: f64, top: f64, legend: f64) -> Self {
        let right = legend + GAP + orientation::HEIGHT;
        let plot = Frame { from: [MARGIN, top], to: [700.0, top + height.max(right)] };
        let (centre, left) = (plot.centre(), plot.to[0] + 20.0);
        let start = centre[1] - 0.5 * right;
        Self {
            centre,
            plot,
            legend: [left, start],
            orientation: [left, start + legend + GAP],
            table: plot.to[1] + 8.0,
        }
    }

    fn below(height: f64, top: f64, legend: f64) -> Self {
        let plot = Frame { from: [MARGIN, top], to: [WIDTH - MARGIN, top + height] };
        let start = plot.to[1] + GAP;
        Self {
            centre: plot.centre(),
            plot,
            legend: [MARGIN + 60.0, start],
            orientation: [0.5 * WIDTH + 60.0, start],
            table: start + legend.max(orientation::HEIGHT) + 8.0,
        }
    }
}
