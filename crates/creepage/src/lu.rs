//! A small dense system, factored in place and solved without allocation.
#![allow(clippy::inline_always)] // what is dispatched must be compiled for each kind of processor

use pulp::{Arch, Simd, WithSimd};

/// Rows are this much longer at most: a whole number of registers on every processor.
const REGISTER: usize = 8;

/// `P A = L U` with partial pivoting; the diagonal holds its reciprocals. One value is filled and
/// factored again and again, which the owning decompositions of the linear algebra library do not offer.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lu {
    n: usize,
    /// Length of a row; its end is zero.
    stride: usize,
    entries: Vec<f64>,
    pivots: Vec<usize>,
    /// Room for the rest of a row.
    room: Vec<f64>,
}

impl Lu {
    pub(crate) fn new(n: usize) -> Self {
        let stride = n.next_multiple_of(REGISTER);
        let entries = vec![0.0; n * stride];
        Self { n, stride, entries, pivots: vec![0; n], room: vec![0.0; stride] }
    }

    /// The factors of a matrix given row after row; `None` when it is singular or not finite.
    pub(crate) fn of_rows(rows: &[f64], n: usize) -> Option<Self> {
        let mut lu = Self::new(n);
        for (to, row) in lu.entries.chunks_exact_mut(lu.stride).zip(rows.chunks_exact(n)) {
            to[..n].copy_from_slice(row);
        }
        lu.factor().then_some(lu)
    }

    /// Two rows of the matrix, `first` and the next, to be filled before [`Self::factor`].
    pub(crate) fn two_rows(&mut self, first: usize) -> (&mut [f64], &mut [f64]) {
        let (n, stride) = (self.n, self.stride);
        let (one, two) = self.entries[first * stride..(first + 2) * stride].split_at_mut(stride);
        (&mut one[..n], &mut two[..n])
    }

    /// Factors the matrix in place; false when it is singular or not finite.
    pub(crate) fn factor(&mut self) -> bool {
        Arch::new().dispatch(Factor(self))
    }

    /// Solves with the factors; `x` holds the right-hand side and receives the solution.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        Arch::new().dispatch(Solve(self, x));
    }

    fn largest_below(&self, k: usize) -> usize {
        let (mut best, mut size) = (k, -1.0);
        for (row, entries) in self.entries.chunks_exact(self.stride).enumerate().skip(k) {
            if entries[k].abs() > size {
                (best, size) = (row, entries[k].abs());
            }
        }
        best
    }

    fn swap_rows(&mut self, k: usize, later: usize) {
        if later != k {
            let (above, below) = self.entries.split_at_mut(later * self.stride);
            above[k * self.stride..(k + 1) * self.stride]
                .swap_with_slice(&mut below[..self.stride]);
        }
    }
}

struct Factor<'a>(&'a mut Lu);

impl WithSimd for Factor<'_> {
    type Output = bool;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let Self(lu) = self;
        let (n, stride) = (lu.n, lu.stride);
        for k in 0..n {
            let pivot = lu.largest_below(k);
            lu.pivots[k] = pivot;
            lu.swap_rows(k, pivot);
            let (done, below) = lu.entries.split_at_mut((k + 1) * stride);
            let pivot_row = &mut done[k * stride..];
            let reciprocal = pivot_row[k].recip();
            if !reciprocal.is_finite() {
                return false;
            }
            // Whole registers from the one with entry k + 1; what is done before it is not moved.
            let start = (k + 1) / S::F64_LANES * S::F64_LANES;
            let room = &mut lu.room[start..];
            room.copy_from_slice(&pivot_row[start..]);
            room[..k + 1 - start].fill(0.0);
            pivot_row[k] = reciprocal;
            for row in below.chunks_exact_mut(stride) {
                let factor = row[k] * reciprocal;
                row[k] = factor;
                add_times(simd, &mut row[start..], -factor, room);
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
        let Self(Lu { stride, entries, pivots, .. }, x) = self;
        for (k, pivot) in pivots.iter().enumerate() {
            x.swap(k, *pivot);
        }
        let n = x.len();
        for (k, row) in entries.chunks_exact(*stride).enumerate() {
            let (known, rest) = x.split_at_mut(k);
            rest[0] -= dot(simd, &row[..k], known);
        }
        for (k, row) in entries.chunks_exact(*stride).enumerate().rev() {
            let (rest, known) = x.split_at_mut(k + 1);
            rest[k] = (rest[k] - dot(simd, &row[k + 1..n], known)) * row[k];
        }
    }
}

/// `to + factor * by`, of whole registers.
#[inline(always)]
fn add_times<S: Simd>(simd: S, to: &mut [f64], factor: f64, by: &[f64]) {
    let factor = simd.splat_f64s(factor);
    let (by, _) = S::as_simd_f64s(by);
    let (to, _) = S::as_mut_simd_f64s(to);
    for (to, by) in to.iter_mut().zip(by) {
        *to = simd.mul_add_e_f64s(factor, *by, *to);
    }
}

#[inline(always)]
fn dot<S: Simd>(simd: S, a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (S::as_simd_f64s(a), S::as_simd_f64s(b));
    let mut sum = simd.splat_f64s(0.0);
    for (a, b) in a.iter().zip(b) {
        sum = simd.mul_add_e_f64s(*a, *b, sum);
    }
    let mut rest = 0.0;
    for (a, b) in a_rest.iter().zip(b_rest) {
        rest += a * b;
    }
    simd.reduce_sum_f64s(sum) + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix without order whose diagonal is small, so that rows must change places.
    #[test]
    fn solves_what_it_factored() {
        for n in [1, 2, 7, 17, 80] {
            let entry = |i: usize, j: usize| {
                let part = ((1 + 7 * i + 13 * j + i * j) as f64).sin();
                if i == j { 1e-9 * part } else { part }
            };
            let rows: Vec<f64> = (0..n * n).map(|at| entry(at / n, at % n)).collect();
            let expected: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
            let mut x: Vec<f64> =
                (0..n).map(|i| (0..n).map(|j| entry(i, j) * expected[j]).sum()).collect();
            Lu::of_rows(&rows, n).unwrap().solve(&mut x);
            for (x, expected) in x.iter().zip(&expected) {
                // Rounding times a condition number of some thousands.
                assert!((x - expected).abs() < 1e-11, "{n}: {x} {expected}");
            }
        }
    }

    #[test]
    fn singular_matrices_and_no_numbers_are_refused() {
        assert!(!Lu::new(3).factor());
        assert!(Lu::of_rows(&[1.0, 2.0, 2.0, 4.0], 2).is_none());
        assert!(Lu::of_rows(&[1.0, f64::NAN, 2.0, 4.0], 2).is_none());
    }
}
