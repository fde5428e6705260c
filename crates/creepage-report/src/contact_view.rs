//! The ellipse itself: areas, axes, tractions, spin pole, rolling direction, scale.

use creepage::rolling::FieldPoint;

use crate::contact_picture::{ADHESION, Area, DARK, GREY, HATCHING, RED, SLIP, TRACTION};
use crate::format::{round_below, significant};
use crate::label::Label;
use crate::report::{Report, disc_to_theory};
use crate::scene::{Anchor, Ink, Point, Scene, Type};

/// Longest arrow over the distance between arrows.
const LONGEST: f64 = 0.92;
/// Arrows on a semi-axis of a circle; eleven across in all.
const ARROWS: f64 = 5.0;
/// From the outermost arrow to the edge, over the distance between arrows.
const EDGE: f64 = 0.55;
/// Tractions below this share of their bound are rounding errors, and not drawn.
const NOISE: f64 = 1e-9;

/// How a contact lies on the sheet: `x` to the right, `y` downwards, so that `z` points away from
/// the reader.
pub(crate) struct View {
    centre: Point,
    semi_axes: [f64; 2],
    /// Units of the sheet for one metre along `x` and along `y`.
    scale: [f64; 2],
    tractions: Vec<FieldPoint>,
    /// Largest of the tractions.
    largest: f64,
    /// The length of its arrow.
    longest: f64,
}

impl View {
    pub(crate) fn new(report: &Report, centre: Point, semi_axes: [f64; 2]) -> Self {
        let ellipse = report.contact.ellipse();
        let counts = semi_axes.map(|axis| arrows(axis / (semi_axes[0] * semi_axes[1]).sqrt()));
        let tractions = tractions(report, counts);
        let largest = largest(&tractions);
        let pitch = [0, 1].map(|i| semi_axes[i] / (f64::from(counts[i]) + EDGE));
        Self {
            centre,
            semi_axes,
            scale: [semi_axes[0] / ellipse.a(), semi_axes[1] / ellipse.b()],
            tractions,
            largest,
            longest: LONGEST * f64::min(pitch[0], pitch[1]),
        }
    }

    /// How many times larger `x` is drawn than `y`; one when the ellipse is to scale.
    pub(crate) fn stretch(&self) -> f64 {
        self.scale[0] / self.scale[1]
    }

    /// Whether both axes have the same scale.
    pub(crate) fn to_scale(&self) -> bool {
        (self.stretch() - 1.0).abs() < 1e-6
    }

    /// A round traction [Pa] and the length of its arrow, unless there is no traction.
    pub(crate) fn reference(&self, unit: f64) -> Option<(f64, f64)> {
        if self.tractions.is_empty() {
            return None;
        }
        let round = round_below(self.largest * unit);
        Some((round, round / (self.largest * unit) * self.longest))
    }

    pub(crate) fn draw(&self, scene: &mut Scene, report: &Report, plot: Area) {
        self.areas(scene, report);
        self.axes(scene);
        self.edges(scene);
        self.arrows(scene, report);
        if let Some(pole) = spin_pole(report) {
            pole_mark(scene, self.at(pole));
        }
        rolling_direction(scene, plot.from);
        self.scale_bars(scene, [plot.from[0] + 6.0, plot.to[1] - 14.0]);
    }

    /// Where `(x/a, y/b)` lies on the sheet.
    fn at(&self, disc: Point) -> Point {
        [0, 1].map(|i| self.centre[i] + self.semi_axes[i] * disc[i])
    }

    fn areas(&self, scene: &mut Scene, report: &Report) {
        scene.hatching("slip", HATCHING, 7.0, 1.3);
        scene.ellipse(self.centre, self.semi_axes, Ink::fill(SLIP));
        scene.ellipse(self.centre, self.semi_axes, Ink::fill("url(#slip)"));
        let adhesion: Vec<Vec<Point>> = (report.areas.adhesion.iter())
            .map(|polygon| polygon.iter().map(|&point| self.at(point)).collect())
            .collect();
        if !adhesion.is_empty() {
            scene.area(&adhesion, Ink::fill(ADHESION).outlined(DARK, 1.2));
        }
        scene.ellipse(self.centre, self.semi_axes, Ink::line(DARK, 2.0));
    }

    fn axes(&self, scene: &mut Scene) {
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

    /// Names the edges where material enters and leaves the contact.
    fn edges(&self, scene: &mut Scene) {
        let ([left, y], [right, _]) = (self.at([-1.0, 0.0]), self.at([1.0, 0.0]));
        let style = Type::new(12.5, GREY);
        for (words, below) in [(["leading", "trailing"], -7.0), (["edge", "edge"], 20.0)] {
            scene.text([right + 9.0, y + below], style, &Label::new(words[0]));
            let style = style.anchored(Anchor::End);
            scene.text([left - 9.0, y + below], style, &Label::new(words[1]));
        }
    }

    fn arrows(&self, scene: &mut Scene, report: &Report) {
        let unit = disc_to_theory(report.contact);
        for point in &self.tractions {
            let centre = self.at([0, 1].map(|i| point.position[i] / unit[i]));
            let half =
                point.traction.map(|component| 0.5 * self.longest * component / self.largest);
            let end = |sign: f64| [centre[0] + sign * half[0], centre[1] + sign * half[1]];
            scene.arrow(end(-1.0), end(1.0), 1.9, TRACTION);
        }
    }

    /// A bar along `x`, and one along `y` where its scale is another.
    fn scale_bars(&self, scene: &mut Scene, corner: Point) {
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

/// The field at a lattice of `counts` points on either side of the centre; empty where there is
/// no traction.
fn tractions(report: &Report, counts: [u32; 2]) -> Vec<FieldPoint> {
    let unit = disc_to_theory(report.contact);
    let steps = |count: u32| {
        let half = f64::from(count);
        (0..=2 * count).map(move |k| (f64::from(k) - half) / (half + EDGE))
    };
    let positions: Vec<Point> = steps(counts[1])
        .flat_map(|y| steps(counts[0]).map(move |x| [x, y]))
        .filter(|p| magnitude(*p) < 0.97)
        .map(|p| [p[0] * unit[0], p[1] * unit[1]])
        .collect();
    let mut field = report.answer.theory.field(report.answer.creepage, &positions);
    field.retain(|point| point.traction.iter().all(|component| component.is_finite()));
    if largest(&field) < NOISE {
        field.clear();
    }
    field
}

/// How many arrows a semi-axis takes, by its length over that of a circle of the same area.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few dozen at most
fn arrows(length: f64) -> u32 {
    (ARROWS * length).round().max(1.0) as u32
}

fn largest(field: &[FieldPoint]) -> f64 {
    field.iter().map(|point| magnitude(point.traction)).fold(0.0, f64::max)
}

fn magnitude(vector: [f64; 2]) -> f64 {
    vector[0].hypot(vector[1])
}

/// The zero of the rigid slip, `(-eta, xi)/chi` in units of `c`, as `(x/a, y/b)`; none where it
/// lies outside the contact.
pub(crate) fn spin_pole(report: &Report) -> Option<Point> {
    let (creepage, unit) = (report.answer.creepage, disc_to_theory(report.contact));
    let pole = [-creepage.eta / creepage.chi / unit[0], creepage.xi / creepage.chi / unit[1]];
    (magnitude(pole) < 1.0).then_some(pole)
}

/// The sign of the spin pole.
pub(crate) fn pole_mark(scene: &mut Scene, at: Point) {
    scene.circle(at, 7.0, Ink::fill("#ffffff").outlined(RED, 2.2));
    scene.circle(at, 2.2, Ink::fill(RED));
}

/// The upper body rolls to the right.
fn rolling_direction(scene: &mut Scene, [x, y]: Point) {
    scene.text([x, y + 16.0], Type::new(15.0, DARK), &Label::new("rolling direction"));
    scene.arrow([x + 124.0, y + 11.0], [x + 190.0, y + 11.0], 3.2, DARK);
}

/// A round length no longer than `longest` on the sheet: its length there, and its name.
fn bar(longest: f64, scale: f64) -> (f64, String) {
    let metres = round_below(longest / scale);
    (metres * scale, format!("{} mm", significant(metres * 1e3, 3)))
}
