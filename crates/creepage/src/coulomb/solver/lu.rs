//! A small dense system, factored in place and solved without allocation.
#![allow(clippy::inline_always)] // what is dispatched must be compiled for each kind of processor

use pulp::{Arch, Simd, WithSimd};

/// `P A = L U` with partial pivoting; the diagonal holds its reciprocals. One value is filled and
/// factored again and again, which the owning decompositions of the linear algebra library do not offer.
#[derive(Debug, Clone, Default)]
pub(super) struct Lu {
    n: usize,
    entries: Vec<f64>,
    pivots: Vec<usize>,
}

impl Lu {
    pub(super) fn new(n: usize) -> Self {
        Self { n, entries: vec![0.0; n * n], pivots: vec![0; n] }
    }

    /// Two rows of the matrix, `first` and the next, to be filled before [`Self::factor`].
    pub(super) fn two_rows(&mut self, first: usize) -> (&mut [f64], &mut [f64]) {
        let n = self.n;
        self.entries[first * n..(first + 2) * n].split_at_mut(n)
    }

    /// Factors the matrix in place; false when it is singular or not finite.
    pub(super) fn factor(&mut self) -> bool {
        Arch::new().dispatch(Factor(self))
    }

    /// Solves with the factors; `x` holds the right-hand side and receives the solution.
    pub(super) fn solve(&self, x: &mut [f64]) {
        Arch::new().dispatch(Solve(self, x));
    }

    fn largest_below(&self, k: usize) -> usize {
        let size = |row: usize| self.entries[row * self.n + k].abs();
        (k + 1..self.n).fold(k, |best, row| if size(row) > size(best) { row } else { best })
    }

    fn swap_rows(&mut self, k: usize, later: usize) {
        if later != k {
            let (above, below) = self.entries.split_at_mut(later * self.n);
            above[k * self.n..(k + 1) * self.n].swap_with_slice(&mut below[..self.n]);
        }
    }
}

struct Factor<'a>(&'a mut Lu);

impl WithSimd for Factor<'_> {
    type Output = bool;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let n = self.0.n;
        for k in 0..n {
            let pivot = self.0.largest_below(k);
            self.0.pivots[k] = pivot;
            self.0.swap_rows(k, pivot);
            let (done, below) = self.0.entries.split_at_mut((k + 1) * n);
            let (diagonal, pivot_row) = done[k * n + k..].split_at_mut(1);
            diagonal[0] = diagonal[0].recip();
            if !diagonal[0].is_finite() {
                return false;
            }
            for row in below.chunks_exact_mut(n) {
                row[k] *= diagonal[0];
                let (left, right) = row.split_at_mut(k + 1);
                add_times(simd, right, -left[k], pivot_row);
            }
        }
        true
    }
}

struct Solve<'a>(&'a Lu, &'a mut [f64]);

impl WithSimd for Solve<'_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self(Lu { n, entries, pivots }, x) = self;
        for (k, pivot) in pivots.iter().enumerate() {
            x.swap(k, *pivot);
        }
        for (k, row) in entries.chunks_exact(*n).enumerate() {
            let (known, rest) = x.split_at_mut(k);
            rest[0] -= dot(simd, &row[..k], known);
        }
        for (k, row) in entries.chunks_exact(*n).enumerate().rev() {
            let (rest, known) = x.split_at_mut(k + 1);
            rest[k] = (rest[k] - dot(simd, &row[k + 1..], known)) * row[k];
        }
    }
}

/// `to + factor * by`.
#[inline(always)]
fn add_times<S: Simd>(simd: S, to: &mut [f64], factor: f64, by: &[f64]) {
    let factor = simd.splat_f64s(factor);
    let (by, by_rest) = S::as_simd_f64s(by);
    let (to, to_rest) = S::as_mut_simd_f64s(to);
    for (to, by) in to.iter_mut().zip(by) {
        *to = simd.mul_add_e_f64s(factor, *by, *to);
    }
    let [to, by] = [simd.partial_load_f64s(to_rest), simd.partial_load_f64s(by_rest)];
    simd.partial_store_f64s(to_rest, simd.mul_add_e_f64s(factor, by, to));
}

#[inline(always)]
fn dot<S: Simd>(simd: S, a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (S::as_simd_f64s(a), S::as_simd_f64s(b));
    let [a_rest, b_rest] = [simd.partial_load_f64s(a_rest), simd.partial_load_f64s(b_rest)];
    let mut sum = simd.mul_f64s(a_rest, b_rest);
    for (a, b) in a.iter().zip(b) {
        sum = simd.mul_add_e_f64s(*a, *b, sum);
    }
    simd.reduce_sum_f64s(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_system_that_needs_pivots() {
        let n = 7;
        let entry = |i: usize, j: usize| if i == j { 0.0 } else { ((i * n + j) as f64).sin() };
        let mut lu = Lu::new(n);
        for i in 0..n {
            for j in 0..n {
                lu.entries[i * n + j] = entry(i, j);
            }
        }
        let expected: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        let mut x: Vec<f64> =
            (0..n).map(|i| (0..n).map(|j| entry(i, j) * expected[j]).sum()).collect();
        assert!(lu.factor());
        lu.solve(&mut x);
        for (x, expected) in x.iter().zip(&expected) {
            // Rounding times a condition number below 100.
            assert!((x - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn a_singular_matrix_is_reported() {
        assert!(!Lu::new(3).factor());
    }
}
