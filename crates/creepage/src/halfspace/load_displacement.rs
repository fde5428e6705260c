//! The load-displacement equations (2.47), (3.5) in harmonics: one small block per degree.
//!
//! A traction `G (1 - r^2)^(-1/2) sum X_nm Y_nm` of degree `n` causes displacement differences
//! of the same degree. Along the chords through the field point the kernel of
//! Boussinesq-Cerruti depends on the chord's direction `f` only, and the integral of a
//! harmonic over them is its value on the edge a quarter turn ahead of `f`:
//!
//! `u_i = 2 pi/(2n+1) int_0^pi (ab/Q) kernel(f) y_i(f + pi/2) sum_j y_j(f + pi/2) X_j df`,
//! `Q^2 = a^2 cos^2 f + b^2 sin^2 f`, with `y` the harmonics on the edge `r = 1`.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector, DVectorView};

use super::harmonics;
use crate::check::{self, InvalidValue};
use crate::ellipse::Ellipse;

/// The response of the half-space, or of a pair of like bodies, to tractions on an ellipse.
///
/// Coefficients are those of the polynomials [`harmonics::even_indices`] names, in its order.
///
/// ```
/// use creepage::Ellipse;
/// use creepage::halfspace::LoadDisplacement;
/// let response = LoadDisplacement::new(Ellipse::new(1.0, 1.0)?, 0.25, 0)?;
/// // A traction G (1 - r^2)^(-1/2) shifts the circle as a whole by pi (1 - sigma/2).
/// let y00 = std::f64::consts::TAU.sqrt().recip();
/// let [u, v] = response.tangential([&[1.0 / y00], &[0.0]]);
/// assert!((u[0] * y00 - std::f64::consts::PI * 0.875).abs() < 1e-14);
/// assert!(v[0].abs() < 1e-14);
/// # Ok::<(), creepage::InvalidValue>(())
/// ```
#[derive(Debug, Clone)]
pub struct LoadDisplacement {
    blocks: Vec<Block>,
}

/// Displacement coefficients per traction coefficient of one degree.
#[derive(Debug, Clone)]
struct Block {
    /// `u` by `X`.
    ux: DMatrix<f64>,
    /// `u` by `Y`, and `v` by `X`.
    uy: DMatrix<f64>,
    /// `v` by `Y`.
    vy: DMatrix<f64>,
    /// `w` by `Z`.
    wz: DMatrix<f64>,
}

impl LoadDisplacement {
    /// The equations for tractions up to and including `degree`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `0 <= poisson <= 0.5`.
    pub fn new(ellipse: Ellipse, poisson: f64, degree: usize) -> Result<Self, InvalidValue> {
        check::poisson(poisson)?;
        let directions = Directions::new(ellipse, degree);
        let blocks = (0..=degree)
            .map(|n| {
                let [plain, sin2, sin_cos] = directions.integrals(n);
                Block {
                    ux: &plain - poisson * &sin2,
                    uy: poisson * sin_cos,
                    vy: (1.0 - poisson) * &plain + poisson * sin2,
                    wz: (1.0 - poisson) * plain,
                }
            })
            .collect();
        Ok(Self { blocks })
    }

    /// Highest degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.blocks.len() - 1
    }

    /// `(u, v)` caused by the tangential traction `[X, Y]`; lengths in the ellipse's unit,
    /// tractions over `G`. Coefficients beyond the input's last count as zero, beyond
    /// [`LoadDisplacement::degree`] they are left out.
    #[must_use]
    pub fn tangential(&self, [x, y]: [&[f64]; 2]) -> [Vec<f64>; 2] {
        let parts = self.blocks.iter().enumerate().map(|(n, block)| {
            let (x, y) = (of_degree(x, n), of_degree(y, n));
            [&block.ux * &x + &block.uy * &y, &block.uy * x + &block.vy * y]
        });
        let (u, v): (Vec<_>, Vec<_>) = parts.map(|[u, v]| (u, v)).unzip();
        [u, v].map(|degrees| degrees.iter().flat_map(|part| part.iter().copied()).collect())
    }

    /// `w` caused by the pressure `Z`.
    #[must_use]
    pub fn normal(&self, z: &[f64]) -> Vec<f64> {
        let parts = self.blocks.iter().enumerate().map(|(n, block)| &block.wz * of_degree(z, n));
        parts.flat_map(|part| part.iter().copied().collect::<Vec<_>>()).collect()
    }
}

/// The coefficients of degree `n`, zeros where the table ends before.
fn of_degree(coefficients: &[f64], n: usize) -> DVector<f64> {
    let start = if n == 0 { 0 } else { harmonics::polynomial_count(n - 1) };
    match coefficients.get(start..=start + n) {
        Some(part) => DVectorView::from_slice(part, n + 1).into_owned(),
        None => DVector::zeros(n + 1),
    }
}

/// Quadrature over the directions of the chords through a point.
struct Directions {
    /// `weight ab/Q` of every node.
    weights: Vec<f64>,
    /// `sin^2` and `sin cos` of the chord's true direction.
    kernels: Vec<[f64; 2]>,
    /// Even harmonics on the edge a quarter turn ahead, one column a node.
    edge: DMatrix<f64>,
}

impl Directions {
    /// The substitution `tan f = sqrt(a/b) tan theta` moves the poles of the integrand as far
    /// from the real axis as they go, so that the midpoint rule in `theta` converges
    /// geometrically, with about `sqrt(g)` as rate; twice the degree must be resolved besides.
    // A node count of at most some ten thousand, positive by construction.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn new(ellipse: Ellipse, degree: usize) -> Self {
        let (a, b) = (ellipse.a(), ellipse.b());
        let stretch = ellipse.ratio().sqrt();
        let nodes = ((24.0 + 3.0 * degree as f64) / ellipse.g().sqrt()).ceil() as usize;
        let mut directions = Self {
            weights: Vec::with_capacity(nodes),
            kernels: Vec::with_capacity(nodes),
            edge: DMatrix::zeros(harmonics::polynomial_count(degree), nodes),
        };
        let mut values = vec![0.0; harmonics::count(degree)];
        for (node, mut column) in directions.edge.column_iter_mut().enumerate() {
            let (sin_theta, cos_theta) = ((node as f64 + 0.5) * PI / nodes as f64).sin_cos();
            let norm = cos_theta.hypot(stretch * sin_theta);
            let (cos, sin) = (cos_theta / norm, stretch * sin_theta / norm);
            let q = (a * cos).hypot(b * sin);
            let (true_cos, true_sin) = (a * cos / q, b * sin / q);
            directions.weights.push(PI / nodes as f64 * stretch / (norm * norm) * a * b / q);
            directions.kernels.push([true_sin * true_sin, true_sin * true_cos]);
            harmonics::evaluate(degree, -sin, cos, &mut values);
            for (entry, index) in column.iter_mut().zip(harmonics::even_indices(degree)) {
                *entry = values[index];
            }
        }
        directions
    }

    /// `2 pi/(2n+1) int (ab/Q) {1, sin^2, sin cos} y y^T df` for degree `n`.
    fn integrals(&self, n: usize) -> [DMatrix<f64>; 3] {
        let start = if n == 0 { 0 } else { harmonics::polynomial_count(n - 1) };
        let edge = self.edge.rows(start, n + 1);
        let factor = 2.0 * PI / (2.0 * n as f64 + 1.0);
        let integral = |kernel: &dyn Fn(usize) -> f64| {
            let mut weighted = edge.into_owned();
            for (node, mut column) in weighted.column_iter_mut().enumerate() {
                column *= factor * self.weights[node] * kernel(node);
            }
            weighted * edge.transpose()
        };
        [
            integral(&|_| 1.0),
            integral(&|node| self.kernels[node][0]),
            integral(&|node| self.kernels[node][1]),
        ]
    }
}
