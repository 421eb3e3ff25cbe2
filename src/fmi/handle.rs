//! The table of instances.
//!
//! What the host holds as `fmi2Component` is a key of this table. It is never dereferenced, so that
//! null, freed and forged ones are found out.

use std::sync::{Arc, Mutex, PoisonError, RwLock};

use super::any_instance::AnyInstance;
use super::logger::Logger;
use super::slots::Slots;
use super::types::Component;

/// An instance as the table holds it.
#[derive(Debug)]
pub struct Entry {
    /// Outside the lock, so that a refusal can be explained at any time.
    pub logger: Logger,
    /// The instance; locked for the length of a call.
    pub instance: Mutex<AnyInstance>,
}

static INSTANCES: RwLock<Slots<Arc<Entry>>> = RwLock::new(Slots::new());

/// Puts an instance into the table; `None` if the table is full.
pub fn insert(entry: Entry) -> Option<Component> {
    INSTANCES.write().unwrap_or_else(PoisonError::into_inner).insert(Arc::new(entry))
}

/// The instance of a handle, if there is one. Only reads the table and allocates nothing.
#[inline]
pub fn find(component: Component) -> Option<Arc<Entry>> {
    INSTANCES.read().unwrap_or_else(PoisonError::into_inner).get(component).cloned()
}

/// Gives back the memory of the table if no instance is in it; whether that is so.
#[cfg(target_os = "linux")]
pub fn forget_if_empty() -> bool {
    // Whoever holds the lock now has an instance.
    let Ok(mut table) = INSTANCES.try_write() else { return false };
    let is_empty = table.is_empty();
    if is_empty {
        *table = Slots::new();
    }
    is_empty
}

/// Takes an instance out of the table. A call under way keeps it until it ends.
pub fn remove(component: Component) -> Option<Arc<Entry>> {
    INSTANCES.write().unwrap_or_else(PoisonError::into_inner).remove(component)
}
