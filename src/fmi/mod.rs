//! Wheel and wheelset behind the C interfaces of FMI 2.0 and FMI 3.0 for co-simulation and model
//! exchange.
//!
//! One library serves all units, `WheelRail.fmu` and `WheelSet.fmu`, `WheelRail3.fmu` and
//! `WheelSet3.fmu`: the GUID or instantiation token of an instance says which variables it has, the
//! function that makes it through which interface.
//!
//! ```text
//! v2, v3     the exported functions of each interface
//! both       those that both interfaces have with the same arguments
//! exported   how they are declared: raw pointers in, one guarded call each
//! arguments  raw pointers as slices and texts
//! guard      finds the instance, checks that the call is legal now, stops panics, logs
//! floating_point   settings of the processor during a call
//! handle     the table of instances
//! slots      a table whose places the host holds as an index and a generation
//! any_instance   an instance of one unit or the other
//! stepping   from the time span of a run over initialization and steps to its end
//! evaluation the element of the parameters and the outputs of the inputs
//! access     variables by reference, read and set
//! arrays     the same as FMI 3.0 has them: patches as arrays, time and event indicator as variables
//! monitor    energy residual, stiffness and damping
//! directional   derivatives of outputs
//! adjoint       the same backwards: of sums of outputs by all inputs and parameters at once
//! dummy_state   the state of the variant that has one
//! events     event mode, continuous time and the event indicator
//! moving_rails  rails with a mass, moved on over a step
//! worn_files worn profiles at the end of a run
//! saved_states  states saved and restored
//! instance   what an instance of a wheel or a wheelset holds
//! snapshot   what is remembered of it by `fmi2GetFMUstate` and `fmi3GetFMUState`
//! bytes      the same as bytes
//! life_cycle what an instance is made for and where in its life it is
//! coupling, extrapolation, held, differences   what steps, inputs, events and derivatives have to remember
//! references variables by their references
//! logger     messages to the host
//! callback   its function for them
//! error      why a call is refused
//! interface  what messages have to know of the version of the standard
//! starts     start values beside a packed unit
//! unload     what is given back when the library goes
//! location   the folder of resources from its URI or path
//! types      the types that both interfaces have
//! ```
//!
//! The contact is quasi-static: outputs follow from the inputs set last, so that they are evaluated
//! when they are first read after a set, and a step only moves the time. A host may therefore read
//! forces for inputs it has just set, and repeat or take back a step, with or without a saved
//! state.
//!
//! What FMI leaves open is decided so: a call that is refused changes nothing and the instance goes
//! on; a panic closes the instance. Through FMI 2.0 errors and warnings are logged whether or not
//! `loggingOn` was given, unless `fmi2SetDebugLogging` turns off their categories by name; FMI 3.0
//! wants silence without it.

mod access;
mod adjoint;
mod adjoint_scratch;
mod any_instance;
mod arguments;
mod arrays;
mod both;
mod bytes;
mod callback;
mod coupling;
mod differences;
mod directional;
mod dummy_state;
mod error;
mod evaluation;
mod events;
mod exported;
mod extrapolation;
mod floating_point;
mod guard;
mod handle;
mod held;
mod instance;
mod interface;
mod life_cycle;
mod location;
mod logger;
mod monitor;
mod moving_rails;
mod references;
mod saved_states;
mod slots;
mod snapshot;
mod starts;
mod stepping;
mod types;
mod unload;
pub mod v2;
pub mod v3;
mod worn_files;
