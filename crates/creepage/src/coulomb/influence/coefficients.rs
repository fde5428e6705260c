//! Coefficients, in memory that is used again.
//!
//! Pages fresh from the system cost half as much as what is computed into them, and shapes come in
//! series: what was dropped last is kept, for all threads, for one may drop what another prepared.

use std::sync::Mutex;

use super::layout::{BLOCK, Layout};

/// Sets kept: two grids of each contact of a wheelset, while the next ones are made.
const KEPT: usize = 8;
/// Largest number of entries of a set that is kept: of some 16 MB.
const LARGEST: usize = 1_350_000;

/// Nobody waits for it: new memory costs less, and a process forked off would wait for ever.
static SPARE: Mutex<Vec<Coefficients>> = Mutex::new(Vec::new());

/// Rows of coefficients in both precisions, as [`Product`](crate::coulomb::product::Product) reads them, and
/// the blocks of them that strips have of themselves and of their mirror images.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    pub(super) double: Vec<f64>,
    pub(super) single: Vec<f32>,
    /// In `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`.
    pub(super) blocks: [Vec<f64>; 3],
}

impl Coefficients {
    /// So many entries of rows in double precision and of blocks, of any value: all are to be written.
    pub(super) fn with_length(rows: usize, blocks: usize) -> Self {
        let mut room = Self::kept(rows).unwrap_or_default();
        resize(&mut room.double, rows);
        room.blocks.iter_mut().for_each(|of| resize(of, blocks));
        room
    }

    /// The same with as many in single precision.
    pub(super) fn with_single(mut self) -> Self {
        let entries = self.double.len();
        resize(&mut self.single, entries);
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
        self.double.capacity()
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

/// Room to fold rows.
pub(super) struct Fold {
    /// In `x` by `x`; in `x` by `y` and in `y` by `x`; in `y` by `y`: part by part.
    parts: [Vec<f64>; 3],
}

impl Fold {
    pub(super) fn new(layout: &Layout) -> Self {
        Self { parts: std::array::from_fn(|_| vec![0.0; layout.entries()]) }
    }

    /// Makes of the coefficients of all elements those of the parts, in the order of
    /// [`Product`](crate::coulomb::product::Product).
    pub(super) fn row(&mut self, layout: &Layout, of: [&[f64]; 3], row: &mut [f64]) {
        let parts = &mut self.parts;
        for (parts, of) in parts.iter_mut().zip(of) {
            (0..layout.kept()).for_each(|strip| layout.fold(strip, of, parts));
        }
        let mut to = row.chunks_exact_mut(BLOCK);
        for pair in 0..layout.symmetry.parts() / 2 {
            for block in 0..layout.width / BLOCK {
                for part in [2 * pair, 2 * pair + 1] {
                    let start = part * layout.width + block * BLOCK;
                    for (parts, to) in parts.iter().zip(&mut to) {
                        to.copy_from_slice(&parts[start..start + BLOCK]);
                    }
                }
            }
        }
    }
}
