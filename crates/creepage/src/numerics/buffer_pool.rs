//! Pool of buffers that are used again.
//!
//! Pages fresh from the system cost half as much as what is computed into them, and contacts come in series:
//! what was dropped last is kept, for all threads, for one may drop what another prepared.

use std::sync::Mutex;

/// Vectors kept: those of a wheelset's contacts on two grids, while the next ones are made.
const MAX_BUFFERS: usize = 32;
/// Largest size of a vector that is kept, and of all of one kind, in bytes.
const MAX_SIZE: usize = 12_000_000;
const MAX_OF_ALL: usize = 64_000_000;

/// Pool of unused vectors, with what was in them. Nobody waits for them: new memory costs less, and a process
/// forked off would wait for ever.
pub(crate) struct BufferPool<T>(Mutex<Vec<Vec<T>>>);

impl<T> BufferPool<T> {
    pub(crate) const fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    /// A vector with room for so many, and anything in it: the smallest that is kept and has it, or a new one.
    pub(crate) fn take(&self, room: usize) -> Vec<T> {
        self.kept(room).unwrap_or_else(|| Vec::with_capacity(room))
    }

    fn kept(&self, room: usize) -> Option<Vec<T>> {
        let mut kept = self.0.try_lock().ok()?;
        let fitting = kept.iter().enumerate().filter(|(_, one)| one.capacity() >= room);
        let (index, _) = fitting.min_by_key(|(_, one)| one.capacity())?;
        Some(kept.swap_remove(index))
    }

    /// Keeps the memory of a vector.
    pub(crate) fn keep(&self, one: Vec<T>) {
        let size = |one: &Vec<T>| one.capacity() * size_of::<T>();
        if !(1..=MAX_SIZE).contains(&size(&one)) {
            return;
        }
        let Ok(mut kept) = self.0.try_lock() else { return };
        kept.push(one);
        while kept.len() > MAX_BUFFERS || kept.iter().map(size).sum::<usize>() > MAX_OF_ALL {
            kept.remove(0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_that_fits_is_taken() {
        let spare = BufferPool::new();
        for size in [30, 10, 20] {
            spare.keep(vec![1.0; size]);
        }
        spare.keep(Vec::<f64>::new());
        let sizes = [15, 15, 15, 5].map(|room| spare.take(room).capacity());
        assert!(sizes[2] >= 15 && sizes == [20, 30, sizes[2], 10], "{sizes:?}");
        spare.keep(Vec::with_capacity(MAX_SIZE));
        (0..=MAX_BUFFERS).for_each(|_| spare.keep(vec![0.0; 3]));
        assert_eq!(spare.0.lock().unwrap().len(), MAX_BUFFERS);
        (0..=MAX_BUFFERS).for_each(|_| spare.keep(Vec::with_capacity(MAX_SIZE / 8)));
        assert_eq!(spare.0.lock().unwrap().len(), MAX_OF_ALL / MAX_SIZE);
    }
}
