//! Coefficients, in memory that is used again.

use crate::coulomb::spare::Spare;

/// Of sets of up to some 16 MB, by their numbers of entries.
static SPARE: Spare<Coefficients> = Spare::up_to(450_000);

/// Slip in `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`; in both precisions.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    pub(super) double: [Vec<f64>; 3],
    pub(super) single: [Vec<f32>; 3],
}

impl Coefficients {
    /// So many of each in double precision, of any value: all are to be written.
    pub(super) fn with_length(entries: usize) -> Self {
        let mut room = SPARE.take(entries).unwrap_or_default();
        room.double.iter_mut().for_each(|of| resize(of, entries));
        room
    }

    /// The same with as many in single precision.
    pub(super) fn with_single(mut self) -> Self {
        let entries = self.double[0].len();
        self.single.iter_mut().for_each(|of| resize(of, entries));
        self
    }

    /// Copies all to single precision.
    #[allow(clippy::cast_possible_truncation)] // single precision is meant
    pub(super) fn copy_to_single(&mut self) {
        for (single, double) in self.single.iter_mut().zip(&self.double) {
            single.clear();
            single.extend(double.iter().map(|entry| *entry as f32));
        }
    }

    /// Keeps the memory for [`Coefficients::with_length`].
    pub(super) fn keep(self) {
        SPARE.keep(self.double[0].capacity(), self);
    }
}

/// To so many entries; pages that are all zeros come from the system when they are written to.
fn resize<T: Clone + Default>(of: &mut Vec<T>, entries: usize) {
    if of.capacity() < entries {
        *of = vec![T::default(); entries];
    } else {
        of.resize(entries, T::default());
    }
}
