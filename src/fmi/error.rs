//! Why a call through the interface is refused.

use crate::error::ContactError;

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
        state: &'static str,
        /// What to call.
        remedy: &'static str,
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
    #[error("{0} is fixed after initialization: call fmi2Reset to change it")]
    Fixed(&'static str),
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
    /// A step that starts beyond the end.
    #[error("the step starts at {time} s, after the stop time of {stop} s")]
    AfterStop {
        /// Start of the step [s].
        time: f64,
        /// Stop time of the experiment [s].
        stop: f64,
    },
    /// An unknown log category.
    #[error("there is no log category \"{0}\": see LogCategories in modelDescription.xml")]
    UnknownCategory(String),
    /// A library and a description that do not belong together.
    #[error(
        "the GUID is \"{given}\", but this library is of \"{wheel}\" (WheelRail) and \"{wheelset}\" (WheelSet): use the modelDescription.xml packed with it"
    )]
    WrongGuid {
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
        "fmuResourceLocation \"{0}\" is not a file: URI; profiles are looked for in the working directory only"
    )]
    BadLocation(String),
    /// A panic, which is a fault of this library.
    #[error("internal fault; the instance is closed: free it, and please report this")]
    Panic,
}
