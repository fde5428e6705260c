//! A contact ellipse on the sheet: axes, scale, and where its arrows stand.

use creepage::Ellipse;

use crate::format::{round_below, significant};
use crate::label::Label;
use crate::scene::{Ink, Point, Scene, Type};
use crate::sheet::{DARK, GREY};

/// Longest arrow over the distance between arrows.
const LONGEST: f64 = 0.92;
/// Arrows on a semi-axis of a circle; eleven across in all.
const ARROWS: f64 = 5.0;
/// From the outermost arrow to the edge, over the distance between arrows.
const EDGE: f64 = 0.55;

/// How a contact lies on the sheet: `x` to the right, `y` downwards, so that `z` points away from
/// the reader.
pub(crate) struct Plane {
    pub(crate) centre: Point,
    pub(crate) semi_axes: [f64; 2],
    /// Units of the sheet for one metre along `x` and along `y`.
    scale: [f64; 2],
}

impl Plane {
    /// The `ellipse` (m) drawn at `centre` with these semi-axes.
    pub(crate) fn new(centre: Point, semi_axes: [f64; 2], ellipse: Ellipse) -> Self {
        let scale = [semi_axes[0] / ellipse.a(), semi_axes[1] / ellipse.b()];
        Self { centre, semi_axes, scale }
    }

    /// How many times larger `x` is drawn than `y`; one when the ellipse is to scale.
    pub(crate) fn stretch(&self) -> f64 {
        self.scale[0] / self.scale[1]
    }

    /// Whether both axes have the same scale.
    pub(crate) fn to_scale(&self) -> bool {
        (self.stretch() - 1.0).abs() < 1e-6
    }

    /// Where `(x/a, y/b)` lies on the sheet.
    pub(crate) fn at(&self, disc: Point) -> Point {
        [0, 1].map(|i| self.centre[i] + self.semi_axes[i] * disc[i])
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
            .filter(|p| magnitude(*p) < 0.97)
            .collect()
    }

    /// The length of the longest arrow on the sheet.
    pub(crate) fn longest_arrow(&self) -> f64 {
        let counts = self.counts();
        let pitch = [0, 1].map(|i| self.semi_axes[i] / (f64::from(counts[i]) + EDGE));
        LONGEST * f64::min(pitch[0], pitch[1])
    }

    /// Arrows on either side of the centre.
    fn counts(&self) -> [u32; 2] {
        self.semi_axes.map(|axis| arrows(axis / (self.semi_axes[0] * self.semi_axes[1]).sqrt()))
    }

    /// The axes `x` and `y` through the centre.
    pub(crate) fn axes(&self, scene: &mut Scene) {
        let ([left, top], [right, bottom]) = (self.at([-1.0, -1.0]), self.at([1.0, 1.0]));
        let [x, y] = self.centre;
        let thin = Ink::line(GREY, 0.9).dashed("7 3 1.5 3");
        scene.line(&[[left - 8.0, y], [right + 58.0, y]], thin);
        scene.line(&[[x, top - 8.0], [x, bottom + 14.0]], thin);
        scene.arrow([right + 54.0, y], [right + 72.0, y], 1.6, GREY);
        scene.arrow([x, bottom + 12.0], [x, bottom + 30.0], 1.6, GREY);
        let style = Type::new(17.0, DARK);
        scene.text([right + 78.0, y + 5.0], style, &Label::default().symbol("x"));
        scene.text([x + 9.0, bottom + 30.0], style, &Label::default().symbol("y"));
    }

    /// A bar along `x`, and one along `y` where its scale is another.
    pub(crate) fn scale_bars(&self, scene: &mut Scene, corner: Point) {
        let ink = Ink::line(DARK, 1.6);
        let (length, name) = bar(150.0, self.scale[0]);
        let [x, y] = corner;
        scene.line(&[[x, y - 4.0], [x, y + 4.0]], ink);
        scene.line(&[[x, y], [x + length, y]], ink);
        scene.line(&[[x + length, y - 4.0], [x + length, y + 4.0]], ink);
        let style = Type::new(14.0, DARK);
        scene.text([x + length + 10.0, y + 5.0], style, &Label::new(&name));
        if !self.to_scale() {
            let (height, name) = bar(46.0, self.scale[1]);
            scene.line(&[[x, y], [x, y - height]], ink);
            scene.line(&[[x - 4.0, y - height], [x + 4.0, y - height]], ink);
            scene.text([x + 9.0, y - height + 10.0], style, &Label::new(&name));
        }
    }
}

/// How many arrows a semi-axis takes, by its length over that of a circle of the same area.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few dozen at most
fn arrows(length: f64) -> u32 {
    (ARROWS * length).round().max(1.0) as u32
}

/// A round length no longer than `longest` on the sheet: its length there, and its name.
fn bar(longest: f64, scale: f64) -> (f64, String) {
    let metres = round_below(longest / scale);
    (metres * scale, format!("{} mm", significant(metres * 1e3, 3)))
}

/// Length of a vector.
pub(crate) fn magnitude(vector: [f64; 2]) -> f64 {
    vector[0].hypot(vector[1])
}
