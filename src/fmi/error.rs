//! Why a call through the interface is refused.

use std::path::Path;

use super::interface::Interface;
use super::location;
use crate::error::ContactError;
use crate::variables::shortened;

impl FmiError {
    /// What is odd about the argument for the resources of `interface`, with the folder that it was
    /// taken for.
    pub fn odd_location(
        interface: Interface,
        location: &str,
        folder: Option<&Path>,
    ) -> Option<Self> {
        let given = || shortened(location);
        match folder {
            None if location.is_empty() => None,
            None => Some(Self::BadLocation { interface, given: given() }),
            Some(folder) if !folder.is_dir() => Some(Self::NoFolder {
                interface,
                given: given(),
                folder: folder.display().to_string(),
            }),
            Some(folder) if interface == Interface::V3 && location::is_uri(location) => {
                Some(Self::UriForPath { given: given(), folder: folder.display().to_string() })
            }
            Some(_) => None,
        }
    }

    /// That of a call which needs initialization mode at least.
    pub fn too_early(interface: Interface) -> Self {
        let first = match interface {
            Interface::V2 => "fmi2SetupExperiment and fmi2EnterInitializationMode",
            Interface::V3 => "fmi3EnterInitializationMode",
        };
        let remedy = format!("call {first} first");
        Self::WrongState { state: "before initialization".into(), remedy }
    }

    /// That of a parameter whose value does not go with the rest.
    pub fn unfit(name: &str, value: &str, allowed: &str) -> Self {
        let [name, value, allowed] = [name, value, allowed].map(Into::into);
        ContactError::BadText { name, value, allowed }.into()
    }
}

/// A refusal; the message goes to the host's logger.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FmiError {
    #[error(transparent)]
    Contact(#[from] ContactError),
    #[error("not allowed {state}: {remedy}")]
    WrongState { state: String, remedy: String },
    #[error("argument {0} is null")]
    NullPointer(&'static str),
    #[error("argument {0} is not UTF-8")]
    NotUnicode(&'static str),
    #[error("value reference {reference} does not exist: they go from 0 to {last}")]
    UnknownReference { reference: u32, last: usize },
    #[error("{name} is of type {kind}: it has its own function")]
    WrongType { name: &'static str, kind: &'static str },
    #[error("{0} is no input: only inputs have time derivatives")]
    NoInput(&'static str),
    #[error("{name} is not admitted as {role} of a directional derivative: {reason}")]
    NoDerivative { name: &'static str, role: &'static str, reason: &'static str },
    #[error("seed {seed} of {name} is not admitted: a finite number")]
    BadSeed { name: &'static str, seed: f64 },
    #[error("derivative {order} of {name} = {value} is not admitted: a finite number")]
    BadDerivative { name: &'static str, order: i32, value: f64 },
    #[error("{name} is fixed after initialization: call {interface}Reset to change it")]
    Fixed { name: &'static str, interface: Interface },
    #[error("argument {name} = {value} is not admitted: {allowed}")]
    BadArgument { name: &'static str, value: f64, allowed: &'static str },
    #[error(
        "argument communicationStepSize = {step} is not admitted: the step from {time} s would end at {} s, after the stop time of {stop} s",
        time + step
    )]
    AfterStop { time: f64, step: f64, stop: f64 },
    #[error("there is no log category \"{0}\": see LogCategories in modelDescription.xml")]
    UnknownCategory(String),
    #[error(
        "the {} is \"{given}\", but this library is of \"{wheel}\" (WheelRail) and \"{wheelset}\" (WheelSet): use the modelDescription.xml packed with it",
        interface.identity()
    )]
    WrongGuid { interface: Interface, given: String, wheel: &'static str, wheelset: &'static str },
    #[error("fmuType {0} is neither model exchange (0) nor co-simulation (1)")]
    WrongFmuType(i32),
    #[error("argument instanceName is empty")]
    NoName,
    #[error("not supported: modelDescription.xml does not set {0}")]
    NotSupported(&'static str),
    #[error("argument {0} is no state of this instance: it was freed, or belongs to another one")]
    UnknownState(&'static str),
    #[error("argument serializedState {0}")]
    BadBytes(String),
    #[error(
        "{} \"{given}\" is not {}; profiles are looked for in the working directory only",
        interface.location_argument().0,
        interface.location_argument().1
    )]
    BadLocation { interface: Interface, given: String },
    #[error("{file}, {problem}")]
    BadStarts { file: String, problem: String },
    #[error(
        "{} \"{given}\" names no folder that exists ({folder}): profiles beside the unit will not be found",
        interface.location_argument().0
    )]
    NoFolder { interface: Interface, given: String, folder: String },
    #[error(
        "resourcePath \"{given}\" is a URI, as FMI 2.0 has it, where FMI 3.0 has an absolute path: taken for {folder}"
    )]
    UriForPath { given: String, folder: String },
    #[error("the instance was made through FMI {}: call the functions that begin with {own}", own.version())]
    OtherInterface { own: Interface },
    #[error("the unit has no {0}: see modelDescription.xml")]
    None(&'static str),
    #[error("value reference {reference} does not exist: that of {array} is {first}")]
    WithinArray { reference: u32, array: &'static str, first: u32 },
    #[error("{0} is computed by the element and cannot be set")]
    Computed(&'static str),
    #[error("argument {name} = {given}, but the variables have {wanted} elements")]
    WrongCount { name: &'static str, given: usize, wanted: usize },
    #[error("internal fault; the instance is closed: free it, and please report this")]
    Panic,
}
