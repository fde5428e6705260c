//! Tractions of all elements, kept as products read them.

use super::Influence;

/// A vector an element: tractions over their bounds, or a change of them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tractions {
    /// All `x` components, all `y` components.
    pub own: [Vec<f64>; 2],
    /// The same with the strips in opposite order, where a mirrored [`Influence`] needs it.
    pub(super) mirrored: [Vec<f64>; 2],
    /// Both in single precision.
    pub(super) single: [[Vec<f32>; 2]; 2],
    offsets: Vec<usize>,
}

impl Tractions {
    pub(crate) fn zeros(influence: &Influence) -> Self {
        let n = influence.columns();
        let kept = if influence.mirrored { n } else { 0 };
        let zeros = |n: usize| [0, 1].map(|_| vec![0.0; n]);
        Self {
            own: zeros(n),
            mirrored: zeros(kept),
            single: [n, kept].map(|n| [0, 1].map(|_| vec![0.0; n])),
            offsets: influence.offsets.clone(),
        }
    }

    pub(crate) fn clear(&mut self) {
        for values in self.own.iter_mut().chain(&mut self.mirrored) {
            values.fill(0.0);
        }
        for values in self.single.as_flattened_mut() {
            values.fill(0.0);
        }
    }

    pub(crate) fn at(&self, element: usize) -> [f64; 2] {
        [self.own[0][element], self.own[1][element]]
    }

    pub(crate) fn largest(&self) -> f64 {
        self.own.iter().flatten().fold(0.0, |largest, t| t.abs().max(largest))
    }

    /// Adds to a strip `change`, that of all `x` before that of all `y`.
    pub(crate) fn add(&mut self, strip: usize, change: &[f64]) {
        let elements = self.offsets[strip]..self.offsets[strip + 1];
        for (k, change) in change.chunks_exact(elements.len()).enumerate() {
            let own = &mut self.own[k][elements.clone()];
            own.iter_mut().zip(change).for_each(|(own, change)| *own += change);
            self.copy(strip, k);
        }
    }

    /// Takes all `x`, then all `y`, from one vector.
    pub(crate) fn copy_from(&mut self, vector: &[f64]) {
        let half = self.own[0].len();
        for (k, vector) in vector.chunks_exact(half).enumerate() {
            self.own[k].copy_from_slice(vector);
        }
        self.copy_all();
    }

    /// Puts all `x`, then all `y`, into one vector.
    pub(crate) fn copy_to(&self, vector: &mut [f64]) {
        let (x, y) = vector.split_at_mut(self.own[0].len());
        x.copy_from_slice(&self.own[0]);
        y.copy_from_slice(&self.own[1]);
    }

    /// Adds `factor` times other tractions.
    pub(crate) fn add_times(&mut self, factor: f64, other: &Self) {
        let to = self.own.iter_mut().flatten();
        to.zip(other.own.iter().flatten()).for_each(|(to, from)| *to += factor * from);
        self.copy_all();
    }

    /// Sets every element.
    pub(crate) fn set(&mut self, at: impl Fn(usize) -> [f64; 2]) {
        let [x, y] = &mut self.own;
        for (element, (x, y)) in x.iter_mut().zip(y).enumerate() {
            [*x, *y] = at(element);
        }
        self.copy_all();
    }

    fn copy_all(&mut self) {
        for strip in 0..self.offsets.len() - 1 {
            self.copy(strip, 0);
            self.copy(strip, 1);
        }
    }

    /// Copies a strip to single precision, and to its place in the opposite order.
    #[allow(clippy::cast_possible_truncation)] // single precision is meant
    fn copy(&mut self, strip: usize, k: usize) {
        let Self { own, mirrored, single: [single, mirrored_single], offsets } = self;
        let elements = offsets[strip]..offsets[strip + 1];
        let (own, n) = (&own[k][elements.clone()], elements.len());
        let copied = &mut single[k][elements];
        copied.iter_mut().zip(own).for_each(|(copied, own)| *copied = *own as f32);
        if !mirrored[k].is_empty() {
            let start = offsets[offsets.len() - 2 - strip];
            mirrored[k][start..start + n].copy_from_slice(own);
            mirrored_single[k][start..start + n].copy_from_slice(copied);
        }
    }
}
