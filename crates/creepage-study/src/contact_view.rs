//! The ellipse itself: areas, tractions, spin pole, rolling direction.

use creepage::rolling::FieldPoint;

use crate::format::round_below;
use crate::label::Label;
use crate::plane::{Plane, magnitude};
use crate::report::{Report, disc_to_theory};
use crate::scene::{Anchor, Ink, Point, Scene, Type};
use crate::sheet::{ADHESION, Area, DARK, GREY, HATCHING, RED, SLIP, TRACTION};

/// Tractions below this share of their bound are rounding errors, and not drawn.
const NOISE: f64 = 1e-9;

/// A contact on the sheet with its tractions.
pub(crate) struct View {
    plane: Plane,
    tractions: Vec<FieldPoint>,
    /// Largest of the tractions.
    largest: f64,
    /// The length of its arrow.
    longest: f64,
}

impl View {
    pub(crate) fn new(report: &Report, centre: Point, semi_axes: [f64; 2]) -> Self {
        let plane = Plane::new(centre, semi_axes, report.contact.ellipse());
        let tractions = tractions(report, &plane.lattice());
        let largest = largest(&tractions);
        let longest = plane.longest_arrow();
        Self { plane, tractions, largest, longest }
    }

    pub(crate) fn plane(&self) -> &Plane {
        &self.plane
    }

    /// A round traction (Pa) and the length of its arrow, unless there is no traction.
    pub(crate) fn reference(&self, unit: f64) -> Option<(f64, f64)> {
        if self.tractions.is_empty() {
            return None;
        }
        let round = round_below(self.largest * unit);
        Some((round, round / (self.largest * unit) * self.longest))
    }

    pub(crate) fn draw(&self, scene: &mut Scene, report: &Report, plot: Area) {
        self.areas(scene, report);
        self.plane.axes(scene);
        self.edges(scene);
        self.arrows(scene, report);
        if let Some(pole) = spin_pole(report) {
            pole_mark(scene, self.plane.at(pole));
        }
        rolling_direction(scene, plot.from);
        self.plane.scale_bars(scene, [plot.from[0] + 6.0, plot.to[1] - 14.0]);
    }

    fn areas(&self, scene: &mut Scene, report: &Report) {
        scene.hatching("slip", HATCHING, 7.0, 1.3);
        scene.ellipse(self.plane.centre, self.plane.semi_axes, Ink::fill(SLIP));
        scene.ellipse(self.plane.centre, self.plane.semi_axes, Ink::fill("url(#slip)"));
        let adhesion: Vec<Vec<Point>> = (report.areas.adhesion.iter())
            .map(|polygon| polygon.iter().map(|&point| self.plane.at(point)).collect())
            .collect();
        if !adhesion.is_empty() {
            scene.area(&adhesion, Ink::fill(ADHESION).outlined(DARK, 1.2));
        }
        scene.ellipse(self.plane.centre, self.plane.semi_axes, Ink::line(DARK, 2.0));
    }

    /// Names the edges where material enters and leaves the contact.
    fn edges(&self, scene: &mut Scene) {
        let ([left, y], [right, _]) = (self.plane.at([-1.0, 0.0]), self.plane.at([1.0, 0.0]));
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
            let centre = self.plane.at([0, 1].map(|i| point.position[i] / unit[i]));
            let half =
                point.traction.map(|component| 0.5 * self.longest * component / self.largest);
            let end = |sign: f64| [centre[0] + sign * half[0], centre[1] + sign * half[1]];
            scene.arrow(end(-1.0), end(1.0), 1.9, TRACTION);
        }
    }
}

/// The field at points `(x/a, y/b)`; empty where there is no traction.
fn tractions(report: &Report, lattice: &[Point]) -> Vec<FieldPoint> {
    let unit = disc_to_theory(report.contact);
    let positions: Vec<Point> = lattice.iter().map(|p| [p[0] * unit[0], p[1] * unit[1]]).collect();
    let mut field = report.answer.theory.field(report.answer.creepage, &positions);
    field.retain(|point| point.traction.iter().all(|component| component.is_finite()));
    if largest(&field) < NOISE {
        field.clear();
    }
    field
}

fn largest(field: &[FieldPoint]) -> f64 {
    field.iter().map(|point| magnitude(point.traction)).fold(0.0, f64::max)
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
