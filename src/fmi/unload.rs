//! What is given back when a host unloads the library.
//!
//! By a function in the section that the loader of Linux calls: `atexit` would do, but zig's glibc
//! calls what a library has given to it at the end of the process, when the library may be gone.
//! Elsewhere the memory of the tables stays, as that of any static variable does.
#![allow(unsafe_code)]

use std::sync::atomic::{AtomicBool, Ordering};

/// Whether an instance was ever made: a program that works with elements alone may end while its
/// other threads still calculate.
static SERVES_A_HOST: AtomicBool = AtomicBool::new(false);

/// Takes note that instances are made, at whose end memory may be given back.
pub fn expect() {
    SERVES_A_HOST.store(true, Ordering::Relaxed);
}

#[cfg(target_os = "linux")]
mod on_linux {
    use super::{Ordering, SERVES_A_HOST};
    use crate::fmi::handle;
    use crate::math::until_unload::give_back_all;

    /// The loader calls what is in this section when it unloads the library, and at the end of the
    /// process.
    #[used]
    // SAFETY: the section holds pointers to such functions.
    #[unsafe(link_section = ".fini_array")]
    static AT_UNLOAD: extern "C" fn() = at_unload;

    /// Gives back the tables that all instances share.
    ///
    /// A process may end while other threads still calculate: where an instance is left, nothing is
    /// touched.
    extern "C" fn at_unload() {
        if SERVES_A_HOST.load(Ordering::Relaxed) && handle::forget_if_empty() {
            // SAFETY: all that calculates in a unit is an instance, and there is none and will be
            // none: the library is being unloaded, or the process ends.
            unsafe { give_back_all() };
        }
    }
}
