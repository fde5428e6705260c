//! The tractions as arrows.

use super::StaticsReport;
use crate::plane::{Plane, magnitude};
use crate::scene::{Point, Scene};
use crate::sheet::TRACTION;

/// The arrows: where they stand, `(x/a, y/b)`, and the tractions there (Pa).
pub(super) struct Arrows {
    tractions: Vec<(Point, [f64; 2])>,
    pub(super) largest: f64,
    pub(super) longest: f64,
}

impl Arrows {
    pub(super) fn new(report: &StaticsReport, plane: &Plane) -> Self {
        let (a, b) = (report.ellipse.a(), report.ellipse.b());
        let traction = |disc: Point| report.field.traction([a * disc[0], b * disc[1]]);
        let tractions: Vec<_> =
            plane.lattice().into_iter().map(|disc| (disc, traction(disc))).collect();
        let largest =
            tractions.iter().map(|(_, traction)| magnitude(*traction)).fold(0.0, f64::max);
        Self { tractions, largest, longest: plane.longest_arrow() }
    }

    pub(super) fn draw(&self, scene: &mut Scene, plane: &Plane) {
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
