//! Displacement by elements that are far away: constant tractions by Gauss points, for many
//! elements at a time.
//!
//! Three points each way from four times an element's size, two from eight times, and from farther
//! where it tapers: displacements err by less than 2e-6 then, and slip by about 1e-6 of that by an
//! element's own traction.

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use super::mesh::Mesh;

/// Gauss's points on (-1, 1), two and three, and the part of the whole that each stands for.
const TWO: [(f64, f64); 2] = [(-0.577_350_269_189_625_8, 0.5), (0.577_350_269_189_625_8, 0.5)];
const THREE: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 18.0),
    (0.0, 8.0 / 18.0),
    (0.774_596_669_241_483_4, 5.0 / 18.0),
];
/// Distance over size from which three points each way suffice, and from which two.
const FAR: [f64; 2] = [4.0, 8.0];
/// Distance over size from which two suffice in a triangle. With the weight `1 + taper t` they are
/// exact to the second order only: what lacks is .012 times the taper times the third power of size
/// over distance.
const TAPERED: f64 = 20.0;

/// The Gauss points of all elements.
#[derive(Debug, Clone)]
pub(crate) struct FarField {
    three: Vec<Point>,
    two: Vec<Point>,
    middles: Vec<[f64; 2]>,
    /// Squares of the distances from which three points suffice, and from which two.
    far: [Vec<f64>; 2],
    offsets: Vec<usize>,
}

/// One Gauss point, of all elements.
#[derive(Debug, Clone)]
struct Point {
    x: Vec<f64>,
    y: Vec<f64>,
    weight: Vec<f64>,
}

impl FarField {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let elements: Vec<_> = mesh.all().map(|(strip, i)| mesh.strips[strip].corners(i)).collect();
        Self {
            three: points(&elements, &THREE),
            two: points(&elements, &TWO),
            middles: elements.iter().map(|corners| map(*corners, 0.0, 0.0).0).collect(),
            far: [0, 1].map(|k| elements.iter().map(|corners| far(corners)[k]).collect()),
            offsets: mesh.offsets().to_vec(),
        }
    }

    /// Sets the displacements at a point by every element, as if all were far.
    pub(crate) fn displace(&self, poisson: f64, at: [f64; 2], by: &mut [&mut [f64]; 3]) {
        let mut run = |points, elements| {
            let by = by.each_mut().map(|by| &mut **by);
            Arch::new().dispatch(Displace { points, elements, poisson, at, by });
        };
        run(&self.two, 0..self.middles.len());
        for strip in self.offsets.windows(2) {
            run(&self.three, self.within(&self.far[1], strip[0]..strip[1], at));
        }
    }

    /// The elements of a strip, from the first to the last, that are not far.
    pub(crate) fn near(&self, strip: Range<usize>, at: [f64; 2]) -> Range<usize> {
        self.within(&self.far[0], strip, at)
    }

    fn within(&self, far: &[f64], mut strip: Range<usize>, at: [f64; 2]) -> Range<usize> {
        let is_near = |element: &usize| square(self.middles[*element], at) <= far[*element];
        let Some(first) = strip.find(is_near) else {
            return 0..0;
        };
        first..strip.rfind(is_near).unwrap_or(first) + 1
    }
}

/// Squares of the distances from which three points suffice for a quadrilateral, and from which two;
/// its first and its last two corners are the ends of its sides along.
fn far(corners: &[[f64; 2]; 4]) -> [f64; 2] {
    let [a, b, c, d] = *corners;
    let size = square(a, c).max(square(b, d));
    let [low, high] = [square(d, a), square(b, c)].map(f64::sqrt);
    let taper = ((high - low) / (high + low)).abs();
    let two = FAR[1].max(TAPERED * taper.cbrt());
    [FAR[0], two].map(|times| times * times * size)
}

fn square(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[0] - from[0]).powi(2) + (to[1] - from[1]).powi(2)
}

/// Gauss points of quadrilaterals, the same of `rule` each way.
fn points(elements: &[[[f64; 2]; 4]], rule: &[(f64, f64)]) -> Vec<Point> {
    let both = rule.iter().flat_map(|one| rule.iter().map(move |other| (*one, *other)));
    let point = |((s, ws), (t, wt))| {
        let mut point = Point { x: Vec::new(), y: Vec::new(), weight: Vec::new() };
        for corners in elements {
            let ([x, y], area) = map(*corners, s, t);
            point.x.push(x);
            point.y.push(y);
            point.weight.push(4.0 * ws * wt * area);
        }
        point
    };
    both.map(point).collect()
}

/// Bilinear map of a square on a quadrilateral: the image, and a quarter of the area there.
pub(super) fn map([a, b, c, d]: [[f64; 2]; 4], s: f64, t: f64) -> ([f64; 2], f64) {
    let part = |s: f64, t: f64| 0.25 * (1.0 + s) * (1.0 + t);
    let weights = [part(-s, -t), part(s, -t), part(s, t), part(-s, t)];
    let at = [0, 1]
        .map(|k| weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k] + weights[3] * d[k]);
    let along = [0, 1].map(|k| 0.25 * ((1.0 - t) * (b[k] - a[k]) + (1.0 + t) * (c[k] - d[k])));
    let across = [0, 1].map(|k| 0.25 * ((1.0 - s) * (d[k] - a[k]) + (1.0 + s) * (c[k] - b[k])));
    (at, (along[0] * across[1] - along[1] * across[0]).abs())
}

struct Displace<'a> {
    points: &'a [Point],
    elements: Range<usize>,
    poisson: f64,
    at: [f64; 2],
    by: [&'a mut [f64]; 3],
}

impl WithSimd for Displace<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { points, elements, poisson, at: [x, y], by } = self;
        let [xx, xy, yy] = by.map(|by| &mut by[elements.clone()]);
        for by in [&mut *xx, &mut *xy, &mut *yy] {
            by.fill(0.0);
        }
        for point in points {
            let [xs, ys, weights] =
                [&point.x, &point.y, &point.weight].map(|of| &of[elements.clone()]);
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
    use crate::coulomb::influence::displace_closed;
    use crate::ellipse::Ellipse;

    /// Against closed forms; the error of three points each way is of sixth order in size over
    /// distance, 1/4096 at most here, and two points are used from twice that distance.
    #[test]
    fn far_elements_act_as_their_gauss_points() {
        let mesh = Mesh::ellipse(Ellipse::from_ratio(0.5).unwrap(), 24, 40);
        let field = FarField::new(&mesh);
        let mut seen = 0;
        for at in [[0.1, -0.2], [0.6, 0.0], [0.0, 1.3]] {
            let mut closed: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::new());
            displace_closed(&mesh, 0.3, at, &mut closed);
            let mut by: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; mesh.len()]);
            field.displace(0.3, at, &mut by.each_mut().map(Vec::as_mut_slice));
            for strip in mesh.offsets().windows(2) {
                let near = field.near(strip[0]..strip[1], at);
                for element in (strip[0]..strip[1]).filter(|element| !near.contains(element)) {
                    seen += 1;
                    for k in 0..3 {
                        let apart = (by[k][element] - closed[k][element]).abs();
                        assert!(apart < 2e-6 * closed[0][element], "{at:?} {element} {apart:e}");
                    }
                }
            }
        }
        assert!(seen > 2000, "{seen}");
    }
}
