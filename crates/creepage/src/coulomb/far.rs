//! Displacement by elements that are far away: constant tractions by four Gauss points each, for
//! many elements at a time.
//!
//! Relative errors of the slip over a step of half an element, the worst of 300 random
//! quadrilaterals: 3e-4, 4e-5 and 3e-6 at distances of 3, 4 and 6 times their size.

use pulp::{Arch, Simd, WithSimd};

use super::mesh::Mesh;

const POINTS: usize = 4;
/// Gauss's two points on (-1, 1).
const GAUSS: f64 = 0.577_350_269_189_625_8;
/// Distance over size from which an element counts as far.
const FAR: f64 = 4.0;

/// The Gauss points of all elements.
#[derive(Debug, Clone)]
pub(crate) struct FarField {
    /// Point by point, each of all elements.
    x: [Vec<f64>; POINTS],
    y: [Vec<f64>; POINTS],
    weight: [Vec<f64>; POINTS],
    middles: Vec<[f64; 2]>,
    /// Square of the distance from which an element is far.
    far: Vec<f64>,
}

impl FarField {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let room = || std::array::from_fn(|_| Vec::with_capacity(mesh.len()));
        let mut field = Self {
            x: room(),
            y: room(),
            weight: room(),
            middles: Vec::with_capacity(mesh.len()),
            far: Vec::with_capacity(mesh.len()),
        };
        for (strip, i) in mesh.all() {
            field.add(mesh.strips[strip].corners(i));
        }
        field
    }

    fn add(&mut self, corners: [[f64; 2]; 4]) {
        for k in 0..POINTS {
            let [s, t] =
                [if k % 2 == 0 { -GAUSS } else { GAUSS }, if k < 2 { -GAUSS } else { GAUSS }];
            let ([x, y], weight) = map(corners, s, t);
            self.x[k].push(x);
            self.y[k].push(y);
            self.weight[k].push(weight);
        }
        let apart = |i: usize, k: usize| {
            (corners[i][0] - corners[k][0]).powi(2) + (corners[i][1] - corners[k][1]).powi(2)
        };
        self.middles.push(map(corners, 0.0, 0.0).0);
        self.far.push(FAR * FAR * apart(0, 2).max(apart(1, 3)));
    }

    /// Whether an element is far from a point.
    pub(crate) fn is_far(&self, element: usize, [x, y]: [f64; 2]) -> bool {
        let [p, q] = self.middles[element];
        (p - x).powi(2) + (q - y).powi(2) > self.far[element]
    }

    /// Adds to `sums`, which are as many as elements, the displacements at a point by every element
    /// as if all were far.
    pub(crate) fn displace(&self, poisson: f64, at: [f64; 2], sums: [&mut [f64]; 3]) {
        Arch::new().dispatch(Displace { field: self, poisson, at, sums });
    }
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

struct Displace<'a> {
    field: &'a FarField,
    poisson: f64,
    at: [f64; 2],
    sums: [&'a mut [f64]; 3],
}

impl WithSimd for Displace<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { field, poisson, at: [x, y], sums: [xx, xy, yy] } = self;
        for ((xs, ys), weights) in field.x.iter().zip(&field.y).zip(&field.weight) {
            let points = xs.iter().zip(ys).zip(weights);
            let sums = xx.iter_mut().zip(&mut *xy).zip(&mut *yy);
            for (((xx, xy), yy), ((px, py), weight)) in sums.zip(points) {
                let (dx, dy) = (px - x, py - y);
                let inverse = 1.0 / (dx * dx + dy * dy).sqrt();
                let (own, bent) = (weight * inverse, weight * poisson * inverse.powi(3));
                *xx += own - bent * dy * dy;
                *xy += bent * dx * dy;
                *yy += own - bent * dx * dx;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::influence::displace;
    use crate::ellipse::Ellipse;

    /// Against closed forms; the error of two points each way is of fourth order in size over
    /// distance, 1/256 at most here.
    #[test]
    fn far_elements_act_as_their_gauss_points() {
        let mesh = Mesh::ellipse(Ellipse::from_ratio(0.5).unwrap(), 12, 20);
        let field = FarField::new(&mesh);
        let mut seen = 0;
        for at in [[0.1, -0.2], [0.6, 0.0], [0.0, 1.3]] {
            let mut closed: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::new());
            displace(&mesh, 0.3, at, &mut closed);
            let mut sums: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; mesh.len()]);
            field.displace(0.3, at, sums.each_mut().map(Vec::as_mut_slice));
            for element in (0..mesh.len()).filter(|element| field.is_far(*element, at)) {
                seen += 1;
                for k in 0..3 {
                    let apart = (sums[k][element] - closed[k][element]).abs();
                    assert!(apart < 1e-4 * closed[0][element], "{at:?} {element}");
                }
            }
        }
        assert!(seen > 300, "{seen}");
    }
}
