//! What is given back when a host unloads the library.
#![allow(unsafe_code)]

use std::sync::Once;

use super::handle;
use crate::math::until_unload::give_back_all;

/// Asks the system to call [`at_unload`] when this library is unloaded, or at the end of the
/// process; once.
pub fn expect() {
    static ASKED: Once = Once::new();
    ASKED.call_once(|| {
        // Without room for one more such function the memory stays, as that of any static variable.
        // SAFETY: a function of the library that calls it is called before the library goes.
        let _ = unsafe { libc::atexit(at_unload) };
    });
}

/// Gives back the tables that all instances share.
///
/// A process may end while other threads still calculate: where an instance is left, nothing is
/// touched.
extern "C" fn at_unload() {
    if handle::forget_if_empty() {
        // SAFETY: all that calculates in a unit is an instance, and there is none and will be none:
        // the library is being unloaded, or the process ends.
        unsafe { give_back_all() };
    }
}
