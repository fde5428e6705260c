//! A row of the grid's coefficients times the tractions: where most of the time goes.

use pulp::{Arch, Simd, WithSimd};

/// The rows of coefficients of one element.
#[derive(Clone, Copy)]
pub(crate) struct Row<'a, T = f64> {
    pub xx: &'a [T],
    pub xy: &'a [T],
    pub yy: &'a [T],
}

impl Row<'_> {
    /// Slip by tractions `x`, `y`, in the mirror image too when `sign` is -1.
    pub(crate) fn apply(&self, sign: f64, x: &[f64], y: &[f64]) -> [f64; 2] {
        let [u_x, u_y, v_x, v_y] = Arch::new().dispatch(Products { row: *self, x, y });
        [u_x + sign * u_y, sign * v_x + v_y]
    }
}

impl Row<'_, f32> {
    /// The same in single precision, at twice the speed.
    pub(crate) fn apply(&self, sign: f64, x: &[f32], y: &[f32]) -> [f64; 2] {
        let sums = Arch::new().dispatch(Products { row: *self, x, y });
        let [u_x, u_y, v_x, v_y] = sums.map(f64::from);
        [u_x + sign * u_y, sign * v_x + v_y]
    }
}

/// Scalar products of a row with tractions: `xx x`, `xy y`, `xy x`, `yy y`.
struct Products<'a, T> {
    row: Row<'a, T>,
    x: &'a [T],
    y: &'a [T],
}

macro_rules! products {
    ($float:ty, $lanes:ident, $split:ident, $splat:ident, $multiply_add:ident, $add:ident,
     $load:ident, $sum:ident) => {
        impl WithSimd for Products<'_, $float> {
            type Output = [$float; 4];

            #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) -> [$float; 4] {
                let Self { row: Row { xx, xy, yy }, x, y } = self;
                let (xx, xx_rest) = S::$split(xx);
                let (xy, xy_rest) = S::$split(xy);
                let (yy, yy_rest) = S::$split(yy);
                let (x, x_rest) = S::$split(x);
                let (y, y_rest) = S::$split(y);
                let add = |sums: [S::$lanes; 4], [xx, xy, yy, x, y]: [S::$lanes; 5]| {
                    [
                        simd.$multiply_add(xx, x, sums[0]),
                        simd.$multiply_add(xy, y, sums[1]),
                        simd.$multiply_add(xy, x, sums[2]),
                        simd.$multiply_add(yy, y, sums[3]),
                    ]
                };
                // Two sets of sums, for an addition waits for the one before; zipped pairs, for an index
                // is checked.
                let mut sums = [[simd.$splat(0.0); 4]; 2];
                let (xx, xx_odd) = xx.as_chunks::<2>();
                let (xy, xy_odd) = xy.as_chunks::<2>();
                let (yy, yy_odd) = yy.as_chunks::<2>();
                let (x, x_odd) = x.as_chunks::<2>();
                let (y, y_odd) = y.as_chunks::<2>();
                for ((((xx, xy), yy), x), y) in xx.iter().zip(xy).zip(yy).zip(x).zip(y) {
                    sums[0] = add(sums[0], [xx[0], xy[0], yy[0], x[0], y[0]]);
                    sums[1] = add(sums[1], [xx[1], xy[1], yy[1], x[1], y[1]]);
                }
                let odd = xx_odd.iter().zip(xy_odd).zip(yy_odd).zip(x_odd).zip(y_odd);
                for ((((xx, xy), yy), x), y) in odd {
                    sums[0] = add(sums[0], [*xx, *xy, *yy, *x, *y]);
                }
                let last = |rest: &[$float]| simd.$load(rest);
                let rest =
                    [last(xx_rest), last(xy_rest), last(yy_rest), last(x_rest), last(y_rest)];
                sums[1] = add(sums[1], rest);
                let sums: [S::$lanes; 4] =
                    std::array::from_fn(|k| simd.$add(sums[0][k], sums[1][k]));
                sums.map(|sum| simd.$sum(sum))
            }
        }
    };
}

products!(
    f64,
    f64s,
    as_simd_f64s,
    splat_f64s,
    mul_add_e_f64s,
    add_f64s,
    partial_load_f64s,
    reduce_sum_f64s
);
products!(
    f32,
    f32s,
    as_simd_f32s,
    splat_f32s,
    mul_add_e_f32s,
    add_f32s,
    partial_load_f32s,
    reduce_sum_f32s
);
