//! What is known about a variable and the unit that has it.

use serde::{Deserialize, Serialize};

use super::spelling;

/// Who sets a variable, and when.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Causality {
    /// Set by the host at any time.
    Input,
    /// Set by the host before the element is initialized, then fixed.
    Parameter,
    /// Follows from parameters and starting inputs at initialization.
    CalculatedParameter,
    /// Computed by the element.
    Output,
}

/// Type of a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Real,
    /// A whole number.
    Integer,
    /// True or false.
    Boolean,
    /// A text, such as a profile name.
    Text,
    /// A choice; its value is that of the item.
    Enumeration(&'static Enumeration),
}

/// A set of choices.
#[derive(Debug, PartialEq)]
#[non_exhaustive]
pub struct Enumeration {
    /// Name of the type.
    pub name: &'static str,
    /// What is chosen.
    pub description: &'static str,
    /// The choices.
    pub items: &'static [Item],
}

impl Enumeration {
    /// The item of that value.
    pub fn item(&self, value: i32) -> Option<&'static Item> {
        self.items.iter().find(|i| i.value == value)
    }
}

/// One choice.
#[derive(Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Item {
    /// Name, as used in text files.
    pub name: &'static str,
    /// Value, as used by FMI; fixed for good.
    pub value: i32,
    /// What is chosen with it.
    pub description: &'static str,
}

/// A value of any type; enumerations are integers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Value<'a> {
    /// Of a real variable, in its unit.
    Real(f64),
    /// Of an integer variable or an enumeration.
    Integer(i32),
    /// Of a boolean variable.
    Boolean(bool),
    /// Of a text variable.
    Text(&'a str),
}

/// What is known about a variable.
#[derive(Debug, PartialEq)]
#[non_exhaustive]
pub struct Variable {
    /// Name, such as `wheel.force.z`.
    pub name: &'static str,
    /// The quantity, its frame and sign.
    pub description: &'static str,
    /// Place in the table of its unit, which is also the FMI value reference.
    pub reference: usize,
    /// Type.
    pub kind: Kind,
    /// Who sets it.
    pub causality: Causality,
    /// Unit; empty for pure numbers and for what is not a number.
    pub unit: &'static str,
    /// Smallest admitted value.
    pub min: Option<f64>,
    /// Largest admitted value.
    pub max: Option<f64>,
    /// Size of a change that matters; 1 where none is declared.
    pub nominal: f64,
    /// Start value of inputs and parameters.
    pub start: Option<Value<'static>>,
    /// References of the inputs and parameters on which an output depends.
    pub dependencies: &'static [usize],
    /// Whether it is computed only when it is read.
    pub on_request: bool,
    /// Whether it counts what evaluations met with, whatever the time.
    pub is_counter: bool,
    /// What is admitted, in words.
    pub allowed: &'static str,
    /// Name of the array of FMI 3.0 of which it is an element.
    pub array: Option<&'static str>,
    /// Of the variable of FMI 3.0 with this reference the places of its elements: itself alone, or
    /// all of the array that it begins; none within an array.
    pub elements: &'static [u32],
}

impl Variable {
    /// Whether it is an input or a parameter.
    pub fn is_settable(&self) -> bool {
        matches!(self.causality, Causality::Input | Causality::Parameter)
    }

    /// Whether it is an output of every evaluation.
    pub(crate) fn is_evaluated(&self) -> bool {
        self.causality == Causality::Output && !self.on_request
    }
}

/// A unit: what one archive stands for.
#[derive(Debug)]
#[non_exhaustive]
pub struct Unit {
    /// `modelIdentifier`: name of the archive and of the library in it.
    pub identifier: &'static str,
    /// Identifies the description from which library and XML were made: its hash.
    pub guid: &'static str,
    /// Every variable; its place is its FMI value reference.
    pub variables: &'static [Variable],
}

impl Unit {
    /// The variable of that name.
    ///
    /// # Errors
    /// With the nearest name if there is none.
    pub fn find(&self, name: &str) -> Result<&'static Variable, UnknownVariable> {
        self.variables.iter().find(|v| v.name == name).ok_or_else(|| {
            // No two names differ by capitals alone.
            let small = name.to_lowercase();
            let names = self.variables.iter().map(|v| (spelling::distance(&small, v.name), v.name));
            let (distance, nearest) =
                names.min_by_key(|(distance, _)| *distance).unwrap_or_default();
            UnknownVariable { name: name.into(), nearest, distance }
        })
    }
}

/// A name that no variable has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no variable \"{name}\"; the nearest name is {nearest}")]
#[non_exhaustive]
pub struct UnknownVariable {
    /// The name asked for.
    pub name: String,
    /// The name of a variable that differs least from it, whether letters are large or small.
    pub nearest: &'static str,
    /// Number of letters by which it differs.
    pub distance: usize,
}
