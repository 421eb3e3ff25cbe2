//! Where the messages of an instance go.
#![allow(unsafe_code)]

use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::{Mutex, PoisonError};

/// `fmi2Status` of a step that went well.
pub const OK: c_int = 0;
/// `fmi2Status` of a step that went on with a remark.
pub const WARNING: c_int = 1;

/// Messages kept of one instance; later ones are dropped, the first tell the cause.
const KEPT: usize = 100;

/// The messages of one instance, in the order of arrival.
#[derive(Debug, Default)]
pub struct Messages(Mutex<Vec<String>>);

impl Messages {
    /// Hands out the messages so far and forgets them.
    pub fn take(&self) -> Vec<String> {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn push(&self, message: String) {
        let mut messages = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if messages.len() < KEPT {
            messages.push(message);
        }
    }
}

/// `fmi2CallbackLogger`. `environment` is the [`Messages`] of the instance.
///
/// The standard's logger takes a format and any number of arguments. Rust cannot define such a
/// function; one argument is taken, which is what a unit sends that passes its messages through
/// `"%s"`. Other formats are taken as messages without arguments.
pub unsafe extern "C" fn log(
    environment: *mut c_void,
    _instance_name: *const c_char,
    status: c_int,
    _category: *const c_char,
    message: *const c_char,
    first_argument: *const c_char,
) {
    if status == OK || environment.is_null() || message.is_null() {
        return;
    }
    // SAFETY: FMI 2.0, 2.1.5: the unit hands back the componentEnvironment of the callbacks, which
    // outlive the instance (`Instance` owns both).
    let messages = unsafe { &*environment.cast::<Messages>() };
    // SAFETY: FMI 2.0, 2.1.5: message is a null-terminated string.
    let format = unsafe { CStr::from_ptr(message) };
    // Variable arguments of 64-bit Arm under macOS are not where a fixed one would be.
    let reads_arguments = cfg!(not(all(target_vendor = "apple", target_arch = "aarch64")));
    let one_text = format == c"%s" && reads_arguments && !first_argument.is_null();
    let text = if one_text {
        // SAFETY: the format announces one null-terminated string.
        unsafe { CStr::from_ptr(first_argument) }.to_string_lossy()
    } else {
        // Without arguments a doubled percent sign is all that a format can hold.
        format.to_string_lossy().replace("%%", "%").into()
    };
    let severity = if status == WARNING { "warning" } else { "error" };
    messages.push(format!("{severity}: {}", text.trim_end()));
}
