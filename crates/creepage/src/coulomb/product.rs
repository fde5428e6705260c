//! Matrix-vector products of the influence matrix: most of the computing time.

use pulp::{Arch, Simd, WithSimd};

/// Columns that are read at once: rows come in whole blocks.
pub(crate) const BLOCK: usize = 8;

/// Coefficients of an element by the tractions of one strip.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    pub xx: &'a [f64],
    pub xy: &'a [f64],
    pub yy: &'a [f64],
}

/// The rows of a strip's elements, by the tractions of one strip.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// Those of the first element, then those of the next.
    pub rows: Row<'a>,
    pub columns: usize,
    /// That of `xy`.
    pub sign: f64,
    /// First of the elements.
    pub first: usize,
}

impl Block<'_> {
    /// Adds to the slip of the strip's elements that by tractions `x` and `y`.
    pub(crate) fn add_slip(&self, tractions: [&[f64]; 2], slip: &mut [Vec<f64>; 2]) {
        Arch::new().dispatch(AddSlip { block: *self, tractions, slip });
    }
}

struct AddSlip<'a> {
    block: Block<'a>,
    tractions: [&'a [f64]; 2],
    slip: &'a mut [Vec<f64>; 2],
}

impl WithSimd for AddSlip<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { block: Block { rows, columns, sign, first }, tractions, slip } = self;
        let chunks = |part| <[f64]>::chunks_exact(part, columns);
        let rows = chunks(rows.xx).zip(chunks(rows.xy)).zip(chunks(rows.yy));
        let [u, v] = slip;
        let slip = u[first..].iter_mut().zip(&mut v[first..]);
        for (((xx, xy), yy), (u, v)) in rows.zip(slip) {
            let by = slip_by(simd, Row { xx, xy, yy }, sign, tractions);
            *u += by[0];
            *v += by[1];
        }
    }
}

/// Slip `xx x + sign xy y`, `sign xy x + yy y`.
#[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
#[inline(always)]
fn slip_by<S: Simd>(simd: S, row: Row, sign: f64, [x, y]: [&[f64]; 2]) -> [f64; 2] {
    let Row { xx, xy, yy } = row;
    let (xx, xx_rest) = S::as_simd_f64s(xx);
    let (xy, xy_rest) = S::as_simd_f64s(xy);
    let (yy, yy_rest) = S::as_simd_f64s(yy);
    let (x, x_rest) = S::as_simd_f64s(x);
    let (y, y_rest) = S::as_simd_f64s(y);
    let add = |sums: [S::f64s; 4], xx, xy, yy, x, y| {
        [
            simd.mul_add_e_f64s(xx, x, sums[0]),
            simd.mul_add_e_f64s(xy, y, sums[1]),
            simd.mul_add_e_f64s(xy, x, sums[2]),
            simd.mul_add_e_f64s(yy, y, sums[3]),
        ]
    };
    let mut sums = [simd.splat_f64s(0.0); 4];
    for ((((xx, xy), yy), x), y) in xx.iter().zip(xy).zip(yy).zip(x).zip(y) {
        sums = add(sums, *xx, *xy, *yy, *x, *y);
    }
    if !xx_rest.is_empty() {
        let load = |rest: &[f64]| simd.partial_load_f64s(rest);
        let (x, y) = (load(x_rest), load(y_rest));
        sums = add(sums, load(xx_rest), load(xy_rest), load(yy_rest), x, y);
    }
    let sum = |k: usize| simd.reduce_sum_f64s(sums[k]);
    [sum(0) + sign * sum(1), sign * sum(2) + sum(3)]
}

/// All rows of a strip by all tractions: for each row, numbered from 0, `put` gets what its parts give in `x`
/// and in `y`.
///
/// Rows are in blocks: of each pair of parts for [`BLOCK`] columns `xx`, `xy` and `yy` of the one, then of the
/// other; tractions are `x` and `y` of the one, then of the other. Sums are as precise as tractions are.
pub(crate) struct Product<'a, C, T, F> {
    pub rows: &'a [C],
    pub tractions: &'a [T],
    /// Pairs of parts: one or two.
    pub pairs: usize,
    pub put: F,
}

impl<F: FnMut(usize, [[f64; 4]; 2])> Product<'_, f32, f32, F> {
    pub(crate) fn compute(self) {
        Arch::new().dispatch(self);
    }
}

impl<C: Copy + Into<f64>, F: FnMut(usize, [[f64; 4]; 2])> Product<'_, C, f64, F> {
    pub(crate) fn compute(self) {
        Arch::new().dispatch(self);
    }
}

impl<F: FnMut(usize, [[f64; 4]; 2])> WithSimd for Product<'_, f32, f32, F> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        if S::F32_LANES > BLOCK {
            return self.with_simd(pulp::Scalar::new());
        }
        let per = BLOCK / S::F32_LANES;
        let Self { rows, tractions, pairs, mut put } = self;
        let ((rows, _), (tractions, _)) = (S::as_simd_f32s(rows), S::as_simd_f32s(tractions));
        let width = tractions.len() / pairs / 4;
        // Two rows at once, for tractions are read once and an addition waits for the one before.
        for (k, two) in rows.chunks(2 * 6 * pairs * width).enumerate() {
            let (one, other) = two.split_at(6 * pairs * width);
            let is_last = other.is_empty();
            let other = if is_last { one } else { other };
            let mut found = [[[0.0; 4]; 2]; 2];
            for pair in 0..pairs {
                let own = 6 * pair * width..6 * (pair + 1) * width;
                let (one, other) = (&one[own.clone()], &other[own]);
                let by = tractions[4 * pair * width..].chunks_exact(4 * per);
                let both = one.chunks_exact(6 * per).zip(other.chunks_exact(6 * per));
                let [mut first, mut second] = [[simd.splat_f32s(0.0); 4]; 2];
                for ((one, other), by) in both.zip(by) {
                    for i in 0..per {
                        first = add_vector(simd, first, one, by, i);
                        second = add_vector(simd, second, other, by, i);
                    }
                }
                for (found, sums) in found.iter_mut().zip([first, second]) {
                    for (part, component) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        let sum = simd.reduce_sum_f32s(sums[2 * part + component]);
                        found[component][2 * pair + part] = sum.into();
                    }
                }
            }
            put(2 * k, found[0]);
            if !is_last {
                put(2 * k + 1, found[1]);
            }
        }
    }
}

/// Adds to the sums of a pair of parts, `x` and `y` of the one and of the other, what vector `i` of a block
/// gives.
#[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
#[inline(always)]
fn add_vector<S: Simd>(
    simd: S,
    [xk, yk, xl, yl]: [S::f32s; 4],
    row: &[S::f32s],
    by: &[S::f32s],
    i: usize,
) -> [S::f32s; 4] {
    let per = BLOCK / S::F32_LANES;
    let [x, y, u, v] = [by[i], by[per + i], by[2 * per + i], by[3 * per + i]];
    let [xx, xy, yy] = [row[i], row[per + i], row[2 * per + i]];
    let [uu, uv, vv] = [row[3 * per + i], row[4 * per + i], row[5 * per + i]];
    [
        simd.mul_add_e_f32s(uv, v, simd.mul_add_e_f32s(xx, x, xk)),
        simd.mul_add_e_f32s(uv, u, simd.mul_add_e_f32s(yy, y, yk)),
        simd.mul_add_e_f32s(xy, y, simd.mul_add_e_f32s(uu, u, xl)),
        simd.mul_add_e_f32s(xy, x, simd.mul_add_e_f32s(vv, v, yl)),
    ]
}

impl<C: Copy + Into<f64>, F: FnMut(usize, [[f64; 4]; 2])> WithSimd for Product<'_, C, f64, F> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { rows, tractions, pairs, mut put } = self;
        let (tractions, _) = tractions.as_chunks::<BLOCK>().0.as_chunks::<4>();
        let (rows, _) = rows.as_chunks::<BLOCK>().0.as_chunks::<6>();
        let blocks = tractions.len() / pairs;
        for (k, row) in rows.chunks_exact(tractions.len()).enumerate() {
            let mut found = [[0.0; 4]; 2];
            for pair in 0..pairs {
                let own = pair * blocks..(pair + 1) * blocks;
                let mut sums = [[0.0; BLOCK]; 4];
                for (row, by) in row[own.clone()].iter().zip(&tractions[own]) {
                    add_block(&mut sums, row, by);
                }
                for (part, component) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    found[component][2 * pair + part] = sums[2 * part + component].iter().sum();
                }
            }
            put(k, found);
        }
    }
}

/// Adds to the sums of a pair of parts, `x` and `y` of the one and of the other, what a block gives.
#[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
#[inline(always)]
fn add_block<C: Copy + Into<f64>>(
    [xk, yk, xl, yl]: &mut [[f64; BLOCK]; 4],
    row: &[[C; BLOCK]; 6],
    [x, y, u, v]: &[[f64; BLOCK]; 4],
) {
    for i in 0..BLOCK {
        let [xx, xy, yy]: [f64; 3] = [row[0][i].into(), row[1][i].into(), row[2][i].into()];
        let [uu, uv, vv]: [f64; 3] = [row[3][i].into(), row[4][i].into(), row[5][i].into()];
        xk[i] += xx * x[i] + uv * v[i];
        yk[i] += yy * y[i] + uv * u[i];
        xl[i] += uu * u[i] + xy * y[i];
        yl[i] += vv * v[i] + xy * x[i];
    }
}
