//! The functions of the C interface that the importer calls.
#![allow(unsafe_code)]

use std::ffi::{c_char, c_int, c_uint};

use anyhow::{Context, Result};
use libloading::Library;
use wheelrail::fmi::v2::types::{CallbackFunctions, Component};

/// `fmi2Status` as a number: a library may return any.
pub type Status = c_int;

type SetMany<T> = unsafe extern "C" fn(Component, *const c_uint, usize, *const T) -> Status;
pub type GetMany<T> = unsafe extern "C" fn(Component, *const c_uint, usize, *mut T) -> Status;
type Transition = unsafe extern "C" fn(Component) -> Status;

/// Declares the structure of function pointers and how it is filled from the library.
macro_rules! functions {
    ($($field:ident: $symbol:literal as $type:ty;)+) => {
        /// Function pointers into the library of a unit; valid as long as the library is loaded.
        pub struct Functions {
            $(#[doc = concat!("`", $symbol, "`.")] pub $field: $type,)+
        }

        impl Functions {
            /// Looks up every function.
            pub fn of(library: &Library) -> Result<Self> {
                Ok(Self {
                    $($field: {
                        // SAFETY: the types are those of FMI 2.0, 2.1 and 4.2, for the function of
                        // that name.
                        *unsafe { library.get::<$type>($symbol) }
                            .with_context(|| format!("the unit does not export {}", $symbol))?
                    },)+
                })
            }
        }
    };
}

functions! {
    instantiate: "fmi2Instantiate" as unsafe extern "C" fn(
        *const c_char, c_int, *const c_char, *const c_char, *const CallbackFunctions, c_int, c_int,
    ) -> Component;
    free_instance: "fmi2FreeInstance" as unsafe extern "C" fn(Component);
    setup_experiment: "fmi2SetupExperiment" as
        unsafe extern "C" fn(Component, c_int, f64, f64, c_int, f64) -> Status;
    enter_initialization_mode: "fmi2EnterInitializationMode" as Transition;
    exit_initialization_mode: "fmi2ExitInitializationMode" as Transition;
    terminate: "fmi2Terminate" as Transition;
    set_real: "fmi2SetReal" as SetMany<f64>;
    set_integer: "fmi2SetInteger" as SetMany<c_int>;
    set_boolean: "fmi2SetBoolean" as SetMany<c_int>;
    set_string: "fmi2SetString" as SetMany<*const c_char>;
    get_real: "fmi2GetReal" as GetMany<f64>;
    get_integer: "fmi2GetInteger" as GetMany<c_int>;
    get_string: "fmi2GetString" as GetMany<*const c_char>;
    do_step: "fmi2DoStep" as unsafe extern "C" fn(Component, f64, f64, c_int) -> Status;
}
