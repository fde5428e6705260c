//! Displacement by constant tractions on elements: the integrals of Boussinesq and Cerruti in closed
//! form, for many elements at a time.
//!
//! (2.11c) is integrated over an element with the divergence theorem: `x^2/R^3 = 1/R - d/dx (x/R)`,
//! and so on; `1/R` is the divergence of the position over `R`. What is left are integrals along the
//! sides of an element. Its sides along are parts of the borders of its strip, so that what they
//! add is a difference between its two cuts, as what the cuts themselves add: there is one sum a
//! cut, and each serves two elements.

use pulp::{Arch, Simd, WithSimd};

use super::mesh::Mesh;
use crate::lanes::ln;

/// Keeps logarithms finite where what they are multiplied with vanishes.
const TINY: f64 = 1e-140;

/// The cuts of all strips, from the leading edge of each; there is one more than a strip has elements.
#[derive(Debug, Clone)]
pub(crate) struct Cuts {
    lower: Ends,
    upper: Ends,
    /// From the lower to the upper end.
    tangent: Ends,
    /// First element of every strip, and the number of all.
    offsets: Vec<usize>,
    /// Traction of each element.
    tractions: Vec<f64>,
    /// Of each cut at one point: in `x` by `x`, in `x` by `y` and in `y` by `x`, in `y` by `y`.
    sums: [Vec<f64>; 3],
}

/// A vector for every cut.
#[derive(Debug, Clone, Default)]
struct Ends {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Ends {
    fn push(&mut self, [x, y]: [f64; 2]) {
        self.x.push(x);
        self.y.push(y);
    }
}

impl Cuts {
    /// The elements of a mesh, each with the traction that acts on all of it.
    pub(crate) fn new(mesh: &Mesh, tractions: Vec<f64>) -> Self {
        let [mut lower, mut upper, mut tangent] = [(); 3].map(|()| Ends::default());
        for strip in &mesh.strips {
            for i in 0..=strip.len() {
                let [[x0, y0], [x1, y1]] = strip.cut_ends(i);
                let length = (x1 - x0).hypot(y1 - y0);
                lower.push([x0, y0]);
                upper.push([x1, y1]);
                tangent.push([(x1 - x0) / length, (y1 - y0) / length]);
            }
        }
        let sums = std::array::from_fn(|_| vec![0.0; lower.x.len()]);
        Self { lower, upper, tangent, offsets: mesh.offsets().to_vec(), tractions, sums }
    }

    /// Adds the displacements at a point by every element, in units of `length / (pi G)`.
    pub(crate) fn displace(&mut self, poisson: f64, at: [f64; 2], by: &mut [Vec<f64>; 3]) {
        let Self { lower, upper, tangent, offsets, tractions, sums } = self;
        Arch::new().dispatch(Sums { lower, upper, tangent, poisson, at, by: sums });
        for (by, sums) in by.iter_mut().zip(sums) {
            for (strip, elements) in offsets.windows(2).enumerate() {
                let cuts = &sums[elements[0] + strip..=elements[1] + strip];
                let sides = cuts.iter().zip(&cuts[1..]).map(|(front, rear)| front - rear);
                let tractions = &tractions[elements[0]..elements[1]];
                by.extend(sides.zip(tractions).map(|(sides, traction)| traction * sides));
            }
        }
    }
}

struct Sums<'a> {
    lower: &'a Ends,
    upper: &'a Ends,
    tangent: &'a Ends,
    poisson: f64,
    at: [f64; 2],
    by: &'a mut [Vec<f64>; 3],
}

impl WithSimd for Sums<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { lower, upper, tangent, poisson, at: [x, y], by: [xx, xy, yy] } = self;
        let sums = xx.iter_mut().zip(xy).zip(yy);
        let lower = lower.x.iter().zip(&lower.y);
        let ends = lower.zip(upper.x.iter().zip(&upper.y));
        let cuts = ends.zip(tangent.x.iter().zip(&tangent.y));
        for (((xx, xy), yy), (((x0, y0), (x1, y1)), (tx, ty))) in sums.zip(cuts) {
            let ends = [Corner::new(x0 - x, y0 - y), Corner::new(x1 - x, y1 - y)];
            let borders = ends[1].border() - ends[0].border();
            let (own, bent) = along_cut(ends, [*tx, *ty]);
            *xx = own - poisson * ty * bent[0] + borders;
            *xy = -poisson * ty * bent[1];
            *yy = own + poisson * tx * bent[1] + (1.0 - poisson) * borders;
        }
    }
}

/// An end of a cut, seen from the point.
#[derive(Clone, Copy)]
struct Corner {
    x: f64,
    y: f64,
    radius: f64,
}

#[allow(clippy::inline_always)]
impl Corner {
    #[inline(always)]
    fn new(x: f64, y: f64) -> Self {
        Self { x, y, radius: (x * x + y * y).sqrt() }
    }

    /// Integral of `y / R` along the border, as far as here: `y asinh(x / |y|)`.
    #[inline(always)]
    fn border(self) -> f64 {
        let ratio = (self.x.abs() + self.radius) / self.y.abs().max(TINY);
        self.y * ln(ratio).copysign(self.x)
    }
}

/// Integrals along a cut of direction `t`, whose normal is `(ty, -tx)`: of `distance / R`, and of
/// `x / R` and `y / R`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn along_cut([lower, upper]: [Corner; 2], [tx, ty]: [f64; 2]) -> (f64, [f64; 2]) {
    let distance = ty * lower.x - tx * lower.y;
    let [from, to] = [lower, upper].map(|end| tx * end.x + ty * end.y);
    let [before, behind] = [(from, lower), (to, upper)].map(|(t, end)| t.abs() + end.radius);
    let either = |is_one: bool, one: f64, other: f64| if is_one { one } else { other };
    // The logarithm of (to + behind) / (from + before), where nothing cancels.
    let upwards = either(to > 0.0, behind, 1.0) * either(from < 0.0, before, 1.0);
    let downwards = either(from >= 0.0, before, 1.0) * either(to <= 0.0, behind, 1.0);
    let square = either(from < 0.0 && to > 0.0, distance * distance, 1.0);
    let own = distance * ln(upwards.max(TINY) / (downwards * square).max(TINY));
    let radial = upper.radius - lower.radius;
    (own, [ty * own + tx * radial, ty * radial - tx * own])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::mesh::{SUBCELLS, Strip};
    use crate::ellipse::Ellipse;

    /// A strip of one quadrilateral whose lower side reaches from `x[0][0]` to `x[0][1]`.
    fn quadrilateral(x: [[f64; 2]; 2], [low, high]: [f64; 2]) -> Mesh {
        let piece = |k: usize| k as f64 / SUBCELLS as f64;
        let strip = Strip {
            across: std::array::from_fn(|k| low + piece(k) * (high - low)),
            middle: x.map(|[rear, front]| 0.5 * (front + rear)),
            half_length: x.map(|[rear, front]| 0.5 * (front - rear)),
            along: (0..=SUBCELLS).map(|k| 1.0 - 2.0 * piece(k)).collect(),
            patch: 0..1,
        };
        Mesh::new(vec![strip])
    }

    fn by_all(mesh: &Mesh, poisson: f64, at: [f64; 2]) -> [f64; 3] {
        let mut by: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::new());
        Cuts::new(mesh, vec![1.0; mesh.len()]).displace(poisson, at, &mut by);
        by.map(|by| by.iter().sum())
    }

    /// Midpoint sums of the integrand away from the load: their error is of order 1e-5 here.
    #[test]
    fn cuts_sum_to_the_integral() {
        let (poisson, steps) = (0.3, 400);
        let (x, [low, high]) = ([[0.5, 1.3], [0.2, 1.5]], [-0.2, 0.9]);
        let mut sum = [0.0; 3];
        for (i, j) in (0..steps).flat_map(|i| (0..steps).map(move |j| (i, j))) {
            let [s, t] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(steps));
            let end = |k: usize| x[0][k] + t * (x[1][k] - x[0][k]);
            let (px, py) = (end(0) + s * (end(1) - end(0)), low + t * (high - low));
            let r = px.hypot(py);
            let area = (end(1) - end(0)) * (high - low) / f64::from(steps * steps);
            sum[0] += area * ((1.0 - poisson) / r + poisson * px * px / r.powi(3));
            sum[1] += area * poisson * px * py / r.powi(3);
            sum[2] += area * ((1.0 - poisson) / r + poisson * py * py / r.powi(3));
        }
        let found = by_all(&quadrilateral(x, [low, high]), poisson, [0.0; 2]);
        for (found, sum) in found.into_iter().zip(sum) {
            assert!((found - sum).abs() < 1e-5, "{found} {sum}");
        }
    }

    /// Far away the load acts as a point; cancellation must not spoil what is left of it.
    #[test]
    fn far_away_a_square_is_a_point_load() {
        let (poisson, side, distance) = (0.25, 1e-2, 40.0);
        let ends = [distance, distance + side];
        let load = quadrilateral([ends, ends], [-0.5 * side, 0.5 * side]);
        let r = distance + 0.5 * side;
        let expected = [side * side / r, 0.0, side * side * (1.0 - poisson) / r];
        for (found, expected) in by_all(&load, poisson, [0.0; 2]).into_iter().zip(expected) {
            // Next term of the expansion: (side/distance)^2 = 6e-8; rounding of sums of the order of the
            // distance, 1e-16 (r/side)^2 = 2e-9.
            assert!((found - expected).abs() < 1e-7 * side * side / r, "{found} {expected}");
        }
    }

    /// Elements are pieces of their strip: inside, on a border, at a corner, on a cut and outside.
    #[test]
    fn elements_add_up_to_their_strip() {
        let x = [[-1.0, 1.0], [-0.4, 1.2]];
        let whole = quadrilateral(x, [-0.3, 0.5]);
        let mut pieces = whole.strips[0].clone();
        pieces.along =
            (0..=5 * SUBCELLS).map(|k| 1.0 - k as f64 / (2.5 * SUBCELLS as f64)).collect();
        let pieces = Mesh::new(vec![pieces]);
        let on_cut = pieces.strips[0].middle_cut(2);
        for at in [[0.1, 0.2], [0.3, -0.3], [1.0, -0.3], on_cut, [4.0, -3.0], [0.0, 0.5]] {
            let [whole, pieces] = [&whole, &pieces].map(|mesh| by_all(mesh, 0.3, at));
            for k in 0..3 {
                // Rounding.
                assert!((whole[k] - pieces[k]).abs() < 1e-14, "{at:?}: {whole:?} {pieces:?}");
            }
            assert!(whole[0] > 0.0 && whole[2] > 0.0);
        }
    }

    /// A disc under constant traction at its centre: `u = integral of (1 - nu sin^2) d(theta) r`, pi
    /// (2 - nu) r, where the polygon's area lacks by the square of the strips' width.
    #[test]
    fn a_disc_moves_its_centre() {
        let mesh = Mesh::ellipse(Ellipse::from_ratio(1.0).unwrap(), 20, 41);
        let found = by_all(&mesh, 0.3, [0.0; 2]);
        let expected = std::f64::consts::PI * 1.7;
        assert!((found[0] / expected - 1.0).abs() < 2e-3, "{found:?}");
        assert!((found[2] / expected - 1.0).abs() < 2e-3 && found[1].abs() < 1e-12, "{found:?}");
    }
}
