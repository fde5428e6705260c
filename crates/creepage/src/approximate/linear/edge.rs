//! Edge singularities of the traction on the ellipse, and the displacements that go with them.
//!
//! At the point `(a sin t, b cos t)` of the edge a traction `(1 - r^2)^(-1/2) (X', Y')` has the
//! strength `(X', Y')`: for polynomials of degree `n` a trigonometric polynomial with the
//! frequencies `m = -n, -n + 2, ..., n`. The compliance of the edge,
//!
//! `W(t) = ab/Q [[1 - sigma s^2, -sigma s c], [-sigma s c, 1 - sigma c^2]]`,
//! `Q = |(a cos t, b sin t)|`, `(c, s) = (a cos t, b sin t)/Q`,
//!
//! makes the load-displacement equations of [`halfspace`](crate::halfspace) Toeplitz: a traction
//! of degree `n` causes the displacement `P_n(x sin p/a + y cos p/b)` when the coefficients `k_m`
//! of its strength satisfy `sum_m' W_(m - m') k_m' = exp(-i m p)`. For functions of `y` alone the
//! right side is a row of ones, and the solutions of all degrees follow one from another
//! ([`strengths_of_y`]).
//!
//! Every displacement is one of two kinds: `u` even in `x` and `v` odd, or the reverse. Then
//! the coefficients become real when those of `Y'` are divided by `i` in the first kind, those
//! of `X'` by `-i` in the second.

use std::f64::consts::FRAC_PI_2;
use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;
use nalgebra::{DMatrix, DVector, Matrix2};

use crate::ellipse::Ellipse;

/// Coefficients `k_m` of the strength of `(X, Y)` of one degree, `m = -n, -n + 2, ..., n`.
pub(super) type Strength = Vec<[f64; 2]>;

/// A point of the half `y > 0` of the leading edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// `t`, from 0 at the end of the semi-axis `b` to `pi/2` at the leading point.
    pub(super) angle: f64,
    /// Weight of the quadrature over `t`.
    pub(super) weight: f64,
    /// `W`.
    pub(super) compliance: Matrix2<f64>,
}

/// Gauss nodes for products of two strengths of `degree` with `W`.
///
/// At the end of the longer axis `W` has a feature of width `g`. The nodes crowd there with
/// the square of the distance, so that `1/sqrt(g)` more of them suffice.
// A node count of some hundred, positive by construction.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn nodes(ellipse: Ellipse, poisson: f64, degree: usize) -> Vec<Node> {
    let count = degree + 16 + (12.0 / ellipse.g().sqrt()).ceil() as usize;
    let rule = GaussLegendre::new(NonZeroUsize::MIN.saturating_add(count));
    let half = FRAC_PI_2 / 2.0;
    let node = |&(x, w): &(f64, f64)| {
        let angle = half * (1.0 + x);
        Node { angle, weight: half * w, compliance: compliance(ellipse, poisson, angle) }
    };
    rule.iter().map(node).collect()
}

fn compliance(ellipse: Ellipse, poisson: f64, angle: f64) -> Matrix2<f64> {
    let (sin, cos) = angle.sin_cos();
    let (along, across) = (ellipse.a() * cos, ellipse.b() * sin);
    let q = along.hypot(across);
    let (c, s) = (along / q, across / q);
    let coupling = -poisson * s * c;
    Matrix2::new(1.0 - poisson * s * s, coupling, coupling, 1.0 - poisson * c * c)
        * (ellipse.a() * ellipse.b() / q)
}

/// The strengths that belong to `P_n(y/b)`, for every degree `n` up to the moments' last: in
/// the first columns for `u`, in the second for `v`.
///
/// As functions on the unit circle they are the kernels of the polynomials that are orthogonal
/// with weight `W`, and follow by Szegő's recurrence.
pub(super) fn strengths_of_y(moments: &[Matrix2<f64>]) -> Vec<Vec<Matrix2<f64>>> {
    let mut szego = Szego::new(moments[0]);
    let mut kernel = vec![inverse(moments[0])];
    let mut kernels = vec![kernel.clone()];
    for _ in 1..moments.len() {
        szego.advance(moments);
        let at_one: Matrix2<f64> = szego.forward.iter().sum();
        let factor = inverse(szego.forward_norm) * at_one.transpose();
        kernel.push(Matrix2::zeros());
        for (k, f) in kernel.iter_mut().zip(&szego.forward) {
            *k += f * factor;
        }
        kernels.push(kernel.clone());
    }
    kernels
}

/// Orthogonal polynomials of one degree: `forward` is monic and orthogonal to all lower powers,
/// `backward` begins with 1 and is orthogonal to all others.
struct Szego {
    forward: Vec<Matrix2<f64>>,
    backward: Vec<Matrix2<f64>>,
    forward_norm: Matrix2<f64>,
    backward_norm: Matrix2<f64>,
}

impl Szego {
    fn new(moment: Matrix2<f64>) -> Self {
        let one = vec![Matrix2::identity()];
        Self { forward: one.clone(), backward: one, forward_norm: moment, backward_norm: moment }
    }

    fn advance(&mut self, moments: &[Matrix2<f64>]) {
        let shifted = self.forward.iter().zip(&moments[1..]);
        let overlap: Matrix2<f64> = shifted.map(|(f, moment)| moment.transpose() * f).sum();
        let alpha = inverse(self.backward_norm) * overlap;
        let beta = inverse(self.forward_norm) * overlap.transpose();
        self.forward.insert(0, Matrix2::zeros());
        self.backward.push(Matrix2::zeros());
        for (f, b) in self.forward.iter_mut().zip(&mut self.backward) {
            (*f, *b) = (*f - *b * alpha, *b - *f * beta);
        }
        self.forward_norm -= overlap.transpose() * alpha;
        self.backward_norm -= overlap * beta;
    }
}

/// Of a positive definite matrix, so that the determinant is no concern.
fn inverse(matrix: Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::new(matrix.m22, -matrix.m12, -matrix.m21, matrix.m11) / matrix.determinant()
}

/// The strength that belongs to any right side of low degree, by elimination.
pub(super) fn strength(moments: &[Matrix2<f64>], right: &[[f64; 2]]) -> Strength {
    let size = 2 * right.len();
    let matrix = DMatrix::from_fn(size, size, |i, j| {
        let (k, l) = (i / 2, j / 2);
        let moment = if k >= l { moments[k - l] } else { moments[l - k].transpose() };
        moment[(i % 2, j % 2)]
    });
    let mut solution = DVector::from_fn(size, |i, _| right[i / 2][i % 2]);
    // Positive definite, hence never singular.
    let solved = matrix.lu().solve_mut(&mut solution);
    debug_assert!(solved);
    solution.as_slice().chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}
