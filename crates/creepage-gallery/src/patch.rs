//! The contact as a patch: its outline and its area of adhesion.

use std::f64::consts::TAU;

use creepage::rolling::exact::{Exact, Resolution};
use creepage::rolling::{Creepage, Region, Theory};
use creepage::{Ellipse, InvalidValue};
use creepage_report::Areas;
use creepage_report::plot::{Anchor, Fill, Label, Panel, Pen, Scale};

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

/// A panel for a contact: `x` to the right, where the rolling goes, `y` downwards, as in all
/// pictures of contacts. Everything is in units of `c`.
pub(crate) fn panel(ellipse: Ellipse) -> Panel {
    let reach = [1.35 * ellipse.a().max(0.6 * ellipse.b()), 1.12 * ellipse.b()];
    let scale = |range| Scale::new(range, Label::default());
    Panel::new(scale([-reach[0], reach[0]]), scale([reach[1], -reach[1]])).to_scale().bare()
}

/// The edge, and arrows for `x` and `y` beyond it.
pub(crate) fn framed(panel: Panel, ellipse: Ellipse) -> Panel {
    let (a, ink) = (ellipse.a(), "#5d6a76");
    panel
        .curve(outline(ellipse), Pen::OUTLINE)
        .arrow([a + 0.06, 0.0], [a + 0.23, 0.0], 1.6, ink)
        .text([a + 0.29, 0.025], Anchor::Middle, Label::default().symbol("x"))
}

/// Areas of slip and of adhesion.
pub(crate) fn areas(panel: Panel, ellipse: Ellipse, adhesion: &[Polygon]) -> Panel {
    let edges = adhesion.iter().cloned().map(closed);
    let panel =
        panel.area(vec![outline(ellipse)], Fill::SLIP).area(adhesion.to_vec(), Fill::ADHESION);
    edges.fold(panel, |panel, edge| panel.curve(edge, Pen::OUTLINE.wide(1.4)))
}

/// The area of adhesion by the full theory, and its share of the contact.
pub(crate) fn full_adhesion(
    a_over_b: f64,
    poisson: f64,
    creepage: Creepage,
) -> Result<(Vec<Polygon>, f64), InvalidValue> {
    let theory = Exact::new(a_over_b, poisson, Resolution::new(56, 44)?)?;
    let mut workspace = theory.workspace();
    theory.solve_with(creepage, &mut workspace);
    let regions = |points: &[[f64; 2]]| {
        theory.field_of(&workspace, points).iter().map(|point| point.region).collect()
    };
    let (polygons, share) = adhesion(Ellipse::from_ratio(a_over_b)?, regions);
    Ok((polygons.iter().map(|polygon| smoothed(polygon)).collect(), share))
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
