//! The contact as a patch: its outline and its area of adhesion.

use std::f64::consts::TAU;

use creepage::Ellipse;
use creepage::rolling::Region;
use creepage_report::Areas;
use creepage_report::plot::{Fill, Panel, Pen};

/// A closed polygon in units of `c`.
pub(crate) type Polygon = Vec<[f64; 2]>;

/// The contact's edge.
pub(crate) fn outline(ellipse: Ellipse) -> Polygon {
    let at = |k: u32| (TAU * f64::from(k) / 240.0).sin_cos();
    (0..=240).map(at).map(|(sin, cos)| [ellipse.a() * cos, ellipse.b() * sin]).collect()
}

/// The area of adhesion, and its share of the contact, for a field that answers with regions at
/// positions in units of `c`.
pub(crate) fn adhesion(
    ellipse: Ellipse,
    regions: impl Fn(&[[f64; 2]]) -> Vec<Region>,
) -> (Vec<Polygon>, f64) {
    let semi_axes = [ellipse.a(), ellipse.b()];
    let scaled = |point: &[f64; 2]| [0, 1].map(|i| semi_axes[i] * point[i]);
    let areas = Areas::trace(|points| regions(&points.iter().map(scaled).collect::<Vec<_>>()));
    let polygons = areas.adhesion.iter().map(|polygon| polygon.iter().map(scaled).collect());
    (polygons.collect(), areas.adhesion_share)
}

/// A polygon as a line that ends where it began.
pub(crate) fn closed(mut polygon: Polygon) -> Polygon {
    polygon.extend(polygon.first().copied());
    polygon
}

/// Areas of slip and of adhesion.
pub(crate) fn areas(panel: Panel, ellipse: Ellipse, adhesion: &[Polygon]) -> Panel {
    let panel =
        panel.area(vec![outline(ellipse)], Fill::SLIP).area(adhesion.to_vec(), Fill::ADHESION);
    borders(panel, adhesion, Pen::OUTLINE.wide(1.4))
}

/// Borders of areas, in one pen.
pub(crate) fn borders(panel: Panel, areas: &[Polygon], pen: Pen) -> Panel {
    areas.iter().cloned().map(closed).fold(panel, |panel, border| panel.curve(border, pen))
}

/// A closed polygon without ripples shorter than an element of the full theory, whose border of
/// adhesion steps from element to element.
pub(crate) fn smoothed(polygon: &[[f64; 2]]) -> Polygon {
    const REACH: usize = 3;
    let count = polygon.len();
    let mut points = polygon.to_vec();
    // A mean of means has no corners of its own.
    for _ in 0..2 {
        let mean = |k: usize| {
            let near = || (0..=2 * REACH).map(|i| points[(k + count + i - REACH) % count]);
            [0, 1].map(|i| near().map(|point| point[i]).sum::<f64>() / (2 * REACH + 1) as f64)
        };
        points = if count > 8 * REACH { (0..count).map(mean).collect() } else { points };
    }
    points
}
