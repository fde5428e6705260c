//! A small dense system, factored in place and solved without allocation.
#![allow(clippy::inline_always)] // what is dispatched must be compiled for each kind of processor

use pulp::{Arch, Simd, WithSimd};

/// Rows are this much longer at most: a whole number of registers on every processor.
const REGISTER: usize = 8;
/// Columns that are factored before they are taken from the others at once.
const PANEL: usize = 4;
const TWO_PANELS: usize = 2 * PANEL;
/// Rows left that are read half as often when two panels are taken from them at once.
const MANY: usize = 24;

/// `P A = L U` with partial pivoting; the diagonal holds its reciprocals. One value is filled and
/// factored again and again, which the owning decompositions of the linear algebra library do not offer.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Lu {
    n: usize,
    /// So many first rows are those of the identity, and are not looked at: a whole number of panels.
    known: usize,
    /// Length of a row; its end is zero.
    stride: usize,
    entries: Vec<f64>,
    pivots: Vec<usize>,
}

impl Lu {
    pub(crate) fn new(n: usize) -> Self {
        let mut lu = Self::default();
        lu.resize(n);
        lu
    }

    /// Room for another number of unknowns.
    pub(crate) fn resize(&mut self, n: usize) {
        (self.n, self.known, self.stride) = (n, 0, n.next_multiple_of(REGISTER));
        self.entries.clear();
        self.entries.resize(n * self.stride, 0.0);
        self.pivots.resize(n, 0);
    }

    /// Numbers that it has room for.
    pub(crate) fn room(&self) -> usize {
        self.entries.capacity()
    }

    /// The factors of a matrix given row after row; `None` when it is singular or not finite.
    pub(crate) fn of_rows(rows: &[f64], n: usize) -> Option<Self> {
        let mut lu = Self::new(n);
        for (to, row) in lu.entries.chunks_exact_mut(lu.stride).zip(rows.chunks_exact(n)) {
            to[..n].copy_from_slice(row);
        }
        lu.factor(0).then_some(lu)
    }

    /// A row of the matrix, to be filled before [`Self::factor`].
    pub(crate) fn row(&mut self, row: usize) -> &mut [f64] {
        &mut self.entries[row * self.stride..][..self.n]
    }

    /// Factors the matrix in place; false when it is singular or not finite. Its first `known` rows
    /// are those of the identity: they cost nothing.
    pub(crate) fn factor(&mut self, known: usize) -> bool {
        self.known = known - known % PANEL;
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
        let mut first = lu.known;
        while first < lu.n {
            if !lu.factor_columns(first) {
                return false;
            }
            let end = first + PANEL;
            if first + MANY > lu.n {
                if end < lu.n {
                    lu.eliminate::<S, PANEL>(simd, first, lu.stride);
                }
                first = end;
                continue;
            }
            lu.eliminate::<S, PANEL>(simd, first, end + PANEL);
            if !lu.factor_columns(end) {
                return false;
            }
            lu.eliminate::<S, TWO_PANELS>(simd, first, lu.stride);
            first = end + PANEL;
        }
        true
    }
}

impl Lu {
    /// Factors the columns of a panel, from its first row down; false when they are singular. Rows are
    /// so long that a panel is always whole.
    #[inline(always)]
    fn factor_columns(&mut self, first: usize) -> bool {
        let end = self.n.min(first + PANEL);
        let mut pivot = self.largest_below(first);
        for k in first..end {
            self.pivots[k] = pivot;
            self.swap_rows(k, pivot);
            let (done, below) = self.entries.split_at_mut((k + 1) * self.stride);
            let pivot_row = &mut done[k * self.stride..];
            let reciprocal = pivot_row[k].recip();
            if !reciprocal.is_finite() {
                return false;
            }
            pivot_row[k] = reciprocal;
            let (column, mut by) = (k - first, [0.0; PANEL]);
            by[column + 1..].copy_from_slice(&pivot_row[k + 1..first + PANEL]);
            let (next, mut size) = ((column + 1).min(PANEL - 1), -1.0);
            pivot = k + 1;
            for (row, entries) in (k + 1..).zip(below.chunks_exact_mut(self.stride)) {
                let factor = entries[k] * reciprocal;
                let Some(part) = entries[first..].first_chunk_mut::<PANEL>() else { continue };
                for j in 0..PANEL {
                    part[j] -= factor * by[j];
                }
                if part[next].abs() > size {
                    (pivot, size) = (row, part[next].abs());
                }
                part[column] = factor;
            }
        }
        true
    }

    /// Takes the rows of `W` factored columns from all rows below, beyond these columns as far as `to`.
    #[inline(always)]
    fn eliminate<S: Simd, const W: usize>(&mut self, simd: S, first: usize, to: usize) {
        // So that what is left of a row beside a panel is a whole number of registers.
        const { assert!(PANEL.is_multiple_of(S::F64_LANES)) };
        let (stride, end) = (self.stride, first + W);
        let (done, below) = self.entries.split_at_mut(end * stride);
        let panel = &mut done[first * stride..];
        for k in 1..W {
            let (above, row) = panel.split_at_mut(k * stride);
            let (factors, rest) = row[..to].split_at_mut(end);
            for (above, factor) in above.chunks_exact(stride).zip(&factors[first..]) {
                add_times(simd, rest, -factor, &above[end..to]);
            }
        }
        let by = |k: usize| S::as_simd_f64s(&panel[k * stride + end..k * stride + to]).0;
        let (p, q, r, s) = (by(0), by(1), by(2), by(3));
        for row in below.chunks_exact_mut(stride) {
            let (factors, rest) = row[..to].split_at_mut(end);
            let (rest, _) = S::as_mut_simd_f64s(rest);
            let factor = |k: usize| simd.splat_f64s(-factors[first + k]);
            let four = [factor(0), factor(1), factor(2), factor(3)];
            if W == PANEL {
                for ((((to, p), q), r), s) in rest.iter_mut().zip(p).zip(q).zip(r).zip(s) {
                    *to = add_four(simd, *to, four, [*p, *q, *r, *s]);
                }
                continue;
            }
            let (t, u, v, w) = (by(4), by(5), by(6), by(7));
            let more = [factor(4), factor(5), factor(6), factor(7)];
            let rows = p.iter().zip(q).zip(r).zip(s).zip(t).zip(u).zip(v).zip(w);
            for (to, (((((((p, q), r), s), t), u), v), w)) in rest.iter_mut().zip(rows) {
                let sum = add_four(simd, *to, four, [*p, *q, *r, *s]);
                *to = add_four(simd, sum, more, [*t, *u, *v, *w]);
            }
        }
    }
}

/// `sum` and four products.
#[inline(always)]
fn add_four<S: Simd>(simd: S, sum: S::f64s, a: [S::f64s; 4], b: [S::f64s; 4]) -> S::f64s {
    let sum = simd.mul_add_e_f64s(a[0], b[0], sum);
    let sum = simd.mul_add_e_f64s(a[1], b[1], sum);
    let sum = simd.mul_add_e_f64s(a[2], b[2], sum);
    simd.mul_add_e_f64s(a[3], b[3], sum)
}

struct Solve<'a>(&'a Lu, &'a mut [f64]);

impl WithSimd for Solve<'_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self(Lu { n, known, stride, entries, pivots }, x) = self;
        for (k, pivot) in pivots.iter().enumerate().skip(*known) {
            x.swap(k, *pivot);
        }
        let blocks = || entries.chunks(PANEL * stride).enumerate().skip(known / PANEL);
        for (block, rows) in blocks() {
            let first = PANEL * block;
            let (known, x) = x.split_at_mut(first);
            let x = &mut x[..PANEL.min(n - first)];
            take(simd, x, rows, *stride, 0, known);
            if let Some(x) = x.first_chunk_mut::<PANEL>() {
                lower(x, rows, *stride, first);
            } else {
                lower(x, rows, *stride, first);
            }
        }
        for (block, rows) in blocks().rev() {
            let first = PANEL * block;
            let (x, known) = x.split_at_mut((*n).min(first + PANEL));
            let x = &mut x[first..];
            take(simd, x, rows, *stride, first + PANEL, known);
            if let Some(x) = x.first_chunk_mut::<PANEL>() {
                upper(x, rows, *stride, first);
            } else {
                upper(x, rows, *stride, first);
            }
        }
    }
}

/// Solves with the factors of a panel's own columns; its length is often known when it is compiled.
#[inline(always)]
fn lower(x: &mut [f64], rows: &[f64], stride: usize, first: usize) {
    for k in 1..x.len() {
        let row = &rows[k * stride + first..][..x.len()];
        for j in 0..k {
            x[k] -= row[j] * x[j];
        }
    }
}

#[inline(always)]
fn upper(x: &mut [f64], rows: &[f64], stride: usize, first: usize) {
    for k in (0..x.len()).rev() {
        let row = &rows[k * stride + first..][..x.len()];
        for j in k + 1..x.len() {
            x[k] -= row[j] * x[j];
        }
        x[k] *= row[k];
    }
}

/// Takes from the values of some rows what columns from `start` on give with known values.
#[inline(always)]
fn take<S: Simd>(simd: S, x: &mut [f64], rows: &[f64], stride: usize, start: usize, known: &[f64]) {
    let row = |k: usize| &rows[k * stride + start..][..known.len()];
    if let [a, b, c, d] = x {
        let (p, p_rest) = S::as_simd_f64s(row(0));
        let (q, q_rest) = S::as_simd_f64s(row(1));
        let (r, r_rest) = S::as_simd_f64s(row(2));
        let (s, s_rest) = S::as_simd_f64s(row(3));
        let (known, rest) = S::as_simd_f64s(known);
        let mut sums = [simd.splat_f64s(0.0); 4];
        for ((((p, q), r), s), x) in p.iter().zip(q).zip(r).zip(s).zip(known) {
            sums[0] = simd.mul_add_e_f64s(*p, *x, sums[0]);
            sums[1] = simd.mul_add_e_f64s(*q, *x, sums[1]);
            sums[2] = simd.mul_add_e_f64s(*r, *x, sums[2]);
            sums[3] = simd.mul_add_e_f64s(*s, *x, sums[3]);
        }
        let last = |row: &[f64]| row.iter().zip(rest).map(|(l, x)| l * x).sum::<f64>();
        *a -= simd.reduce_sum_f64s(sums[0]) + last(p_rest);
        *b -= simd.reduce_sum_f64s(sums[1]) + last(q_rest);
        *c -= simd.reduce_sum_f64s(sums[2]) + last(r_rest);
        *d -= simd.reduce_sum_f64s(sums[3]) + last(s_rest);
    } else {
        for (k, x) in x.iter_mut().enumerate() {
            *x -= dot(simd, row(k), known);
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
        for n in [1, 2, 7, 17, 50, 80, 131] {
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

    /// The rows of the identity are left as they are, whether they fill panels or not.
    #[test]
    fn known_rows_need_not_be_filled() {
        let n = 23;
        for known in [0, 3, 4, 10, 23] {
            let part = |i: usize, j: usize| ((1 + 7 * i + 13 * j + i * j) as f64).sin();
            let identity = |i: usize, j: usize| f64::from(u8::from(i == j));
            let entry = |i: usize, j: usize| if i < known { identity(i, j) } else { part(i, j) };
            let expected: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
            let mut lu = Lu::new(n);
            for i in known - known % PANEL..n {
                lu.row(i).iter_mut().enumerate().for_each(|(j, to)| *to = entry(i, j));
            }
            assert!(lu.factor(known));
            let mut x: Vec<f64> =
                (0..n).map(|i| (0..n).map(|j| entry(i, j) * expected[j]).sum()).collect();
            lu.solve(&mut x);
            for (x, expected) in x.iter().zip(&expected) {
                // Rounding times a condition number of some thousands.
                assert!((x - expected).abs() < 1e-11, "{known}: {x} {expected}");
            }
        }
    }

    #[test]
    fn singular_matrices_and_no_numbers_are_refused() {
        assert!(!Lu::new(3).factor(0));
        assert!(Lu::of_rows(&[1.0, 2.0, 2.0, 4.0], 2).is_none());
        assert!(Lu::of_rows(&[1.0, f64::NAN, 2.0, 4.0], 2).is_none());
    }
}
