//! Making and freeing instances.

use std::ffi::c_int;
use std::ptr::null_mut;

use super::types::{
    Boolean, CO_SIMULATION, CallbackFunctions, Component, FALSE, MODEL_EXCHANGE, Text,
};
use crate::fmi::arguments::{name, text, text_or_empty};
use crate::fmi::callback::Callback;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{self, Call, NEVER, Request};
use crate::fmi::interface::Interface;
use crate::fmi::life_cycle::Purpose;
use crate::fmi::logger::Logger;

/// `fmi2GetTypesPlatform`: the types of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> Text {
    c"default".as_ptr()
}

/// `fmi2GetVersion`: of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> Text {
    c"2.0".as_ptr()
}

/// `fmi2Instantiate`: null, explained to the logger, if an argument is not good.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: Text,
    fmu_type: c_int,
    guid: Text,
    resource_location: Text,
    functions: *const CallbackFunctions,
    _visible: Boolean,
    logging_on: Boolean,
) -> Component {
    if functions.is_null() || !functions.is_aligned() {
        return null_mut();
    }
    // SAFETY: FMI 2.0, 2.1.5: the struct of callback functions is there and filled in; it was
    // checked for null. Its functions stay callable as long as the instance lives.
    let functions = unsafe { *functions };
    // SAFETY: FMI 2.0, 2.1.2 and 2.1.5: all three are texts or null.
    let (instance_name, identity, location) = unsafe {
        let location = text_or_empty("fmuResourceLocation", resource_location);
        (name(instance_name), text("fmuGUID", guid), location)
    };
    let purpose = match fmu_type {
        MODEL_EXCHANGE => Ok(Purpose::ModelExchange),
        CO_SIMULATION => Ok(Purpose::CoSimulation),
        other => Err(FmiError::WrongFmuType(other)),
    };
    let environment = functions.component_environment;
    let callback = functions.logger.map(|l| Callback::v2(l, environment, instance_name.into()));
    let logger = Logger::new(callback, Interface::V2, logging_on != FALSE);
    let call = Call::new(Interface::V2, "fmi2Instantiate", NEVER);
    guard::instantiate(Request { call, instance_name, purpose, identity, location }, logger)
}

/// `fmi2FreeInstance`: null, freed and forged handles do nothing.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2FreeInstance(component: Component) {
    guard::free(component);
}
