//! The table of instances.
//!
//! What the host holds as `fmi2Component` is a number made of a place in this table and the place's
//! generation. It is never dereferenced, so that null, freed and forged ones are found out.

use std::sync::{Arc, Mutex, PoisonError, RwLock};

use super::instance::Instance;
use super::logger::Logger;
use super::types::Component;

/// An instance as the table holds it.
#[derive(Debug)]
pub struct Entry {
    /// Outside the lock, so that a refusal can be explained at any time.
    pub logger: Logger,
    /// The instance; locked for the length of a call.
    pub instance: Mutex<Instance>,
}

#[derive(Debug)]
struct Slot {
    generation: usize,
    entry: Option<Arc<Entry>>,
}

static SLOTS: RwLock<Vec<Slot>> = RwLock::new(Vec::new());

/// Half of the bits for the place plus one, half for the generation.
const PLACE_BITS: u32 = usize::BITS / 2;
const PLACE_MASK: usize = (1 << PLACE_BITS) - 1;
/// Generations start here, so that small numbers are no handles.
const FIRST_GENERATION: usize = 0x2a5b;

/// Puts an instance into the table; `None` if the table is full.
pub fn insert(entry: Entry) -> Option<Component> {
    let mut slots = SLOTS.write().unwrap_or_else(PoisonError::into_inner);
    let free = slots.iter().position(|slot| slot.entry.is_none());
    let place = free.unwrap_or_else(|| {
        slots.push(Slot { generation: FIRST_GENERATION, entry: None });
        slots.len() - 1
    });
    if place >= PLACE_MASK {
        return None;
    }
    let slot = &mut slots[place];
    slot.entry = Some(Arc::new(entry));
    Some(std::ptr::without_provenance_mut(slot.generation << PLACE_BITS | (place + 1)))
}

/// The instance of a handle, if there is one. Only reads the table and allocates nothing.
#[inline]
pub fn find(component: Component) -> Option<Arc<Entry>> {
    let (place, generation) = parts(component)?;
    let slots = SLOTS.read().unwrap_or_else(PoisonError::into_inner);
    let slot = slots.get(place)?;
    if slot.generation == generation { slot.entry.clone() } else { None }
}

/// Takes an instance out of the table. A call under way keeps it until it ends.
pub fn remove(component: Component) -> Option<Arc<Entry>> {
    let (place, generation) = parts(component)?;
    let mut slots = SLOTS.write().unwrap_or_else(PoisonError::into_inner);
    let slot = slots.get_mut(place).filter(|slot| slot.generation == generation)?;
    let entry = slot.entry.take()?;
    slot.generation = slot.generation.wrapping_add(1) & PLACE_MASK;
    Some(entry)
}

fn parts(component: Component) -> Option<(usize, usize)> {
    let number = component.addr();
    Some(((number & PLACE_MASK).checked_sub(1)?, number >> PLACE_BITS))
}
