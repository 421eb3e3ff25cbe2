//! Making, initializing and ending instances.

use std::ffi::CStr;

use super::callback::Callback;
use super::calls;
use super::types::{
    Boolean, ClockUpdate, Component, ComponentEnvironment, FALSE, IntermediateUpdate, LogMessage,
    Preemption, Status, Text, ValueReference,
};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::text;
use crate::fmi::both;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{self, Call, Request, guard};
use crate::fmi::interface::Interface;
use crate::fmi::life_cycle::Purpose;
use crate::fmi::logger::Logger;

/// `fmi3GetVersion`: of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> Text {
    c"3.0".as_ptr()
}

/// `fmi3InstantiateModelExchange`: null, explained to the logger, if an argument is not good.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    instance_name: Text,
    token: Text,
    resource_path: Text,
    _visible: Boolean,
    logging_on: Boolean,
    environment: ComponentEnvironment,
    log_message: Option<LogMessage>,
) -> Component {
    let (call, purpose) = (calls::INSTANTIATE_MODEL_EXCHANGE, Ok(Purpose::ModelExchange));
    let logger = logger(logging_on, environment, log_message);
    // SAFETY: FMI 3.0, 2.3.1: the first three arguments are texts or null.
    unsafe { instantiate(call, purpose, [instance_name, token, resource_path], logger) }
}

/// `fmi3InstantiateCoSimulation`: null, explained to the logger, if an argument is not good. The
/// unit never returns early and never asks for intermediate updates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    instance_name: Text,
    token: Text,
    resource_path: Text,
    _visible: Boolean,
    logging_on: Boolean,
    event_mode_used: Boolean,
    _early_return_allowed: Boolean,
    _required_intermediate_variables: *const ValueReference,
    _required_count: usize,
    environment: ComponentEnvironment,
    log_message: Option<LogMessage>,
    _intermediate_update: Option<IntermediateUpdate>,
) -> Component {
    // FMI 3.0, 2.3.1: to be refused where `hasEventMode` is not set.
    let purpose = match event_mode_used {
        FALSE => Ok(Purpose::CoSimulation),
        _ => Err(FmiError::NotSupported("hasEventMode")),
    };
    let logger = logger(logging_on, environment, log_message);
    let texts = [instance_name, token, resource_path];
    // SAFETY: FMI 3.0, 2.3.1: the first three arguments are texts or null.
    unsafe { instantiate(calls::INSTANTIATE_CO_SIMULATION, purpose, texts, logger) }
}

/// `fmi3InstantiateScheduledExecution`: there is none, which is explained to the logger; null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    instance_name: Text,
    token: Text,
    resource_path: Text,
    _visible: Boolean,
    logging_on: Boolean,
    environment: ComponentEnvironment,
    log_message: Option<LogMessage>,
    _clock_update: Option<ClockUpdate>,
    _lock_preemption: Option<Preemption>,
    _unlock_preemption: Option<Preemption>,
) -> Component {
    let purpose = Err(FmiError::None("scheduled execution"));
    let logger = logger(logging_on, environment, log_message);
    let texts = [instance_name, token, resource_path];
    // SAFETY: FMI 3.0, 2.3.1: the first three arguments are texts or null.
    unsafe { instantiate(calls::INSTANTIATE_SCHEDULED_EXECUTION, purpose, texts, logger) }
}

fn logger(
    logging_on: Boolean,
    environment: ComponentEnvironment,
    log_message: Option<LogMessage>,
) -> Logger {
    Logger::new(Callback::of(log_message, environment), Interface::V3, logging_on != FALSE)
}

/// # Safety
/// FMI 3.0, 2.2.3: the texts, instance name, token and path, are null-terminated or null.
unsafe fn instantiate(
    call: Call,
    purpose: Result<Purpose, FmiError>,
    [instance_name, token, resource_path]: [Text; 3],
    logger: Logger,
) -> Component {
    let name = if instance_name.is_null() {
        c""
    } else {
        // SAFETY: the caller's promise; null was checked.
        unsafe { CStr::from_ptr(instance_name) }
    };
    // SAFETY: the caller's promise; the path may be null.
    let (identity, location) = unsafe {
        let location =
            if resource_path.is_null() { Ok("") } else { text("resourcePath", resource_path) };
        (text("instantiationToken", token), location)
    };
    let request = Request { call, instance_name: name, purpose, identity, location };
    guard::instantiate(request, logger)
}

/// `fmi3FreeInstance`: null, freed and forged handles do nothing.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3FreeInstance(component: Component) {
    guard::free(component);
}

/// `fmi3SetDebugLogging`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    component: Component,
    logging_on: Boolean,
    count: usize,
    categories: *const Text,
) -> Status {
    let (call, on) = (calls::SET_DEBUG_LOGGING, logging_on != FALSE);
    // SAFETY: FMI 3.0, 2.3.1: `categories` holds `nCategories` texts.
    unsafe { both::set_debug_logging(call, component, on, count, categories) }
}

/// `fmi3EnterInitializationMode`: the tolerance is checked and not used, there is nothing to
/// integrate.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterInitializationMode(
    component: Component,
    tolerance_defined: Boolean,
    tolerance: f64,
    start_time: f64,
    stop_time_defined: Boolean,
    stop_time: f64,
) -> Status {
    guard(component, calls::ENTER_INITIALIZATION, |instance, _| {
        let stop = (stop_time_defined != FALSE).then_some(stop_time);
        let tolerance = (tolerance_defined != FALSE).then_some(tolerance);
        on_instance!(instance, |i| {
            i.setup_experiment(tolerance, start_time, stop)?;
            i.enter_initialization()?;
        });
        Ok(Status::Ok)
    })
}

/// `fmi3ExitInitializationMode`: loads the profiles; if one of them cannot be had, the mode is not
/// left.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3ExitInitializationMode(component: Component) -> Status {
    both::exit_initialization(calls::EXIT_INITIALIZATION, component)
}

/// `fmi3Terminate`: writes worn profiles, where that is asked for; if one cannot be written, the
/// run is not ended.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3Terminate(component: Component) -> Status {
    both::terminate(calls::TERMINATE, component)
}

/// `fmi3Reset`: as after instantiation; log categories stay.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3Reset(component: Component) -> Status {
    both::reset(calls::RESET, component)
}
