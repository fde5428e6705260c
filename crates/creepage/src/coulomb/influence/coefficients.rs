//! Influence coefficients: displacements combined into the slip that products read.

use pulp::{Arch, Simd, WithSimd};

use super::layout::Layout;
use crate::coulomb::product::BLOCK;
use crate::numerics::buffer_pool::BufferPool;

static ROWS: BufferPool<f32> = BufferPool::new();
static BLOCKS: BufferPool<f64> = BufferPool::new();

/// Rows of coefficients as [`Product`](crate::coulomb::product::Product) reads them, in single precision, which
/// moves forces by a hundred-millionth, and the blocks of them that strips have of themselves and of their
/// mirror images.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    pub(super) rows: Vec<f32>,
    /// In `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`.
    pub(super) blocks: [Vec<f64>; 3],
}

impl Coefficients {
    /// So many entries of rows and of blocks, of any value: all are to be written.
    pub(super) fn with_length(rows: usize, blocks: usize) -> Self {
        Self {
            rows: resized(ROWS.take(rows), rows),
            blocks: std::array::from_fn(|_| resized(BLOCKS.take(blocks), blocks)),
        }
    }
}

fn resized<T: Clone + Default>(mut of: Vec<T>, entries: usize) -> Vec<T> {
    of.resize(entries, T::default());
    of
}

impl Drop for Coefficients {
    fn drop(&mut self) {
        ROWS.keep(std::mem::take(&mut self.rows));
        self.blocks.iter_mut().for_each(|of| BLOCKS.keep(std::mem::take(of)));
    }
}

/// A row part by part: in `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`.
pub(super) struct Folded([Vec<f64>; 3]);

impl Folded {
    pub(super) fn new(layout: &Layout) -> Self {
        Self(std::array::from_fn(|_| vec![0.0; layout.entries()]))
    }

    /// Takes the parts of the coefficients of all elements.
    pub(super) fn set(&mut self, layout: &Layout, of: [&[f64]; 3]) {
        Arch::new().dispatch(Fold { layout, of, to: &mut self.0 });
    }

    /// Puts these numbers less others into a row, in the order of
    /// [`Product`](crate::coulomb::product::Product).
    pub(super) fn put_less<C: Number>(&self, other: &Self, layout: &Layout, row: &mut [C]) {
        let parts = [&self.0, &other.0];
        Arch::new().dispatch(PutLess { layout, parts, row });
    }
}

/// A coefficient in single or double precision.
pub(super) trait Number: Copy {
    fn of(number: f64) -> Self;
}

impl Number for f32 {
    #[allow(clippy::cast_possible_truncation)] // single precision is meant
    fn of(number: f64) -> Self {
        number as Self
    }
}

impl Number for f64 {
    fn of(number: f64) -> Self {
        number
    }
}

struct Fold<'a> {
    layout: &'a Layout,
    of: [&'a [f64]; 3],
    to: &'a mut [Vec<f64>; 3],
}

impl WithSimd for Fold<'_> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for (of, to) in self.of.into_iter().zip(self.to) {
            for strip in 0..self.layout.kept() {
                self.layout.fold(strip, of, to);
            }
        }
    }
}

struct PutLess<'a, C> {
    layout: &'a Layout,
    parts: [&'a [Vec<f64>; 3]; 2],
    row: &'a mut [C],
}

impl<C: Number> WithSimd for PutLess<'_, C> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { layout, parts: [[a, b, c], [d, e, f]], row } = self;
        let these = [a.as_chunks().0, b.as_chunks().0, c.as_chunks().0];
        let others = [d.as_chunks().0, e.as_chunks().0, f.as_chunks().0];
        let blocks = layout.width / BLOCK;
        for (k, to) in row.as_chunks_mut::<BLOCK>().0.as_chunks_mut::<6>().0.iter_mut().enumerate()
        {
            let first = k + k / blocks * blocks;
            for (i, to) in to.iter_mut().enumerate() {
                let (kind, block) = (i % 3, first + i / 3 * blocks);
                let this: &[f64; BLOCK] = &these[kind][block];
                let other: &[f64; BLOCK] = &others[kind][block];
                for (to, (this, other)) in to.iter_mut().zip(this.iter().zip(other)) {
                    *to = C::of(this - other);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::influence::layout::{Symmetry, unfold};
    use crate::coulomb::influence::{Precision, Tractions};
    use crate::coulomb::product::Product;

    /// The products of the parts of any row and any tractions, symmetric or not, in double precision.
    #[test]
    fn parts_add_up_to_the_whole() {
        use Symmetry::{Across, Along, Both, None};
        for (symmetry, elements) in [None, Along, Across, Both].into_iter().flat_map(|symmetry| {
            [[0, 5, 11, 16], [0, 6, 7, 13], [0, 4, 4, 8]].map(|e| (symmetry, e))
        }) {
            let layout = Layout::new(symmetry, &elements);
            let n = layout.len();
            let numbers = |phase: f64| (0..n).map(|k| (k as f64 + phase).sin()).collect::<Vec<_>>();
            let [xx, xy, yy, x, y] = [0.1, 0.7, 1.9, 2.2, 3.1].map(numbers);
            let [mut folded, nothing] = [(); 2].map(|()| Folded::new(&layout));
            folded.set(&layout, [&xx, &xy, &yy]);
            let mut row = vec![0.0_f64; 3 * layout.entries()];
            folded.put_less(&nothing, &layout, &mut row);
            let mut tractions = Tractions::on(layout);
            tractions.copy_from(&[&x[..], &y[..]].concat());
            tractions.fold_all(Precision::Double);
            let mut found = [f64::NAN; 2];
            let put = |_, parts: [[f64; 4]; 2]| found = parts.map(|parts| unfold(parts)[0]);
            let (rows, pairs) = (&row[..], symmetry.parts() / 2);
            Product { rows, tractions: &tractions.double[..], pairs, put }.compute();
            let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let expected = [sum(&xx, &x) + sum(&xy, &y), sum(&xy, &x) + sum(&yy, &y)];
            for (found, expected) in found.into_iter().zip(expected) {
                // Rounding of some tens of terms of order one.
                assert!((found - expected).abs() < 1e-13, "{symmetry:?}: {found} {expected}");
            }
        }
    }
}
