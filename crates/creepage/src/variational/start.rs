//! Start of the iteration.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::discretization::Discretization;
use crate::Creepage;

/// First guess of the traction polynomials.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Start<'a> {
    /// Full sliding as if rigid: the default, from which every case converges.
    #[default]
    FullSliding,
    /// Least slip, without regard to the traction bound: full adhesion.
    Adhesion,
    /// No traction.
    Zero,
    /// The unknowns of a neighbouring case, as [`VariationalSolution::tau`] of the same
    /// degree; missing ones count as zero.
    ///
    /// [`VariationalSolution::tau`]: super::VariationalSolution::tau
    From(&'a [f64]),
}

impl Start<'_> {
    pub(super) fn tau(
        &self,
        discretization: &Discretization,
        weights: &[f64],
        creepage: Creepage,
    ) -> DVector<f64> {
        let unknowns = discretization.unknowns();
        match self {
            Self::FullSliding => full_sliding(discretization, weights, creepage),
            Self::Adhesion => adhesion(discretization, weights, creepage),
            Self::Zero => DVector::zeros(unknowns),
            Self::From(given) => {
                DVector::from_fn(unknowns, |i, _| given.get(i).copied().unwrap_or(0.0))
            }
        }
    }
}

/// The polynomials nearest to the direction of the rigid slip: minimal mean of `W T`.
fn full_sliding(
    discretization: &Discretization,
    weights: &[f64],
    creepage: Creepage,
) -> DVector<f64> {
    let n = discretization.unknowns() / 2;
    let mut normal = DMatrix::zeros(n, n);
    let mut right = DMatrix::zeros(n, 2);
    for (point, &weight) in weights.iter().enumerate() {
        let value = DVector::from_column_slice(discretization.rows(point).value);
        normal.syger(weight, &value, &value, 1.0);
        let [p, q] = discretization.rigid_slip(creepage, point);
        let magnitude = p.hypot(q);
        if magnitude > 0.0 {
            right.column_mut(0).axpy(weight * p / magnitude, &value, 1.0);
            right.column_mut(1).axpy(weight * q / magnitude, &value, 1.0);
        }
    }
    let solution = solve(normal, &right);
    DVector::from_column_slice(solution.as_slice())
}

/// Minimal mean of `W S`.
fn adhesion(discretization: &Discretization, weights: &[f64], creepage: Creepage) -> DVector<f64> {
    let unknowns = discretization.unknowns();
    let mut normal = DMatrix::zeros(unknowns, unknowns);
    let mut right = DMatrix::zeros(unknowns, 1);
    for (point, &weight) in weights.iter().enumerate() {
        let rows = discretization.rows(point);
        let row =
            |x: &[f64], y: &[f64]| DVector::from_iterator(unknowns, x.iter().chain(y).copied());
        for (row, slip) in [row(rows.px, rows.py), row(rows.py, rows.qy)]
            .iter()
            .zip(discretization.rigid_slip(creepage, point))
        {
            normal.syger(weight, row, row, 1.0);
            right.column_mut(0).axpy(-weight * slip, row, 1.0);
        }
    }
    let solution = solve(normal, &right);
    DVector::from_column_slice(solution.as_slice())
}

/// Solves normal equations, of which the lower triangle is given; a mesh that cannot tell two
/// polynomials apart leaves them zero.
fn solve(mut normal: DMatrix<f64>, right: &DMatrix<f64>) -> DMatrix<f64> {
    let ridge = 1e-13 * normal.diagonal().amax();
    for i in 0..normal.nrows() {
        normal[(i, i)] += ridge;
    }
    match Cholesky::new(normal) {
        Some(factor) => factor.solve(right),
        None => DMatrix::zeros(right.nrows(), right.ncols()),
    }
}
