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
        Arch::new().dispatch(Slip { row: *self, sign, tractions: [x, y] })
    }

    /// Slip of the element by its tractions, and of its mirror image by those in mirrored order.
    pub(crate) fn apply_to_both(&self, tractions: [[&[f64]; 2]; 2]) -> [[f64; 2]; 2] {
        Arch::new().dispatch(BothSlips { row: *self, tractions })
    }
}

impl Row<'_, f32> {
    /// The same in single precision, at twice the speed.
    #[allow(clippy::cast_possible_truncation)] // a sign
    pub(crate) fn apply(&self, sign: f64, x: &[f32], y: &[f32]) -> [f64; 2] {
        let [u, v] =
            Arch::new().dispatch(Slip { row: *self, sign: sign as f32, tractions: [x, y] });
        [f64::from(u), f64::from(v)]
    }

    /// The same in single precision, at twice the speed.
    pub(crate) fn apply_to_both(&self, tractions: [[&[f32]; 2]; 2]) -> [[f64; 2]; 2] {
        let [[u, v], [p, q]] = Arch::new().dispatch(BothSlips { row: *self, tractions });
        [[f64::from(u), f64::from(v)], [f64::from(p), f64::from(q)]]
    }
}

/// The rows of a strip's elements, by the tractions of one strip.
#[derive(Clone, Copy)]
pub(crate) struct Block<'a> {
    /// From the first element's first coefficient on; the next element's is `stride` further.
    pub rows: Row<'a>,
    pub stride: usize,
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
        let Self { block: Block { rows, stride, columns, sign, first }, tractions, slip } = self;
        let chunks = |part| <[f64]>::chunks(part, stride);
        let rows = chunks(rows.xx).zip(chunks(rows.xy)).zip(chunks(rows.yy));
        let [u, v] = slip;
        let slip = u[first..].iter_mut().zip(&mut v[first..]);
        for (((xx, xy), yy), (u, v)) in rows.zip(slip) {
            let row = Row { xx: &xx[..columns], xy: &xy[..columns], yy: &yy[..columns] };
            let by = Slip { row, sign, tractions }.with_simd(simd);
            *u += by[0];
            *v += by[1];
        }
    }
}

/// Slip `xx x + sign xy y`, `sign xy x + yy y`.
struct Slip<'a, T> {
    row: Row<'a, T>,
    sign: T,
    tractions: [&'a [T]; 2],
}

/// The same by the first tractions with sign 1 and by the second with -1: for what is read of a row.
struct BothSlips<'a, T> {
    row: Row<'a, T>,
    tractions: [[&'a [T]; 2]; 2],
}

// What is compiled for each kind of processor calls no closure of an array's `map`.
macro_rules! slips {
    ($float:ty, $lanes:ident, $split:ident, $splat:ident, $multiply_add:ident, $add:ident,
     $subtract:ident, $load:ident, $sum:ident) => {
        impl WithSimd for Slip<'_, $float> {
            type Output = [$float; 2];

            #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) -> [$float; 2] {
                let Self { row: Row { xx, xy, yy }, sign, tractions: [x, y] } = self;
                let (xx, xx_rest) = S::$split(xx);
                let (xy, xy_rest) = S::$split(xy);
                let (yy, yy_rest) = S::$split(yy);
                let (x, x_rest) = S::$split(x);
                let (y, y_rest) = S::$split(y);
                let add = |sums: [S::$lanes; 4], xx, xy, yy, x, y| {
                    [
                        simd.$multiply_add(xx, x, sums[0]),
                        simd.$multiply_add(xy, y, sums[1]),
                        simd.$multiply_add(xy, x, sums[2]),
                        simd.$multiply_add(yy, y, sums[3]),
                    ]
                };
                // Two sets of sums, for an addition waits for the one before; zipped pairs, for an index
                // is checked.
                let (mut even, mut odd) = ([simd.$splat(0.0); 4], [simd.$splat(0.0); 4]);
                let (xx, xx_odd) = xx.as_chunks::<2>();
                let (xy, xy_odd) = xy.as_chunks::<2>();
                let (yy, yy_odd) = yy.as_chunks::<2>();
                let (x, x_odd) = x.as_chunks::<2>();
                let (y, y_odd) = y.as_chunks::<2>();
                for ((((xx, xy), yy), x), y) in xx.iter().zip(xy).zip(yy).zip(x).zip(y) {
                    even = add(even, xx[0], xy[0], yy[0], x[0], y[0]);
                    odd = add(odd, xx[1], xy[1], yy[1], x[1], y[1]);
                }
                let last = xx_odd.iter().zip(xy_odd).zip(yy_odd).zip(x_odd).zip(y_odd);
                for ((((xx, xy), yy), x), y) in last {
                    even = add(even, *xx, *xy, *yy, *x, *y);
                }
                if !xx_rest.is_empty() {
                    let load = |rest: &[$float]| simd.$load(rest);
                    let (x, y) = (load(x_rest), load(y_rest));
                    odd = add(odd, load(xx_rest), load(xy_rest), load(yy_rest), x, y);
                }
                let sum = |k: usize| simd.$sum(simd.$add(even[k], odd[k]));
                [sum(0) + sign * sum(1), sign * sum(2) + sum(3)]
            }
        }

        impl WithSimd for BothSlips<'_, $float> {
            type Output = [[$float; 2]; 2];

            #[allow(clippy::inline_always)]
            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) -> [[$float; 2]; 2] {
                let Self { row: Row { xx, xy, yy }, tractions: [[x, y], [u, v]] } = self;
                let (xx, xx_rest) = S::$split(xx);
                let (xy, xy_rest) = S::$split(xy);
                let (yy, yy_rest) = S::$split(yy);
                let (x, x_rest) = S::$split(x);
                let (y, y_rest) = S::$split(y);
                let (u, u_rest) = S::$split(u);
                let (v, v_rest) = S::$split(v);
                let add = |sums: [S::$lanes; 4], xx, xy, yy, x, y| {
                    [
                        simd.$multiply_add(xx, x, sums[0]),
                        simd.$multiply_add(xy, y, sums[1]),
                        simd.$multiply_add(xy, x, sums[2]),
                        simd.$multiply_add(yy, y, sums[3]),
                    ]
                };
                let (mut own, mut image) = ([simd.$splat(0.0); 4], [simd.$splat(0.0); 4]);
                let rows = xx.iter().zip(xy).zip(yy);
                let all = rows.zip(x).zip(y).zip(u).zip(v);
                for ((((((xx, xy), yy), x), y), u), v) in all {
                    own = add(own, *xx, *xy, *yy, *x, *y);
                    image = add(image, *xx, *xy, *yy, *u, *v);
                }
                if !xx_rest.is_empty() {
                    let load = |rest: &[$float]| simd.$load(rest);
                    let (xx, xy, yy) = (load(xx_rest), load(xy_rest), load(yy_rest));
                    own = add(own, xx, xy, yy, load(x_rest), load(y_rest));
                    image = add(image, xx, xy, yy, load(u_rest), load(v_rest));
                }
                [
                    [simd.$sum(simd.$add(own[0], own[1])), simd.$sum(simd.$add(own[3], own[2]))],
                    [
                        simd.$sum(simd.$subtract(image[0], image[1])),
                        simd.$sum(simd.$subtract(image[3], image[2])),
                    ],
                ]
            }
        }
    };
}

slips!(
    f64,
    f64s,
    as_simd_f64s,
    splat_f64s,
    mul_add_e_f64s,
    add_f64s,
    sub_f64s,
    partial_load_f64s,
    reduce_sum_f64s
);
slips!(
    f32,
    f32s,
    as_simd_f32s,
    splat_f32s,
    mul_add_e_f32s,
    add_f32s,
    sub_f32s,
    partial_load_f32s,
    reduce_sum_f32s
);
