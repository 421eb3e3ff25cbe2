//! One solver for all who share a model, behind a lock, so that no step allocates.

use std::sync::{Mutex, MutexGuard, PoisonError};

use super::solver::TractionStrips;

/// A solver for whoever has the model; whoever comes while it is in use waits.
#[derive(Debug)]
pub struct Scratch(Mutex<Box<TractionStrips>>);

impl Scratch {
    /// As [`TractionStrips::new`].
    #[must_use]
    pub fn new(points: usize, strips: usize) -> Self {
        Self(Mutex::new(Box::new(TractionStrips::new(points, strips))))
    }

    /// The solver. It keeps no result, so that one left in the middle of a solution is as good.
    pub fn lend(&self) -> MutexGuard<'_, Box<TractionStrips>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for Scratch {
    fn clone(&self) -> Self {
        Self(Mutex::new(self.lend().clone()))
    }
}
