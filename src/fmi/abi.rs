//! The functions that FMI 2.0 asks of a co-simulation unit, as the library exports them.
//!
//! Arguments are as in the standard; raw pointers become slices and texts here and nowhere else. What
//! is not supported yet is exported, explains itself to the logger and answers `fmi2Error`.
#![allow(unsafe_code)]
// The names are the standard's, and so is the contract of their pointers.
#![allow(non_snake_case, clippy::missing_safety_doc)]

use std::ffi::{CStr, c_char, c_int};
use std::ptr::null_mut;
use std::slice;

use super::error::FmiError;
use super::guard::{self, Call, Request, guard};
use super::instance::State;
use super::logger::{Category, Logger};
use super::types::{
    Boolean, CallbackFunctions, Component, FALSE, FmuState, Status, Text, ValueReference,
    status_kind,
};
use crate::variables::Value;

/// An array of the host as a slice; count 0 accepts null.
///
/// # Safety
/// FMI 2.0, 2.1.7: an argument array holds as many elements as its count says and stays for the call.
unsafe fn array<'a, T>(
    name: &'static str,
    start: *const T,
    count: usize,
) -> Result<&'a [T], FmiError> {
    check_array(name, start, count)?;
    if count == 0 {
        return Ok(&[]);
    }
    // SAFETY: FMI 2.0, 2.1.7, see above; null, alignment and size were checked.
    Ok(unsafe { slice::from_raw_parts(start, count) })
}

/// An array of the host to be written; count 0 accepts null.
///
/// # Safety
/// As for [`array`], and no other argument overlaps it.
unsafe fn array_mut<'a, T>(
    name: &'static str,
    start: *mut T,
    count: usize,
) -> Result<&'a mut [T], FmiError> {
    check_array(name, start, count)?;
    if count == 0 {
        return Ok(&mut []);
    }
    // SAFETY: FMI 2.0, 2.1.7, see above; null, alignment and size were checked.
    Ok(unsafe { slice::from_raw_parts_mut(start, count) })
}

fn check_array<T>(name: &'static str, start: *const T, count: usize) -> Result<(), FmiError> {
    if count > 0 && start.is_null() {
        return Err(FmiError::NullPointer(name));
    }
    if count > isize::MAX as usize / size_of::<T>() || (count > 0 && !start.is_aligned()) {
        let allowed = "an aligned array of a count that fits into memory";
        return Err(FmiError::BadArgument { name, value: count as f64, allowed });
    }
    Ok(())
}

/// A text of the host.
///
/// # Safety
/// FMI 2.0, 2.1.2: an `fmi2String` is null or null-terminated, and stays for the call.
unsafe fn text<'a>(name: &'static str, start: Text) -> Result<&'a str, FmiError> {
    if start.is_null() {
        return Err(FmiError::NullPointer(name));
    }
    // SAFETY: FMI 2.0, 2.1.2, see above; null was checked.
    unsafe { CStr::from_ptr(start) }.to_str().map_err(|_| FmiError::NotUnicode(name))
}

/// Texts of the host, as [`text`].
///
/// # Safety
/// As for [`array`] and [`text`].
unsafe fn texts<'a>(
    name: &'static str,
    start: *const Text,
    count: usize,
) -> Result<Vec<&'a str>, FmiError> {
    // SAFETY: FMI 2.0, 2.1.2 and 2.1.7: the caller's promise is that of both functions.
    unsafe { array(name, start, count)?.iter().map(|&t| text(name, t)).collect() }
}

/// Writes one value through a pointer of the host.
///
/// # Safety
/// As for [`array_mut`] with one element.
unsafe fn write<T>(name: &'static str, target: *mut T, value: T) -> Result<Status, FmiError> {
    // SAFETY: FMI 2.0, 2.1.7: the caller's promise.
    unsafe { array_mut(name, target, 1)?[0] = value };
    Ok(Status::Ok)
}

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

/// `fmi2SetupExperiment`: the tolerance is not used, there is nothing to integrate.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetupExperiment(
    component: Component,
    _tolerance_defined: Boolean,
    _tolerance: f64,
    start_time: f64,
    stop_time_defined: Boolean,
    stop_time: f64,
) -> Status {
    guard(component, Call::SETUP_EXPERIMENT, |instance, _| {
        let stop = (stop_time_defined != FALSE).then_some(stop_time);
        instance.setup_experiment(start_time, stop)?;
        Ok(Status::Ok)
    })
}

/// `fmi2EnterInitializationMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterInitializationMode(component: Component) -> Status {
    guard(component, Call::ENTER_INITIALIZATION, |instance, _| {
        instance.enter_initialization()?;
        Ok(Status::Ok)
    })
}

/// `fmi2ExitInitializationMode`: loads the profiles; if one of them cannot be had, the mode is not left.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2ExitInitializationMode(component: Component) -> Status {
    guard(component, Call::EXIT_INITIALIZATION, |instance, logger| {
        instance.exit_initialization()?;
        logger.log(Status::Ok, Category::Events, "initialized");
        Ok(Status::Ok)
    })
}

/// `fmi2Terminate`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Terminate(component: Component) -> Status {
    guard(component, Call::TERMINATE, |instance, logger| {
        instance.state = State::Terminated;
        logger.log(Status::Ok, Category::Events, "terminated");
        Ok(Status::Ok)
    })
}

/// `fmi2Reset`: as after `fmi2Instantiate`; log categories stay.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Reset(component: Component) -> Status {
    guard(component, Call::RESET, |instance, logger| {
        instance.reset();
        logger.log(Status::Ok, Category::Events, "reset");
        Ok(Status::Ok)
    })
}

/// `fmi2GetReal`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut f64,
) -> Status {
    guard(component, Call::GET_REAL, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        instance.get_real(references, values, logger)
    })
}

/// `fmi2SetReal`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const f64,
) -> Status {
    guard(component, Call::SET_REAL, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array("value", values, count)?) };
        instance.set(references, |i| Value::Real(values[i]))
    })
}

/// `fmi2GetInteger`, enumerations too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut i32,
) -> Status {
    guard(component, Call::GET_INTEGER, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        instance.get_integer(references, values, logger)
    })
}

/// `fmi2SetInteger`, enumerations too: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const i32,
) -> Status {
    guard(component, Call::SET_INTEGER, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array("value", values, count)?) };
        instance.set(references, |i| Value::Integer(values[i]))
    })
}

/// `fmi2GetBoolean`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut Boolean,
) -> Status {
    guard(component, Call::GET_BOOLEAN, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        instance.get_boolean(references, values, logger)
    })
}

/// `fmi2SetBoolean`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const Boolean,
) -> Status {
    guard(component, Call::SET_BOOLEAN, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array("value", values, count)?) };
        instance.set(references, |i| Value::Boolean(values[i] != FALSE))
    })
}

/// `fmi2GetString`: the texts are good until the next call on this instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *mut *const c_char,
) -> Status {
    guard(component, Call::GET_STRING, |instance, logger| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements and do not overlap.
        let (references, values) =
            unsafe { (array("vr", references, count)?, array_mut("value", values, count)?) };
        instance.get_text(references, values, logger)
    })
}

/// `fmi2SetString`: all values or, if one is refused, none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    component: Component,
    references: *const ValueReference,
    count: usize,
    values: *const Text,
) -> Status {
    guard(component, Call::SET_STRING, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.7: both arrays hold `nvr` elements.
        let (references, values) =
            unsafe { (array("vr", references, count)?, texts("value", values, count)?) };
        instance.set(references, |i| Value::Text(values[i]))
    })
}

/// `fmi2GetFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetFMUstate(component: Component, _state: *mut FmuState) -> Status {
    guard(component, Call::GET_FMU_STATE, |_, _| {
        Err(FmiError::NotSupported("canGetAndSetFMUstate"))
    })
}

/// `fmi2SetFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetFMUstate(component: Component, _state: FmuState) -> Status {
    guard(component, Call::SET_FMU_STATE, |_, _| {
        Err(FmiError::NotSupported("canGetAndSetFMUstate"))
    })
}

/// `fmi2FreeFMUstate`: there are no states to free; null does nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: Component, state: *mut FmuState) -> Status {
    guard(component, Call::FREE_FMU_STATE, |_, _| {
        // SAFETY: FMI 2.0, 2.1.8: the argument points to a state pointer of the host.
        let held = unsafe { array("FMUstate", state, usize::from(!state.is_null()))? };
        if held.iter().all(|state| state.is_null()) {
            return Ok(Status::Ok);
        }
        Err(FmiError::NotSupported("canGetAndSetFMUstate"))
    })
}

/// `fmi2SerializedFMUstateSize`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializedFMUstateSize(
    component: Component,
    _state: FmuState,
    _size: *mut usize,
) -> Status {
    guard(component, Call::SERIALIZED_SIZE, |_, _| {
        Err(FmiError::NotSupported("canSerializeFMUstate"))
    })
}

/// `fmi2SerializeFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializeFMUstate(
    component: Component,
    _state: FmuState,
    _bytes: *mut c_char,
    _size: usize,
) -> Status {
    guard(component, Call::SERIALIZE, |_, _| Err(FmiError::NotSupported("canSerializeFMUstate")))
}

/// `fmi2DeSerializeFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DeSerializeFMUstate(
    component: Component,
    _bytes: *const c_char,
    _size: usize,
    _state: *mut FmuState,
) -> Status {
    guard(component, Call::DESERIALIZE, |_, _| Err(FmiError::NotSupported("canSerializeFMUstate")))
}

/// `fmi2GetDirectionalDerivative`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetDirectionalDerivative(
    component: Component,
    _unknowns: *const ValueReference,
    _unknown_count: usize,
    _knowns: *const ValueReference,
    _known_count: usize,
    _seed: *const f64,
    _sensitivity: *mut f64,
) -> Status {
    guard(component, Call::DIRECTIONAL_DERIVATIVE, |_, _| {
        Err(FmiError::NotSupported("providesDirectionalDerivative"))
    })
}

/// `fmi2SetRealInputDerivatives`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetRealInputDerivatives(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> Status {
    guard(component, Call::SET_INPUT_DERIVATIVES, |_, _| {
        Err(FmiError::NotSupported("canInterpolateInputs"))
    })
}

/// `fmi2GetRealOutputDerivatives`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetRealOutputDerivatives(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> Status {
    guard(component, Call::GET_OUTPUT_DERIVATIVES, |_, _| {
        Err(FmiError::NotSupported("maxOutputDerivativeOrder"))
    })
}

/// `fmi2DoStep`: any length from zero on.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DoStep(
    component: Component,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: Boolean,
) -> Status {
    guard(component, Call::DO_STEP, |instance, _| {
        instance.step(current_communication_point, communication_step_size)?;
        Ok(Status::Ok)
    })
}

/// `fmi2CancelStep`: no step is ever pending.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2CancelStep(component: Component) -> Status {
    guard(component, Call::CANCEL_STEP, |_, _| Ok(Status::Ok))
}

/// `fmi2GetStatus`: of the last step, which was made.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(
    component: Component,
    kind: c_int,
    value: *mut Status,
) -> Status {
    guard(component, Call::GET_STATUS, |_, logger| match kind {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one status.
        status_kind::DO_STEP => unsafe { write("value", value, Status::Ok) },
        _ => Ok(no_such_status(kind, logger)),
    })
}

/// `fmi2GetRealStatus`: the time of the last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(
    component: Component,
    kind: c_int,
    value: *mut f64,
) -> Status {
    guard(component, Call::GET_REAL_STATUS, |instance, logger| match kind {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one real.
        status_kind::LAST_SUCCESSFUL_TIME => unsafe { write("value", value, instance.time()) },
        _ => Ok(no_such_status(kind, logger)),
    })
}

/// `fmi2GetIntegerStatus`: there is none in the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetIntegerStatus(
    component: Component,
    kind: c_int,
    _value: *mut c_int,
) -> Status {
    guard(component, Call::GET_INTEGER_STATUS, |_, logger| Ok(no_such_status(kind, logger)))
}

/// `fmi2GetBooleanStatus`: the unit never wants to end the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: Component,
    kind: c_int,
    value: *mut Boolean,
) -> Status {
    guard(component, Call::GET_BOOLEAN_STATUS, |_, logger| match kind {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one boolean.
        status_kind::TERMINATED => unsafe { write("value", value, FALSE) },
        _ => Ok(no_such_status(kind, logger)),
    })
}

/// `fmi2GetStringStatus`: no step is pending, so that there is nothing to say.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetStringStatus(
    component: Component,
    kind: c_int,
    _value: *mut Text,
) -> Status {
    guard(component, Call::GET_STRING_STATUS, |_, logger| Ok(no_such_status(kind, logger)))
}

#[cold]
fn no_such_status(kind: c_int, logger: &Logger) -> Status {
    if logger.takes(Category::Discard) {
        let message = format!("there is no status of kind {kind} to ask for here");
        logger.log(Status::Discard, Category::Discard, &message);
    }
    Status::Discard
}
