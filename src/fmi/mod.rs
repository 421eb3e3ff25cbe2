//! Wheel and wheelset behind the C interface of FMI 2.0 for co-simulation and model exchange.
//!
//! One library serves both units, `WheelRail.fmu` and `WheelSet.fmu`: the GUID of an instance says which variables it has.
//!
//! ```text
//! abi        the exported functions: raw pointers in, one guarded call each
//! guard      finds the instance, checks that the call is legal now, stops panics, logs
//! handle     the table of instances
//! slots      a table whose places the host holds as an index and a generation
//! any_instance   an instance of one unit or the other
//! instance   a wheel or a wheelset with its variables and its place in the life cycle
//! access     its variables by reference
//! coupling   energy residual, stiffness and damping
//! extrapolation   inputs that go on with their time derivatives
//! snapshot   what is remembered of it by `fmi2GetFMUstate`
//! bytes      the same as bytes
//! logger     messages to the host
//! error      why a call is refused
//! location   the folder of resources from its URI
//! types      the types of `fmi2TypesPlatform.h` and `fmi2FunctionTypes.h`
//! ```
//!
//! The contact is quasi-static: outputs follow from the inputs set last, so that they are evaluated when
//! they are first read after a set, and `fmi2DoStep` only moves the time. A host may therefore read
//! forces for inputs it has just set, and repeat or take back a step, with or without a saved state.
//!
//! What FMI leaves open is decided so: a call that is refused changes nothing and the instance goes on;
//! a panic closes the instance. Errors and warnings are logged whether or not `loggingOn` was given,
//! unless `fmi2SetDebugLogging` turns off their categories by name.

pub mod abi;
mod access;
mod any_instance;
mod bytes;
mod coupling;
mod differences;
mod directional;
mod error;
mod events;
mod extrapolation;
mod guard;
mod handle;
mod instance;
mod location;
mod logger;
mod slots;
mod snapshot;
pub mod types;
mod worn_files;
