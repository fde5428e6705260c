//! The picture of a problem without rolling, seen from above.

use super::field::Field;
use super::{StaticsReport, bands, caption, key};
use crate::contact_picture::{DARK, Layout, TRACTION, WIDTH};
use crate::contact_view::{magnitude, pole_mark};
use crate::legend;
use crate::plane::Plane;
use crate::scene::{Ink, Point, Scene};

/// The arrows: where they stand, `(x/a, y/b)`, and the tractions there [Pa].
pub(super) struct Arrows {
    tractions: Vec<(Point, [f64; 2])>,
    pub(super) largest: f64,
    pub(super) longest: f64,
}

impl StaticsReport<'_> {
    /// The contact seen from above, as SVG.
    pub(super) fn svg(&self) -> String {
        let levels = self.levels();
        let height = key::height(self, levels.len());
        let layout = Layout::new(self.ellipse.ratio(), caption::TITLE_HEIGHT, height);
        let plane = Plane::new(layout.centre, layout.semi_axes, self.ellipse);
        let arrows = Arrows::new(self, &plane);
        let mut scene = Scene::new();
        caption::title(&mut scene, self);
        bands::draw(&mut scene, self, &plane, &levels);
        plane.axes(&mut scene);
        self.marks(&mut scene, &plane);
        arrows.draw(&mut scene, &plane);
        plane.scale_bars(&mut scene, [layout.plot.from[0] + 6.0, layout.plot.to[1] - 14.0]);
        key::draw(&mut scene, layout.key, self, &levels, &arrows);
        legend::orientation(&mut scene, layout.orientation, &plane);
        caption::table(&mut scene, layout.table, self);
        scene.finish([WIDTH, layout.table + caption::table_height(self)], self.title)
    }

    /// The lift-off limit and the load of a die, or the adhesion ellipse.
    fn marks(&self, scene: &mut Scene, plane: &Plane) {
        let scaled = |factor: f64| plane.semi_axes.map(|axis| factor * axis);
        match self.field {
            Field::Die { offset, .. } => {
                scene.ellipse(plane.centre, scaled(1.0 / 3.0), key::LIMIT);
                let place = [offset[0] / self.ellipse.a(), offset[1] / self.ellipse.b()];
                pole_mark(scene, plane.at(place));
            }
            Field::Bonded(_) => {}
            Field::PartialSlip(partial) => {
                let factor = partial.adhesion().a() / self.ellipse.a();
                scene.ellipse(plane.centre, scaled(factor), Ink::line(DARK, 2.6));
            }
        }
    }
}

impl Arrows {
    fn new(report: &StaticsReport, plane: &Plane) -> Self {
        let (a, b) = (report.ellipse.a(), report.ellipse.b());
        let traction = |disc: Point| report.field.traction([a * disc[0], b * disc[1]]);
        let tractions: Vec<_> =
            plane.lattice().into_iter().map(|disc| (disc, traction(disc))).collect();
        let largest =
            tractions.iter().map(|(_, traction)| magnitude(*traction)).fold(0.0, f64::max);
        Self { tractions, largest, longest: plane.longest_arrow() }
    }

    fn draw(&self, scene: &mut Scene, plane: &Plane) {
        if self.largest > 0.0 {
            for (disc, traction) in &self.tractions {
                let half = traction.map(|part| 0.5 * self.longest * part / self.largest);
                let centre = plane.at(*disc);
                let end = |sign: f64| [0, 1].map(|i| centre[i] + sign * half[i]);
                scene.arrow(end(-1.0), end(1.0), 1.9, TRACTION);
            }
        }
    }
}
