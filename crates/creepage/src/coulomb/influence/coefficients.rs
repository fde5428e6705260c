//! Coefficients, in memory that is used again.
//!
//! Pages fresh from the system cost half as much as what is computed into them, and shapes come in
//! series: what was dropped last is kept, for all threads, for one may drop what another prepared.

use std::sync::Mutex;

/// Sets kept: two grids of each contact of a wheelset, while the next ones are made.
const KEPT: usize = 8;
/// Largest number of entries of a set that is kept: of some 16 MB.
const LARGEST: usize = 450_000;

/// Nobody waits for it: new memory costs less, and a process forked off would wait for ever.
static SPARE: Mutex<Vec<Coefficients>> = Mutex::new(Vec::new());

/// Slip in `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`; in both precisions.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    pub(super) double: [Vec<f64>; 3],
    pub(super) single: [Vec<f32>; 3],
}

impl Coefficients {
    /// So many of each in double precision, of any value: all are to be written.
    pub(super) fn with_length(entries: usize) -> Self {
        let mut room = Self::kept(entries).unwrap_or_default();
        room.double.iter_mut().for_each(|of| resize(of, entries));
        room
    }

    /// The same with as many in single precision.
    pub(super) fn with_single(mut self) -> Self {
        let entries = self.double[0].len();
        self.single.iter_mut().for_each(|of| resize(of, entries));
        self
    }

    /// The smallest kept set that has room for so many.
    fn kept(entries: usize) -> Option<Self> {
        let mut kept = SPARE.try_lock().ok()?;
        let fitting = kept.iter().enumerate().filter(|(_, one)| one.capacity() >= entries);
        let (index, _) = fitting.min_by_key(|(_, one)| one.capacity())?;
        Some(kept.swap_remove(index))
    }

    fn capacity(&self) -> usize {
        self.double[0].capacity()
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
        if !(1..=LARGEST).contains(&self.capacity()) {
            return;
        }
        let Ok(mut kept) = SPARE.try_lock() else { return };
        if kept.len() == KEPT {
            kept.remove(0);
        }
        kept.push(self);
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
