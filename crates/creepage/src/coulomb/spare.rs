//! Memory that is used again.
//!
//! Pages fresh from the system cost half as much as what is computed into them, and shapes come in
//! series: what was dropped last is kept, for all threads, for one may drop what another prepared.

use std::sync::Mutex;

/// Pieces kept: two grids of each contact of a wheelset, while the next ones are made.
const KEPT: usize = 8;

/// Pieces of memory that are not in use, each with its size.
pub(super) struct Spare<T> {
    /// Nobody waits for it: new memory costs less, and a process forked off would wait for ever.
    pieces: Mutex<Vec<(usize, T)>>,
    /// Size of the largest piece that is kept.
    largest: usize,
}

impl<T> Spare<T> {
    pub(super) const fn up_to(largest: usize) -> Self {
        Self { pieces: Mutex::new(Vec::new()), largest }
    }

    /// The smallest piece that is as large.
    pub(super) fn take(&self, size: usize) -> Option<T> {
        let mut pieces = self.pieces.try_lock().ok()?;
        let fitting = pieces.iter().enumerate().filter(|(_, (own, _))| *own >= size);
        let (index, _) = fitting.min_by_key(|(_, (own, _))| *own)?;
        Some(pieces.swap_remove(index).1)
    }

    /// Keeps a piece, and drops the one that was kept first where there are many.
    pub(super) fn keep(&self, size: usize, piece: T) {
        if !(1..=self.largest).contains(&size) {
            return;
        }
        let Ok(mut pieces) = self.pieces.try_lock() else { return };
        if pieces.len() == KEPT {
            pieces.remove(0);
        }
        pieces.push((size, piece));
    }
}

/// So many times a value, in the memory of other numbers.
pub(crate) fn refill<T: Clone>(mut of: Vec<T>, count: usize, value: T) -> Vec<T> {
    of.clear();
    of.resize(count, value);
    of
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_piece_that_is_large_enough_is_used_again() {
        let spare = Spare::up_to(100);
        for size in [30, 10, 20, 0, 101] {
            spare.keep(size, size);
        }
        assert_eq!(spare.take(15), Some(20));
        assert_eq!(spare.take(15), Some(30));
        assert_eq!(spare.take(15), None);
        assert_eq!(spare.take(0), Some(10));
    }

    #[test]
    fn few_pieces_are_kept_and_the_first_goes_first() {
        let spare = Spare::up_to(100);
        (1..=KEPT + 1).for_each(|size| spare.keep(size, size));
        assert_eq!(spare.take(1), Some(2));
    }
}
