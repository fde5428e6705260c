//! The field in shades: the darker, the more.

use creepage::rolling::Region;

use super::StaticsReport;
use super::levels::MOST;
use crate::areas::Areas;
use crate::plane::Plane;
use crate::scene::{Ink, Point, Scene};
use crate::sheet::DARK;

/// Shades in equal steps of grey, light enough to carry dark arrows.
const SHADES: [&str; MOST + 1] =
    ["#f4f8fc", "#dfeaf5", "#c9dcee", "#b2cde6", "#9bbddd", "#83abd0", "#6b98c2", "#5385b3"];
/// The lines between shades.
const CONTOUR: &str = "#3f6288";

/// The shade of a band among `levels` levels, spread over all shades.
pub(super) fn shade(band: usize, levels: usize) -> &'static str {
    SHADES[(band * MOST).checked_div(levels).unwrap_or(0).min(MOST)]
}

/// Fills the contact with its bands.
pub(super) fn draw(scene: &mut Scene, report: &StaticsReport, plane: &Plane, levels: &[f64]) {
    let outline = Ink::fill(shade(0, levels.len()));
    scene.ellipse(plane.centre, plane.semi_axes, outline);
    for (band, level) in levels.iter().enumerate() {
        let above = Areas::trace(|points| {
            let region = |point: &Point| {
                if report.intensity(*point) > *level { Region::Adhesion } else { Region::Slip }
            };
            points.iter().map(region).collect()
        });
        let polygons: Vec<Vec<Point>> = (above.adhesion.iter())
            .map(|polygon| polygon.iter().map(|&point| plane.at(point)).collect())
            .collect();
        let ink = Ink::fill(shade(band + 1, levels.len())).outlined(CONTOUR, 0.8);
        if !polygons.is_empty() {
            scene.area(&polygons, ink);
        }
    }
    scene.ellipse(plane.centre, plane.semi_axes, Ink::line(DARK, 2.0));
}
