//! Lists that are filled anew in every evaluation without allocating.

use std::ops::{Deref, DerefMut};

/// A list with room set aside; unlike that of a plain `Vec`, its clone has as much room.
#[derive(Debug, Default)]
pub struct FixedVec<T>(Vec<T>);

impl<T> FixedVec<T> {
    /// An empty list with room for `count` items.
    pub fn new(count: usize) -> Self {
        Self(Vec::with_capacity(count))
    }
}

impl<T: Clone> Clone for FixedVec<T> {
    fn clone(&self) -> Self {
        let mut copy = Self::new(self.0.capacity());
        copy.0.extend_from_slice(&self.0);
        copy
    }
}

impl<T> Deref for FixedVec<T> {
    type Target = Vec<T>;

    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T> DerefMut for FixedVec<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clone_has_the_items_and_the_room() {
        let mut list = FixedVec::new(7);
        list.push(1);
        let copy = list.clone();
        assert_eq!(*copy, vec![1]);
        assert!(copy.capacity() >= 7);
    }
}
