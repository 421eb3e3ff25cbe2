//! What surrounds every call: instance, state, panics, messages.

use std::ffi::CStr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::ptr::null_mut;
use std::sync::{Mutex, TryLockError};

use super::any_instance::AnyInstance;
use super::error::FmiError;
use super::handle::{self, Entry};
use super::instance::{Purpose, State};
use super::location;
use super::logger::{Category, Logger};
use super::types::{CO_SIMULATION, Component, MODEL_EXCHANGE, Status};
use crate::variables::{Unit, WHEEL, WHEELSET, shortened};

/// A function of the interface and the states in which FMI allows it.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    name: &'static str,
    allowed: u8,
}

const INSTANTIATED: u8 = State::Instantiated.bit();
const INITIALIZATION: u8 = State::Initialization.bit();
const STEPPING: u8 = State::Stepping.bit();
const EVENT: u8 = State::EventMode.bit();
const CONTINUOUS: u8 = State::ContinuousTime.bit();
const TERMINATED: u8 = State::Terminated.bit();
const RUNNING: u8 = STEPPING | EVENT | CONTINUOUS;
const ALIVE: u8 = INSTANTIATED | INITIALIZATION | RUNNING | TERMINATED;
const READABLE: u8 = INITIALIZATION | RUNNING | TERMINATED;
const SETTABLE: u8 = INSTANTIATED | INITIALIZATION | RUNNING;

macro_rules! calls {
    ($($constant:ident $name:literal $allowed:expr;)*) => {
        impl Call {
            $(#[doc = $name] pub const $constant: Self = Self { name: $name, allowed: $allowed };)*
        }
    };
}

// FMI 2.0, 3.2.3 and 4.2.4: the state machines of model exchange and co-simulation and their tables of calls.
calls! {
    SET_DEBUG_LOGGING "fmi2SetDebugLogging" ALIVE;
    SETUP_EXPERIMENT "fmi2SetupExperiment" INSTANTIATED;
    ENTER_INITIALIZATION "fmi2EnterInitializationMode" INSTANTIATED;
    EXIT_INITIALIZATION "fmi2ExitInitializationMode" INITIALIZATION;
    TERMINATE "fmi2Terminate" RUNNING;
    RESET "fmi2Reset" ALIVE;
    GET_REAL "fmi2GetReal" READABLE;
    GET_INTEGER "fmi2GetInteger" READABLE;
    GET_BOOLEAN "fmi2GetBoolean" READABLE;
    GET_STRING "fmi2GetString" READABLE;
    SET_REAL "fmi2SetReal" SETTABLE;
    SET_INTEGER "fmi2SetInteger" SETTABLE;
    SET_BOOLEAN "fmi2SetBoolean" SETTABLE;
    SET_STRING "fmi2SetString" SETTABLE;
    GET_FMU_STATE "fmi2GetFMUstate" ALIVE;
    SET_FMU_STATE "fmi2SetFMUstate" ALIVE;
    FREE_FMU_STATE "fmi2FreeFMUstate" ALIVE;
    SERIALIZED_SIZE "fmi2SerializedFMUstateSize" ALIVE;
    SERIALIZE "fmi2SerializeFMUstate" ALIVE;
    DESERIALIZE "fmi2DeSerializeFMUstate" ALIVE;
    DIRECTIONAL_DERIVATIVE "fmi2GetDirectionalDerivative" READABLE;
    SET_INPUT_DERIVATIVES "fmi2SetRealInputDerivatives" INSTANTIATED | INITIALIZATION | STEPPING;
    GET_OUTPUT_DERIVATIVES "fmi2GetRealOutputDerivatives" STEPPING | TERMINATED;
    ENTER_EVENT_MODE "fmi2EnterEventMode" EVENT | CONTINUOUS;
    NEW_DISCRETE_STATES "fmi2NewDiscreteStates" EVENT;
    ENTER_CONTINUOUS_TIME_MODE "fmi2EnterContinuousTimeMode" EVENT;
    COMPLETED_INTEGRATOR_STEP "fmi2CompletedIntegratorStep" CONTINUOUS;
    SET_TIME "fmi2SetTime" EVENT | CONTINUOUS;
    SET_CONTINUOUS_STATES "fmi2SetContinuousStates" CONTINUOUS;
    GET_DERIVATIVES "fmi2GetDerivatives" EVENT | CONTINUOUS | TERMINATED;
    GET_EVENT_INDICATORS "fmi2GetEventIndicators" INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
    GET_CONTINUOUS_STATES "fmi2GetContinuousStates" INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
    GET_NOMINALS "fmi2GetNominalsOfContinuousStates" INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
    DO_STEP "fmi2DoStep" STEPPING;
    CANCEL_STEP "fmi2CancelStep" 0;
    GET_STATUS "fmi2GetStatus" STEPPING | TERMINATED;
    GET_REAL_STATUS "fmi2GetRealStatus" STEPPING | TERMINATED;
    GET_INTEGER_STATUS "fmi2GetIntegerStatus" STEPPING | TERMINATED;
    GET_BOOLEAN_STATUS "fmi2GetBooleanStatus" STEPPING | TERMINATED;
    GET_STRING_STATUS "fmi2GetStringStatus" STEPPING | TERMINATED;
}

/// Runs a call on the instance of a handle.
///
/// A handle that is none gives an error without a message, and so does a call made from within the logger: it could call again, and
/// so on. An instance that is busy in another thread is told.
#[inline]
pub fn guard(
    component: Component,
    call: Call,
    body: impl FnOnce(&mut AnyInstance, &Logger) -> Result<Status, FmiError>,
) -> Status {
    catch_unwind(AssertUnwindSafe(|| {
        let Some(entry) = handle::find(component) else { return Status::Error };
        let mut instance = match entry.instance.try_lock() {
            Ok(instance) => instance,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return busy(call, &entry.logger),
        };
        let result = instance.state().admits(call).and_then(|()| {
            catch_unwind(AssertUnwindSafe(|| body(&mut instance, &entry.logger))).unwrap_or_else(
                |_| {
                    instance.put_into(State::Closed);
                    Err(FmiError::Panic)
                },
            )
        });
        result.unwrap_or_else(|error| refuse(call, &error, &entry.logger))
    }))
    .unwrap_or(Status::Error)
}

#[cold]
fn refuse(call: Call, error: &FmiError, logger: &Logger) -> Status {
    if logger.takes(Category::Error) {
        logger.log(Status::Error, Category::Error, format_args!("{}: {error}", call.name));
    }
    Status::Error
}

#[cold]
fn busy(call: Call, logger: &Logger) -> Status {
    let message = format_args!(
        "{}: the instance is busy with another call: one instance is for one thread at a time",
        call.name
    );
    logger.log_unless_logging(Status::Error, Category::Error, message);
    Status::Error
}

/// What `fmi2Instantiate` is called with, checked for nulls.
#[derive(Debug)]
pub struct Request<'a> {
    /// `instanceName`.
    pub instance_name: &'a CStr,
    /// `fmuType`.
    pub fmu_type: i32,
    /// `fmuGUID`.
    pub guid: Result<&'a str, FmiError>,
    /// `fmuResourceLocation`; empty if null.
    pub resource_location: Result<&'a str, FmiError>,
}

/// Makes an instance and puts it into the table; null, with a message, if that is not possible.
pub fn instantiate(request: Request, logger: Logger) -> Component {
    const NAME: &str = "fmi2Instantiate";
    catch_unwind(AssertUnwindSafe(|| match examine(request, &logger) {
        Ok((unit, purpose, folders)) => {
            logger.log(Status::Ok, Category::Events, format_args!("{NAME}"));
            let instance = Mutex::new(AnyInstance::new(unit, purpose, folders));
            handle::insert(Entry { logger, instance }).unwrap_or(null_mut())
        }
        Err(error) => {
            logger.log(Status::Error, Category::Error, format_args!("{NAME}: {error}"));
            null_mut()
        }
    }))
    .unwrap_or(null_mut())
}

/// Of which unit the instance is, what it is for, and where profiles are looked for: in the resources, then in the working directory.
fn examine(
    request: Request,
    logger: &Logger,
) -> Result<(&'static Unit, Purpose, Vec<PathBuf>), FmiError> {
    if request.instance_name.is_empty() {
        return Err(FmiError::NoName);
    }
    let purpose = match request.fmu_type {
        MODEL_EXCHANGE => Purpose::ModelExchange,
        CO_SIMULATION => Purpose::CoSimulation,
        other => return Err(FmiError::WrongFmuType(other)),
    };
    let given = request.guid?;
    // One library serves both: the description says which variables the host knows.
    let unit =
        [&WHEEL, &WHEELSET].into_iter().find(|unit| unit.guid == given).ok_or_else(|| {
            FmiError::WrongGuid {
                given: shortened(given),
                wheel: WHEEL.guid,
                wheelset: WHEELSET.guid,
            }
        })?;
    let location = request.resource_location?;
    let resources = location::folder(location);
    if resources.is_none() && !location.is_empty() {
        let warning = FmiError::BadLocation(shortened(location));
        let message = format_args!("fmi2Instantiate: {warning}");
        logger.log(Status::Warning, Category::Warning, message);
    }
    let working_directory = std::env::current_dir().unwrap_or_else(|_| PathBuf::from("."));
    let folders = resources.map(|folder| folder.join("profiles")).into_iter();
    Ok((unit, purpose, folders.chain([working_directory]).collect()))
}

/// Takes the instance out of the table; freed, forged and null handles do nothing.
pub fn free(component: Component) {
    // A panic while dropping must not cross the interface; there is nobody to tell.
    let _ = catch_unwind(|| drop(handle::remove(component)));
}

impl State {
    const fn bit(self) -> u8 {
        1 << self as u8
    }

    #[inline]
    fn admits(self, call: Call) -> Result<(), FmiError> {
        if call.allowed & self.bit() != 0 { Ok(()) } else { Err(self.refusal(call)) }
    }

    #[cold]
    fn refusal(self, call: Call) -> FmiError {
        let state = match self {
            Self::Instantiated => "before initialization",
            Self::Initialization => "in initialization mode",
            Self::Stepping => "after initialization",
            Self::EventMode => "in event mode",
            Self::ContinuousTime => "in continuous-time mode",
            Self::Terminated => "after fmi2Terminate",
            Self::Closed => "after an internal fault",
        };
        let remedy = match self {
            _ if call.allowed == 0 => "no step is ever pending",
            Self::Instantiated => "call fmi2SetupExperiment and fmi2EnterInitializationMode first",
            Self::Initialization => "call fmi2ExitInitializationMode first",
            Self::EventMode | Self::ContinuousTime if call.allowed & STEPPING != 0 => {
                "the instance is for model exchange, the call for co-simulation"
            }
            Self::Stepping if call.allowed & (EVENT | CONTINUOUS) != 0 => {
                "the instance is for co-simulation, the call for model exchange"
            }
            Self::EventMode if call.allowed & CONTINUOUS != 0 => {
                "call fmi2EnterContinuousTimeMode first"
            }
            Self::ContinuousTime if call.allowed & EVENT != 0 => "call fmi2EnterEventMode first",
            Self::Stepping | Self::EventMode | Self::ContinuousTime | Self::Terminated => {
                "call fmi2Reset to start again"
            }
            Self::Closed => "free the instance",
        };
        FmiError::WrongState { state, remedy }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fmi::types::CallbackFunctions;

    #[test]
    fn a_panic_is_an_error_and_closes_the_instance() {
        let functions = CallbackFunctions {
            logger: None,
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: null_mut(),
        };
        let request = Request {
            instance_name: c"wheel",
            fmu_type: CO_SIMULATION,
            guid: Ok(WHEEL.guid),
            resource_location: Ok(""),
        };
        let component = instantiate(request, Logger::new(&functions, c"wheel".into(), false));
        assert_eq!(guard(component, Call::RESET, |_, _| Ok(Status::Ok)), Status::Ok);
        assert_eq!(guard(component, Call::RESET, |_, _| panic!("on purpose")), Status::Error);
        assert_eq!(guard(component, Call::RESET, |_, _| Ok(Status::Ok)), Status::Error);
        free(component);
    }
}
