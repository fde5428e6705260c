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
use crate::numerics::simd_math::{ln_of_ratio, multiply_add};

/// Keeps logarithms finite where what they are multiplied with vanishes.
const TINY: f64 = 1e-140;

/// The cuts of all strips, from the leading edge of each; there is one more than a strip has elements.
#[derive(Debug, Clone)]
pub(crate) struct Cuts {
    /// Ends of all cuts, border by border.
    corners: Ends,
    /// Strips one beside the other, in order.
    runs: Vec<Run>,
    /// Of each cut from its lower to its upper end.
    tangent: Ends,
    /// First element of every strip, and the number of all.
    offsets: Vec<usize>,
    /// Traction of each element.
    tractions: Vec<f64>,
    seen: Seen,
    /// Of each cut at one point: in `x` by `x`, in `x` by `y` and in `y` by `x`, in `y` by `y`.
    sums: [Vec<f64>; 3],
}

/// Strips each of whose lower border is the upper one of the strip below, with the same ends of cuts.
#[derive(Debug, Clone)]
struct Run {
    /// First corner.
    corner: usize,
    /// Corners on each border.
    width: usize,
    /// Cuts of all strips.
    cuts: usize,
}

/// A vector for every cut, or for every corner.
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

    fn extend(&mut self, ends: &[[f64; 2]]) {
        for end in ends {
            self.push(*end);
        }
    }
}

/// All corners seen from a point: distances, and [`Corner::border`].
#[derive(Debug, Clone)]
struct Seen {
    radius: Vec<f64>,
    border: Vec<f64>,
}

impl Cuts {
    /// The elements of a mesh, each with the traction that acts on all of it.
    pub(crate) fn new(mesh: &Mesh, tractions: Vec<f64>) -> Self {
        let (mut corners, mut tangent) = (Ends::default(), Ends::default());
        let (mut runs, mut border): (Vec<Run>, Vec<[f64; 2]>) = (Vec::new(), Vec::new());
        for strip in &mesh.strips {
            let ends: Vec<_> = (0..=strip.len()).map(|i| strip.cut_ends(i)).collect();
            let [lower, upper]: [Vec<[f64; 2]>; 2] =
                [0, 1].map(|k| ends.iter().map(|ends| ends[k]).collect());
            if border != lower {
                let (corner, width) = (corners.x.len(), ends.len());
                runs.push(Run { corner, width, cuts: 0 });
                corners.extend(&lower);
            }
            corners.extend(&upper);
            if let Some(run) = runs.last_mut() {
                run.cuts += ends.len();
            }
            for [[x0, y0], [x1, y1]] in ends {
                let length = (x1 - x0).hypot(y1 - y0);
                tangent.push([(x1 - x0) / length, (y1 - y0) / length]);
            }
            border = upper;
        }
        let sums = std::array::from_fn(|_| vec![0.0; tangent.x.len()]);
        let [radius, border] = [(); 2].map(|()| vec![0.0; corners.x.len()]);
        let (offsets, seen) = (mesh.offsets().to_vec(), Seen { radius, border });
        Self { corners, runs, tangent, offsets, tractions, seen, sums }
    }

    /// The displacements at a point by every element, in units of `length / (pi G)`.
    pub(crate) fn displace(&mut self, poisson: f64, at: [f64; 2], by: [&mut [f64]; 3]) {
        Arch::new().dispatch(Displace { cuts: self, poisson, at, by });
    }
}

struct Displace<'a> {
    cuts: &'a mut Cuts,
    poisson: f64,
    at: [f64; 2],
    by: [&'a mut [f64]; 3],
}

impl WithSimd for Displace<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { cuts, poisson, at, by } = self;
        // Processors with so many lanes multiply and add at once.
        if S::F64_LANES >= 4 {
            cuts.see::<true>(at);
            cuts.add_up::<true>(poisson, at);
        } else {
            cuts.see::<false>(at);
            cuts.add_up::<false>(poisson, at);
        }
        for (by, sums) in by.into_iter().zip(&cuts.sums) {
            for (strip, elements) in cuts.offsets.windows(2).enumerate() {
                let sums = &sums[elements[0] + strip..=elements[1] + strip];
                let elements = elements[0]..elements[1];
                let sides = sums.iter().zip(&sums[1..]).zip(&cuts.tractions[elements.clone()]);
                for (by, ((front, rear), traction)) in by[elements].iter_mut().zip(sides) {
                    *by = traction * (front - rear);
                }
            }
        }
    }
}

#[allow(clippy::inline_always)]
impl Cuts {
    #[inline(always)]
    fn see<const FUSED: bool>(&mut self, [x, y]: [f64; 2]) {
        let Seen { radius, border } = &mut self.seen;
        let corners = self.corners.x.iter().zip(&self.corners.y);
        for ((radius, border), (px, py)) in radius.iter_mut().zip(border).zip(corners) {
            let corner = Corner::new::<FUSED>(px - x, py - y);
            (*radius, *border) = (corner.radius, corner.border::<FUSED>());
        }
    }

    /// Sums of each cut, its corners seen.
    #[inline(always)]
    fn add_up<const FUSED: bool>(&mut self, poisson: f64, [x, y]: [f64; 2]) {
        let Self { corners, runs, tangent, seen, sums: [xx, xy, yy], .. } = self;
        let mut first = 0;
        for run in runs {
            let of_run = first..first + run.cuts;
            let sums = xx[of_run.clone()].iter_mut().zip(&mut xy[of_run.clone()]);
            let sums = sums.zip(&mut yy[of_run.clone()]);
            let tangents = tangent.x[of_run.clone()].iter().zip(&tangent.y[of_run]);
            let [lower, upper] = [0, run.width].map(|beside| {
                let corner = run.corner + beside;
                let ends = corner..corner + run.cuts;
                let places = corners.x[ends.clone()].iter().zip(&corners.y[ends.clone()]);
                places.zip(seen.radius[ends.clone()].iter().zip(&seen.border[ends]))
            });
            for ((((xx, xy), yy), (tx, ty)), (lower, upper)) in
                sums.zip(tangents).zip(lower.zip(upper))
            {
                let ends = [lower, upper].map(|((px, py), (radius, _))| Corner {
                    x: px - x,
                    y: py - y,
                    radius: *radius,
                });
                let borders = upper.1.1 - lower.1.1;
                let (own, bent) = along_cut::<FUSED>(ends, [*tx, *ty]);
                *xx = own - poisson * ty * bent[0] + borders;
                *xy = -poisson * ty * bent[1];
                *yy = own + poisson * tx * bent[1] + (1.0 - poisson) * borders;
            }
            first += run.cuts;
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
    fn new<const FUSED: bool>(x: f64, y: f64) -> Self {
        Self { x, y, radius: multiply_add::<FUSED>(x, x, y * y).sqrt() }
    }

    /// Integral of `y / R` along the border, as far as here: `y asinh(x / |y|)`.
    #[inline(always)]
    fn border<const FUSED: bool>(self) -> f64 {
        let (sum, across) = ((self.x.abs() + self.radius).max(TINY), self.y.abs().max(TINY));
        self.y * ln_of_ratio::<FUSED>(sum, across).copysign(self.x)
    }
}

/// Integrals along a cut of direction `t`, whose normal is `(ty, -tx)`: of `distance / R`, and of
/// `x / R` and `y / R`.
#[allow(clippy::inline_always)]
#[inline(always)]
fn along_cut<const FUSED: bool>(
    [lower, upper]: [Corner; 2],
    [tx, ty]: [f64; 2],
) -> (f64, [f64; 2]) {
    let distance = multiply_add::<FUSED>(ty, lower.x, -tx * lower.y);
    let from = multiply_add::<FUSED>(tx, lower.x, ty * lower.y);
    let to = multiply_add::<FUSED>(tx, upper.x, ty * upper.y);
    let (before, behind) = (from.abs() + lower.radius, to.abs() + upper.radius);
    let either = |is_one: bool, one: f64, other: f64| if is_one { one } else { other };
    // The logarithm of (to + behind) / (from + before), where nothing cancels.
    let upwards = either(to > 0.0, behind, 1.0) * either(from < 0.0, before, 1.0);
    let downwards = either(from >= 0.0, before, 1.0) * either(to <= 0.0, behind, 1.0);
    let square = either(from < 0.0 && to > 0.0, distance * distance, 1.0);
    let (over, under) = (upwards.max(TINY), (downwards * square).max(TINY));
    let own = distance * ln_of_ratio::<FUSED>(over, under);
    let radial = upper.radius - lower.radius;
    let bent =
        [multiply_add::<FUSED>(ty, own, tx * radial), multiply_add::<FUSED>(ty, radial, -tx * own)];
    (own, bent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::mesh::Strip;
    use crate::coulomb::subdivision::{Pieces, SUBCELLS};
    use crate::ellipse::Ellipse;

    /// A strip of one quadrilateral whose lower side reaches from `x[0][0]` to `x[0][1]`.
    fn quadrilateral(x: [[f64; 2]; 2], [low, high]: [f64; 2]) -> Mesh {
        let piece = |k: usize| k as f64 / SUBCELLS as f64;
        let strip = Strip {
            across: std::array::from_fn(|k| low + piece(k) * (high - low)),
            middle: x.map(|[rear, front]| 0.5 * (front + rear)),
            half_length: x.map(|[rear, front]| 0.5 * (front - rear)),
            along: Pieces::new((0..=SUBCELLS).map(|k| 1.0 - 2.0 * piece(k)).collect()),
            patch: 0..1,
        };
        Mesh::new(vec![strip])
    }

    fn by_all(mesh: &Mesh, poisson: f64, at: [f64; 2]) -> [f64; 3] {
        let mut by: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0; mesh.len()]);
        let rows = by.each_mut().map(Vec::as_mut_slice);
        Cuts::new(mesh, vec![1.0; mesh.len()]).displace(poisson, at, rows);
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
        let cuts = (0..=5 * SUBCELLS).map(|k| 1.0 - k as f64 / (2.5 * SUBCELLS as f64));
        pieces.along = Pieces::new(cuts.collect());
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
