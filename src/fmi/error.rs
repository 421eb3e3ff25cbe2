//! Why a call through the interface is refused.

use super::interface::Interface;
use crate::error::ContactError;

impl FmiError {
    /// That of a call which needs initialization mode at least.
    pub fn too_early(interface: Interface) -> Self {
        let first = match interface {
            Interface::V2 => "fmi2SetupExperiment and fmi2EnterInitializationMode",
            Interface::V3 => "fmi3EnterInitializationMode",
        };
        let remedy = format!("call {first} first");
        Self::WrongState { state: "before initialization".into(), remedy }
    }
}

/// A refusal; the message goes to the host's logger.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FmiError {
    /// A value, a parameter or a profile that the element does not take.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A call at the wrong time.
    #[error("not allowed {state}: {remedy}")]
    WrongState {
        /// Where in its life the instance is, as an adverbial.
        state: String,
        /// What to call.
        remedy: String,
    },
    /// A pointer that must not be null.
    #[error("argument {0} is null")]
    NullPointer(&'static str),
    /// A text that is not UTF-8.
    #[error("argument {0} is not UTF-8")]
    NotUnicode(&'static str),
    /// A value reference that no variable has.
    #[error("value reference {reference} does not exist: they go from 0 to {last}")]
    UnknownReference {
        /// The reference.
        reference: u32,
        /// The greatest one.
        last: usize,
    },
    /// A function for another type than that of the variable.
    #[error("{name} is of type {kind}: it has its own function")]
    WrongType {
        /// The variable.
        name: &'static str,
        /// Its type in the words of FMI.
        kind: &'static str,
    },
    /// A derivative of what is no continuous input.
    #[error("{0} is no input: only inputs have time derivatives")]
    NoInput(&'static str),
    /// A directional derivative of or by what has none.
    #[error("{name} is not admitted as {role} of a directional derivative: {reason}")]
    NoDerivative {
        /// The variable.
        name: &'static str,
        /// Unknown or known.
        role: &'static str,
        /// Why not.
        reason: &'static str,
    },
    /// A seed that is not a number.
    #[error("seed {seed} of {name} is not admitted: a finite number")]
    BadSeed {
        /// The input.
        name: &'static str,
        /// The seed.
        seed: f64,
    },
    /// A derivative that is not a number.
    #[error("derivative {order} of {name} = {value} is not admitted: a finite number")]
    BadDerivative {
        /// The input.
        name: &'static str,
        /// Order of the derivative.
        order: i32,
        /// Its value.
        value: f64,
    },
    /// A parameter set after initialization.
    #[error("{name} is fixed after initialization: call {interface}Reset to change it")]
    Fixed {
        /// The parameter.
        name: &'static str,
        /// Whose function resets.
        interface: Interface,
    },
    /// A time or step that is not admitted.
    #[error("argument {name} = {value} is not admitted: {allowed}")]
    BadArgument {
        /// The argument.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What would be admitted.
        allowed: &'static str,
    },
    /// A step that ends beyond the end.
    #[error(
        "argument communicationStepSize = {step} is not admitted: the step from {time} s would end at {} s, after the stop time of {stop} s",
        time + step
    )]
    AfterStop {
        /// Start of the step [s].
        time: f64,
        /// Its length [s].
        step: f64,
        /// Stop time of the experiment [s].
        stop: f64,
    },
    /// An unknown log category.
    #[error("there is no log category \"{0}\": see LogCategories in modelDescription.xml")]
    UnknownCategory(String),
    /// A library and a description that do not belong together.
    #[error(
        "the {} is \"{given}\", but this library is of \"{wheel}\" (WheelRail) and \"{wheelset}\" (WheelSet): use the modelDescription.xml packed with it",
        interface.identity()
    )]
    WrongGuid {
        /// Through which the host came.
        interface: Interface,
        /// What the host read.
        given: String,
        /// That of the wheel unit of the library.
        wheel: &'static str,
        /// That of the wheelset unit of the library.
        wheelset: &'static str,
    },
    /// A type of unit that FMI does not know.
    #[error("fmuType {0} is neither model exchange (0) nor co-simulation (1)")]
    WrongFmuType(i32),
    /// An instance without a name.
    #[error("argument instanceName is empty")]
    NoName,
    /// A function behind a capability flag that is not set.
    #[error("not supported: modelDescription.xml does not set {0}")]
    NotSupported(&'static str),
    /// A state that was freed, or is another instance's.
    #[error("argument {0} is no state of this instance: it was freed, or belongs to another one")]
    UnknownState(&'static str),
    /// Bytes that are no state.
    #[error("argument serializedState {0}")]
    BadBytes(String),
    /// A resource location that cannot be used.
    #[error(
        "{} \"{given}\" is not {}; profiles are looked for in the working directory only",
        interface.location_argument().0,
        interface.location_argument().1
    )]
    BadLocation {
        /// Through which the host came.
        interface: Interface,
        /// What the host gave.
        given: String,
    },
    /// Start values beside the unit that cannot be taken.
    #[error("{file}, {problem}")]
    BadStarts {
        /// The file.
        file: String,
        /// What is wrong.
        problem: String,
    },
    /// A resource location that names no folder.
    #[error(
        "{} \"{given}\" names no folder that exists ({folder}): profiles beside the unit will not be found",
        interface.location_argument().0
    )]
    NoFolder {
        /// Through which the host came.
        interface: Interface,
        /// What the host gave.
        given: String,
        /// What it was taken for.
        folder: String,
    },
    /// A URI through FMI 3.0.
    #[error(
        "resourcePath \"{given}\" is a URI, as FMI 2.0 has it, where FMI 3.0 has an absolute path: taken for {folder}"
    )]
    UriForPath {
        /// What the host gave.
        given: String,
        /// What it was taken for.
        folder: String,
    },
    /// A function of the other version of the standard.
    #[error("the instance was made through FMI {}: call the functions that begin with {own}", own.version())]
    OtherInterface {
        /// Through which the instance was made.
        own: Interface,
    },
    /// A function for what the unit has none of.
    #[error("the unit has no {0}: see modelDescription.xml")]
    None(&'static str),
    /// A reference within an array.
    #[error("value reference {reference} does not exist: that of {array} is {first}")]
    WithinArray {
        /// The reference.
        reference: u32,
        /// The array.
        array: &'static str,
        /// Its reference.
        first: u32,
    },
    /// A variable that is computed, whatever its value.
    #[error("{0} is computed by the element and cannot be set")]
    Computed(&'static str),
    /// An array of values that is too long or too short.
    #[error("argument {name} = {given}, but the variables have {wanted} elements")]
    WrongCount {
        /// The argument.
        name: &'static str,
        /// Its value.
        given: usize,
        /// What it has to be.
        wanted: usize,
    },
    /// A panic, which is a fault of this library.
    #[error("internal fault; the instance is closed: free it, and please report this")]
    Panic,
}
