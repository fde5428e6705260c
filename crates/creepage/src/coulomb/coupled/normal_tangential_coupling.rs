//! Influence of pressure on slip and of tangential traction on normal displacement, for
//! elements of unlike bodies.
//!
//! With the plane influence of an element at a point `(x, y)`,
//!
//! ```math
//! S = \iint \frac{(x' - x, \, y' - y)}{R^2} \, dx' dy' = \oint n \ln R \, ds,
//! ```
//!
//! (2.11a,b) and (2.15c) are `(u, v) = kappa/(pi G) sum Z S` and
//! `w = -kappa/(pi G) sum (X, Y) . S`.

use crate::coulomb::mesh::Mesh;
use crate::numerics::gauss::GAUSS_2;

/// Distance over size from which four Gauss points act as an element: an error of 3e-5.
const FAR: f64 = 4.0;

/// One element: its corners, all around, and its Gauss points with their parts of the area.
#[derive(Debug, Clone)]
struct Element {
    corners: [[f64; 2]; 4],
    middle: [f64; 2],
    /// Square of the distance from which it is far.
    far: f64,
    points: [([f64; 2], f64); 4],
}

/// Influence of a mesh's elements.
#[derive(Debug, Clone)]
pub(super) struct NormalInfluence {
    elements: Vec<Element>,
}

impl NormalInfluence {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let elements = mesh.all().map(|(strip, i)| Element::new(mesh.strips[strip].corners(i)));
        Self { elements: elements.collect() }
    }

    /// `sum Z S` at a point.
    pub(super) fn by_pressure(&self, at: [f64; 2], pressures: &[f64]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (element, z) in self.elements.iter().zip(pressures) {
            let [x, y] = element.normal_influence(at);
            sum[0] += z * x;
            sum[1] += z * y;
        }
        sum
    }

    /// `sum (X, Y) . S` at a point.
    pub(super) fn by_traction(&self, at: [f64; 2], tractions: &[[f64; 2]]) -> f64 {
        let terms = self.elements.iter().zip(tractions).map(|(element, traction)| {
            let [x, y] = element.normal_influence(at);
            x * traction[0] + y * traction[1]
        });
        terms.sum()
    }
}

impl Element {
    fn new(corners: [[f64; 2]; 4]) -> Self {
        let points = std::array::from_fn(|k| {
            let side = |low: bool| GAUSS_2[usize::from(!low)].0;
            map(corners, side(k % 2 == 0), side(k < 2))
        });
        let apart = |i: usize, k: usize| {
            let [[a, b], [c, d]] = [corners[i], corners[k]];
            (a - c).powi(2) + (b - d).powi(2)
        };
        let far = FAR * FAR * apart(0, 2).max(apart(1, 3));
        Self { corners, middle: map(corners, 0.0, 0.0).0, far, points }
    }

    fn normal_influence(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [p, q] = self.middle;
        if (p - x).powi(2) + (q - y).powi(2) > self.far {
            return self.by_points([x, y]);
        }
        let corners = self.corners.map(|[p, q]| [p - x, q - y]);
        let mut sum = [0.0; 2];
        for k in 0..4 {
            let side = edge(corners[k], corners[(k + 1) % 4]);
            sum[0] += side[0];
            sum[1] += side[1];
        }
        sum
    }

    fn by_points(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for ([p, q], weight) in self.points {
            let (dx, dy) = (p - x, q - y);
            let over = weight / (dx * dx + dy * dy);
            sum[0] += over * dx;
            sum[1] += over * dy;
        }
        sum
    }
}

/// `int n ln R ds` along an edge with the element on its left, up to a multiple of its normal that
/// cancels all around; its ends lead from the field point.
fn edge(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let [across, up] = [to[0] - from[0], to[1] - from[1]];
    let length = across.hypot(up);
    if length == 0.0 {
        return [0.0; 2];
    }
    let ([tx, ty], [nx, ny]) = ([across / length, up / length], [up / length, -across / length]);
    let distance = nx * from[0] + ny * from[1];
    let [start, end] = [from, to].map(|[x, y]| tx * x + ty * y);
    let logarithm = |[x, y]: [f64; 2], along: f64| {
        let square = x * x + y * y;
        if square > 0.0 { 0.5 * along * square.ln() } else { 0.0 }
    };
    let angle = (distance * length).atan2(distance * distance + start * end);
    let integral = logarithm(to, end) - logarithm(from, start) + distance * angle;
    [nx * integral, ny * integral]
}

/// Bilinear map of a square on a quadrilateral: the image, and a quarter of the area there.
fn map([a, b, c, d]: [[f64; 2]; 4], s: f64, t: f64) -> ([f64; 2], f64) {
    let part = |s: f64, t: f64| 0.25 * (1.0 + s) * (1.0 + t);
    let weights = [part(-s, -t), part(s, -t), part(s, t), part(-s, t)];
    let at = [0, 1]
        .map(|k| weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k] + weights[3] * d[k]);
    let along = [0, 1].map(|k| 0.25 * ((1.0 - t) * (b[k] - a[k]) + (1.0 + t) * (c[k] - d[k])));
    let across = [0, 1].map(|k| 0.25 * ((1.0 - s) * (d[k] - a[k]) + (1.0 + s) * (c[k] - b[k])));
    (at, (along[0] * across[1] - along[1] * across[0]).abs())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::coulomb::mesh::StripGrading;
    use crate::ellipse::Ellipse;

    /// By Gauss's theorem a disc of uniform density attracts as `-pi (x, y)` inside and as all its
    /// mass outside; strips cut off less than a hundredth of it.
    #[test]
    fn a_uniform_disc_attracts_by_the_theorem_of_gauss() {
        let circle = Ellipse::from_ratio(1.0).unwrap();
        let mesh = Mesh::with_sides(circle, 24, 24, StripGrading::NARROW);
        let (normal_influence, ones) = (NormalInfluence::new(&mesh), vec![1.0; mesh.len()]);
        for at in [[0.0, 0.0], [0.3, -0.4], [0.0, 0.8], [1.5, 0.5], [-3.0, 2.0]] {
            let square = at[0] * at[0] + at[1] * at[1];
            let found = normal_influence.by_pressure(at, &ones);
            for k in 0..2 {
                let expected = -PI * at[k] / square.max(1.0);
                assert!((found[k] - expected).abs() < 0.01, "{at:?}: {found:?}");
            }
        }
    }

    /// Near and far together against midpoints of many cells.
    #[test]
    fn an_edge_has_its_closed_form() {
        let corners = [[1.0, -0.5], [1.2, 0.4], [-0.8, 0.6], [-1.0, -0.4]];
        let element = Element::new(corners);
        for at in [[0.1, 0.05], [1.1, 0.3], [3.0, 1.0], [-2.0, -6.0]] {
            let (mut sum, n) = ([0.0; 2], 1600);
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let middle = |k: i32| (2.0 * f64::from(k) + 1.0) / f64::from(n) - 1.0;
                let ([x, y], weight) = map(corners, middle(i), middle(j));
                let (dx, dy) = (x - at[0], y - at[1]);
                // A quarter of the area belongs to a Gauss point of weight one.
                let over = 4.0 * weight / f64::from(n * n) / (dx * dx + dy * dy);
                sum[0] += over * dx;
                sum[1] += over * dy;
            }
            let found = element.normal_influence(at);
            for k in 0..2 {
                // A cell's width next to the singular point, Gauss's error far away.
                assert!((found[k] - sum[k]).abs() < 4e-3, "{at:?}: {found:?} {sum:?}");
            }
        }
    }
}
