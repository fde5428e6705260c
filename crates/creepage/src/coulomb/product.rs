//! A row of the grid's coefficients times the tractions: where most of the time goes.

use pulp::{Arch, Simd, WithSimd};

/// The rows of coefficients of one element, and how to apply them.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a> {
    pub xx: &'a [f64],
    pub xy: &'a [f64],
    pub yy: &'a [f64],
}

impl Row<'_> {
    /// Slip by tractions `x`, `y`, in the mirror image too when `sign` is -1.
    pub(crate) fn apply(&self, sign: f64, x: &[f64], y: &[f64]) -> [f64; 2] {
        let [u_x, u_y, v_x, v_y] = Arch::new().dispatch(Products { row: *self, x, y });
        [u_x + sign * u_y, sign * v_x + v_y]
    }
}

/// Scalar products of a row with tractions: `xx x`, `xy y`, `xy x`, `yy y`.
struct Products<'a> {
    row: Row<'a>,
    x: &'a [f64],
    y: &'a [f64],
}

impl WithSimd for Products<'_> {
    type Output = [f64; 4];

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [f64; 4] {
        let Self { row: Row { xx, xy, yy }, x, y } = self;
        let (xx, xx_rest) = S::as_simd_f64s(xx);
        let (xy, xy_rest) = S::as_simd_f64s(xy);
        let (yy, yy_rest) = S::as_simd_f64s(yy);
        let (x, x_rest) = S::as_simd_f64s(x);
        let (y, y_rest) = S::as_simd_f64s(y);
        let add = |sums: [S::f64s; 4], [xx, xy, yy, x, y]: [S::f64s; 5]| {
            [
                simd.mul_add_e_f64s(xx, x, sums[0]),
                simd.mul_add_e_f64s(xy, y, sums[1]),
                simd.mul_add_e_f64s(xy, x, sums[2]),
                simd.mul_add_e_f64s(yy, y, sums[3]),
            ]
        };
        // Two sets of sums, for an addition waits for the one before.
        let mut sums = [[simd.splat_f64s(0.0); 4]; 2];
        let half = x.len() / 2;
        for k in 0..half {
            sums[0] = add(sums[0], [xx[2 * k], xy[2 * k], yy[2 * k], x[2 * k], y[2 * k]]);
            let k = 2 * k + 1;
            sums[1] = add(sums[1], [xx[k], xy[k], yy[k], x[k], y[k]]);
        }
        if let Some(k) = (2 * half..x.len()).next() {
            sums[0] = add(sums[0], [xx[k], xy[k], yy[k], x[k], y[k]]);
        }
        let last = |rest: &[f64]| simd.partial_load_f64s(rest);
        let rest = [last(xx_rest), last(xy_rest), last(yy_rest), last(x_rest), last(y_rest)];
        sums[1] = add(sums[1], rest);
        let sums: [S::f64s; 4] = std::array::from_fn(|k| simd.add_f64s(sums[0][k], sums[1][k]));
        sums.map(|sum| simd.reduce_sum_f64s(sum))
    }
}
