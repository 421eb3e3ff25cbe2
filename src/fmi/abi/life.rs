//! Making, initializing and ending instances.

use std::ffi::{CStr, c_int};
use std::ptr::null_mut;

use super::arguments::{text, texts};
use crate::fmi::any_instance::on_instance;
use crate::fmi::guard::{self, Call, Request, guard};
use crate::fmi::logger::{Category, Logger};
use crate::fmi::types::{Boolean, CallbackFunctions, Component, FALSE, Status, Text};

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
    // SAFETY: FMI 2.0, 2.1.5: the struct of callback functions is there and filled in; it was checked
    // for null. Its functions stay callable as long as the instance lives.
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
    let logger = Logger::new(&functions, name.into(), logging_on != FALSE);
    guard::instantiate(Request { instance_name: name, fmu_type, guid, resource_location }, logger)
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
    guard(component, Call::SET_DEBUG_LOGGING, |_, logger| {
        // SAFETY: FMI 2.0, 2.1.5: `categories` holds `nCategories` texts.
        let names = unsafe { texts("categories", categories, count)? };
        logger.set_categories(logging_on != FALSE, &names)?;
        Ok(Status::Ok)
    })
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
    guard(component, Call::SETUP_EXPERIMENT, |instance, _| {
        let stop = (stop_time_defined != FALSE).then_some(stop_time);
        let tolerance = (tolerance_defined != FALSE).then_some(tolerance);
        on_instance!(instance, |i| i.setup_experiment(tolerance, start_time, stop))?;
        Ok(Status::Ok)
    })
}

/// `fmi2EnterInitializationMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterInitializationMode(component: Component) -> Status {
    guard(component, Call::ENTER_INITIALIZATION, |instance, _| {
        on_instance!(instance, |i| i.enter_initialization())?;
        Ok(Status::Ok)
    })
}

/// `fmi2ExitInitializationMode`: loads the profiles; if one of them cannot be had, the mode is not left.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2ExitInitializationMode(component: Component) -> Status {
    guard(component, Call::EXIT_INITIALIZATION, |instance, logger| {
        let status = on_instance!(instance, |i| i.exit_initialization(logger))?;
        logger.log(Status::Ok, Category::Events, format_args!("initialized"));
        Ok(status)
    })
}

/// `fmi2Terminate`: writes worn profiles, where that is asked for; if one cannot be written, the run is not ended.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Terminate(component: Component) -> Status {
    guard(component, Call::TERMINATE, |instance, logger| {
        on_instance!(instance, |i| i.terminate())?;
        logger.log(Status::Ok, Category::Events, format_args!("terminated"));
        Ok(Status::Ok)
    })
}

/// `fmi2Reset`: as after `fmi2Instantiate`; log categories stay.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Reset(component: Component) -> Status {
    guard(component, Call::RESET, |instance, logger| {
        on_instance!(instance, |i| i.reset());
        logger.log(Status::Ok, Category::Events, format_args!("reset"));
        Ok(Status::Ok)
    })
}
