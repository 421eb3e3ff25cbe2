//! A table whose places are handed to the host as pointers that are never dereferenced.

use std::ffi::c_void;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What the host holds: a place in a table and the generation of what was put there.
pub type Key = *mut c_void;

/// A table of entries; null, removed and forged keys, and those of other tables, are found out.
#[derive(Debug)]
pub struct Slots<T>(Vec<Slot<T>>);

#[derive(Debug)]
struct Slot<T> {
    generation: usize,
    entry: Option<T>,
}

/// Half of the bits for the place plus one, half for the generation.
const PLACE_BITS: u32 = usize::BITS / 2;
const PLACE_MASK: usize = (1 << PLACE_BITS) - 1;

/// Generations are counted over all tables, from a number so great that small numbers are no keys.
static GENERATIONS: AtomicUsize = AtomicUsize::new(0x2a5b);

impl<T> Slots<T> {
    /// A table without entries.
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Puts an entry into the table; `None` if the table is full.
    pub fn insert(&mut self, entry: T) -> Option<Key> {
        let generation = GENERATIONS.fetch_add(1, Ordering::Relaxed) & PLACE_MASK;
        let free = self.0.iter().position(|slot| slot.entry.is_none());
        let place = free.unwrap_or(self.0.len());
        if place >= PLACE_MASK {
            return None;
        }
        let slot = Slot { generation, entry: Some(entry) };
        if place < self.0.len() {
            self.0[place] = slot;
        } else {
            self.0.push(slot);
        }
        Some(std::ptr::without_provenance_mut(generation << PLACE_BITS | (place + 1)))
    }

    /// The entry of a key, if there is one; allocates nothing.
    #[inline]
    pub fn get(&self, key: Key) -> Option<&T> {
        let (place, generation) = parts(key)?;
        self.0.get(place).filter(|slot| slot.generation == generation)?.entry.as_ref()
    }

    /// The entry of a key to be changed.
    pub fn get_mut(&mut self, key: Key) -> Option<&mut T> {
        let (place, generation) = parts(key)?;
        self.0.get_mut(place).filter(|slot| slot.generation == generation)?.entry.as_mut()
    }

    /// Whether there is no entry.
    #[cfg(target_os = "linux")]
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(|slot| slot.entry.is_none())
    }

    /// Takes an entry out of the table.
    pub fn remove(&mut self, key: Key) -> Option<T> {
        let (place, generation) = parts(key)?;
        self.0.get_mut(place).filter(|slot| slot.generation == generation)?.entry.take()
    }
}

fn parts(key: Key) -> Option<(usize, usize)> {
    let number = key.addr();
    Some(((number & PLACE_MASK).checked_sub(1)?, number >> PLACE_BITS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_good_for_its_own_entry_alone() {
        let (mut one, mut other) = (Slots::new(), Slots::new());
        let key = one.insert('a').unwrap();
        let foreign = other.insert('b').unwrap();
        assert_eq!((one.get(key), one.get(foreign)), (Some(&'a'), None));
        assert_eq!(one.remove(key), Some('a'));
        assert_eq!(one.remove(key), None);
        let again = one.insert('c').unwrap();
        assert_ne!(again, key);
        assert_eq!((one.get(key), one.get(again)), (None, Some(&'c')));
    }
}
