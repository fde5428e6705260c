//! Coefficients, and how displacements become those that products read.

use pulp::{Arch, Simd, WithSimd};

use super::layout::Layout;
use crate::coulomb::product::BLOCK;
use crate::spare::Spare;

static ROWS: Spare<f32> = Spare::new();
static BLOCKS: Spare<f64> = Spare::new();

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
