//! Where the messages of an instance go.
#![allow(unsafe_code)]

use std::ffi::{CStr, c_int};
use std::sync::{Mutex, PoisonError};

use wheelrail::fmi::v2::types::{CallbackLogger, ComponentEnvironment, Status, Text};

/// Of a step that went well, and of one that went on with a remark.
pub const OK: c_int = Status::Ok as c_int;
pub const WARNING: c_int = Status::Warning as c_int;

/// [`log`] with the arguments that it takes of a [`CallbackLogger`].
type Logger = unsafe extern "C" fn(ComponentEnvironment, Text, c_int, Text, Text, Text);

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

/// [`log`] for the callbacks of an instance.
pub fn callback() -> CallbackLogger {
    // SAFETY: both are pointers to functions of C. The unit calls with the fixed arguments and, for
    // "%s", with one more, which is where the last one of `log` is; else `log` does not read it.
    unsafe { std::mem::transmute::<Logger, CallbackLogger>(log) }
}

/// `fmi2CallbackLogger`. `environment` is the [`Messages`] of the instance.
///
/// The standard's logger takes a format and any number of arguments. Rust cannot define such a
/// function; one argument is taken, which is what a unit sends that passes its messages through
/// `"%s"`. Other formats are taken as messages without arguments.
unsafe extern "C" fn log(
    environment: ComponentEnvironment,
    _instance_name: Text,
    status: c_int,
    _category: Text,
    message: Text,
    first_argument: Text,
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
