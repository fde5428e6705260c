//! A small dense system, factored in place and solved without allocation.
#![allow(clippy::inline_always)] // what is dispatched must be compiled for each kind of processor

use pulp::{Arch, Simd, WithSimd};

/// `P A = L U` with partial pivoting. One value is filled and factored again and again, which
/// the owning decompositions of the linear algebra library do not offer.
#[derive(Debug, Clone)]
pub(super) struct Dense {
    n: usize,
    entries: Vec<f64>,
    pivots: Vec<usize>,
}

impl Dense {
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

    #[inline(always)]
    fn factor_now(&mut self) -> bool {
        let n = self.n;
        for k in 0..n {
            let pivot = self.largest_below(k);
            self.pivots[k] = pivot;
            if pivot != k {
                let (above, below) = self.entries.split_at_mut(pivot * n);
                above[k * n..(k + 1) * n].swap_with_slice(&mut below[..n]);
            }
            let inverse = self.entries[k * n + k].recip();
            if !inverse.is_finite() {
                return false;
            }
            self.eliminate(k, inverse);
        }
        true
    }

    #[inline(always)]
    fn largest_below(&self, k: usize) -> usize {
        let size = |row: usize| self.entries[row * self.n + k].abs();
        (k + 1..self.n).fold(k, |best, row| if size(row) > size(best) { row } else { best })
    }

    #[inline(always)]
    fn eliminate(&mut self, k: usize, inverse: f64) {
        let n = self.n;
        let (done, below) = self.entries.split_at_mut((k + 1) * n);
        let pivot_row = &done[k * n + k + 1..];
        for row in below.chunks_exact_mut(n) {
            let factor = row[k] * inverse;
            row[k] = factor;
            for (entry, pivot) in row[k + 1..].iter_mut().zip(pivot_row) {
                *entry -= factor * pivot;
            }
        }
    }

    /// Solves with the factors; `x` holds the right-hand side and receives the solution.
    pub(super) fn solve(&self, x: &mut [f64]) {
        Arch::new().dispatch(Solve(self, x));
    }

    #[inline(always)]
    fn solve_now(&self, x: &mut [f64]) {
        let n = self.n;
        for k in 0..n {
            x.swap(k, self.pivots[k]);
        }
        for k in 1..n {
            let (known, rest) = x.split_at_mut(k);
            rest[0] -= dot(&self.entries[k * n..k * n + k], known);
        }
        for k in (0..n).rev() {
            let (rest, known) = x.split_at_mut(k + 1);
            let sum = dot(&self.entries[k * n + k + 1..(k + 1) * n], known);
            rest[k] = (rest[k] - sum) / self.entries[k * n + k];
        }
    }
}

struct Factor<'a>(&'a mut Dense);

impl WithSimd for Factor<'_> {
    type Output = bool;
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        self.0.factor_now()
    }
}

struct Solve<'a>(&'a Dense, &'a mut [f64]);

impl WithSimd for Solve<'_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.0.solve_now(self.1);
    }
}

/// Scalar product in partial sums, which the compiler turns into vector instructions.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let (a, a_rest) = a.as_chunks::<LANES>();
    let (b, b_rest) = b.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for l in 0..LANES {
            sums[l] += a[l] * b[l];
        }
    }
    for (sum, (a, b)) in sums.iter_mut().zip(a_rest.iter().zip(b_rest)) {
        *sum += a * b;
    }
    sums.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_system_that_needs_pivots() {
        let n = 7;
        let entry = |i: usize, j: usize| if i == j { 0.0 } else { ((i * n + j) as f64).sin() };
        let mut dense = Dense::new(n);
        for i in 0..n {
            for j in 0..n {
                dense.entries[i * n + j] = entry(i, j);
            }
        }
        let expected: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        let mut x: Vec<f64> =
            (0..n).map(|i| (0..n).map(|j| entry(i, j) * expected[j]).sum()).collect();
        assert!(dense.factor());
        dense.solve(&mut x);
        for (x, expected) in x.iter().zip(&expected) {
            // Rounding times a condition number below 100.
            assert!((x - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn a_singular_matrix_is_told() {
        assert!(!Dense::new(3).factor());
    }
}
