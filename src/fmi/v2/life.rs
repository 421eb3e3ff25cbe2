//! Making, initializing and ending instances.

use std::ffi::{CStr, c_int};
use std::ptr::null_mut;

use super::callback::Callback;
use super::calls;
use super::types::{
    Boolean, CO_SIMULATION, CallbackFunctions, Component, FALSE, MODEL_EXCHANGE, Status, Text,
};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::text;
use crate::fmi::both;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{self, Request, guard};
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
    let name = if instance_name.is_null() {
        c""
    } else {
        // SAFETY: FMI 2.0, 2.1.2: a text is null-terminated; it was checked for null.
        unsafe { CStr::from_ptr(instance_name) }
    };
    // SAFETY: FMI 2.0, 2.1.2 and 2.1.5: both arguments are texts; the location may be null.
    let (guid, resource_location) = unsafe {
        let location = if resource_location.is_null() {
            Ok("")
        } else {
            text("fmuResourceLocation", resource_location)
        };
        (text("fmuGUID", guid), location)
    };
    let purpose = match fmu_type {
        MODEL_EXCHANGE => Ok(Purpose::ModelExchange),
        CO_SIMULATION => Ok(Purpose::CoSimulation),
        other => Err(FmiError::WrongFmuType(other)),
    };
    let callback = Callback::of(&functions, name.into());
    let logger = Logger::new(callback, Interface::V2, logging_on != FALSE);
    let request = Request {
        call: calls::INSTANTIATE,
        instance_name: name,
        purpose,
        identity: guid,
        location: resource_location,
    };
    guard::instantiate(request, logger)
}

/// `fmi2FreeInstance`: null, freed and forged handles do nothing.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2FreeInstance(component: Component) {
    guard::free(component);
}

/// `fmi2SetDebugLogging`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: Component,
    logging_on: Boolean,
    count: usize,
    categories: *const Text,
) -> Status {
    let (call, on) = (calls::SET_DEBUG_LOGGING, logging_on != FALSE);
    // SAFETY: FMI 2.0, 2.1.5: `categories` holds `nCategories` texts.
    unsafe { both::set_debug_logging(call, component, on, count, categories) }
}

/// `fmi2SetupExperiment`: the tolerance is checked and not used, there is nothing to integrate.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetupExperiment(
    component: Component,
    tolerance_defined: Boolean,
    tolerance: f64,
    start_time: f64,
    stop_time_defined: Boolean,
    stop_time: f64,
) -> Status {
    guard(component, calls::SETUP_EXPERIMENT, |instance, _| {
        let stop = (stop_time_defined != FALSE).then_some(stop_time);
        let tolerance = (tolerance_defined != FALSE).then_some(tolerance);
        on_instance!(instance, |i| i.setup_experiment(tolerance, start_time, stop))?;
        Ok(Status::Ok)
    })
}

/// `fmi2EnterInitializationMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterInitializationMode(component: Component) -> Status {
    guard(component, calls::ENTER_INITIALIZATION, |instance, _| {
        on_instance!(instance, |i| i.enter_initialization())?;
        Ok(Status::Ok)
    })
}

/// `fmi2ExitInitializationMode`: loads the profiles; if one of them cannot be had, the mode is not
/// left.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2ExitInitializationMode(component: Component) -> Status {
    both::exit_initialization(calls::EXIT_INITIALIZATION, component)
}

/// `fmi2Terminate`: writes worn profiles, where that is asked for; if one cannot be written, the
/// run is not ended.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Terminate(component: Component) -> Status {
    both::terminate(calls::TERMINATE, component)
}

/// `fmi2Reset`: as after `fmi2Instantiate`; log categories stay.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Reset(component: Component) -> Status {
    both::reset(calls::RESET, component)
}
