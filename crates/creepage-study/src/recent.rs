//! Cache of the values that were asked for last, by their keys.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The last few values by their keys; each is made once, and whoever else asks for it meanwhile waits.
#[derive(Debug)]
pub(crate) struct Recent<K, V> {
    entries: Mutex<VecDeque<(K, Slot<V>)>>,
    most: fn() -> usize,
}

type Slot<V> = Arc<OnceLock<Arc<V>>>;

impl<K, V> Recent<K, V> {
    /// Keeps as many as `most` says when there is a new one.
    pub(crate) fn new(most: fn() -> usize) -> Self {
        Self { entries: Mutex::default(), most }
    }

    /// How many are kept.
    #[cfg(test)]
    pub(crate) fn count(&self) -> usize {
        self.entries.lock().unwrap_or_else(PoisonError::into_inner).len()
    }
}

impl<K: PartialEq + Clone, V> Recent<K, V> {
    /// The value of a key, as it was made or as it is now.
    pub(crate) fn of(&self, key: &K, make: impl FnOnce() -> V) -> Arc<V> {
        let slot = self.slot(key);
        Arc::clone(slot.get_or_init(|| Arc::new(make())))
    }

    /// The value of a key, if it is there: whoever makes what is not needs not wait for others, but may make it twice.
    pub(crate) fn find(&self, key: &K) -> Option<Arc<V>> {
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        let place = entries.iter().position(|(known, _)| known == key)?;
        let entry = entries.remove(place)?;
        let value = entry.1.get().cloned();
        entries.push_back(entry);
        value
    }

    /// Keeps a value, unless there is one of its key by now: that, else.
    pub(crate) fn keep(&self, key: &K, value: V) -> Arc<V> {
        self.of(key, || value)
    }

    /// The place of a key; the one not asked for the longest gives way to a new one.
    fn slot(&self, key: &K) -> Slot<V> {
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        let place = entries.iter().position(|(known, _)| known == key);
        let entry = place.and_then(|place| entries.remove(place));
        let (key, slot) = entry.unwrap_or_else(|| (key.clone(), Slot::default()));
        if entries.len() >= (self.most)().max(1) {
            entries.pop_front();
        }
        entries.push_back((key, Arc::clone(&slot)));
        slot
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    #[test]
    fn the_value_not_asked_for_the_longest_gives_way() {
        let made = AtomicUsize::new(0);
        let recent = Recent::new(|| 3);
        let ask = |key: u32| {
            *recent.of(&key, || {
                made.fetch_add(1, Ordering::Relaxed);
                10 * key
            })
        };
        for key in [1, 2, 3, 1, 4, 1, 3] {
            assert_eq!(ask(key), 10 * key);
        }
        // 2 gave way to 4; 1 and 3 were there.
        assert_eq!((made.load(Ordering::Relaxed), recent.count()), (4, 3));
        ask(2);
        assert_eq!(made.load(Ordering::Relaxed), 5);
        assert_eq!((recent.find(&2).as_deref(), recent.find(&9)), (Some(&20), None));
        assert_eq!((*recent.keep(&2, 7), *recent.keep(&9, 90)), (20, 90));
    }

    /// Many threads that ask for one value wait for whoever makes it.
    #[test]
    fn a_value_is_made_once() {
        let (made, recent) = (AtomicUsize::new(0), Recent::new(|| 2));
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    recent.of(&"one", || {
                        std::thread::sleep(std::time::Duration::from_millis(10));
                        made.fetch_add(1, Ordering::Relaxed)
                    })
                });
            }
        });
        assert_eq!(made.load(Ordering::Relaxed), 1);
    }
}
