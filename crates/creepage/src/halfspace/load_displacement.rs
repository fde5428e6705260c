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

use nalgebra::{DMatrix, DVector};

use super::{Polynomial, ResponseError, Traction, elliptic, harmonics};
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
    ellipse: Ellipse,
    blocks: Vec<Block>,
}

/// Displacement coefficients per traction coefficient of one degree.
#[derive(Debug, Clone)]
pub(super) struct Block {
    /// `u` by `X`.
    pub(super) ux: DMatrix<f64>,
    /// `u` by `Y`, and `v` by `X`.
    pub(super) uy: DMatrix<f64>,
    /// `v` by `Y`.
    pub(super) vy: DMatrix<f64>,
    /// `w` by `Z`.
    pub(super) wz: DMatrix<f64>,
}

impl LoadDisplacement {
    /// Highest degree that can be prepared; it takes a second or two and some 100 MB, and ten
    /// times that for the most slender ellipses.
    pub const MAX_DEGREE: usize = 200;

    /// The equations for tractions up to and including `degree`.
    ///
    /// # Errors
    /// [`InvalidValue`] unless `0 <= poisson <= 0.5` and `degree` is at most
    /// [`LoadDisplacement::MAX_DEGREE`].
    pub fn new(ellipse: Ellipse, poisson: f64, degree: usize) -> Result<Self, InvalidValue> {
        check::poisson(poisson)?;
        check::require(degree <= Self::MAX_DEGREE, "degree", degree as f64, "at most 200")?;
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
        Ok(Self { ellipse, blocks })
    }

    /// Highest degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.blocks.len() - 1
    }

    /// The ellipse.
    #[must_use]
    pub fn ellipse(&self) -> Ellipse {
        self.ellipse
    }

    pub(super) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The displacement differences `[u, v, w]` inside the ellipse caused by a traction of
    /// either behaviour at the edge: (2.47), (3.5). A traction that vanishes at the edge causes
    /// displacements of two degrees more than its own.
    ///
    /// # Errors
    /// [`ResponseError`] when the traction lives on another ellipse, or when the displacements'
    /// degree is higher than was prepared.
    pub fn displacement(&self, traction: &Traction) -> Result<[Polynomial; 3], ResponseError> {
        self.check(traction.ellipse(), traction.singular_degree())?;
        let [x, y, z] = traction.singular();
        let [u, v] = self.tangential([x, y]);
        let used = 0..harmonics::polynomial_count(traction.singular_degree());
        let polynomial =
            |table: Vec<f64>| Polynomial::from_harmonics(self.ellipse, &table[used.clone()]);
        Ok([polynomial(u)?, polynomial(v)?, polynomial(self.normal(z))?])
    }

    pub(super) fn check(&self, ellipse: Ellipse, degree: usize) -> Result<(), ResponseError> {
        if ellipse != self.ellipse {
            return Err(ResponseError::OtherEllipse { given: ellipse, prepared: self.ellipse });
        }
        if degree > self.degree() {
            return Err(ResponseError::Degree { needed: degree, prepared: self.degree() });
        }
        Ok(())
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
pub(super) fn of_degree(coefficients: &[f64], n: usize) -> DVector<f64> {
    let start = if n == 0 { 0 } else { harmonics::polynomial_count(n - 1) };
    let padded = coefficients.iter().skip(start).copied().chain(std::iter::repeat(0.0));
    DVector::from_iterator(n + 1, padded.take(n + 1))
}

/// Quadrature over the directions of the chords through a point.
struct Directions {
    /// `weight ab/Q` of every node, the same for all.
    weight: f64,
    /// `sin^2` and `sin cos` of the chord's true direction.
    kernels: Vec<[f64; 2]>,
    /// Even harmonics on the edge a quarter turn ahead, one column a node.
    edge: DMatrix<f64>,
}

impl Directions {
    /// In the elliptic functions' argument `u` the measure `ab/Q df` is `s du`, and the
    /// midpoint rule converges geometrically at every ratio; twice the degree is resolved.
    fn new(ellipse: Ellipse, degree: usize) -> Self {
        Self::with_nodes(ellipse, degree, elliptic::node_count(ellipse.integrals().k, 2 * degree))
    }

    fn with_nodes(ellipse: Ellipse, degree: usize, count: usize) -> Self {
        let (g, k) = (ellipse.g(), ellipse.integrals().k);
        let mut directions = Self {
            weight: 2.0 * k * ellipse.minor() / count as f64,
            kernels: Vec::with_capacity(count),
            edge: DMatrix::zeros(harmonics::polynomial_count(degree), count),
        };
        for (node, mut column) in elliptic::nodes(g, count).zip(directions.edge.column_iter_mut()) {
            let ([cos, sin], [true_cos, true_sin]) = node.directions(ellipse);
            directions.kernels.push([true_sin * true_sin, true_sin * true_cos]);
            harmonics::visit(degree, [-sin, cos], |n, m, value| {
                if n.wrapping_add_signed(m).is_multiple_of(2) {
                    column[harmonics::position(n, m)] = value;
                }
            });
        }
        directions
    }

    /// `2 pi/(2n+1) int (ab/Q) {1, sin^2, sin cos} y y^T df` for degree `n`.
    fn integrals(&self, n: usize) -> [DMatrix<f64>; 3] {
        let start = if n == 0 { 0 } else { harmonics::polynomial_count(n - 1) };
        let edge = self.edge.rows(start, n + 1);
        let transposed = edge.transpose();
        let factor = 2.0 * PI / (2.0 * n as f64 + 1.0) * self.weight;
        let integral = |kernel: &dyn Fn(usize) -> f64| {
            let mut weighted = edge.into_owned();
            for (node, mut column) in weighted.column_iter_mut().enumerate() {
                column *= factor * kernel(node);
            }
            weighted * &transposed
        };
        [
            integral(&|_| 1.0),
            integral(&|node| self.kernels[node][0]),
            integral(&|node| self.kernels[node][1]),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twice_the_nodes_change_nothing() {
        for (ratio, degree) in [1e-6, 1e-4, 0.01, 0.05, 0.2, 0.5, 0.9, 1.0, 3.0, 1e3, 1e6]
            .iter()
            .zip([40, 5].iter().cycle())
        {
            let ellipse = Ellipse::from_ratio(*ratio).unwrap();
            let prepared = Directions::new(ellipse, *degree);
            let doubled = Directions::with_nodes(ellipse, *degree, 2 * prepared.kernels.len());
            // Rounding of the harmonics at degree 40, and of sums of some thousand terms.
            let rounding = 3e-14 + 0.25 * f64::EPSILON * doubled.kernels.len() as f64;
            for n in 0..=*degree {
                let (coarse, fine) = (prepared.integrals(n), doubled.integrals(n));
                let scale = fine[0].amax();
                for (coarse, fine) in coarse.iter().zip(&fine) {
                    let difference = (coarse - fine).amax() / scale;
                    assert!(difference < rounding, "{ratio} {degree} {n}: {difference}");
                }
            }
        }
    }
}
