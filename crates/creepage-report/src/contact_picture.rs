//! The picture of one contact, seen from above: what goes where on the sheet.

use creepage::rolling::Status;

use crate::caption;
use crate::contact_view::View;
use crate::legend;
use crate::report::Report;
use crate::scene::{Point, Scene};

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

/// Contacts longer than this, along over across, have the legend below instead of beside.
const WIDE: f64 = 1.7;
/// Ratio of axes up to which the ellipse is drawn to scale; beyond, its short axis is widened
/// so that areas and arrows stay readable, and the picture says so.
const LARGEST_RATIO: f64 = 6.0;
/// Room around the ellipse for axes, rolling direction and scale.
const ROOM: f64 = 66.0;

impl Report<'_> {
    /// The contact seen from above, as SVG.
    pub(crate) fn contact_svg(&self) -> String {
        let layout = Layout::of(self);
        let view = View::new(self, layout.centre, layout.semi_axes);
        let mut scene = Scene::new();
        caption::title(&mut scene, self);
        view.draw(&mut scene, self, layout.plot);
        legend::key(&mut scene, layout.key, self, &view);
        legend::orientation(&mut scene, layout.orientation, &view);
        caption::table(&mut scene, layout.table, self);
        let description = format!("Rolling contact, theory {}", self.answer.theory_name);
        scene.finish([WIDTH, layout.table + caption::TABLE_HEIGHT], &description)
    }
}

/// A part of the sheet: where it starts and ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Area {
    pub(crate) from: Point,
    pub(crate) to: Point,
}

struct Layout {
    centre: Point,
    semi_axes: [f64; 2],
    plot: Area,
    key: Point,
    orientation: Point,
    table: f64,
}

impl Layout {
    fn of(report: &Report) -> Self {
        let solved = report.answer.solution.status == Status::Solved;
        let top = if solved { caption::TITLE_HEIGHT } else { caption::BANNER_BOTTOM };
        let ratio = report.contact.ellipse().ratio().clamp(1.0 / LARGEST_RATIO, LARGEST_RATIO);
        let key_height = legend::key_height(report);
        if ratio > WIDE {
            Self::wide(ratio, top, key_height)
        } else {
            Self::beside(ratio, top, key_height)
        }
    }

    /// Ellipse on the left, legend on the right.
    fn beside(ratio: f64, top: f64, key_height: f64) -> Self {
        let tallest = 210.0 + 60.0 * (1.0 - ratio).max(0.0);
        let semi_x = f64::min(250.0, tallest * ratio);
        let legend_height = key_height + legend::GAP + legend::ORIENTATION_HEIGHT;
        let height = (2.0 * (semi_x / ratio + ROOM)).max(legend_height);
        let plot = Area { from: [MARGIN, top], to: [700.0, top + height] };
        let legend = plot.to[0] + 20.0;
        let middle = f64::midpoint(plot.from[1], plot.to[1]);
        let key = middle - 0.5 * legend_height;
        Self {
            centre: [f64::midpoint(plot.from[0], plot.to[0]), middle],
            semi_axes: [semi_x, semi_x / ratio],
            plot,
            key: [legend, key],
            orientation: [legend, key + key_height + legend::GAP],
            table: plot.to[1] + 8.0,
        }
    }

    /// Ellipse on top, legend below.
    fn wide(ratio: f64, top: f64, key_height: f64) -> Self {
        let semi_x = f64::min(370.0, 190.0 * ratio);
        let height = 2.0 * (semi_x / ratio + ROOM);
        let plot = Area { from: [MARGIN, top], to: [WIDTH - MARGIN, top + height] };
        let legend = plot.to[1] + legend::GAP;
        Self {
            centre: [f64::midpoint(plot.from[0], plot.to[0]), top + 0.5 * height],
            semi_axes: [semi_x, semi_x / ratio],
            plot,
            key: [MARGIN + 60.0, legend],
            orientation: [0.5 * WIDTH + 60.0, legend],
            table: legend + key_height.max(legend::ORIENTATION_HEIGHT) + 8.0,
        }
    }
}
