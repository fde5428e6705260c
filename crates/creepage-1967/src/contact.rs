//! Plan view of a contact as in the thesis's sketches: outline, adhesion area, and the fields in it.

use crate::axes::RING;
use crate::theories::{like_bodies, spaced};
use creepage::coulomb::{Exact, Resolution};
use creepage::variational::{Start, Variational};
use creepage::{Creepage, FieldPoint, Region, Solved, Theory};
use creepage::{Ellipse, InvalidValue};
use creepage_plot::{Anchor, Axis, Contour, Fill, Label, Panel, Pen, ellipse, signed_area};

/// A closed polygon in units of `c`.
pub(crate) type Polygon = Vec<[f64; 2]>;

/// What answers with traction, slip and area at positions in units of `c`.
pub(crate) type Field<'a> = Box<dyn Fn(&[[f64; 2]]) -> Vec<FieldPoint> + 'a>;

/// The full theory on elements small enough for areas of adhesion to be drawn.
pub(crate) fn detailed(a_over_b: f64, poisson: f64) -> Result<Exact, InvalidValue> {
    Exact::new(&like_bodies(a_over_b, poisson)?, Resolution::new(56, 44)?)
}

/// The field of the full theory.
pub(crate) fn full(theory: &Exact, creepage: Creepage) -> Field<'_> {
    let solved = theory.solve_contact(creepage);
    Box::new(move |positions| solved.field(positions))
}

/// The field of chapter 5.
pub(crate) fn chapter_5(theory: &Variational, creepage: Creepage) -> Field<'_> {
    let tau = theory.solve_from(creepage, &Start::FullSliding).tau;
    Box::new(move |positions| {
        theory.points(creepage, &tau, positions).into_iter().map(|point| point.field).collect()
    })
}

/// The field of a theory that answers at once.
pub(crate) fn of(theory: &dyn Theory, creepage: Creepage) -> Field<'_> {
    Box::new(move |positions| theory.field(creepage, positions))
}

/// The contact's edge.
pub(crate) fn outline(contact: Ellipse) -> Polygon {
    ellipse([contact.a(), contact.b()])
}

/// The area of adhesion and its share of the contact.
pub(crate) fn adhesion(contact: Ellipse, field: &Field) -> (Vec<Polygon>, f64) {
    traced(contact, |points| {
        field(points).iter().map(|point| point.region == Region::Adhesion).collect()
    })
}

/// The part of the contact, and its share, whose positions in units of `c` are inside.
pub(crate) fn traced(
    contact: Ellipse,
    is_inside: impl Fn(&[[f64; 2]]) -> Vec<bool>,
) -> (Vec<Polygon>, f64) {
    let semi_axes = [contact.a(), contact.b()];
    let scaled = |point: &[f64; 2]| [0, 1].map(|i| semi_axes[i] * point[i]);
    let found = Contour::trace(|disc| is_inside(&disc.iter().map(scaled).collect::<Vec<_>>()));
    let polygons = found.polygons.iter().map(|polygon| polygon.iter().map(scaled).collect());
    (polygons.collect(), found.share)
}

/// Areas of slip and of adhesion.
pub(crate) fn areas(panel: Panel, contact: Ellipse, adhesion: &[Polygon]) -> Panel {
    panel
        .area(vec![outline(contact)], Fill::SLIP)
        .area(adhesion.to_vec(), Fill::ADHESION)
        .outlines(adhesion, Pen::OUTLINE.wide(1.4))
}

/// The area of adhesion by the full theory without the steps of its elements, and its share of the
/// contact.
pub(crate) fn full_adhesion(
    a_over_b: f64,
    poisson: f64,
    creepage: Creepage,
) -> Result<(Vec<Polygon>, f64), InvalidValue> {
    let theory = detailed(a_over_b, poisson)?;
    let (area, share) = adhesion(Ellipse::from_ratio(a_over_b)?, &full(&theory, creepage));
    Ok((smooth_area(&area), share))
}

/// An area of adhesion by the full theory without the steps of its elements, to be filled.
pub(crate) fn smooth_area(adhesion: &[Polygon]) -> Vec<Polygon> {
    adhesion.iter().map(|polygon| smoothed(polygon)).collect()
}

/// A closed polygon without ripples shorter than an element of the full theory, whose border of
/// adhesion steps from element to element.
fn smoothed(polygon: &[[f64; 2]]) -> Polygon {
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

/// `|(X, Y)|/mu Z` at a point inside the contact.
pub(crate) fn reduced(ellipse: Ellipse, point: &FieldPoint) -> f64 {
    let [x, y] = point.position;
    let bound = (1.0 - (x / ellipse.a()).powi(2) - (y / ellipse.b()).powi(2)).max(0.0).sqrt();
    point.traction[0].hypot(point.traction[1]) / bound.max(f64::MIN_POSITIVE)
}

/// The parts of closed polygons whose points are to be kept.
pub(crate) fn parts(polygons: &[Polygon], keep: impl Fn([f64; 2]) -> bool) -> Vec<Polygon> {
    let mut lines = Vec::new();
    for polygon in polygons {
        // A line that goes round begins where something is left out, if anything is.
        let start = polygon.iter().position(|point| !keep(*point)).unwrap_or(0);
        let around = polygon.iter().cycle().skip(start).take(polygon.len() + 1);
        let mut line = Vec::new();
        for point in around {
            if keep(*point) {
                line.push(*point);
            } else if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
        }
        lines.push(line);
    }
    lines.retain(|line| line.len() > 1);
    lines
}

/// The boundary between adhesion and slip: that of the adhesion area without the contact's edge.
pub(crate) fn separatrix(ellipse: Ellipse, adhesion: &[Polygon]) -> Vec<Polygon> {
    parts(adhesion, |point| radius(ellipse, point) < EDGE)
}

/// The same by the full theory, whose elements leave steps in the line.
pub(crate) fn full_separatrix(ellipse: Ellipse, adhesion: &[Polygon]) -> Vec<Polygon> {
    smooth(parts(adhesion, |point| radius(ellipse, point) < EDGE_OF_ELEMENTS))
}

/// A ring that points out a small area.
pub(crate) fn ringed(panel: Panel, area: &[[f64; 2]]) -> Panel {
    let mean = |k: usize| area.iter().map(|point| point[k]).sum::<f64>() / area.len() as f64;
    let [x, y] = [mean(0), mean(1)];
    let far = area.iter().map(|point| (point[0] - x).hypot(point[1] - y)).fold(0.0, f64::max);
    let radius = far + 0.08;
    let ring = spaced(0.0, std::f64::consts::TAU, 60).into_iter().map(f64::sin_cos);
    panel.curve(ring.map(|(sin, cos)| [x + radius * cos, y + radius * sin]).collect(), RING)
}

/// A hair off the contact's edge.
pub(crate) const EDGE: f64 = 0.998;
/// Where the middles of the outermost elements of [`detailed`] lie: beyond, nothing is resolved.
pub(crate) const EDGE_OF_ELEMENTS: f64 = 0.975;

/// 0 at the centre, 1 on the contact's edge.
pub(crate) fn radius(ellipse: Ellipse, [x, y]: [f64; 2]) -> f64 {
    (x / ellipse.a()).hypot(y / ellipse.b())
}

/// Takes the steps of elements out of open lines, over the width of an element of [`detailed`].
pub(crate) fn smooth(mut lines: Vec<Polygon>) -> Vec<Polygon> {
    for line in lines.iter_mut().filter(|line| line.first() != line.last()) {
        // Twelve times (1, 2, 1)/4: a bell of 2.4 points to either side.
        for _ in 0..12 {
            let old = line.clone();
            for (k, triple) in old.windows(3).enumerate() {
                let mean = |i: usize| 0.25 * (triple[0][i] + 2.0 * triple[1][i] + triple[2][i]);
                line[k + 1] = [mean(0), mean(1)];
            }
        }
    }
    lines
}

/// Pieces of adhesion that cover more than a thousandth of the contact.
pub(crate) fn pieces(ellipse: Ellipse, adhesion: &[Polygon]) -> usize {
    adhesion.iter().filter(|polygon| signed_area(polygon) > 1e-3 * ellipse.area()).count()
}

/// An empty panel to scale for a contact: `x`, the rolling direction, to the right, `y` down; with
/// white beside a slender one, which would be too tall else.
pub(crate) fn panel(ellipse: Ellipse, heading: Label) -> Panel {
    let b = ellipse.b();
    let reach = ellipse.a().max(0.6 * b);
    let x = Axis::new([-1.12 * reach, 1.22 * reach], Label::default());
    let y = Axis::new([1.2 * b, -1.08 * b], Label::default());
    Panel::new(x, y).to_scale().bare().heading(heading)
}

/// Adds the contact's edge and the axes.
pub(crate) fn edge(panel: Panel, ellipse: Ellipse) -> Panel {
    let (a, b) = (ellipse.a(), ellipse.b());
    panel
        .curve(vec![[-1.08 * a, 0.0], [1.12 * a, 0.0]], Pen::GUIDE)
        .curve(vec![[0.0, -1.05 * b], [0.0, 1.1 * b]], Pen::GUIDE)
        .curve(outline(ellipse), Pen::OUTLINE)
        .text([1.13 * a, 0.04 * b], Anchor::Start, Label::default().symbol("x"))
        .text([0.05 * a, 1.19 * b], Anchor::Start, Label::default().symbol("y"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_separatrix_leaves_the_edge_out() {
        let circle = Ellipse::from_ratio(1.0).unwrap();
        let (adhesion, _) = traced(circle, |points| points.iter().map(|p| p[0] > 0.2).collect());
        let lines = separatrix(circle, &adhesion);
        assert_eq!(lines.len(), 1);
        // Bisected to a thousandth of a lattice cell.
        assert!(lines[0].iter().all(|point| (point[0] - 0.2).abs() < 1e-3));
        assert_eq!(pieces(circle, &adhesion), 1);
    }

    #[test]
    fn a_line_within_is_closed() {
        let square = vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
        let lines = parts(&square, |_| true);
        assert_eq!(lines[0].first(), lines[0].last());
        assert_eq!(parts(&square, |point| point[1] < 0.5), [vec![[0.0, 0.0], [1.0, 0.0]]]);
    }
}
