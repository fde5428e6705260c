//! Traction vector of all elements, in the layout that products read.

use pulp::{Arch, Simd, WithSimd};

use super::coefficients::Number;
use super::layout::Layout;
use super::{Influence, Precision};
use crate::coulomb::product::BLOCK;

/// A vector an element: tractions over their bounds, or a change of them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tractions {
    /// All `x` components, all `y` components.
    pub own: [Vec<f64>; 2],
    layout: Layout,
    /// Sums and differences over mirror images, part by part.
    parts: [Vec<f64>; 2],
    /// The parts in blocks: of each pair of them `x` and `y` of the one, then of the other.
    pub(super) double: Vec<f64>,
    pub(super) single: Vec<f32>,
}

impl Tractions {
    pub(crate) fn zeros(influence: &Influence) -> Self {
        Self::on(influence.layout.clone())
    }

    /// Zeros on a layout.
    pub(super) fn on(layout: Layout) -> Self {
        let (n, entries) = (layout.len(), layout.entries());
        let zeros = |n: usize| [0, 1].map(|_| vec![0.0; n]);
        let (double, single) = (vec![0.0; 2 * entries], vec![0.0; 2 * entries]);
        Self { own: zeros(n), layout, parts: zeros(entries), double, single }
    }

    /// Keeps them for products with another influence of as many elements, which may have other symmetries.
    pub(crate) fn match_symmetry(&mut self, influence: &Influence) {
        if self.layout.symmetry == influence.layout.symmetry {
            return;
        }
        let own = std::mem::take(&mut self.own);
        *self = Self { own, ..Self::zeros(influence) };
        self.fold_all(Precision::Double);
    }

    pub(crate) fn clear(&mut self) {
        for values in self.own.iter_mut().chain(&mut self.parts).chain([&mut self.double]) {
            values.fill(0.0);
        }
        self.single.fill(0.0);
    }

    pub(crate) fn at(&self, element: usize) -> [f64; 2] {
        [self.own[0][element], self.own[1][element]]
    }

    pub(crate) fn largest(&self) -> f64 {
        self.own.iter().flatten().fold(0.0, |largest, t| t.abs().max(largest))
    }

    /// Adds to a strip `change`, that of all `x` before that of all `y`; products know of it after
    /// [`Tractions::fold`].
    pub(crate) fn add(&mut self, strip: usize, change: &[f64]) {
        let elements = self.layout.elements(strip);
        for (own, change) in self.own.iter_mut().zip(change.chunks_exact(elements.len())) {
            let own = &mut own[elements.clone()];
            own.iter_mut().zip(change).for_each(|(own, change)| *own += change);
        }
    }

    /// Takes all `x`, then all `y`, from one vector; products know of it after [`Tractions::fold_all`].
    pub(crate) fn copy_from(&mut self, vector: &[f64]) {
        let half = self.own[0].len();
        for (own, vector) in self.own.iter_mut().zip(vector.chunks_exact(half)) {
            own.copy_from_slice(vector);
        }
    }

    /// Puts all `x`, then all `y`, into one vector.
    pub(crate) fn copy_to(&self, vector: &mut [f64]) {
        let (x, y) = vector.split_at_mut(self.own[0].len());
        x.copy_from_slice(&self.own[0]);
        y.copy_from_slice(&self.own[1]);
    }

    /// Adds `factor` times other tractions, for products in double precision.
    pub(crate) fn add_times(&mut self, factor: f64, other: &Self) {
        let to = self.own.iter_mut().flatten();
        to.zip(other.own.iter().flatten()).for_each(|(to, from)| *to += factor * from);
        self.fold_all(Precision::Double);
    }

    /// Sets every element, for products in double precision.
    pub(crate) fn set(&mut self, at: impl Fn(usize) -> [f64; 2]) {
        let [x, y] = &mut self.own;
        for (element, (x, y)) in x.iter_mut().zip(y).enumerate() {
            [*x, *y] = at(element);
        }
        self.fold_all(Precision::Double);
    }

    /// Makes all parts those of the tractions, for products as precise as that.
    pub(crate) fn fold_all(&mut self, precision: Precision) {
        (0..self.layout.kept()).for_each(|strip| self.fold(strip, precision));
    }

    /// Makes the parts of a strip that is gone through and of its mirror image those of their tractions, for
    /// products as precise as that.
    pub(crate) fn fold(&mut self, strip: usize, precision: Precision) {
        let Self { own, layout, parts, double, single } = self;
        let (own, parts) = (own.each_ref().map(Vec::as_slice), parts.each_mut());
        match precision {
            Precision::Single => {
                Arch::new().dispatch(Fold { layout, strip, own, parts, to: single });
            }
            Precision::Double => {
                Arch::new().dispatch(Fold { layout, strip, own, parts, to: double });
            }
        }
    }
}

struct Fold<'a, T> {
    layout: &'a Layout,
    strip: usize,
    own: [&'a [f64]; 2],
    parts: [&'a mut Vec<f64>; 2],
    to: &'a mut [T],
}

impl<T: Number> WithSimd for Fold<'_, T> {
    type Output = ();

    #[allow(clippy::inline_always)] // so that it is compiled for each kind of processor
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self { layout, strip, own: [x, y], parts: [by_x, by_y], to } = self;
        layout.fold(strip, x, by_x);
        layout.fold(strip, y, by_y);
        let (factors, parts) =
            (layout.factors.as_chunks().0, [by_x.as_chunks().0, by_y.as_chunks().0]);
        let (to, blocks) = (to.as_chunks_mut::<BLOCK>().0, layout.width / BLOCK);
        for block in layout.blocks(strip) {
            let factors: &[f64; BLOCK] = &factors[block];
            for part in 0..layout.symmetry.parts() {
                let first = 4 * (part / 2 * blocks + block) + 2 * (part % 2);
                for (parts, to) in parts.iter().zip(&mut to[first..]) {
                    let part: &[f64; BLOCK] = &parts[part * blocks + block];
                    for (to, (factor, part)) in to.iter_mut().zip(factors.iter().zip(part)) {
                        *to = T::of(factor * part);
                    }
                }
            }
        }
    }
}
