//! Areas of the unit disc or of a square, traced to a smooth boundary by marching squares.
//!
//! A square lattice is bent onto the disc `(x/a, y/b)`, edge to edge, so that no area needs clipping. Where the boundary crosses a lattice edge is
//! found by bisection, since a point is known to be inside or outside only.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use crate::scene::Point;

/// Lattice cells along each side of the square.
const CELLS: usize = 96;
/// Lattice nodes a side, with a rim of outside around so that every boundary closes.
const NODES: usize = CELLS + 3;
/// Halvings of a lattice edge: the crossing is known to a thousandth of a cell.
const HALVINGS: usize = 10;
/// Points are asked for a hair inside the disc, where a field is defined.
const INSIDE: f64 = 0.9995;

/// The boundary of an area in the unit disc, or in a square.
#[derive(Debug, Clone)]
pub struct Contour {
    /// Closed loops, counter-clockwise about the area.
    pub polygons: Vec<Vec<Point>>,
    /// Area of the loops over that of the disc or the square.
    pub share: f64,
}

impl Contour {
    /// Traces the area whose points `is_inside` answers with true; it is asked for many points at
    /// once, some fifteen thousand in all.
    #[must_use]
    pub fn trace(is_inside: impl Fn(&[Point]) -> Vec<bool>) -> Self {
        Self::on(disc_point, |points| {
            is_inside(&points.iter().map(|p| [p[0] * INSIDE, p[1] * INSIDE]).collect::<Vec<_>>())
        })
    }

    /// The same in the square from -1 to 1.
    #[must_use]
    pub fn trace_square(is_inside: impl Fn(&[Point]) -> Vec<bool>) -> Self {
        Self::on(square_point, is_inside)
    }

    fn on(place: Place, is_inside: impl Fn(&[Point]) -> Vec<bool>) -> Self {
        let lattice = Lattice::sample(place, &is_inside);
        let successors = lattice.successors();
        let crossings = lattice.crossings(&successors, is_inside);
        let polygons = loops(&successors, &crossings);
        let area = polygons.iter().fold(0.0, |sum, polygon| sum + signed_area(polygon));
        let share = (area / signed_area(&rim(place))).clamp(0.0, 1.0);
        Self { polygons, share }
    }
}

/// An ellipse about the origin as a closed line.
#[must_use]
pub fn ellipse([a, b]: [f64; 2]) -> Vec<Point> {
    let at = |k: u32| (TAU * f64::from(k) / 240.0).sin_cos();
    (0..=240).map(at).map(|(sin, cos)| [a * cos, b * sin]).collect()
}

/// A polygon as a line that ends where it began.
#[must_use]
pub fn closed(mut polygon: Vec<Point>) -> Vec<Point> {
    polygon.extend(polygon.first().copied());
    polygon
}

/// Where node `(i, j)` of the lattice lies.
type Place = fn(usize, usize) -> Point;

/// The point of the square at node `(i, j)`; the outermost nodes repeat those next to them.
fn square_point(i: usize, j: usize) -> Point {
    [i, j].map(|k| 2.0 * (k.clamp(1, CELLS + 1) - 1) as f64 / CELLS as f64 - 1.0)
}

/// The same on the disc.
fn disc_point(i: usize, j: usize) -> Point {
    let [u, v] = square_point(i, j);
    [u * (1.0 - 0.5 * v * v).sqrt(), v * (1.0 - 0.5 * u * u).sqrt()]
}

/// The edge as the lattice has it, counter-clockwise.
fn rim(place: Place) -> Vec<Point> {
    let (low, high) = (1, CELLS + 1);
    let side = |at: fn(usize) -> (usize, usize)| {
        (low..high).map(at).map(|(i, j)| place(i, j)).collect::<Vec<_>>()
    };
    [
        side(|k| (k, 1)),
        side(|k| (CELLS + 1, k)),
        side(|k| (CELLS + 2 - k, CELLS + 1)),
        side(|k| (1, CELLS + 2 - k)),
    ]
    .concat()
}

/// The area of a polygon, positive counter-clockwise.
#[must_use]
pub fn signed_area(polygon: &[Point]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0])).sum()
}

/// An edge from node `(i, j)` to its neighbour along `i`, or along `j`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Edge {
    i: usize,
    j: usize,
    along_j: bool,
}

impl Edge {
    fn nodes(self) -> [(usize, usize); 2] {
        let (i, j) = (self.i, self.j);
        [(i, j), if self.along_j { (i, j + 1) } else { (i + 1, j) }]
    }
}

/// Which nodes are inside.
struct Lattice {
    place: Place,
    inside: Vec<bool>,
}

impl Lattice {
    fn sample(place: Place, is_inside: impl Fn(&[Point]) -> Vec<bool>) -> Self {
        let inner = || (1..=CELLS + 1).flat_map(|j| (1..=CELLS + 1).map(move |i| (i, j)));
        let points: Vec<_> = inner().map(|(i, j)| place(i, j)).collect();
        let mut lattice = Self { place, inside: vec![false; NODES * NODES] };
        for ((i, j), inside) in inner().zip(is_inside(&points)) {
            lattice.inside[i + NODES * j] = inside;
        }
        lattice
    }

    fn is_inside(&self, (i, j): (usize, usize)) -> bool {
        self.inside[i + NODES * j]
    }

    /// For every edge where the boundary enters a cell, the edge where it leaves that cell, with
    /// the area on its left. Of two opposite corners inside, each gets a boundary of its own.
    fn successors(&self) -> BTreeMap<Edge, Edge> {
        let mut successors = BTreeMap::new();
        for (i, j) in (0..NODES - 1).flat_map(|j| (0..NODES - 1).map(move |i| (i, j))) {
            let corners =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|n| self.is_inside(n));
            let sides = [
                Edge { i, j, along_j: false },
                Edge { i: i + 1, j, along_j: true },
                Edge { i, j: j + 1, along_j: false },
                Edge { i, j, along_j: true },
            ];
            let turns = |side: usize| (corners[side % 4], corners[(side + 1) % 4]);
            for enter in (0..4).filter(|&side| turns(side) == (true, false)) {
                if let Some(leave) =
                    (1..4).map(|k| enter + 4 - k).find(|&s| !turns(s).0 && turns(s).1)
                {
                    successors.insert(sides[enter], sides[leave % 4]);
                }
            }
        }
        successors
    }

    /// Where the boundary crosses each of its edges.
    fn crossings(
        &self,
        successors: &BTreeMap<Edge, Edge>,
        is_inside: impl Fn(&[Point]) -> Vec<bool>,
    ) -> BTreeMap<Edge, Point> {
        let (mut ins, mut outs): (Vec<_>, Vec<_>) = successors
            .keys()
            .map(|edge| {
                let [start, end] = edge.nodes();
                let points = ((self.place)(start.0, start.1), (self.place)(end.0, end.1));
                if self.is_inside(start) { points } else { (points.1, points.0) }
            })
            .unzip();
        for _ in 0..HALVINGS {
            let middles: Vec<_> = ins.iter().zip(&outs).map(|(p, q)| middle(*p, *q)).collect();
            let ends = ins.iter_mut().zip(&mut outs);
            for ((inner, outer), (middle, inside)) in
                ends.zip(middles.iter().zip(is_inside(&middles)))
            {
                *(if inside { inner } else { outer }) = *middle;
            }
        }
        let crossing = ins.iter().zip(&outs).map(|(p, q)| middle(*p, *q));
        successors.keys().copied().zip(crossing).collect()
    }
}

fn middle(p: Point, q: Point) -> Point {
    [f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])]
}

/// Follows the boundary from edge to edge until every loop is closed.
fn loops(successors: &BTreeMap<Edge, Edge>, crossings: &BTreeMap<Edge, Point>) -> Vec<Vec<Point>> {
    let mut left = successors.clone();
    let mut loops = Vec::new();
    while let Some((mut edge, mut next)) = left.pop_first() {
        let mut points = Vec::new();
        loop {
            points.extend(crossings.get(&edge));
            edge = next;
            match left.remove(&edge) {
                Some(following) => next = following,
                None => break,
            }
        }
        loops.push(points);
    }
    loops
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn trace(is_inside: impl Fn(Point) -> bool) -> Contour {
        Contour::trace(|points| points.iter().map(|p| is_inside(*p)).collect())
    }

    #[test]
    fn all_inside_is_the_whole_disc_and_all_outside_is_nothing() {
        let all = trace(|_| true);
        // The same points in the same order, up to the start: rounding only.
        assert!((all.share - 1.0).abs() < 1e-12);
        assert_eq!(all.polygons.len(), 1);
        assert!(trace(|_| false).polygons.is_empty());
        assert!(trace(|_| false).share.abs() < 1e-300);
    }

    #[test]
    fn a_circle_inside_has_its_area_and_its_radius() {
        let contour = trace(|p| p[0].hypot(p[1]) < 0.6 * INSIDE);
        // Chords of a circle of r = 0.6 over cells of 2/96: area short by (h/r)^2/6 = 2e-4.
        assert!((contour.share - 0.36).abs() < 4e-4 * 0.36);
        for p in &contour.polygons[0] {
            // A thousandth of a cell, stretched at most by the bending of the lattice.
            assert!((p[0].hypot(p[1]) - 0.6).abs() < 2.1e-2 / 1024.0 * 2.0);
        }
    }

    #[test]
    fn a_ring_has_a_hole() {
        let contour = trace(|p| (0.3..0.8).contains(&p[0].hypot(p[1])));
        assert_eq!(contour.polygons.len(), 2);
        assert!((contour.share - (0.64 - 0.09)).abs() < 2e-3);
    }

    #[test]
    fn half_a_square_is_traced_to_its_corners() {
        let half =
            Contour::trace_square(|points| points.iter().map(|[x, y]| x + y > 0.0).collect());
        // A straight border, known to a thousandth of a cell.
        assert!((half.share - 0.5).abs() < 1e-4, "{}", half.share);
        assert_eq!(half.polygons.len(), 1);
    }

    #[test]
    fn a_half_disc_meets_the_edge() {
        let contour = trace(|p| p[0] > 0.2);
        let segment = (0.2_f64.acos() - 0.2 * (1.0_f64 - 0.04).sqrt()) / PI;
        // Its straight side moves by the hair that points are drawn inside: 0.0005 * 0.2.
        assert!((contour.share - segment).abs() < 2e-4);
        assert_eq!(contour.polygons.len(), 1);
    }

    #[test]
    fn a_checkerboard_closes_every_loop_inside_the_disc() {
        let contour = trace(|p| ((p[0] * 48.0).floor() + (p[1] * 48.0).floor()) % 2.0 == 0.0);
        assert!(contour.polygons.len() > 100);
        for p in contour.polygons.iter().flatten() {
            assert!(p[0].hypot(p[1]) < 1.0 + 1e-12);
        }
    }
}
