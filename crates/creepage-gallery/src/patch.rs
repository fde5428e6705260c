//! The contact as a patch: its outline and its area of adhesion.

use std::f64::consts::TAU;

use creepage::Ellipse;
use creepage::rolling::{Creepage, Region, Theory};
use creepage_report::Areas;

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

/// The area of adhesion by a theory that answers quickly.
pub(crate) fn adhesion_of(
    ellipse: Ellipse,
    theory: &dyn Theory,
    creepage: Creepage,
) -> (Vec<Polygon>, f64) {
    adhesion(ellipse, |points| {
        theory.field(creepage, points).iter().map(|point| point.region).collect()
    })
}

/// A polygon as a line that ends where it began.
pub(crate) fn closed(mut polygon: Polygon) -> Polygon {
    polygon.extend(polygon.first().copied());
    polygon
}
