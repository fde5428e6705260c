//! Coordinate plane of an ellipse on the sheet (its axes, scale and arrows), and the layout around it: a legend, and a table at the foot.

use crate::clip::Frame;
use crate::format::{round_below, significant};
use crate::ink::Ink;
use crate::label::Label;
use crate::legend::{Legend, Sample};
use crate::panel::Panel;
use crate::scene::{Point, Scene, Type};
use crate::theme::{ARROW, DARK, GREY, MARGIN};

/// Longest arrow over the distance between arrows.
const LONGEST: f64 = 0.92;
/// Arrows on a semi-axis of a circle; eleven across in all.
const ARROWS: f64 = 5.0;
/// From the outermost arrow to the edge, over the distance between arrows.
const EDGE: f64 = 0.55;

/// `x` to the right, `y` downwards, so that `z` points away from the reader.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    /// Semi-axes on the sheet.
    pub(crate) semi_axes: [f64; 2],
    /// Units of the sheet for one metre along `x` and along `y`.
    scale: [f64; 2],
}

impl Plane {
    /// For an ellipse with semi-axes in metres.
    pub(crate) fn new([a, b]: [f64; 2]) -> Self {
        let semi_axes = drawn(a / b);
        Self { semi_axes, scale: [semi_axes[0] / a, semi_axes[1] / b] }
    }

    /// How many times larger `x` is drawn than `y`; one when the ellipse is to scale.
    pub(crate) fn stretch(&self) -> f64 {
        self.scale[0] / self.scale[1]
    }

    /// Whether both axes have the same scale.
    pub(crate) fn is_to_scale(&self) -> bool {
        (self.stretch() - 1.0).abs() < 1e-6
    }

    /// The part of the sheet that the ellipse, times `factor`, spans about `centre`.
    pub(crate) fn around(&self, centre: Point, factor: f64) -> Frame {
        let corner = |sign: f64| [0, 1].map(|i| centre[i] + sign * factor * self.semi_axes[i]);
        Frame { from: corner(-1.0), to: corner(1.0) }
    }

    /// Where arrows stand, as `(x/a, y/b)`.
    pub(crate) fn lattice(&self) -> Vec<Point> {
        let counts = self.counts();
        let steps = |count: u32| {
            let half = f64::from(count);
            (0..=2 * count).map(move |k| (f64::from(k) - half) / (half + EDGE))
        };
        steps(counts[1])
            .flat_map(|y| steps(counts[0]).map(move |x| [x, y]))
            .filter(|p| p[0].hypot(p[1]) < 0.97)
            .collect()
    }

    /// The length of the longest arrow on the sheet.
    fn longest_arrow(&self) -> f64 {
        let counts = self.counts();
        let pitch = [0, 1].map(|i| self.semi_axes[i] / (f64::from(counts[i]) + EDGE));
        LONGEST * f64::min(pitch[0], pitch[1])
    }

    /// Arrows on either side of the centre, by the length of a semi-axis over that of a circle of
    /// the same area.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few dozen at most
    fn counts(&self) -> [u32; 2] {
        let mean = (self.semi_axes[0] * self.semi_axes[1]).sqrt();
        self.semi_axes.map(|axis| (ARROWS * axis / mean).round().max(1.0) as u32)
    }

    /// The axes `x` and `y` through the centre.
    pub(crate) fn axes(&self, scene: &mut Scene, centre @ [x, y]: Point) {
        let Frame { from: [left, top], to: [right, bottom] } = self.around(centre, 1.0);
        let thin = Ink::broken_line(GREY, 0.9, "7 3 1.5 3");
        scene.line(&[[left - 8.0, y], [right + 58.0, y]], thin);
        scene.line(&[[x, top - 8.0], [x, bottom + 14.0]], thin);
        scene.arrow([right + 54.0, y], [right + 72.0, y], 1.6, GREY);
        scene.arrow([x, bottom + 12.0], [x, bottom + 30.0], 1.6, GREY);
        let style = Type::new(17.0, DARK);
        scene.text([right + 78.0, y + 5.0], style, &Label::default().symbol("x"));
        scene.text([x + 9.0, bottom + 30.0], style, &Label::default().symbol("y"));
    }

    /// A bar along `x`, and one along `y` where its scale is another.
    pub(crate) fn scale_bars(&self, scene: &mut Scene, [x, y]: Point) {
        let (ink, style) = (Ink::line(DARK, 1.6), Type::new(14.0, DARK));
        let (length, name) = bar(150.0, self.scale[0]);
        scene.line(&[[x, y - 4.0], [x, y + 4.0]], ink);
        scene.line(&[[x, y], [x + length, y]], ink);
        scene.line(&[[x + length, y - 4.0], [x + length, y + 4.0]], ink);
        scene.text([x + length + 10.0, y + 5.0], style, &Label::new(&name));
        if !self.is_to_scale() {
            let (height, name) = bar(46.0, self.scale[1]);
            scene.line(&[[x, y], [x, y - height]], ink);
            scene.line(&[[x - 4.0, y - height], [x + 4.0, y - height]], ink);
            scene.text([x + 9.0, y - height + 10.0], style, &Label::new(&name));
        }
    }
}

/// A round length no longer than `longest` on the sheet: its length there, and its name.
fn bar(longest: f64, scale: f64) -> (f64, String) {
    let metres = round_below(longest / scale);
    (metres * scale, format!("{} mm", significant(metres * 1e3, 3)))
}

/// A field as arrows in an ellipse.
#[derive(Debug, Clone)]
pub struct Arrows {
    /// The middle of each, as `(x/a, y/b)`, and the field there.
    field: Vec<(Point, [f64; 2])>,
    largest: f64,
    plane: Plane,
}

impl Arrows {
    pub(crate) fn new(plane: Plane, field: Vec<(Point, [f64; 2])>) -> Self {
        let largest = field.iter().map(|(_, [x, y])| x.hypot(*y)).fold(0.0, f64::max);
        Self { field, largest, plane }
    }

    /// The largest of the field.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// Adds the arrows to a panel in units of the semi-axes; none where the field vanishes.
    #[must_use]
    pub fn draw(&self, panel: Panel) -> Panel {
        if self.largest == 0.0 {
            return panel;
        }
        let half = 0.5 * self.plane.longest_arrow() / self.largest;
        self.field.iter().fold(panel, |panel, (middle, vector)| {
            let end = |sign: f64| {
                [0, 1].map(|i| middle[i] + sign * half * vector[i] / self.plane.semi_axes[i])
            };
            panel.arrow(end(-1.0), end(1.0), 1.9, ARROW)
        })
    }

    /// The arrow of a round size of the field, and that size; `unit` is that of the field.
    #[must_use]
    pub fn sample(&self, unit: f64) -> Option<(Sample, f64)> {
        let largest = self.largest * unit;
        (largest > 0.0).then(|| {
            let round = round_below(largest);
            let length = round / largest * self.plane.longest_arrow();
            (Sample::Arrow { colour: ARROW, length }, round)
        })
    }
}

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
