//! Tractions of all elements, and the elastic slip that they cause.

use super::grid::Grid;

/// Traction of each element over its bound, `x` then `y`. Kept twice, for the coefficients of the
/// upper half of the strips are those of the lower half by the tractions in mirrored order.
#[derive(Debug, Clone)]
pub(super) struct Tractions {
    pub own: [Vec<f64>; 2],
    /// The same with the strips in opposite order.
    mirrored: [Vec<f64>; 2],
    along: usize,
}

impl Tractions {
    pub(super) fn zeros(grid: &Grid) -> Self {
        let zeros = || [0, 1].map(|_| vec![0.0; grid.elements.len()]);
        Self { own: zeros(), mirrored: zeros(), along: grid.elements.along }
    }

    pub(super) fn clear(&mut self) {
        for values in self.own.iter_mut().chain(&mut self.mirrored) {
            values.fill(0.0);
        }
    }

    pub(super) fn at(&self, element: usize) -> [f64; 2] {
        [self.own[0][element], self.own[1][element]]
    }

    pub(super) fn largest(&self) -> f64 {
        self.own.iter().flatten().fold(0.0, |largest, t| t.abs().max(largest))
    }

    /// Elastic slip of an element.
    pub(super) fn slip(&self, grid: &Grid, element: usize) -> [f64; 2] {
        let (row, sign) = grid.row(element);
        let [x, y] = if sign > 0.0 { &self.own } else { &self.mirrored };
        row.apply(sign, x, y)
    }

    /// Adds to a strip `change`, that of all `x` before that of all `y`.
    pub(super) fn add(&mut self, strip: usize, change: &[f64]) {
        let along = self.along;
        let start = strip * along;
        let mirrored = self.own[0].len() - along - start;
        for (k, change) in change.chunks_exact(along).enumerate() {
            for (i, change) in change.iter().enumerate() {
                self.own[k][start + i] += change;
                self.mirrored[k][mirrored + i] = self.own[k][start + i];
            }
        }
    }

    /// Adds `factor` times other tractions.
    pub(super) fn add_times(&mut self, factor: f64, other: &Self) {
        let to = self.own.iter_mut().chain(&mut self.mirrored).flatten();
        let from = other.own.iter().chain(&other.mirrored).flatten();
        to.zip(from).for_each(|(to, from)| *to += factor * from);
    }

    /// Takes all `x`, then all `y`, from one vector.
    pub(super) fn copy_from(&mut self, vector: &[f64]) {
        let half = vector.len() / 2;
        for (k, vector) in [&vector[..half], &vector[half..]].into_iter().enumerate() {
            self.own[k].copy_from_slice(vector);
            let strips = vector.chunks_exact(self.along);
            let mirrored = self.mirrored[k].chunks_exact_mut(self.along).rev();
            mirrored.zip(strips).for_each(|(to, from)| to.copy_from_slice(from));
        }
    }

    /// Puts all `x`, then all `y`, into one vector.
    pub(super) fn copy_to(&self, vector: &mut [f64]) {
        let (x, y) = vector.split_at_mut(self.own[0].len());
        x.copy_from_slice(&self.own[0]);
        y.copy_from_slice(&self.own[1]);
    }
}
