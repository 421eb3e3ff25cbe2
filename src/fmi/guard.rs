//! What surrounds every call: instance, state, panics, messages.

use std::ffi::CStr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::ptr::null_mut;
use std::sync::{Mutex, TryLockError};

use super::any_instance::AnyInstance;
use super::error::FmiError;
use super::floating_point::OwnSettings;
use super::handle::{self, Entry};
use super::interface::Interface;
use super::life_cycle::{Purpose, State};
use super::logger::{Category, Logger};
use super::starts::Starts;
use super::types::{Component, Status};
use super::unload;
use crate::variables::{WHEEL, WHEELSET, shortened, unit_of};

/// A function of an interface and the states in which the standard allows it.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    name: &'static str,
    interface: Interface,
    allowed: u8,
}

impl Call {
    /// A function that is legal in `allowed`, a sum of the constants below.
    pub const fn new(interface: Interface, name: &'static str, allowed: u8) -> Self {
        Self { name, interface, allowed }
    }
}

/// No state.
pub const NEVER: u8 = 0;
/// Before initialization.
pub const INSTANTIATED: u8 = State::Instantiated.bit();
/// Initialization mode.
pub const INITIALIZATION: u8 = State::Initialization.bit();
/// Step mode of co-simulation.
pub const STEPPING: u8 = State::Stepping.bit();
/// Event mode of model exchange.
pub const EVENT: u8 = State::EventMode.bit();
/// Continuous-time mode.
pub const CONTINUOUS: u8 = State::ContinuousTime.bit();
/// After the end of a run.
pub const TERMINATED: u8 = State::Terminated.bit();
/// Between initialization and the end of a run.
pub const RUNNING: u8 = STEPPING | EVENT | CONTINUOUS;
/// Always but after an internal fault.
pub const ALIVE: u8 = INSTANTIATED | INITIALIZATION | RUNNING | TERMINATED;
/// Where outputs can be read.
pub const READABLE: u8 = INITIALIZATION | RUNNING | TERMINATED;
/// Where inputs can be set.
pub const SETTABLE: u8 = INSTANTIATED | INITIALIZATION | RUNNING;

/// Runs a call on the instance of a handle, with the processor set as Rust wants it.
///
/// A handle that is none gives an error without a message, and so does a call made from within the
/// logger: it could call again, and so on. An instance that is busy in another thread is told.
pub fn guard(
    component: Component,
    call: Call,
    body: &mut dyn FnMut(&mut AnyInstance, &Logger) -> Result<Status, FmiError>,
) -> Status {
    let _settings = OwnSettings::apply();
    catch_unwind(AssertUnwindSafe(|| {
        let Some(entry) = handle::find(component) else { return Status::Error };
        let mut instance = match entry.instance.try_lock() {
            Ok(instance) => instance,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return busy(call, &entry.logger),
        };
        let result = admits(&instance, call).and_then(|()| {
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

/// What an instance is asked for with, checked for nulls.
#[derive(Debug)]
pub struct Request<'a> {
    /// The function that was called.
    pub call: Call,
    /// `instanceName`.
    pub instance_name: &'a CStr,
    /// What for, or why not for that.
    pub purpose: Result<Purpose, FmiError>,
    /// What the host has read of the description: `fmuGUID`, `instantiationToken`.
    pub identity: Result<&'a str, FmiError>,
    /// Where the resources lie; empty if null.
    pub location: Result<&'a str, FmiError>,
}

/// Makes an instance and puts it into the table; null, with a message, if that is not possible.
pub fn instantiate(request: Request, logger: Logger) -> Component {
    let _settings = OwnSettings::apply();
    unload::expect();
    let name = request.call.name;
    catch_unwind(AssertUnwindSafe(|| match examine(request, &logger) {
        Ok(instance) => {
            logger.log(Status::Ok, Category::Events, format_args!("{name}"));
            handle::insert(Entry { logger, instance: Mutex::new(instance) }).unwrap_or(null_mut())
        }
        Err(error) => {
            logger.explain(format_args!("{name}: {error}"));
            null_mut()
        }
    }))
    .unwrap_or(null_mut())
}

/// The instance that is asked for. Profiles are looked for in the resources, then in the working
/// directory.
fn examine(request: Request, logger: &Logger) -> Result<AnyInstance, FmiError> {
    let Call { name, interface, .. } = request.call;
    if request.instance_name.is_empty() {
        return Err(FmiError::NoName);
    }
    let purpose = request.purpose?;
    let given = request.identity?;
    // One library serves both: the description says which variables the host knows.
    let (unit, has_state) =
        unit_of(given, &[&WHEEL, &WHEELSET]).ok_or_else(|| FmiError::WrongGuid {
            interface,
            given: shortened(given),
            wheel: WHEEL.guid,
            wheelset: WHEELSET.guid,
        })?;
    let location = request.location?;
    let resources = interface.resources(location);
    if let Some(warning) = FmiError::odd_location(interface, location, resources.as_deref()) {
        logger.log(Status::Warning, Category::Warning, format_args!("{name}: {warning}"));
    }
    let working_directory = std::env::current_dir().unwrap_or_else(|_| PathBuf::from("."));
    let starts = Starts::beside(resources.as_deref())?;
    let folders = resources.map(|folder| folder.join("profiles")).into_iter();
    let folders = folders.chain([working_directory]).collect();
    AnyInstance::new(unit, interface, purpose, folders, &starts, has_state)
}

/// Takes the instance out of the table; freed, forged and null handles do nothing.
pub fn free(component: Component) {
    let _settings = OwnSettings::apply();
    // A panic while dropping must not cross the interface; there is nobody to tell.
    let _ = catch_unwind(|| drop(handle::remove(component)));
}

/// Whether a call is legal now, and of the interface through which the instance was made.
#[inline]
fn admits(instance: &AnyInstance, call: Call) -> Result<(), FmiError> {
    let state = instance.state();
    if call.allowed & state.bit() != 0 && instance.interface() == call.interface {
        return Ok(());
    }
    Err(refusal(instance.interface(), state, call))
}

#[cold]
fn refusal(own: Interface, state: State, call: Call) -> FmiError {
    if own != call.interface {
        return FmiError::OtherInterface { own };
    }
    if state == State::Instantiated && call.allowed != NEVER {
        return FmiError::too_early(own);
    }
    let words = match state {
        State::Instantiated => "before initialization".into(),
        State::Initialization => "in initialization mode".into(),
        State::Stepping => "after initialization".into(),
        State::EventMode => "in event mode".into(),
        State::ContinuousTime => "in continuous-time mode".into(),
        State::Terminated => format!("after {own}Terminate"),
        State::Closed => "after an internal fault".into(),
    };
    let remedy = match state {
        _ if call.allowed == NEVER => "no step is ever pending".into(),
        State::Initialization => format!("call {own}ExitInitializationMode first"),
        State::EventMode | State::ContinuousTime if call.allowed & STEPPING != 0 => {
            "the instance is for model exchange, the call for co-simulation".into()
        }
        State::Stepping if call.allowed & (EVENT | CONTINUOUS) != 0 => {
            "the instance is for co-simulation, the call for model exchange".into()
        }
        State::EventMode if call.allowed & CONTINUOUS != 0 => {
            format!("call {own}EnterContinuousTimeMode first")
        }
        State::ContinuousTime if call.allowed & EVENT != 0 => {
            format!("call {own}EnterEventMode first")
        }
        State::Instantiated
        | State::Stepping
        | State::EventMode
        | State::ContinuousTime
        | State::Terminated => {
            format!("call {own}Reset to start again")
        }
        State::Closed => "free the instance".into(),
    };
    FmiError::WrongState { state: words, remedy }
}

impl State {
    const fn bit(self) -> u8 {
        1 << self as u8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RESET: Call = Call::new(Interface::V2, "fmi2Reset", ALIVE);

    fn made_through(interface: Interface) -> Component {
        let request = Request {
            call: Call::new(interface, "instantiate", NEVER),
            instance_name: c"wheel",
            purpose: Ok(Purpose::CoSimulation),
            identity: Ok(WHEEL.guid),
            location: Ok(""),
        };
        instantiate(request, Logger::silent())
    }

    #[test]
    fn a_panic_is_an_error_and_closes_the_instance() {
        let component = made_through(Interface::V2);
        assert_eq!(guard(component, RESET, &mut |_, _| Ok(Status::Ok)), Status::Ok);
        assert_eq!(guard(component, RESET, &mut |_, _| panic!("on purpose")), Status::Error);
        assert_eq!(guard(component, RESET, &mut |_, _| Ok(Status::Ok)), Status::Error);
        free(component);
    }

    #[test]
    fn an_instance_is_for_the_functions_of_its_own_interface() {
        let component = made_through(Interface::V3);
        assert_eq!(guard(component, RESET, &mut |_, _| Ok(Status::Ok)), Status::Error);
        free(component);
    }
}
