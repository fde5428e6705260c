//! Newton's matrix, factored: Gauss' elimination by rows, which processors do several numbers at a
//! time.

// Elimination indexes several rows at once.
#![allow(clippy::inline_always, clippy::needless_range_loop)]

use nalgebra::DVector;
use pulp::{Arch, Simd, WithSimd};

/// A square matrix as the product of a lower and an upper triangle, its rows in another order.
#[derive(Debug, Clone)]
pub(super) struct Lu {
    size: usize,
    /// Both triangles, row after row; the lower one has ones on its diagonal.
    rows: Vec<f64>,
    /// Which row of the matrix each row comes from.
    order: Vec<usize>,
}

impl Lu {
    /// From the matrix row after row; `None` where it is singular or has what is no number.
    pub(super) fn new(mut rows: Vec<f64>, size: usize) -> Option<Self> {
        let mut order: Vec<usize> = (0..size).collect();
        let elimination = Elimination { rows: &mut rows, order: &mut order, size };
        Arch::new().dispatch(elimination).then_some(Self { size, rows, order })
    }

    /// What the matrix makes `right` of.
    pub(super) fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let row = |i: usize| &self.rows[i * self.size..(i + 1) * self.size];
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut found: Vec<f64> = self.order.iter().map(|&from| right[from]).collect();
        for i in 0..self.size {
            found[i] -= dot(&row(i)[..i], &found[..i]);
        }
        for i in (0..self.size).rev() {
            let known = dot(&row(i)[i + 1..], &found[i + 1..]);
            found[i] = (found[i] - known) / row(i)[i];
        }
        DVector::from_vec(found)
    }
}

/// Gauss' elimination with pivots by columns; whether it came to its end.
struct Elimination<'a> {
    rows: &'a mut [f64],
    order: &'a mut [usize],
    size: usize,
}

impl WithSimd for Elimination<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        let Self { rows, order, size } = self;
        for k in 0..size {
            let at = |i: usize| rows[i * size + k].abs();
            let top = (k..size).max_by(|&i, &j| at(i).total_cmp(&at(j))).unwrap_or(k);
            if !(at(top) > 0.0 && at(top).is_finite()) {
                return false;
            }
            order.swap(k, top);
            let (upper, lower) = rows.split_at_mut((k + 1) * size);
            let own = &mut upper[k * size..];
            if top > k {
                own.swap_with_slice(&mut lower[(top - k - 1) * size..(top - k) * size]);
            }
            let (pivot, rest) = (own[k], &own[k + 1..]);
            for row in lower.chunks_exact_mut(size) {
                let share = row[k] / pivot;
                row[k] = share;
                for (number, own) in row[k + 1..].iter_mut().zip(rest) {
                    *number -= share * own;
                }
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    /// A matrix without order whose diagonal is small, so that rows must change places.
    fn matrix(size: usize) -> DMatrix<f64> {
        DMatrix::from_fn(size, size, |i, j| {
            let part = ((1 + 7 * i + 13 * j + i * j) as f64).sin();
            if i == j { 1e-9 * part } else { part }
        })
    }

    #[test]
    fn it_solves_what_it_factored() {
        for size in [1, 2, 17, 80] {
            let (matrix, expected) = (matrix(size), DVector::from_fn(size, |i, _| i as f64 - 3.0));
            let rows: Vec<f64> = matrix.transpose().iter().copied().collect();
            let found = Lu::new(rows, size).unwrap().solve(&(&matrix * &expected));
            // Rounding, times what a matrix of this kind makes of it.
            assert!((found - &expected).amax() < 1e-9 * expected.amax(), "{size}");
        }
    }

    #[test]
    fn singular_matrices_and_no_numbers_are_refused() {
        assert!(Lu::new(vec![1.0, 2.0, 2.0, 4.0], 2).is_none());
        assert!(Lu::new(vec![1.0, f64::NAN, 2.0, 4.0], 2).is_none());
    }
}
