//! Coefficients, in memory that is used again.
//!
//! Pages fresh from the system cost half as much as what is computed into them, and shapes come in
//! series: each thread keeps what it dropped last.

use std::cell::RefCell;

/// Sets that a thread keeps: two grids of a contact, while the next two are made.
const KEPT: usize = 4;
/// Largest number of entries of a set that is kept: of some 16 MB.
const LARGEST: usize = 450_000;

thread_local! {
    static SPARE: RefCell<Vec<Coefficients>> = const { RefCell::new(Vec::new()) };
}

/// Slip in `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`; in both precisions.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    pub(super) double: [Vec<f64>; 3],
    pub(super) single: [Vec<f32>; 3],
}

impl Coefficients {
    /// So many of each in double precision, of any value: all are to be written.
    pub(super) fn with_length(entries: usize) -> Self {
        let fits = |kept: &Self| kept.capacity() >= entries;
        let take = |kept: &RefCell<Vec<Self>>| {
            let mut kept = kept.borrow_mut();
            let index = kept.iter().position(fits)?;
            Some(kept.swap_remove(index))
        };
        let mut room = SPARE.try_with(take).ok().flatten().unwrap_or_default();
        for of in &mut room.double {
            if of.capacity() < entries {
                *of = vec![0.0; entries];
            } else {
                of.resize(entries, 0.0);
            }
        }
        room
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
        let give = |kept: &RefCell<Vec<Self>>| {
            let mut kept = kept.borrow_mut();
            if kept.len() == KEPT {
                kept.remove(0);
            }
            kept.push(self);
        };
        // A thread that ends keeps nothing.
        let _ = SPARE.try_with(give);
    }
}
