//! Values that are made once in a process and stay until its end, or until the library that holds
//! them is unloaded.
//!
//! A static variable is never dropped: what it has on the heap would stay behind each time a host
//! loads the library, runs it and unloads it.
#![allow(unsafe_code)]

use std::sync::{Mutex, OnceLock, PoisonError};

/// A value that is made on first use.
#[derive(Debug)]
pub struct UntilUnload<T: 'static>(OnceLock<&'static T>);

/// A value on the heap and how to give its memory back.
struct Made {
    place: *mut (),
    give_back: unsafe fn(*mut ()),
}

// SAFETY: only values that any thread may use and drop get into the list, see `get_or_init`.
unsafe impl Send for Made {}

/// All values of this library.
static MADE: Mutex<Vec<Made>> = Mutex::new(Vec::new());

impl<T: Send + Sync + 'static> UntilUnload<T> {
    /// Nothing yet.
    #[allow(clippy::new_without_default, reason = "statics need a constant")]
    pub const fn new() -> Self {
        Self(OnceLock::new())
    }

    /// The value, made by `make` if there is none.
    pub fn get_or_init(&self, make: impl FnOnce() -> T) -> &'static T {
        /// # Safety
        /// `place` is a box of this type that nobody uses any more.
        unsafe fn give_back<T>(place: *mut ()) {
            // SAFETY: the caller's promise.
            drop(unsafe { Box::from_raw(place.cast::<T>()) });
        }
        self.0.get_or_init(|| {
            let place = Box::into_raw(Box::new(make()));
            let made = Made { place: place.cast(), give_back: give_back::<T> };
            MADE.lock().unwrap_or_else(PoisonError::into_inner).push(made);
            // SAFETY: the box is well until `give_back_all`, after which nothing is asked for.
            unsafe { &*place }
        })
    }
}

/// Gives back the memory of all values; systems without a call at unloading never do.
///
/// # Safety
/// Nobody uses one of the values any more or asks for one: the library is about to be unloaded.
#[cfg_attr(not(target_os = "linux"), allow(dead_code))]
pub unsafe fn give_back_all() {
    let made = std::mem::take(&mut *MADE.lock().unwrap_or_else(PoisonError::into_inner));
    for Made { place, give_back } in made {
        // SAFETY: each box is in the list once; the caller's promise.
        unsafe { give_back(place) };
    }
}
